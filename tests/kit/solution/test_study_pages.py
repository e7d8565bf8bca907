"""The study's charts and pages: they say what its tables hold."""

import math
import re

import pytest

from bounce_grader.common.paths import ROOT
from bounce_study import analytic, chart_speed, charts, look, pages, placing, runs, tables, words
from bounce_study.run import QUESTIONS
from studies import SCENES, STUDIES, committed


# --- charts ---


@pytest.mark.long
def test_the_committed_charts_are_drawn_from_the_committed_tables() -> None:
    import matplotlib

    if matplotlib.__version__ != "3.6.3":
        pytest.skip("the committed charts are drawn by Debian 12's matplotlib")
    for name, svg in charts.draw(committed()).items():
        assert svg == (STUDIES / name).read_bytes(), name


def test_no_two_methods_look_alike_in_grey() -> None:
    styles = [*look.METHODS.values(), *look.PEERS.values(), look.style("one", ["one"])]
    marks = [style.marker for style in styles]
    assert len(set(marks)) == len(marks)
    assert all(look.is_letter(style) for style in look.PEERS.values())


def _with_an_engine() -> tables.Tables:
    """The committed tables, with one engine that is as the penalty method."""
    known = committed()
    rows = [row for row in known["speed_accuracy"].rows if row["method"] == "penalty"]
    engine = [{**row, "method": "engine"} for row in rows]
    known["peers"] = tables.Table("peers", {}, engine)
    known["peers_beside"] = known["speed_accuracy"]
    known["peers_ratios"] = tables.Table("peers_ratios", {}, [])
    return known


def test_engines_are_drawn_in_grey_with_a_letter() -> None:
    known = _with_an_engine()
    assert runs.peers(runs.runs(known)) == ["engine"]
    assert look.style("engine", ["engine"]).color == look.GREY
    alone = {**known}
    del alone["peers"]
    draw = {chart.name: chart.draw for chart in charts.CHARTS}["speed_accuracy_one.svg"]
    assert len(draw(known)) > len(draw(alone))
    page = pages.fill(known, {file.name for file in STUDIES.glob("*.svg")})["speed_accuracy.md"]
    assert "[peers.csv](peers.csv): engine" in page
    assert "(peers.md)" in pages.facts_of("README.md", known)["peers_row"]
    assert pages.facts_of("README.md", alone)["peers_row"] == ""


def test_beside_engines_our_times_are_those_of_the_same_rounds() -> None:
    known = _with_an_engine()
    rows = known["speed_accuracy"].rows
    known["peers_beside"] = tables.Table(
        "peers_beside",
        {"times": "other"},
        [{**row, "ns_per_simulated_second": "7"} for row in rows],
    )
    ours = [run for run in runs.runs(known) if not run.peer]
    assert {run.ns for run in ours} == {7.0}
    assert [run.note for run in ours] == [row["note"] for row in rows], "reasons stay"
    assert pages.facts_of("speed_accuracy.md", known)["times"] == "other"


def test_engines_measured_beside_another_program_are_left_out() -> None:
    known = _with_an_engine()
    rows = [{**row, "error_m": "0.5"} for row in known["speed_accuracy"].rows]
    known["peers_beside"] = tables.Table("peers_beside", {}, rows)
    assert not runs.compared(known)
    assert runs.peers(runs.runs(known)) == []


def test_a_profile_reaches_as_far_as_its_table() -> None:
    shares = chart_speed.profiles(runs.runs(committed()))
    furthest = max(r for own in shares.values() for r in own if math.isfinite(r))
    figure, axes = look.pyplot().subplots()
    chart_speed._profile_panel(axes, shares, [m for m in shares if m not in look.METHODS])
    look.pyplot().close(figure)
    for line, ratios in zip(axes.lines, shares.values()):
        assert line.get_ydata()[-1] == sum(map(math.isfinite, ratios)) / len(ratios)
    assert axes.get_xlim()[1] > furthest


def test_texts_in_a_panel_lie_on_neither_marks_nor_each_other() -> None:
    figure, axes = look.pyplot().subplots()
    room = placing.Places(axes)
    for _ in range(3):
        room.keep(0.5, 0.5, 5)
    written = [room.put("abc", 0.5, 0.5, 8, 3) for _ in range(20)]
    look.pyplot().close(figure)
    assert sum(written) == len(axes.texts) == len({text.xyann for text in axes.texts})
    assert 4 <= sum(written) < 20


# --- the truth, by other means ---


def test_the_truth_is_what_is_known_of_ten_scenes() -> None:
    checks = analytic.checks(committed())
    assert {check.scene for check in checks} == {f.stem for f in SCENES.glob("*.json")} - {
        "tilted_settling"
    }
    for check in checks:
        assert check.error < (1e-12 if check.scene == "pointed_drop" else 2e-15), check


def test_a_truth_that_is_off_is_seen() -> None:
    rows = [dict(row) for row in committed()["truth"].rows]
    for row in rows:
        row["y_m"] = str(float(row["y_m"]) + 1e-9)
    for check in analytic.checks({"truth": tables.Table("truth", {}, rows)}):
        assert check.error == pytest.approx(1e-9, rel=1e-3), check


# --- pages ---


def test_pages_are_their_templates_filled_from_the_tables_beside_them() -> None:
    filled = pages.fill(committed(), {file.name for file in STUDIES.glob("*.svg")})
    assert sorted(filled) == sorted(page.name for page in pages.PAGES)
    for name, text in filled.items():
        assert text == (STUDIES / name).read_text(encoding="utf-8"), name


@pytest.mark.parametrize("page", [page.name for page in pages.PAGES])
def test_templates_have_no_numbers_of_their_own(page: str) -> None:
    text = pages.NAME.sub("", (pages.TEMPLATES / page).read_text(encoding="utf-8"))
    text = re.sub(r"\(eq\. \d+\)|\]\([^)]*\)", "", text)  # equations, and where links lead
    known = (
        "1 − b²/(ac)",
        "θ = 0",
        "δ = 0",
        "p_1 =",
    )  # of formulas, and what was set, not measured
    for formula in known:
        text = text.replace(formula, "")
    assert not re.findall(r".{0,30}\d.{0,30}", text)


@pytest.mark.parametrize("page", [page.name for page in pages.PAGES])
def test_pages_link_to_what_is_there(page: str) -> None:
    text = (STUDIES / page).read_text(encoding="utf-8")
    links = re.findall(r"\]\(([^)#]+)\)", text)
    assert links
    for link in links:
        assert (STUDIES / link).exists(), link


def test_every_chart_and_table_is_on_a_page() -> None:
    text = "".join((STUDIES / page.name).read_text(encoding="utf-8") for page in pages.PAGES)
    text += (ROOT / "README.md").read_text(encoding="utf-8")
    text += (STUDIES / "peers.md").read_text(encoding="utf-8")
    for chart in charts.CHARTS:
        assert chart.name in text
    for question in QUESTIONS:
        assert f"{question}.csv" in text


def test_the_readme_says_of_its_panel_what_the_table_says() -> None:
    """One sentence under one panel, every number of it from the table."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(pages.PANEL.findall(text)) == 1
    assert pages.with_panel(text, committed()) == text


def test_numbers_are_written_short() -> None:
    values = (0.0, 0.00123, 1.5e-7, 33.7, 184025, 0.999)
    assert [words.short(x) for x in values] == ["0", "0.0012", "1.5e-7", "34", "1.8e5", "1.00"]
    assert [words.plain(x) for x in (1e-3, 1e-5, 10000.0)] == ["0.001", "1e-5", "1e4"]
    assert [words.metres(x) for x in (2.0, 0.05, 1e-3, 1e-6)] == [
        "2.0 m",
        "5.0 cm",
        "1.0 mm",
        "1.0e-6 m",
    ]
    assert words.listed(["a", "b", "c"]) == "a, b and c"


# --- what the pages claim in words holds of the tables ---


def test_the_failing_methods_fail_and_the_cures_hold() -> None:
    known = committed()
    facts = pages.facts_of("stability.md", known)
    assert facts["gain_below"] == "0" and facts["gain_others"] == "0"
    assert facts["several_below"] == "0"
    assert facts["several_above"] == facts["several_points"]
    assert facts["stack_pivots"].isdigit(), "the same number at every mass ratio"
    assert float(facts["flat_literal_fine"]) < 1e-12 < float(facts["flat_literal_coarse"])
    assert float(facts["scale_closed"]) < 1e-15
    assert int(facts["gain_count"]) > 0 and int(facts["flat_wrong"]) > 0
    assert "Moreau–Jean, two corners" in facts["rest_still"]
    assert "Moreau–Jean, two corners" in facts["landing_upright"]
    assert "assignment" in facts["landing_mirrored"]
    assert int(facts["floor_scenes"]) > int(facts["floor_of"]) / 2
    assert float(facts["sweeps_high"]) > 100 * float(facts["sweeps_low"])
    assert float(facts["endless_from"]) > 4 / 3
    assert float(facts["flat_merged"]) < 1e-12 < float(facts["flat_residual"])
    models = pages.facts_of("least_model.md", known)
    assert models["ladder_expected"] == models["ladder_scenes"] == "11"


def test_event_driven_comes_within_a_micrometre_in_every_scene() -> None:
    all_runs = runs.runs(committed())
    for scene in runs.scenes(all_runs):
        assert runs.least_time(all_runs, scene, "event_driven", 1e-6) < 1e6
