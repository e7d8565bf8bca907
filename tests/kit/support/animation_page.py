"""The given animation as its reader meets it. Who tests it imports these fixtures by name. The
page gets a clock of the test's, so that no fact depends on how fast the machine is."""

from __future__ import annotations

import json
import os
import re
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

webdriver = pytest.importorskip("selenium.webdriver", reason="selenium is not installed")
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.select import Select
from selenium.webdriver.support.wait import WebDriverWait

PROGRAM = Path(os.environ.get("BOUNCE_BUILD", ROOT / "build/kit")) / "animation"
BROWSER, DRIVER = Path("/usr/bin/chromium"), Path("/usr/bin/chromedriver")
FLAGS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-sync
    --disable-background-networking --disable-component-update --disable-dev-shm-usage""".split()
DATA = re.compile(r"(?<=const animation = ).*(?=;\n)")
PATIENCE = 30  # s, for what a busy machine may delay

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
const [colour, shot, done] = arguments;
const hex = getComputedStyle(document.documentElement).getPropertyValue("--" + colour).trim();
const want = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
const image = new Image();
image.onload = () => {
  const ctx = new OffscreenCanvas(image.width, image.height).getContext("2d");
  ctx.drawImage(image, 0, 0);
  const d = ctx.getImageData(0, 0, image.width, image.height).data;
  let count = 0;
  for (let i = 0; i < d.length; i += 4) {
    if (want.every((w, j) => Math.abs(d[i + j] - w) < 12)) ++count;
  }
  done(count);
};
image.src = "data:image/png;base64," + shot;
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

    def pixels(self, colour: str) -> int:
        shot = self.find("stage").screenshot_as_base64
        return int(self.driver.execute_async_script(COUNT_PIXELS, colour, shot))

    def point_at_plots(self, share: float) -> None:
        """Presses on the first plot, at this share of its time from the left."""
        run = self.driver.execute_script
        first, last = run("return [0, (T - 1) * dt].map(plotted[0].field.x.at)")
        plot = self.find("plots").find_element(By.TAG_NAME, "svg")
        from_middle = first + share * (last - first) - plot.size["width"] / 2
        run("arguments[0].scrollIntoView({block: 'center'})", plot)
        actions = webdriver.ActionChains(self.driver)
        actions.move_to_element_with_offset(plot, round(from_middle), 0).click().perform()

    def media(self, **features: str) -> None:
        named = [{"name": k.replace("_", "-"), "value": v} for k, v in features.items()]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": named})

    def screen(self, width: int, height: int, ratio: int) -> None:
        size = {"width": width, "height": height, "deviceScaleFactor": ratio, "mobile": False}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)

    def wait_until(self, true: Callable[[], bool], patience: float = PATIENCE) -> None:
        WebDriverWait(self.driver, patience, poll_frequency=0.05).until(lambda _: true())


Open = Callable[..., Page]


def written(folder: Path) -> Path:
    """The page of the assignment's scene, as the built program writes it."""
    assert PROGRAM.exists(), f"{PROGRAM} is not built"
    command = [str(PROGRAM)]
    subprocess.run(command, cwd=folder, check=True, capture_output=True, timeout=PATIENCE)
    return folder / "animation.html"


def animation(text: str) -> dict[str, Any]:
    """What a page's script draws."""
    return dict(json.loads(DATA.findall(text)[0]))


def with_animation(text: str, data: dict[str, Any]) -> str:
    return DATA.sub(json.dumps(data), text, count=1)


@contextmanager
def started(profile: Path) -> Iterator[Any]:
    """Chromium without a window, which keeps what pages say on the console. Where it is missing, its
    tests are skipped."""
    for program in (BROWSER, DRIVER):
        if not program.exists():
            pytest.skip(f"{program} is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = str(BROWSER)
    for flag in [*FLAGS, f"--user-data-dir={profile}"]:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service(str(DRIVER)), options=options)
    yield browser
    browser.quit()


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("page"))


@pytest.fixture(scope="module")
def scene(file: Path) -> dict[str, Any]:
    return animation(file.read_text("utf-8"))


@pytest.fixture
def open_page(driver: Any, file: Path) -> Iterator[Open]:
    """Opens a page from disk; at the end nothing may stand on the browser's console."""
    page = Page(driver)
    driver.get_log("browser")
    page.media()
    page.screen(1000, 800, 1)
    clock = driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": CLOCK})

    def open_(path: Path = file) -> Page:
        driver.get(path.as_uri())
        page.wait_until(lambda: page.find("column").text != "")
        return page

    yield open_
    driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", clock)
    assert driver.get_log("browser") == []
