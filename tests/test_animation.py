"""The given animation in a real browser: what a reader of the page sees and can do.

Most tests hand the page a clock of their own, so that no fact depends on how fast the machine is.
"""

from __future__ import annotations

import json
import math
import os
import re
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterator

import pytest

webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed")
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select
from selenium.webdriver.support.wait import WebDriverWait

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = Path(os.environ.get("BOUNCE_BUILD", ROOT / "build/kit")) / "animation"
BROWSER, DRIVER = Path("/usr/bin/chromium"), Path("/usr/bin/chromedriver")
FLAGS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-sync
    --disable-background-networking --disable-component-update --disable-dev-shm-usage""".split()
DATA = re.compile(r"(?<=const animation = ).*(?=;\n)")
PATIENCE = 30  # s, for what a busy machine may delay
REST = 0.8  # s that the last column stays before the loop starts again

# Frames come when a test lets time pass, and at no other time.
CLOCK = """
let now = 0, handle = 0, waiting = new Map();
window.requestAnimationFrame = (f) => (waiting.set(++handle, f), handle);
window.cancelAnimationFrame = (h) => waiting.delete(h);
window.passTime = (ms) => {
  const due = waiting;
  waiting = new Map();
  now += ms;
  due.forEach((f) => f(now));
};
"""
COUNT_PIXELS = """
const stage = document.getElementById(arguments[1]);
const hex = getComputedStyle(document.documentElement).getPropertyValue("--" + arguments[0]).trim();
const want = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
const copy = new OffscreenCanvas(stage.width, stage.height);
const ctx = copy.getContext("2d", { willReadFrequently: true });
ctx.drawImage(stage, 0, 0);
const d = ctx.getImageData(0, 0, stage.width, stage.height).data;
let count = 0;
for (let i = 0; i < d.length; i += 4) {
  if (d[i + 3] > 250 && want.every((w, j) => Math.abs(d[i + j] - w) < 12)) ++count;
}
return count;
"""
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


@dataclass
class Page:
    """The page as its reader meets it: text, controls, keys, and the picture's pixels."""

    driver: Any

    def find(self, id_: str) -> Any:
        return self.driver.find_element(By.ID, id_)

    def number(self, id_: str) -> float:
        return float(self.find(id_).text.replace("\N{MINUS SIGN}", "-"))

    def column(self) -> int:
        return int(self.find("column").text.split("/")[0])

    def playing(self) -> bool:
        return {"Pause": True, "Play": False}[self.find("play").accessible_name]

    def press(self, *keys: str) -> None:
        for key in keys:
            webdriver.ActionChains(self.driver).send_keys(key).perform()

    def pass_time(self, *seconds: float) -> None:
        for s in seconds:
            self.driver.execute_script("passTime(arguments[0])", 1000 * s)

    def slide(self, t: int) -> None:
        self.driver.execute_script(
            "arguments[0].value = arguments[1]; arguments[0].dispatchEvent(new Event('input'))",
            self.find("slider"),
            t,
        )

    def choose(self, speed: str) -> None:
        Select(self.find("speed")).select_by_value(speed)

    def pixels(self, colour: str, canvas: str = "stage") -> int:
        return int(self.driver.execute_script(COUNT_PIXELS, colour, canvas))

    def point_at_plots(self, share: float) -> None:
        """Presses on the plots, at this share of their time from the left."""
        run = self.driver.execute_script
        first, last = run("return [timeX(0), timeX(T - 1)]")
        plots = self.find("plots")
        from_middle = first + share * (last - first) - plots.size["width"] / 2
        run("arguments[0].scrollIntoView({block: 'center'})", plots)
        actions = webdriver.ActionChains(self.driver)
        actions.move_to_element_with_offset(plots, round(from_middle), 0).click().perform()

    def media(self, **features: str) -> None:
        named = [{"name": k.replace("_", "-"), "value": v} for k, v in features.items()]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": named})

    def screen(self, width: int, height: int, ratio: int) -> None:
        size = {"width": width, "height": height, "deviceScaleFactor": ratio, "mobile": False}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)

    def wait_until(self, true: Callable[[], bool]) -> None:
        WebDriverWait(self.driver, PATIENCE, poll_frequency=0.05).until(lambda _: true())


Open = Callable[..., Page]


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    for program in (BROWSER, DRIVER):
        if not program.exists():
            pytest.skip(f"{program} is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = str(BROWSER)
    for flag in [*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('browser')}"]:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    browser = webdriver.Chrome(service=Service(str(DRIVER)), options=options)
    yield browser
    browser.quit()


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of the assignment's scene, as the built program writes it."""
    assert PROGRAM.exists(), f"{PROGRAM} is not built"
    page = tmp_path_factory.mktemp("page") / "animation.html"
    subprocess.run([PROGRAM, page], check=True, capture_output=True, timeout=PATIENCE)
    return page


@pytest.fixture(scope="module")
def scene(file: Path) -> dict[str, Any]:
    data: dict[str, Any] = json.loads(DATA.findall(file.read_text("utf-8"))[0])
    return data


@pytest.fixture(scope="module")
def compared(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of a stored scene, where the square leaves the right way at column 12."""
    page = tmp_path_factory.mktemp("compared") / "animation.html"
    command = [str(PROGRAM), "--compare", str(page)]
    subprocess.run(command, check=True, capture_output=True, timeout=PATIENCE)
    text = page.read_text("utf-8")
    data = json.loads(DATA.findall(text)[0])
    for row in data["q"][:2]:
        row[12:] = [x + 0.01 * (t + 1) for t, x in enumerate(row[12:])]
    page.write_text(DATA.sub(json.dumps(data), text, count=1), "utf-8")
    return page


@pytest.fixture
def open_page(driver: Any, file: Path) -> Iterator[Open]:
    """Opens a page from disk; at the end nothing may stand on the browser's console."""
    page = Page(driver)
    driver.get_log("browser")
    page.media()
    page.screen(1000, 800, 1)
    clocks = []

    def open_(path: Path = file, own_clock: bool = True) -> Page:
        if own_clock:
            add = "Page.addScriptToEvaluateOnNewDocument"
            clocks.append(driver.execute_cdp_cmd(add, {"source": CLOCK}))
        driver.get(path.as_uri())
        page.wait_until(lambda: page.find("stage").get_dom_attribute("width") is not None)
        return page

    yield open_
    for clock in clocks:
        driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", clock)
    assert driver.get_log("browser") == []


def lowest_corner(scene: dict[str, Any], t: int) -> float:
    """phi of column t, eqs. (3) and (4)."""
    theta = scene["q"][2][t]
    arms = (math.sin(theta + math.pi / 4 + k * math.pi / 2) for k in range(4))
    return float(scene["q"][1][t] + scene["l"] / math.sqrt(2) * min(arms))


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


# ---- what is shown ----


@pytest.mark.parametrize("t", [0, 1, 75, 149])
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
    grown = [b - a for a, b in zip(counts, counts[1:])]
    assert min(grown) > 20, counts


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
