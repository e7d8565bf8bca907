"""The given animation's arrows, which stand for a force that acts, and its page on a phone."""

from pathlib import Path
from typing import Any

import pytest
from animation_page import Open, file, lowest_corner, open_page, scene

# Whether the stage is another one without any force; the page has none from then on.
DRAWS_A_FORCE = """
const before = stage.toDataURL();
forces.fill(null);
draw();
return stage.toDataURL() !== before;
"""
PLACES = """
return Object.fromEntries(["stage", "controls", "plots", "numbers"].map((id) => {
  const { top, bottom } = byId(id).getBoundingClientRect();
  return [id, [top + scrollY, bottom + scrollY]];
}));
"""


def pushes(scene: dict[str, Any]) -> list[int]:
    """The columns in which the ground pushes: one a bounce, and in this scene far apart."""
    m, g, v = (scene["motion"][name] for name in "mgv")
    columns = range(len(v[1]) - 1)
    touching = [t for t in columns if lowest_corner(scene, t) < scene["delta"]]
    return [t for t in touching if m * ((v[1][t + 1] - v[1][t]) / scene["dt"] - g[1]) > 1]


@pytest.mark.parametrize("after, seen", [(0, True), (1, False), (2, False)])
def test_a_column_that_stands_shows_no_force_but_its_own(
    open_page: Open, scene: dict[str, Any], after: int, seen: bool
) -> None:
    page = open_page()
    page.slide(pushes(scene)[1] + after)
    assert (page.find("f_n").text != "\N{EN DASH}") == seen
    assert page.driver.execute_script(DRAWS_A_FORCE) == seen


@pytest.mark.parametrize("speed", ["0.125", "1"])
@pytest.mark.parametrize("after, seen", [(0.06, True), (0.3, False)])
@pytest.mark.usual(2)
def test_while_playing_an_arrow_lingers_for_a_moment_of_the_readers(
    open_page: Open, scene: dict[str, Any], speed: str, after: float, seen: bool
) -> None:
    page = open_page()
    page.find("play").click()
    page.choose(speed)
    page.slide(pushes(scene)[0])
    page.find("play").click()
    step = scene["dt"] / float(speed)  # that the contact takes
    page.pass_time(0, step + after)
    assert page.playing() and page.column() > pushes(scene)[0]
    assert page.driver.execute_script(DRAWS_A_FORCE) == seen


def test_no_arrow_lingers_at_the_end_of_the_loop(
    open_page: Open, file: Path, scene: dict[str, Any], tmp_path: Path
) -> None:
    page = open_page()
    last = len(scene["q"][0]) - 1
    page.driver.execute_script("forces[arguments[0]] = [0, strongest]", last - 1)
    page.pass_time(0, last * scene["dt"] + 0.5)
    assert page.column() == last
    assert not page.driver.execute_script(DRAWS_A_FORCE)


def test_on_a_phone_the_square_its_controls_and_the_plots_come_first(open_page: Open) -> None:
    page = open_page()
    page.screen(375, 667, 2)
    page.wait_until(lambda: page.find("stage").size["width"] < 375)
    places = page.driver.execute_script(PLACES)
    ends = [places[id_][1] for id_ in ("stage", "controls", "plots")]
    assert ends == sorted(ends) and ends[-1] < 667
    assert places["numbers"][0] > ends[-1]


def test_says_that_there_is_more_until_the_end_is_seen(open_page: Open) -> None:
    page = open_page()
    page.screen(375, 667, 1)
    more = page.find("more")
    page.wait_until(more.is_displayed)
    more.click()
    page.driver.execute_script("scrollTo(0, document.documentElement.scrollHeight)")
    page.wait_until(lambda: not more.is_displayed())
    page.screen(1280, 1000, 1)
    page.driver.execute_script("scrollTo(0, 0)")
    page.wait_until(lambda: page.find("stage").size["width"] > 600)
    assert not more.is_displayed()


def test_says_each_rule_of_its_style_once(file: Path) -> None:
    style = file.read_text("utf-8").partition("<style>")[2].partition("</style>")[0]
    assert style.count("cursor: crosshair") == 1 and style.count("[hidden]") == 1
