"""The given animation in a real browser: what a reader of the page can do with it."""

from __future__ import annotations

import json
import math
import subprocess
from pathlib import Path
from typing import Any

import pytest
from animation_page import DATA, PATIENCE, PROGRAM, Open, file, open_page, scene
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


# ---- the program ----


def test_the_program_says_where_the_page_is(tmp_path: Path) -> None:
    run = subprocess.run([PROGRAM], cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE)
    assert (run.returncode, run.stderr) == (0, "")
    page = tmp_path / "animation.html"
    assert run.stdout == f"The animation is in {page}; open it in a browser.\n"
    assert list(tmp_path.iterdir()) == [page]


def test_the_program_says_in_one_sentence_what_went_wrong(tmp_path: Path) -> None:
    page = tmp_path / "missing/animation.html"
    run = subprocess.run([PROGRAM, page], capture_output=True, text=True, timeout=PATIENCE)
    assert (run.returncode, run.stdout) == (1, "")
    assert run.stderr.startswith(f"No animation was written: cannot write {page}: ")
    assert run.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "words", ["dt=0.001", "page", "--compar", "a.html b.html", "--compare dt=0.001", "--worked 2"]
)
def test_the_program_refuses_what_it_does_not_understand(tmp_path: Path, words: str) -> None:
    run = subprocess.run(
        [PROGRAM, *words.split()], cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE
    )
    assert (run.returncode, run.stdout, list(tmp_path.iterdir())) == (2, "", [])
    assert run.stderr.startswith(f"bounce: {words.split()[-1]} is not understood; there are:\n")


# ---- time ----


def test_plays_by_itself_and_stands_when_paused(open_page: Open) -> None:
    page = open_page(own_clock=False)
    assert page.playing()
    first = page.number("time")
    page.wait_until(lambda: page.number("time") != first)
    page.find("play").click()
    assert not page.playing()
    stands = page.number("time")
    page.driver.execute_async_script(AFTER_FIVE_FRAMES)
    assert page.number("time") == stands


def test_asks_the_network_for_nothing(open_page: Open, driver: Any, file: Path) -> None:
    driver.get_log("performance")
    open_page().pass_time(0, 0.5)
    events = [json.loads(entry["message"])["message"] for entry in driver.get_log("performance")]
    sent = [e["params"]["request"]["url"] for e in events if e["method"].endswith("WillBeSent")]
    assert {url for url in sent if not url.startswith("data:")} == {file.as_uri()}


@pytest.mark.parametrize("frames", [[0.5], [0.05] * 10, [0.4, 0.001, 0.099]])
def test_moves_on_by_time_and_not_by_frames(open_page: Open, frames: list[float]) -> None:
    page = open_page()
    page.pass_time(0, *frames)
    assert page.number("time") == pytest.approx(0.5, abs=0.011)


@pytest.mark.parametrize("speed", ["0.125", "0.25", "0.5", "1", "2"])
def test_speed_changes_the_rate(open_page: Open, speed: str) -> None:
    page = open_page()
    page.choose(speed)
    page.pass_time(0, 0.6)
    assert page.number("time") == pytest.approx(0.6 * float(speed), abs=0.011)


def test_can_show_the_whole_in_ten_seconds(open_page: Open) -> None:
    page = open_page()
    page.choose("fit")
    page.pass_time(0, 5)
    assert page.column() == pytest.approx(149 / 2, abs=1)
    page.pass_time(5)
    assert page.column() == 149


def test_loops_for_ever(open_page: Open, scene: dict[str, Any]) -> None:
    page = open_page()
    last = len(scene["q"][0]) - 1
    loop = last * scene["dt"] + REST
    page.pass_time(0, loop - REST / 2)
    assert page.column() == last
    page.pass_time(REST / 2 + 0.2)
    assert page.column() == pytest.approx(20, abs=1)
    page.pass_time(1000 * loop)
    assert page.column() == pytest.approx(20, abs=1)
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


def test_obeys_the_keyboard(open_page: Open) -> None:
    page = open_page()
    page.press(Keys.SPACE)
    assert not page.playing()
    page.press(Keys.END)
    assert page.column() == 149
    page.press(Keys.ARROW_RIGHT)
    assert page.column() == 149
    page.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT, Keys.ARROW_RIGHT)
    assert page.column() == 148
    page.press(Keys.HOME)
    assert page.column() == 0
    page.press(Keys.SPACE)
    assert page.playing()


def test_leaves_a_control_the_keys_that_it_answers(open_page: Open) -> None:
    page = open_page()
    page.press(Keys.TAB, Keys.SPACE)  # on the button a space is a click, and no more than one
    assert not page.playing()
    page.press(Keys.TAB, Keys.HOME, Keys.ARROW_RIGHT)  # on the slider
    assert page.column() == 1
    page.press(Keys.SPACE, Keys.SPACE)
    assert (page.playing(), page.column()) == (False, 1)
    page.press(Keys.TAB, Keys.ARROW_DOWN)  # on the choice of speed
    assert page.find("speed").get_attribute("value") == "2"
    assert page.column() == 1


def test_names_every_control(open_page: Open) -> None:
    page = open_page()
    named = {id_: page.find(id_).accessible_name for id_ in ["play", "slider", "speed", "stage"]}
    assert named["play"] == "Pause"
    assert named["slider"] == "Time step"
    assert named["speed"].startswith("Speed")
    assert "square" in named["stage"]
    page.slide(75)
    said = page.find("slider").get_attribute("aria-valuetext")
    assert said == "step 75 of 149, 0.75 seconds"


@pytest.mark.parametrize("size", [(360, 640, 3), (670, 500, 1), (844, 390, 2), (1600, 1000, 1)])
def test_fits_the_screen_in_full_sharpness(open_page: Open, size: tuple[int, int, int]) -> None:
    page = open_page()
    page.screen(*size)
    run = page.driver.execute_script
    page.wait_until(lambda: bool(run(IS_SHARP, *size)))
    run("document.getElementById('contact').hidden = false")
    assert page.find("plots").size["height"] >= 200
    content, room = run("const e = document.documentElement; return [e.scrollWidth, e.clientWidth]")
    assert content <= room


def test_takes_the_colours_of_a_dark_room(open_page: Open) -> None:
    page = open_page()
    light = page.driver.execute_script("return getComputedStyle(document.body).backgroundColor")
    page.media(prefers_color_scheme="dark")
    page.wait_until(lambda: page.pixels("square") > 50)  # the dark scheme's blue
    dark = page.driver.execute_script("return getComputedStyle(document.body).backgroundColor")
    assert dark != light


# ---- any trajectory ----


def bounces(T: int, x_0: float = 0, v: float = 0.6, y: float = 1.5) -> list[list[float]]:
    steps = range(T)
    heights = [abs(y * math.cos(t / 40)) + 0.2 for t in steps]
    return [[x_0 + v * t / 100 for t in steps], heights, [t / 25 for t in steps]]


TRAJECTORIES: dict[str, dict[str, Any]] = {
    "one column": {"q": bounces(1)},
    "two columns": {"q": bounces(2)},
    "20000 columns": {"q": bounces(20000)},
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


@pytest.mark.parametrize("name", TRAJECTORIES)
@pytest.mark.usual(2)
def test_shows_any_trajectory(
    open_page: Open, file: Path, scene: dict[str, Any], tmp_path: Path, name: str
) -> None:
    data: dict[str, Any] = {**scene, "motion": None, **TRAJECTORIES[name]}
    other = tmp_path / "other.html"
    other.write_text(DATA.sub(json.dumps(data), file.read_text("utf-8"), count=1), "utf-8")
    page = open_page(other)
    page.pass_time(0, 0.5, 3, 20)
    last = len(data["q"][0]) - 1
    for t in {0, last // 2, last}:
        page.slide(t)
        assert page.find("column").text == f"{t} / {last}"
        assert page.number("x") == pytest.approx(data["q"][0][t], rel=1e-6, abs=data["l"] / 1000)
        assert page.pixels("square") > 50, "the square cannot be seen"
