"""The student's page in a real browser: it fits a desktop and a phone, by day and in the dark, and
what a submission says is only text there."""

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.formats import html
from test_reports import RECORDS

By = pytest.importorskip("selenium.webdriver.common.by", reason="selenium is not installed").By
Show = Callable[..., Any]


@pytest.fixture
def show(driver: Any, tmp_path: Path) -> Iterator[Show]:
    """Opens the page of a record in a window of this width, with each <details> open."""

    def shown(name: str, width: int = 1000, scheme: str = "light") -> Any:
        page = tmp_path / "page.html"
        page.write_text(html.render(RECORDS[name], "doejane"), "utf-8")
        size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        driver.get(page.as_uri())
        driver.execute_script("document.querySelectorAll('details').forEach(d => d.open = true)")
        return driver

    yield shown
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []


OUTSIDE = """return [...document.querySelectorAll('svg text')].filter((t) => {
    const a = t.getBoundingClientRect(), b = t.ownerSVGElement.getBoundingClientRect();
    return a.left < b.left - 1 || a.right > b.right + 1 || a.bottom > b.bottom + 1;
}).map((t) => t.textContent)"""


@pytest.mark.parametrize("width", [360, 1000])
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("name", ["mistakes", "hostile"])
def test_it_fits_the_screen_and_can_be_read_there(
    show: Show, name: str, width: int, scheme: str
) -> None:
    page = show(name, width, scheme)
    run = page.execute_script
    content = run("const e = document.documentElement; return [e.scrollWidth, e.clientWidth]")
    assert content[0] <= content[1]
    assert run(OUTSIDE) == []
    colours = "const s = getComputedStyle(document.body); return [s.color, s.backgroundColor]"
    ink, paper = (sum(map(int, re.findall(r"\d+", c)[:3])) for c in run(colours))
    assert abs(ink - paper) > 500 and (ink > paper) == (scheme == "dark")


def test_pictures_charts_and_the_boxes_around_wrong_numbers_are_seen(show: Show) -> None:
    page = show("mistakes")
    drawings = page.find_elements(By.CSS_SELECTOR, "figure svg")
    assert len(drawings) > 5 and all(drawing.size["width"] > 200 for drawing in drawings)
    border = "return getComputedStyle(arguments[0]).borderTopWidth"
    wrong = page.find_elements(By.CSS_SELECTOR, "td.wrong")
    assert wrong and {page.execute_script(border, entry) for entry in wrong} == {"2px"}


def test_what_a_submission_says_is_text(show: Show) -> None:
    page = show("hostile")
    assert page.title == "Bouncing: your points"
    assert page.find_elements(By.CSS_SELECTOR, "script, img") == []
