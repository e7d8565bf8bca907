"""The given animation in a real browser: numbers, forces, plots, and the right motion."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from animation_page import Open, animation, file, open_page, scene, with_animation, written
from selenium.webdriver.common.keys import Keys

NOTHING = "\N{EN DASH}"
# Whether the stage is another one without any force; the page has none from then on.
DRAWS_A_FORCE = """
const before = stage.toDataURL();
forces.fill(null);
draw();
return stage.toDataURL() !== before;
"""
DASHES = "return panels().map((p) => p.lines.map((line) => [line.name, line.dash.join()]))"


def lowest_corner(scene: dict[str, Any], t: int) -> float:
    """phi of column t, eqs. (3) and (4)."""
    theta = scene["q"][2][t]
    arms = (math.sin(theta + math.pi / 4 + k * math.pi / 2) for k in range(4))
    return float(scene["q"][1][t] + scene["l"] / math.sqrt(2) * min(arms))


def force(scene: dict[str, Any], t: int) -> list[float]:
    """Of the ground, in column t, along x and y."""
    m, g, v = (scene["motion"][name] for name in "mgv")
    return [m * ((v[i][t + 1] - v[i][t]) / scene["dt"] - g[i]) for i in range(2)]


def touching(scene: dict[str, Any]) -> list[int]:
    columns = range(len(scene["q"][0]) - 1)
    return [t for t in columns if lowest_corner(scene, t) < scene["delta"]]


def pushed(scene: dict[str, Any]) -> list[int]:
    """The columns in which the ground pushes: one a bounce, and in this scene far apart."""
    return [t for t in touching(scene) if force(scene, t)[1] > 1]


def test_slides_to_a_column_and_shows_its_numbers(open_page: Open, scene: dict[str, Any]) -> None:
    page = open_page()
    for t in [0, 1, 75, 149]:
        page.slide(t)
        assert (page.playing(), page.column()) == (False, t)
        expected = [t * scene["dt"], *(row[t] for row in scene["q"]), lowest_corner(scene, t)]
        shown = [page.number(name) for name in ["time", "x", "y", "theta", "phi"]]
        assert shown == pytest.approx(expected, abs=0.51e-4)
    traces = []
    for t in [0, 30, 60, 149]:
        page.slide(t)
        traces.append(page.pixels("corner"))
    # The view follows the square, so that an older part of the trace may leave it later on.
    assert traces[0] + 20 < traces[1] < traces[2] - 20 and traces[-1] > 4 * traces[1], traces


def test_a_column_shows_its_contact_and_no_force_but_its_own(
    open_page: Open, scene: dict[str, Any]
) -> None:
    page = open_page()
    assert touching(scene)
    for t in sorted({0, *touching(scene), *(t - 1 for t in touching(scene))}):
        page.slide(t)
        assert page.find("contact").is_displayed() == (t in touching(scene))
    for t in pushed(scene):
        for other in (t - 1, t + 1, t + 2):
            page.slide(other)
            text = "0.0" if other in touching(scene) else NOTHING
            assert (page.find("f_n").text, page.pixels("force")) == (text, 0)
        page.slide(t)
        shown = [page.number("f_t"), page.number("f_n")]
        assert shown == pytest.approx(force(scene, t), abs=0.051)
        assert page.pixels("force") > 10


def test_while_playing_an_arrow_lingers_for_a_moment_of_the_readers(
    open_page: Open, scene: dict[str, Any]
) -> None:
    for speed, after, lingers in [
        *(("0.125", 0.06, True), ("0.125", 0.3, False)),
        *(("1", 0.06, True), ("1", 0.3, False)),
    ]:
        page = open_page()
        page.find("play").click()
        page.choose(speed)
        page.slide(pushed(scene)[0])
        page.find("play").click()
        page.pass_time(0, scene["dt"] / float(speed) + after)  # of which the contact takes a step
        assert page.playing() and page.column() > pushed(scene)[0]
        assert page.driver.execute_script(DRAWS_A_FORCE) == lingers, (speed, after)


def test_a_cursor_moves_over_the_plots(open_page: Open) -> None:
    page = open_page()
    for colour in ("corner", "square", "force"):
        assert page.pixels(colour, "plots") > 50, f"the {colour} line is missing"
    page.point_at_plots(0.5)
    assert not page.playing() and page.column() == pytest.approx(149 / 2, abs=1.5)
    page.point_at_plots(1)
    assert page.column() == 149


def test_shows_the_right_one_beside_another(open_page: Open, tmp_path: Path) -> None:
    right, other = tmp_path / "right.html", tmp_path / "other.html"
    text = written(right, "--compare")
    data = animation(text)
    for row in data["q"][:2]:  # the square leaves the right way at column 12
        row[12:] = [x + 0.01 * (t + 1) for t, x in enumerate(row[12:])]
    other.write_text(with_animation(text, data), "utf-8")

    assert "yours does the same" in open_page(right).find("other").text
    page = open_page(other)
    assert "from step 12 on, at 0.12 s" in page.find("other").text
    for lines in page.driver.execute_script(DASHES):  # they differ by more than colour
        assert len({dash for _, dash in lines}) == len(lines) == len({name for name, _ in lines})
    page.slide(30)
    both = page.pixels("right")
    assert both > 50 and page.pixels("right", "plots") > 20
    page.find("compare").click()
    assert (page.pixels("right"), page.pixels("right", "plots")) == (0, 0)
    assert not page.find("other").is_displayed()
    page.press("c")
    assert page.pixels("right") == both
    page.press(Keys.SPACE)  # the box has the focus, and a space is its own
    assert page.pixels("right") == 0 and not page.playing()

    page = open_page()  # where no right one is known
    assert not any(page.find(id_).is_displayed() for id_ in ("choice", "other", "key"))
    page.press("c")
    assert page.pixels("right") == 0
