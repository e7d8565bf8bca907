"""./build/bounce --play: the page on which a student throws the square, with a real pointer."""

from __future__ import annotations

import http.client
import re
import socket
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from animation_page import PATIENCE, Page, webdriver
from conftest import ROOT
from handed_out import SYSTEM, check, put, run
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select

pytestmark = pytest.mark.xdist_group("student")
TRUTH = """
const scene = given.scenes.find(({ name }) => name === arguments[0]);
const path = truth(scene.q, scene.v, { ...scene.params, dt: arguments[1] / 10, T: 201 });
return Array.from(Array(20), (_, i) => path.map((row) => row[10 * (i + 1)]));
"""
FAR = "return [q, paths[1]].map((path) => [path[0][T - 1], path[1][T - 1]])"


def plots_are_shown(page: Page) -> bool:
    return bool(page.find("plots").find_element("tag name", "svg").is_displayed())


def build(home: Path, *laid: str) -> None:
    put(home, *laid)
    built = run(home, "cmake", "--build", "build", "--target", "bounce")
    assert built.returncode == 0, built.stdout


@pytest.fixture
def address(home: Path) -> Iterator[str]:
    put(home)
    check(home, "--help")
    build(home)
    if not Path("/usr/include/httplib.h").exists():
        pytest.skip("cpp-httplib is not installed")
    command = ["build/bounce", "--play"]
    with subprocess.Popen(command, cwd=home, env=SYSTEM, stdout=-1, text=True) as server:
        assert server.stdout
        yield re.findall("http://[^ ]+", server.stdout.readline())[0]
        server.terminate()


@pytest.fixture
def page(driver: Any, address: str) -> Iterator[Page]:
    driver.get_log("browser")
    page = Page(driver)
    page.media()
    page.screen(1400, 900, 1)
    driver.get(address)
    page.wait_until(page.playing)
    yield page
    driver.get("about:blank")  # before the server ends
    assert driver.get_log("browser") == []


def test_only_its_own_page_on_this_machine_is_answered(address: str) -> None:
    url = urlsplit(address)

    def status(path: str, **headers: str) -> int:
        asked = http.client.HTTPConnection(url.netloc, timeout=PATIENCE)
        asked.request("GET", path, headers={"Host": url.netloc} | headers)
        return asked.getresponse().status

    own = f"http://{url.netloc}"
    assert status(url.path) == status(url.path, Origin=own) == status(f"{url.path}version") == 200
    for other in ("/", url.path[:-1], f"{url.path}main.cpp", f"{url.path}../main.cpp", "/version"):
        assert status(other) == 404, other
    for headers in ({"Host": "example.org"}, {"Origin": "http://example.org"}, {"Origin": "null"}):
        assert status(url.path, **headers) == 404, headers
    listening = re.findall(r": (\w+):(\w+) \w+:\w+ 0A", Path("/proc/net/tcp").read_text())
    assert [ip for ip, port in listening if int(port, 16) == url.port] == ["0100007F"]
    assert f"{url.port:04X}" not in Path("/proc/net/tcp6").read_text()


def test_requests_without_an_end_or_a_length_hold_nobody_up(address: str) -> None:
    url = urlsplit(address)
    half_sent = [socket.create_connection((url.hostname, url.port or 0)) for _ in range(60)]
    for connection in half_sent:
        connection.sendall(b"GET / HTTP/1.1\r\nHost:")
    asked = http.client.HTTPConnection(url.netloc, timeout=PATIENCE)
    asked.request("GET", url.path)
    assert asked.getresponse().status == 200
    for connection in half_sent:
        connection.close()
    for path in ("/", f"{url.path}simulate"):
        asked = http.client.HTTPConnection(url.netloc, timeout=PATIENCE)
        asked.putrequest("POST", path)
        asked.putheader("Transfer-Encoding", "chunked")
        asked.endheaders()
        assert asked.getresponse().status == 411, path


def test_the_square_is_dragged_thrown_and_compared(page: Page) -> None:
    script, stage = page.driver.execute_script, page.find("stage")
    script("setScene('tumble dt=0.001').then(() => seek(0))")
    page.wait_until(lambda: script("return T === 401 && !playing && position === 0"))
    x, y, width, height = script("return [...camera().to(...pose(0)), wide(), high()]")
    mouse = webdriver.ActionChains(page.driver, duration=30)
    from_middle = round(x - width / 2), round(y - height / 2)
    mouse.move_to_element_with_offset(stage, *from_middle).click_and_hold().perform()
    page.wait_until(lambda: not plots_are_shown(page))  # they would be those of the old throw
    for x, y in [(6, -3)] * 20 + [(20, -10)] * 6:
        mouse.move_by_offset(x, y)
    mouse.release().perform()
    page.wait_until(lambda: script("return thrown.vx > 0.1 && held === null && playing"))
    page.wait_until(lambda: script("return throws.then(() => T === 401)"))
    assert plots_are_shown(page)
    (x, y), true = script(FAR)
    assert (x, y) == pytest.approx(true, abs=0.1) and (x, y) != pytest.approx(true, abs=1e-6)


# What the solution gives, in the unit of the question.
@pytest.mark.parametrize(
    ("scene", "outcome"),
    [
        ("tumble epsilon=1", 124),
        ("tumble vy=-60", 22.9),
        ("rest mu=0", 3.02),
        ("flat_drop", 38.6),
        ("rest tilt=15", 34.6),
        ("tumble delta=0.000001", 1.82),
        ("tumble epsilon=0.9", 0.819),
    ],
)
def test_a_scene_asks_first_and_compares_afterwards(page: Page, scene: str, outcome: float) -> None:
    script = page.driver.execute_script
    asking = "return [...select.querySelectorAll('[data-ask]')].map(({ value }) => value)"
    values = script(asking)
    [value] = [value for value in values if value.startswith(scene)]
    Select(page.find("scene")).select_by_value(value)
    page.wait_until(lambda: script("return throws.then(() => thrown.seconds === (T - 1) * dt)"))
    assert not page.playing() and not plots_are_shown(page)
    page.find("predicted").send_keys("7", Keys.ENTER)
    page.wait_until(lambda: page.playing() and plots_are_shown(page))
    script("seek(T - 1)")
    told = page.find("happened").text
    predicted, own = re.findall(r"(?:predicted|gives) ([\d.]+) [%\w/]+\.", told)
    assert predicted == "7" and float(own) == pytest.approx(outcome, rel=0.01), told


def test_a_slope_is_drawn_with_gravity_straight_down(page: Page) -> None:
    script = page.driver.execute_script
    pull = "return [[0, 0], motion.g].map((point) => camera().to(...point))"
    page.wait_until(lambda: script("return throws.then(() => slope === 0)"))
    assert not page.find("gravity").is_displayed()
    script("setScene('rest tilt=15 dt=0.01 seconds=2')")
    page.wait_until(lambda: script("return throws.then(() => slope !== 0)"))
    (x, y), (x_g, y_g) = script(pull)
    assert page.find("gravity").is_displayed() and x_g == pytest.approx(x) and y_g > y + 9
    heights = script("return [0, T - 1].map((s) => camera().to(...pose(s))[1])")
    assert heights[0] < heights[1], "it moves down the slope"


def test_on_a_phone_stage_and_sliders_are_seen_together(page: Page) -> None:
    page.screen(390, 844, 2)
    sliders = page.find("settings").find_elements("css selector", "[type=range]")
    seen = "const { top, bottom } = arguments[0].getBoundingClientRect(); return [top, bottom]"
    for slider in sliders:
        page.driver.execute_script("arguments[0].scrollIntoView({ block: 'end' })", slider)
        for element in (page.find("stage"), slider):
            top, bottom = page.driver.execute_script(seen, element)
            assert 0 <= top < bottom <= 844.5
    assert page.driver.execute_script("return document.documentElement.scrollWidth") <= 390


# Rocks until it rests; magnifies what a corner sinks in a ten-millionth of a side.
LESS_EXACT = {"tilted_settling": 2e-4, "rocking": 1e-3, "ten_seconds": 0.1}


def test_the_true_motion_is_that_of_the_exact_simulation(page: Page) -> None:
    lines = (ROOT / "fixtures/study/truth.csv").read_text().splitlines()
    samples = [row.split(",") for row in lines if not row.startswith(("#", "scene,"))]
    for name in {row[0] for row in samples}:
        times, *exact = zip(*([float(x) for x in row[1:]] for row in samples if row[0] == name))
        path = page.driver.execute_script(TRUTH, name, times[0])
        within = LESS_EXACT.get(name, 2e-6)
        for row, other in zip(zip(*path), exact):
            assert row == pytest.approx(other, abs=within), name


def test_sliders_the_keyboard_and_models_change_the_same_throw(page: Page) -> None:
    script = page.driver.execute_script

    def farthest() -> float:
        [(number, unit)] = re.findall(r"and ([\d.]+) (m|mm) at most", page.find("errors").text)
        return float(number) / (1000 if unit == "mm" else 1)

    script("setScene('tumble dt=0.01')")
    page.wait_until(lambda: script("return T === 41"))
    coarse = farthest()
    script("settings.elements.dt.focus()")
    page.press(*[Keys.ARROW_LEFT] * 100)
    page.wait_until(lambda: script("return throws.then(() => T === 401)"))
    assert farthest() < coarse / 3
    assert "a model needs contact at one corner here" in page.find("errors").text
    Select(page.find("model")).select_by_value("3")
    assert script("return right === paths[3]")
    assert "the motion if nothing touched" in page.find("other").text
    script("document.activeElement.blur()")
    page.press("t")
    page.wait_until(page.playing)


def test_a_crash_and_a_hang_are_told_and_another_program_is_noticed(home: Path, page: Page) -> None:
    told_of: list[tuple[list[str], str]] = [
        (["broken/part3_null_pointer"], "with a segmentation fault: it followed a null pointer"),
        (
            ["broken/part4_counter_stands_still"],
            "used more than 3 s of CPU time: possibly an infinite loop",
        ),
        (["stub 4"], "please fill in src/part4_simulate.cpp"),
        ([], "this is the same throw with the new one"),
    ]
    for laid, told in told_of:
        build(home, *laid)
        page.wait_until(lambda: told in page.find("status").text, 4 * PATIENCE)
