"""The student's page in a real browser: it fits a desktop and a phone, by day and in the dark, and
what a submission says is only text there."""

import re
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.formats import html
from test_reports import RECORDS

By = pytest.importorskip("selenium.webdriver.common.by", reason="selenium is not installed").By
pytestmark = pytest.mark.xdist_group("browser")
OUTSIDE = """return [...document.querySelectorAll('svg text')].filter((t) => {
    const a = t.getBoundingClientRect(), b = t.ownerSVGElement.getBoundingClientRect();
    return a.left < b.left - 1 || a.right > b.right + 1 || a.bottom > b.bottom + 1;
}).map((t) => t.textContent)"""
WIDTHS = "const e = document.documentElement; return [e.scrollWidth, e.clientWidth]"
COLOURS = "const s = getComputedStyle(document.body); return [s.color, s.backgroundColor]"


@pytest.mark.parametrize("name", ["mistakes", "hostile"])
def test_it_fits_the_screen_and_can_be_read_there(driver: Any, tmp_path: Path, name: str) -> None:
    page = tmp_path / "page.html"
    page.write_text(html.render(RECORDS[name], "doejane"), "utf-8")
    run = driver.execute_script
    for width, scheme in ((360, "light"), (360, "dark"), (1000, "light"), (1000, "dark")):
        size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        driver.get(page.as_uri())
        run("document.querySelectorAll('details').forEach(d => d.open = true)")
        content, window = run(WIDTHS)
        assert content <= window and run(OUTSIDE) == []
        ink, paper = (sum(map(int, re.findall(r"\d+", c)[:3])) for c in run(COLOURS))
        assert abs(ink - paper) > 500 and (ink > paper) == (scheme == "dark")
    assert driver.title == "Bouncing: your points"
    assert driver.find_elements(By.CSS_SELECTOR, "script, img") == []
    if name == "mistakes":
        assert driver.find_element(By.CSS_SELECTOR, "figure svg").size["width"] > 500
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []
