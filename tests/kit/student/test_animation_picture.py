"""The given animation in a real browser: numbers, forces, plots, and the right motion."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import pytest
from animation_page import PATIENCE, PROGRAM, Open, compared, file, lowest_corner, open_page, scene
from selenium.webdriver.common.keys import Keys


# ---- what is shown ----


@pytest.mark.parametrize("t", [0, 1, 75, 149])
@pytest.mark.usual(2)
def test_slides_to_a_column_and_shows_its_numbers(
    open_page: Open, scene: dict[str, Any], t: int
) -> None:
    page = open_page()
    page.slide(t)
    assert (page.playing(), page.column()) == (False, t)
    expected = [t * scene["dt"], *(row[t] for row in scene["q"]), lowest_corner(scene, t)]
    shown = [page.number(name) for name in ["time", "x", "y", "theta", "phi"]]
    assert shown == pytest.approx(expected, abs=0.51e-4)


def test_says_when_the_corner_is_in_contact(open_page: Open, scene: dict[str, Any]) -> None:
    page = open_page()
    columns = range(len(scene["q"][0]))
    touching = [t for t in columns if lowest_corner(scene, t) < scene["delta"]]
    assert 0 < len(touching) < len(columns) / 2
    for t in {0, *touching, *(t - 1 for t in touching)}:
        page.slide(t)
        assert page.find("contact").is_displayed() == (t in touching)


def test_the_trace_of_the_corner_grows(open_page: Open) -> None:
    page = open_page()
    counts = []
    for t in [0, 30, 60, 100, 125, 149]:
        page.slide(t)
        counts.append(page.pixels("corner"))
    # The view follows the square, so that an older part of the trace may leave it later on.
    assert counts[0] + 20 < counts[1] < counts[2] - 20 and counts[-1] > 4 * counts[1], counts


def test_shows_the_force_of_the_ground_in_a_contact_step(
    open_page: Open, scene: dict[str, Any]
) -> None:
    page = open_page()
    columns = range(len(scene["q"][0]) - 1)
    hit = next(t for t in columns if lowest_corner(scene, t) < scene["delta"])
    m, g, v = (scene["motion"][name] for name in "mgv")
    force = [m * ((v[i][hit + 1] - v[i][hit]) / scene["dt"] - g[i]) for i in range(2)]
    assert force[1] > 1
    page.slide(hit - 1)
    assert (page.find("f_n").text, page.pixels("force")) == ("\N{EN DASH}", 0)
    page.slide(hit)
    assert [page.number("f_t"), page.number("f_n")] == pytest.approx(force, abs=0.051)
    assert page.pixels("force") > 50


WIDTHS = """
return [l * camera().scale, document.documentElement.scrollWidth - innerWidth,
  plots.getBoundingClientRect().left - stage.getBoundingClientRect().right,
  document.querySelectorAll("main").length];
"""


@pytest.mark.parametrize("width", [320, 768, 1280, 1920])
def test_the_square_is_large_and_nothing_overflows(open_page: Open, width: int) -> None:
    page = open_page()
    driver = page.driver
    size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    try:
        page.slide(40)
        square, overflow, beside, mains = driver.execute_script(WIDTHS)
        assert square >= 59.9 and overflow <= 0 and mains == 1
        assert (beside > 0) == (width >= 1200)  # the plots
        assert page.pixels("square") > 100
    finally:
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def test_a_force_is_seen_for_a_fifth_of_a_second(open_page: Open) -> None:
    assert open_page().driver.execute_script("return echo") >= 0.2


def test_a_cursor_moves_over_the_plots(open_page: Open) -> None:
    page = open_page()
    for colour in ("corner", "square", "force"):
        assert page.pixels(colour, "plots") > 50, f"the {colour} line is missing"
    page.point_at_plots(0.5)
    assert not page.playing() and page.column() == pytest.approx(149 / 2, abs=1.5)
    page.point_at_plots(1)
    assert page.column() == 149
    dark = """
    const copy = new OffscreenCanvas(plots.width, plots.height);
    const ctx = copy.getContext("2d", { willReadFrequently: true });
    ctx.drawImage(plots, 0, 0);
    const X = Math.round(timeX(shown())), d = ctx.getImageData(X - 2, 0, 5, 60).data;
    return d.filter((_, i) => i % 4 === 3).reduce((a, b) => a + b, 0);
    """
    page.slide(40)
    at_cursor = page.driver.execute_script(dark)
    beside = page.driver.execute_script(dark.replace("X = ", "X = 60 + "))
    assert at_cursor > beside + 5000


# ---- comparing ----


def test_shows_the_right_one_beside_another(open_page: Open, compared: Path) -> None:
    page = open_page(compared)
    assert "from step 12 on, at 0.12 s" in page.find("other").text
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


def test_says_nothing_of_a_right_one_where_none_is_known(open_page: Open) -> None:
    page = open_page()
    assert not any(page.find(id_).is_displayed() for id_ in ("choice", "other", "key"))
    page.press("c")
    assert page.pixels("right") == 0


def test_says_that_a_right_program_does_the_same(open_page: Open, tmp_path: Path) -> None:
    page = tmp_path / "right.html"
    subprocess.run([PROGRAM, "--compare", page], check=True, capture_output=True, timeout=PATIENCE)
    assert "yours does the same" in open_page(page).find("other").text


def test_lines_differ_by_more_than_colour(open_page: Open, compared: Path) -> None:
    page = open_page(compared)
    found = page.driver.execute_script(
        "return panels().map((p) => p.lines.map((line) => [line.name, line.dash.join()]))"
    )
    for lines in found:
        assert len({dash for _, dash in lines}) == len(lines) == len({name for name, _ in lines})
