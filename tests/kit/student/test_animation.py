"""The given animation in a real browser: what a reader of the page can do with it."""

from __future__ import annotations

import json
import math
import subprocess
from pathlib import Path
from typing import Any

import pytest
from animation_page import PATIENCE, PROGRAM, Open, file, open_page, scene, with_animation
from selenium.webdriver.common.keys import Keys

REST = 0.8  # s that the last column stays before the loop starts again
IS_SHARP = """
const stage = document.getElementById("stage");
const [width, height, ratio] = arguments;
return innerWidth === width && innerHeight === height && devicePixelRatio === ratio
  && stage.width === stage.clientWidth * ratio && stage.height === stage.clientHeight * ratio;
"""
AFTER_FIVE_FRAMES = """
const done = arguments[arguments.length - 1];
let left = 5;
const wait = () => (left-- ? requestAnimationFrame(wait) : done());
wait();
"""
SIDE = "return l * camera().scale"  # of the square, in the picture
PLACES = """
return Object.fromEntries(["stage", "controls", "plots", "numbers"].map((id) => {
  const { top, bottom, left, right } = document.getElementById(id).getBoundingClientRect();
  return [id, { top: top + scrollY, bottom: bottom + scrollY, left, right }];
}));
"""
BACKGROUND = "return getComputedStyle(document.body).backgroundColor"


@pytest.mark.parametrize(
    "words, status, printed",
    [
        ("", 0, "The animation is in FOLDER/animation.html; open it in a browser.\n"),
        ("missing/a.html", 1, "No animation was written: cannot write missing/a.html: "),
        *(
            (words, 2, f"bounce: {words.split()[-1]} is not understood; there are:\n")
            for words in ("dt=0.001", "page", "--compar", "a.html b.html", "--compare dt=0.001")
        ),
        ("--worked 2", 2, "bounce: 2 is not understood; there are:\n"),
    ],
)
def test_the_program_says_where_the_page_is_or_what_went_wrong(
    tmp_path: Path, words: str, status: int, printed: str
) -> None:
    command = [str(PROGRAM), *words.split()]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == status
    assert (done.stderr if status else done.stdout).startswith(
        printed.replace("FOLDER", str(tmp_path))
    )
    assert (done.stdout if status else done.stderr) == ""
    assert [file.name for file in tmp_path.iterdir()] == ([] if status else ["animation.html"])


# ---- time ----


def test_plays_by_itself_from_one_file_and_stands_when_paused(
    open_page: Open, driver: Any, file: Path
) -> None:
    driver.get_log("performance")
    page = open_page(own_clock=False)
    assert page.playing()
    first = page.number("time")
    page.wait_until(lambda: page.number("time") != first)
    page.find("play").click()
    assert not page.playing()
    stands = page.number("time")
    driver.execute_async_script(AFTER_FIVE_FRAMES)
    assert page.number("time") == stands
    events = [json.loads(entry["message"])["message"] for entry in driver.get_log("performance")]
    sent = [e["params"]["request"]["url"] for e in events if e["method"].endswith("WillBeSent")]
    assert {url for url in sent if not url.startswith("data:")} == {file.as_uri()}


def test_moves_on_by_time_at_a_speed_in_a_loop(open_page: Open, scene: dict[str, Any]) -> None:
    last = len(scene["q"][0]) - 1
    loop = last * scene["dt"] + REST
    for speed, frames, expected in [
        *((speed, [0.6], 0.6 * float(speed)) for speed in ("0.125", "0.25", "0.5", "1", "2")),
        *(("1", frames, 0.5) for frames in ([0.05] * 10, [0.4, 0.001, 0.099])),
        ("fit", [5.0], 0.745),  # half of all, which it shows in ten seconds
        ("fit", [5.0, 5.0], 1.49),
        ("1", [loop - REST / 2], 1.49),
        ("1", [loop + 0.2], 0.2),
        ("1", [0.2, 1000 * loop], 0.2),
    ]:
        page = open_page()
        page.choose(speed)
        page.pass_time(0, *frames)
        assert page.number("time") == pytest.approx(expected, abs=0.011), (speed, frames)
        assert page.playing()


def test_starts_paused_when_motion_is_unwelcome(open_page: Open) -> None:
    page = open_page()
    page.media(prefers_reduced_motion="reduce")
    page.driver.refresh()
    page.pass_time(0, 0.5)
    assert (page.playing(), page.column()) == (False, 0)
    page.press(Keys.SPACE)
    page.pass_time(0, 0.5)
    assert page.column() > 0


# ---- reach ----


def test_obeys_the_keyboard_and_leaves_a_control_its_keys(open_page: Open) -> None:
    page = open_page()
    left, right = Keys.ARROW_LEFT, Keys.ARROW_RIGHT
    for keys, expected in [
        ([Keys.SPACE, Keys.END], (False, 149)),
        ([right], (False, 149)),
        ([left, left, right], (False, 148)),
        ([Keys.HOME], (False, 0)),
        ([Keys.SPACE], (True, 0)),
        ([Keys.TAB, Keys.SPACE], (False, 0)),  # on the button a space is a click, and only one
        ([Keys.TAB, Keys.HOME, right], (False, 1)),  # on the slider
        ([Keys.SPACE, Keys.SPACE], (False, 1)),
        ([Keys.TAB, Keys.ARROW_DOWN], (False, 1)),  # on the choice of speed
    ]:
        page.press(*keys)
        assert (page.playing(), page.column()) == expected, keys
    assert page.find("speed").get_attribute("value") == "2"
    value = page.find("slider").get_attribute("aria-valuetext")
    assert value == "step 1 of 149, 0.01 seconds"
    assert page.find("slider").accessible_name == "Time step"
    assert "square" in page.find("stage").accessible_name


def test_fits_every_screen_in_full_sharpness_and_takes_its_colours(open_page: Open) -> None:
    page = open_page()
    run = page.driver.execute_script
    page.slide(40)
    for width, height, ratio in [(320, 900, 1), (375, 667, 2), (844, 390, 2), (1600, 1000, 1)]:
        page.screen(width, height, ratio)
        page.wait_until(lambda: bool(run(IS_SHARP, width, height, ratio)))
        places = run(PLACES)
        assert run("return document.documentElement.scrollWidth") <= width
        assert page.find("plots").size["height"] >= 200
        assert (places["plots"]["left"] > places["stage"]["right"]) == (width >= 1200)
        assert page.pixels("square") > 100 and (height < 600 or run(SIDE) >= 59.9)
        if width == 375:  # on a phone the numbers come last
            ends = [places[id_]["bottom"] for id_ in ("stage", "controls", "plots")]
            assert ends == sorted(ends) and ends[-1] < height
            assert places["numbers"]["top"] > ends[-1]
            more = page.find("more")  # which goes when the end is seen
            page.wait_until(more.is_displayed)
            run("scrollTo(0, document.documentElement.scrollHeight)")
            page.wait_until(lambda: not more.is_displayed())
    light = run(BACKGROUND)
    page.media(prefers_color_scheme="dark")
    page.wait_until(lambda: page.pixels("square") > 50)  # the dark scheme's blue
    assert run(BACKGROUND) != light


# ---- any trajectory ----


def bounces(T: int, x_0: float = 0, v: float = 0.6, y: float = 1.5) -> list[list[float]]:
    steps = range(T)
    heights = [abs(y * math.cos(t / 40)) + 0.2 for t in steps]
    return [[x_0 + v * t / 100 for t in steps], heights, [t / 25 for t in steps]]


TRAJECTORIES: dict[str, dict[str, Any]] = {
    **{f"{T} columns": {"q": bounces(T)} for T in (1, 2, 20000)},
    "far in x": {"q": bounces(150, x_0=1e9)},
    "farther than a double can step": {"q": bounces(150, x_0=1e18)},
    "a tiny square": {"l": 1e-4, "q": bounces(150)},
    "a house": {"l": 30.0, "q": bounces(150)},
    "far below the ground": {"q": [[0.0] * 150, [-t * t / 100 for t in range(150)], [0.0] * 150]},
    "to infinity, nearly": {
        "motion": {"m": 0.3, "g": [0, -9.81], "v": [[1e300] * 150] * 3},
        "q": [[1.4**t * f for t in range(150)] for f in (1e285, -3e280, 1.0)],
    },
    "at rest on the ground": {"q": [[2.0] * 150, [0.1] * 150, [0.0] * 150]},
    "in an instant": {"dt": 1e-9, "q": bounces(150)},
    "for years": {"dt": 1e6, "q": bounces(150)},
}


def test_shows_any_trajectory(
    open_page: Open, file: Path, scene: dict[str, Any], tmp_path: Path
) -> None:
    for name, changes in TRAJECTORIES.items():
        data: dict[str, Any] = {**scene, "motion": None, **changes}
        other = tmp_path / "other.html"
        other.write_text(with_animation(file.read_text("utf-8"), data), "utf-8")
        page = open_page(other)
        page.pass_time(0, 0.5, 3, 20)
        last = len(data["q"][0]) - 1
        for t in {0, last // 2, last}:
            page.slide(t)
            assert page.find("column").text == f"{t} / {last}"
            x = pytest.approx(data["q"][0][t], rel=1e-6, abs=data["l"] / 1000)
            assert page.number("x") == x, name
            assert page.pixels("square") > 50, f"{name}: the square cannot be seen"
