"""The student's page in a real browser: matrices, pictures and the chart, on a desktop, on a phone
and in dark mode; and that it shows no answer of a hidden case unless asked."""

from __future__ import annotations

import copy
import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import cli
from bounce_grader.assignment import picture
from bounce_grader.formats import html
from bounce_grader.grading import fixtures
from bounce_grader.grading.record import with_answers, without_answers
from conftest import ROOT, solution_files, write

By = pytest.importorskip("selenium.webdriver.common.by", reason="selenium is not installed").By

MISTAKES = ROOT / "tests" / "submissions" / "mistakes"
WRONG = {
    "part1": "part1_sign_of_the_normal_arm",
    "part2": "part2_mass_in_place_of_its_inverse",
    "part3": "part3_friction_sign",
    "part4": "part4_steps_with_the_first_velocity",
}
HOSTILE = (
    "</title><script>document.title = 'owned'</script><img src=x onerror=\"document.title='x'\">"
)


def graded(tmp: Path, *mistakes: str, options: tuple[str, ...] = ()) -> dict[str, Any]:
    files = solution_files()
    for mistake in mistakes:
        files |= {f.name: f.read_bytes() for f in (MISTAKES / mistake).glob("*.cpp")}
    folder, out = write(tmp / "submission", files), tmp / "record.json"
    assert cli.main(["grade", str(folder), "--json", str(out), *options]) == 0
    record: dict[str, Any] = json.loads(out.read_text())
    return record


@pytest.fixture(scope="module")
def record(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """A mistake in each part, and the solution's curve."""
    wrong = graded(tmp_path_factory.mktemp("wrong"), *WRONG.values())
    right = graded(tmp_path_factory.mktemp("right"), options=("--speed",))
    return {**wrong, "speed": right["speed"]}


Show = Callable[..., Any]


@pytest.fixture
def show(driver: Any, tmp_path: Path) -> Iterator[Show]:
    """Opens the page of a record in a window of this width."""

    def shown(record: dict[str, Any], width: int = 1000, scheme: str = "light") -> Any:
        page = tmp_path / "page.html"
        page.write_text(html.render(record, "doejane"), "utf-8")
        size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        driver.get(page.as_uri())
        return driver

    yield shown
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []


def check_of(record: dict[str, Any], id: str) -> dict[str, Any]:
    return next(c for part in record["parts"] for c in part["checks"] if c["id"] == id)


def test_the_numbers_follow_the_published_schema(
    record: dict[str, Any], secret: dict[str, Any]
) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((ROOT / "docs" / "record.schema.json").read_text())
    for one in (record, *secret.values()):
        jsonschema.validate(one, schema)
    assert sum("shown" in c for part in record["parts"] for c in part["checks"]) > 10


# ---- what is shown ----


def test_wrong_entries_are_boxed_and_the_right_ones_beside_them(
    show: Show, record: dict[str, Any]
) -> None:
    page = show(record)
    case = page.find_element(By.XPATH, "//li[contains(., 'the second column of J is J_n')]")
    yours, right = case.find_elements(By.TAG_NAME, "table")
    assert "boxed where wrong" in yours.text and right.text.startswith("right")
    wrong = yours.find_elements(By.CLASS_NAME, "wrong")
    assert len(wrong) == 1 and right.find_elements(By.CLASS_NAME, "wrong") == []
    number = wrong[0].text.split()[-1].replace("\N{MINUS SIGN}", "-")
    shown = check_of(record, "part1.GivesTheNormalColumn")["shown"]["quantities"][0]
    assert float(number) == pytest.approx(shown["got"][2][0], rel=1e-5)
    assert shown["right"] == [[True], [True], [False]]
    border = "return getComputedStyle(arguments[0]).borderTopWidth"
    assert page.execute_script(border, wrong[0]) == "2px"
    assert yours.find_elements(By.CLASS_NAME, "unit")[0].text == "m"


def test_a_step_is_drawn_with_its_velocity_and_force(show: Show, record: dict[str, Any]) -> None:
    page = show(record)
    check = check_of(record, "part3.BouncesAndSlides")
    assert check["shown"]["contact"].startswith("corner ")
    case = page.find_element(By.XPATH, f"//li[contains(., '{check['title']}')]")
    assert "touches and slides to the " in case.text
    figures = case.find_elements(By.TAG_NAME, "figure")
    captions = case.find_elements(By.TAG_NAME, "figcaption")
    assert [caption.text.split("\n")[0] for caption in captions] == ["yours", "right"]
    for figure in figures:
        assert "force of the ground f = (" in figure.text
        labels = [text.text for text in figure.find_elements(By.TAG_NAME, "text")]
        assert labels == ["v\N{PRIME}", picture.OMEGA, "f"]


def test_a_trajectory_is_drawn_beside_the_right_one(show: Show, record: dict[str, Any]) -> None:
    page = show(record)
    shown = check_of(record, "part4.StepsFromTheColumnBefore")["shown"]
    title = check_of(record, "part4.StepsFromTheColumnBefore")["title"]
    case = page.find_element(By.XPATH, f"//li[contains(., '{title}')]")
    drawing = case.find_element(By.TAG_NAME, "svg")
    first = shown["path"]["first"]
    assert first > 0 and f"column {first} is wrong" in drawing.get_attribute("aria-label")
    fills = [c.get_attribute("fill") for c in drawing.find_elements(By.TAG_NAME, "circle")]
    assert set(fills) == {"none", "currentColor"}


def test_the_chart_stands_on_the_page_with_what_it_means(
    show: Show, record: dict[str, Any]
) -> None:
    page = show(record)
    chart = page.find_element(By.CSS_SELECTOR, ".chart svg")
    assert chart.size["width"] > 400
    assert "of the exact motion from dt = " in page.find_element(By.TAG_NAME, "body").text
    page.find_element(By.CSS_SELECTOR, "details:has(.charts) > summary").click()
    charts = page.find_elements(By.CSS_SELECTOR, ".charts svg")
    assert len(charts) == len(record["speed"]["scenes"]) and charts[0].is_displayed()


# ---- wherever it is read ----


@pytest.mark.parametrize("width", [360, 1000])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_it_fits_the_screen_and_can_be_read_there(
    show: Show, record: dict[str, Any], width: int, scheme: str
) -> None:
    page = show(record, width, scheme)
    run = page.execute_script
    content = run("const e = document.documentElement; return [e.scrollWidth, e.clientWidth]")
    assert content[0] <= content[1]
    run("document.querySelectorAll('details').forEach((d) => (d.open = true))")
    outside = run(
        """return [...document.querySelectorAll('svg text')].filter((t) => {
        const a = t.getBoundingClientRect(), b = t.ownerSVGElement.getBoundingClientRect();
        return a.left < b.left - 1 || a.right > b.right + 1 || a.bottom > b.bottom + 1;
    }).map((t) => t.textContent)"""
    )
    assert outside == []
    colours = "const s = getComputedStyle(document.body); return [s.color, s.backgroundColor]"
    ink, paper = (sum(map(int, re.findall(r"\d+", c)[:3])) for c in run(colours))
    assert abs(ink - paper) > 500 and (ink > paper) == (scheme == "dark")


def test_what_a_submission_says_is_text(show: Show, record: dict[str, Any]) -> None:
    wild = copy.deepcopy(record)
    for part in wild["parts"]:
        part["message"] = HOSTILE
        for check in part["checks"]:
            check["message"] = HOSTILE
            if "shown" in check:
                check["shown"] |= dict.fromkeys(("sentence", "name", "input", "contact"), HOSTILE)
    wild["speed"]["cut"] = HOSTILE
    page = show(wild)
    assert page.title == "Bouncing: your points"
    assert page.find_elements(By.CSS_SELECTOR, "script, img") == []


# ---- hidden cases ----


@pytest.fixture(scope="module")
def secret(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """A part that is right for the angles of the public cases, and wrong only on a hidden one."""
    public = (fixtures.PUBLIC / "part1_contacts.json").read_text()
    angles = [c["input"]["q"][2] for cs in json.loads(public)["checks"].values() for c in cs]
    known = " || ".join(f"q(2) == {angle!r}" for angle in angles)
    part1 = solution_files()["part1_contacts.cpp"].decode().replace("get_contacts(", "honest(")
    part1 += f"""namespace bounce {{ Contact get_contacts(const Vector3& q, const Parameters& p) {{
        Contact c = honest(q, p); if (!({known})) c.phi += 0.25; return c; }} }}"""
    files = {**solution_files(), "part1_contacts.cpp": part1.encode()}
    folder = write(tmp_path_factory.mktemp("secret") / "submission", files)
    records = {}
    options: tuple[str, ...]
    for name, options in (("closed", ()), ("open", ("--reveal",))):
        out = folder.parent / f"{name}.json"
        assert cli.main(["grade", str(folder), "--json", str(out), *options]) == 0
        records[name] = json.loads(out.read_text())
    return records


def expected_phi(check: dict[str, Any]) -> float:
    got: float = check["shown"]["quantities"][0]["got"][0][0]
    return got - 0.25


def test_the_answer_of_a_hidden_case_is_shown_where_that_is_asked_for(
    secret: dict[str, Any],
) -> None:
    closed, opened = (
        check_of(secret[name], "part1.MeasuresTheHeightOfTheLowestCorner")
        for name in ("closed", "open")
    )
    assert "(a hidden case)" in closed["message"]
    assert "expected is not shown" in closed["message"] and "contact" not in closed["shown"]
    quantity = opened["shown"]["quantities"][0]
    assert quantity["expected"][0][0] == pytest.approx(expected_phi(closed), abs=1e-9)
    assert f"expected phi = {quantity['expected'][0][0]:.6g}"[:20] in opened["message"]
    assert "corner" in opened["shown"]["contact"]


def test_and_nowhere_else(secret: dict[str, Any]) -> None:
    closed = secret["closed"]
    text = json.dumps(closed) + html.render(closed)
    for part in closed["parts"]:
        for check in part["checks"]:
            assert "revealed" not in check
            for quantity in check.get("shown", {}).get("quantities", []):
                assert "expected" not in quantity
    check = check_of(closed, "part1.MeasuresTheHeightOfTheLowestCorner")
    assert f"{expected_phi(check):.6g}" not in text
    assert "what is right isn't shown" in html.render(closed).replace("&#x27;", "'")


def test_a_record_is_opened_and_closed_without_a_trace() -> None:
    hidden: dict[str, Any] = {"name": "x", "input": "", "sentence": "", "quantities": []}
    check: dict[str, Any] = {"id": "part1.X", "message": "closed", "shown": hidden}
    kept = {**check, "revealed": {"message": "open", "shown": {**hidden, "contact": "answer"}}}
    record = {"parts": [{"checks": [kept]}]}
    assert without_answers(record) == {"parts": [{"checks": [check]}]}
    opened = with_answers(record)["parts"][0]["checks"][0]
    assert opened == {**check, "message": "open", "shown": {**hidden, "contact": "answer"}}
    assert record["parts"][0]["checks"][0] is kept


# ---- odd numbers ----


@pytest.mark.parametrize("odd", [["nan"], ["inf"], [1e300], [-1e300], [0.0], [1e-300]])
def test_a_picture_can_be_drawn_of_any_numbers(odd: list[Any]) -> None:
    scene: dict[str, Any] = {"l": 0.2, "m": 0.3, "g": [0.0, -9.81, 0.0], "dt": 0.01, "delta": 0.001}
    scene |= {"q": [0.0, 0.1, 0.0], "v": [1.0, 0.0, 0.0]}
    quantity = {"name": picture.VELOCITY, "unit": "", "got": [odd] * 3, "right": [[False]] * 3}
    path = {"first": 1, "got": [odd * 3, [0.0, 1.0, 0.0], odd * 3]}
    step = picture.figures_of({"scene": scene, "quantities": [quantity]})
    way = picture.figures_of({"scene": scene, "quantities": [], "path": path})
    assert (len(step), len(way)) == (1, 1)
    for figure in (*step, *way):
        for text in re.findall(r' d="([^"]*)"', figure.drawing):
            assert re.fullmatch(r"[MLAZ\d .-]*", text), text
            numbers = [abs(float(number)) for number in re.findall(r"-?[\d.]+", text)]
            assert max(numbers) <= picture.FAR
