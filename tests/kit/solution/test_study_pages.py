"""The study's charts and pages: they say what its tables hold."""

import math
import re

import jinja2
import pytest

from bounce_grader.common.paths import ROOT
from bounce_study import analytic, chart_speed, chart_style, charts, measured_part
from bounce_study import measurements, numbers, pages
from bounce_study.point_labels import PointLabels
from bounce_study.run import QUESTIONS
from bounce_study.tables import Table, Tables
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
    styles = [
        *chart_style.METHODS.values(),
        *chart_style.PEERS.values(),
        chart_style.style("one", ["one"]),
    ]
    marks = [style.marker for style in styles]
    assert len(set(marks)) == len(marks)
    assert all(chart_style.is_letter(style) for style in chart_style.PEERS.values())


def _with_an_engine() -> Tables:
    """The committed tables, with one engine that is as the penalty method."""
    known = committed()
    rows = [row for row in known["speed_accuracy"].rows if row["method"] == "penalty"]
    engine = [{**row, "method": "engine"} for row in rows]
    known["peers"] = Table("peers", {}, engine)
    known["peers_beside"] = known["speed_accuracy"]
    known["peers_ratios"] = Table("peers_ratios", {}, [])
    return known


def test_engines_are_drawn_in_grey_with_a_letter() -> None:
    known = _with_an_engine()
    assert measurements.peers(measurements.read(known)) == ["engine"]
    assert chart_style.style("engine", ["engine"]).color == chart_style.GREY
    alone = {**known}
    del alone["peers"]
    draw = {chart.name: chart.draw for chart in charts.CHARTS}["speed_accuracy_one.svg"]
    assert len(draw(known)) > len(draw(alone))
    assert "[peers.csv](peers.csv): engine" in pages.render("speed_accuracy.md", known)
    assert "(peers.md)" in pages.render("README.md", known)
    assert "(peers.md)" not in pages.render("README.md", alone)


def test_beside_engines_our_times_are_those_of_the_same_rounds() -> None:
    known = _with_an_engine()
    rows = known["speed_accuracy"].rows
    timed = [{**row, "ns_per_simulated_second": "7"} for row in rows]
    known["peers_beside"] = Table("peers_beside", {"times": "other"}, timed)
    ours = [run for run in measurements.read(known) if not run.peer]
    assert {run.ns for run in ours} == {7.0}
    assert [run.note for run in ours] == [row["note"] for row in rows], "reasons stay"
    assert pages.facts_of("speed_accuracy.md", known)["times"] == "other"


def test_engines_measured_beside_another_program_are_left_out() -> None:
    known = _with_an_engine()
    rows = [{**row, "error_m": "0.5"} for row in known["speed_accuracy"].rows]
    known["peers_beside"] = Table("peers_beside", {}, rows)
    assert not measurements.compared(known)
    assert measurements.peers(measurements.read(known)) == []


def test_a_profile_reaches_as_far_as_its_table() -> None:
    ratios = chart_speed.profiles(measurements.read(committed()))
    furthest = max(r for own in ratios.values() for r in own if math.isfinite(r))
    figure, axes = chart_style.pyplot().subplots()
    peers = [method for method in ratios if method not in chart_style.METHODS]
    chart_speed._profile_panel(axes, ratios, peers, furthest)
    chart_style.pyplot().close(figure)
    for line, own in zip(axes.lines, ratios.values()):
        assert line.get_ydata()[-1] == sum(map(math.isfinite, own)) / len(own)
    assert axes.get_xlim()[1] > furthest


def test_labels_of_points_lie_on_neither_marks_nor_each_other() -> None:
    figure, axes = chart_style.pyplot().subplots()
    labels = PointLabels(axes)
    for _ in range(3):
        labels.occupy(0.5, 0.5, 5)
    added = [labels.add("abc", 0.5, 0.5, 8, 3) for _ in range(20)]
    chart_style.pyplot().close(figure)
    assert sum(added) == len(axes.texts) == len({text.xyann for text in axes.texts})
    assert 4 <= sum(added) < 20


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
    for check in analytic.checks({"truth": Table("truth", {}, rows)}):
        assert check.error == pytest.approx(1e-9, rel=1e-3), check


# --- pages ---


def test_pages_are_their_templates_filled_from_the_tables_beside_them() -> None:
    filled = pages.fill(committed(), {file.name for file in STUDIES.glob("*.svg")})
    assert sorted(filled) == sorted(page.name for page in pages.PAGES)
    for name, text in filled.items():
        assert text == (STUDIES / name).read_text(encoding="utf-8"), name


@pytest.mark.parametrize("template", sorted(file.name for file in pages.TEMPLATES.glob("*.md")))
def test_templates_have_no_numbers_of_their_own(template: str) -> None:
    text = (pages.TEMPLATES / template).read_text(encoding="utf-8")
    text = re.sub(r"\{\{.*?\}\}|\{%.*?%\}", "", text)
    # equations, where links lead, commands, and a name
    text = re.sub(r"\(eq\. \d+\)|eqs\. \(\d+\) and \(\d+\)|\]\([^)]*\)|`[^`]*`|Box2D", "", text)
    # of formulas, and what was set, not measured
    for formula in ("1 − b²/(ac)", "θ = 0", "δ = 0", "ε = 0", "p_1 =", "side²/6", "scheme's = 1"):
        text = text.replace(formula, "")
    assert not re.findall(r".{0,30}\d.{0,30}", text)


def test_every_picture_has_alt_text_and_a_sentence_that_says_what_to_see() -> None:
    for template in sorted(pages.TEMPLATES.glob("*.md")):
        text = template.read_text(encoding="utf-8")
        for picture, after in re.findall(r"^(!\[.*)\n\n(.*)", text, re.MULTILINE):
            assert re.match(r"!\[.{10,}\]", picture), picture
            assert after.startswith("What to see: "), picture


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
    for chart in charts.CHARTS:
        assert chart.name in text
    for question in (*QUESTIONS, *measured_part.TABLES):
        assert f"{question}.csv" in text


def test_the_readme_says_of_its_panel_what_the_table_says() -> None:
    """One sentence under one panel, every number of it from the table."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(pages.PANEL.findall(text)) == 1
    assert pages.with_panel(text, committed()) == text


def test_numbers_are_written_short() -> None:
    values = (0.0, 0.00123, 1.5e-7, 33.7, 184025, 0.999, math.inf)
    short = ["0", "0.0012", "1.5e-7", "34", "1.8e5", "1.00", "∞"]
    assert list(map(numbers.short, values)) == short
    assert list(map(numbers.plain, (1e-3, 1e-5, 200.0, 1e6))) == ["0.001", "1e-5", "200", "1e6"]
    assert list(map(numbers.ratio, (2.41, 144, 12345))) == ["2.4", "140", "12,000"]
    lengths = (2.0, 0.05, 1e-3, 1e-6)
    assert list(map(numbers.metres, lengths)) == ["2.0 m", "5.0 cm", "1.0 mm", "1.0e-6 m"]
    assert list(map(numbers.plain_metres, lengths)) == ["2 m", "5 cm", "1 mm", "1 µm"]
    assert numbers.time(3000) == "3.0 µs" and numbers.plain_time(3000) == "3 µs"
    assert numbers.listed(["a", "b", "c"]) == "a, b and c"
    assert numbers.listed([]) == "none"


def test_a_page_that_names_what_is_not_known_is_refused() -> None:
    with pytest.raises(jinja2.UndefinedError, match="no_such_fact"):
        pages._environment().from_string("{{ no_such_fact }}").render()


# --- what the pages claim in words holds of the tables ---


def test_the_failing_methods_fail_and_the_cures_hold() -> None:
    known = committed()
    facts = pages.facts_of("stability.md", known)
    assert facts["gain_below"] == facts["gain_others"] == facts["several_below"] == 0
    assert facts["several_above"] == facts["several_points"]
    assert len(facts["stack_pivots"]) == 1, "the same number at every mass ratio"
    literal = "merged_in_8x8_residual_m_s"
    assert float(facts["flat_fine"][literal]) < 1e-12 < float(facts["flat_coarse"][literal])
    assert facts["scale_closed"] < 1e-15
    assert facts["gain_count"] > 0 and facts["flat_wrong"] > 0
    assert "moreau_jean_2" in facts["rest_still"]
    assert "moreau_jean_2" in facts["landing_upright"]
    assert "assignment" in facts["landing_mirrored"]
    assert len(facts["floor_cured"] + facts["floor_uncured"]) > len(facts["floor"]) / 2
    assert float(facts["sweeps_high"]["sweeps"]) > 100 * float(facts["sweeps_low"]["sweeps"])
    assert float(facts["endless_from"]) > 4 / 3
    assert facts["flat_merged"] < 1e-12 < float(facts["flat_worst"]["lemke_8x8_residual_m_s"])
    models = pages.facts_of("least_model.md", known)
    assert models["ladder_expected"] == len(models["ladder"]) == 11


def test_measured_impacts_need_friction_and_more_than_newtons_law() -> None:
    facts = pages.facts_of("measured.md", committed())
    for name in ("one", "oval", "both", "all"):
        group = facts[name]
        newton, least = group["laws"]["newton"], group["least"]
        assert float(newton["behind_low"]) > 0, "Newton's law can be told from the best"
        assert float(group["laws"]["frictionless"]["behind_low"]) > 0
        assert float(least["floor_high"]) < float(least["median_low"]), "none is the best impulse"
    two = facts["two"]["laws"]
    assert float(two["sequence_newton"]["median_high"]) < float(two["two_newton"]["median_low"])
    assert max(facts["drop_horizon"].values()) < 0.2
    assert facts["drop_spread"][-1] < facts["far"], "the law ends the forecast, and not the start"


def test_the_choice_by_mechanics_is_mostly_the_least() -> None:
    chosen = pages.facts_of("least_model.md", committed())["random"]
    assert chosen["scenes"] == 1000
    assert chosen["same"] + chosen["larger"] + chosen["wrong"] == 1000
    assert chosen["same"] > chosen["larger"] > chosen["wrong"]


def test_a_motion_within_a_tolerance_keeps_its_bound_and_costs_little_more_than_the_best() -> None:
    for row in committed()["tolerance"].rows:
        assert int(row["scenes"]) >= 4000 and int(row["violated"]) == 0
        assert float(row["bound_over_error"]) <= 100
        assert float(row["time_over_best"]) <= 1.5


def test_springs_let_a_held_corner_rebound() -> None:
    tipped = pages.facts_of("speed_accuracy.md", committed())["tipped"]
    assert abs(tipped["Newton"]["held"]) < 1e-9 < 0.01 < tipped["springs"]["held"]
    assert tipped["springs"]["omega"] < 0.9 * tipped["Newton"]["omega"]


def test_event_driven_comes_within_a_micrometre_in_every_scene() -> None:
    runs = measurements.read(committed())
    for scene in measurements.scenes(runs):
        times = [r.ns for r in measurements.of(runs, scene, "event_driven") if r.error <= 1e-6]
        assert times and min(times) < 1e6, scene
