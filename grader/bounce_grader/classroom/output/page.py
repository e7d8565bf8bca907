"""Writes class.html, the instructor's page: the numbers and charts for class.html.j2."""

import os
import statistics
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any
from urllib.parse import quote

from bounce_grader.classroom.grading.near_copies import Pair, Similar
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.instructor_files import Course
from bounce_grader.classroom.intake.student import Class
from bounce_grader.classroom.output import charts
from bounce_grader.classroom.output.charts import Bar, Curve
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.manifest import full_points, named_together, part_of, parts
from bounce_grader.common.numbers import percent, scientific, short
from bounce_grader.formats.figures import Drawing, NAMES, ON_PAPER
from bounce_grader.formats.html import fill
from bounce_grader.grading import examples, speed
from bounce_grader.grading.hints import nudge, of_check
from bounce_grader.grading.known_mistakes import for_the_instructor

MOST_UNUSED = 10  # names of unused files of one submission; grades.csv has more
Row = list[str]


def render(
    submitted: Class,
    summaries: Sequence[Summary],
    near: Similar,
    gradebook_sentences: Sequence[str],
    course: Course = Course(),
) -> str:
    names = names_of(summaries)
    graded = [s for s in summaries if s.score is not None]
    scores = [s.score for s in summaries if s.score is not None]
    mistakes = [_mistake(*made) for made in _who_made_mistakes(graded)]
    return fill(
        "classroom/output/class.html.j2",
        title=course.title or "The class",
        date=course.date,
        figures=list(_figures(submitted, summaries, scores)),
        histogram=charts.histogram(scores, _full()),
        graded=graded,
        success=_success(graded) if graded else None,
        mistakes=[mistake for mistake in mistakes if len(mistake["who"]) > 1],
        mistakes_of_one=[mistake for mistake in mistakes if len(mistake["who"]) == 1],
        failed_checks=_failed_checks(graded),
        cases=_cases(graded),
        timed=any(s.ratio is not None for s in summaries),
        curves=_curves(summaries, graded),
        chart_style=ON_PAPER,
        names=NAMES,
        looks=_looks(summaries),
        near=near,
        incomplete=first_few([names[id] for id in near.incomplete]),
        pairs=[[*pair_names(p, names), pair_share(p)] for p in near.pairs],
        unmatched=[[printable_name(entry.name), entry.reason] for entry in submitted.unmatched],
        gradebook_sentences=gradebook_sentences,
        adjusted=any(s.is_adjusted for s in summaries),
        columns=["points", *(f"part {part.number}" for part in parts()), "in the end"],
        timed_rows=[
            [_who(s), _points(s.score), *_speed_and_error(s)] for s in graded if s.ratio is not None
        ],
        submissions=list(map(_row, summaries)),
    )


def _looks(summaries: Sequence[Summary]) -> list[Row]:
    """Who needs a look, and why; in one row if the reasons are the same, as with a reduced box."""
    who: dict[str, list[str]] = {}
    for summary in summaries:
        if summary.needs_a_look:
            who.setdefault("; ".join(summary.needs_a_look), []).append(_who(summary))
    return [[first_few(names, separator="; "), why] for why, names in who.items()]


def _who_made_mistakes(graded: Sequence[Summary]) -> list[tuple[str, str, list[str]]]:
    """The name, the title and the students of each known mistake, the most frequent first,
    and then by part."""
    made: dict[str, tuple[str, str, list[str]]] = {}
    for summary in graded:
        for name, title in summary.mistakes.items():
            made.setdefault(name, (name, title, []))[2].append(_who(summary))
    return sorted(made.values(), key=lambda mistake: (-len(mistake[2]), mistake[0]))


def _mistake(name: str, title: str, who: list[str]) -> dict[str, Any]:
    """A mistake with the line for the instructor, and the hint that students have."""
    words, heading = for_the_instructor(name)
    return {
        "part": part_of(name).number,
        "title": title,
        "words": words,
        "heading": heading,
        "hint": nudge(heading),
        "who": who,
    }


def _cases(graded: Sequence[Summary]) -> list[str]:
    """What the cases caught that were handed in, in sentences; none if nobody wrote any."""
    caught = [s.caught for s in graded if s.caught]
    if not caught:
        return []
    folders = examples.folders()
    nobody = [f"{name} ({folders[name]})" for name in folders if not any(name in c for c in caught)]
    return [
        f"{len(caught)} handed in cases that catch a wrong program, "
        f"{statistics.mean(map(len, caught)):.1f} of {len(folders)} in the mean.",
        f"Caught by nobody: {', '.join(nobody) or 'none'}.",
    ]


def of_near_copies(near: Similar, summaries: Sequence[Summary]) -> list[str]:
    """A sentence for each of the nearest copies, or why there is none."""
    names = names_of(summaries)
    sentences = [
        f"{' and '.join(pair_names(pair, names))} have {pair_share(pair)} in common: look whether "
        "one is a copy"
        for pair in near.pairs
    ]
    sentences += [f"near-copies weren't looked for: {near.problem}"] * bool(near.problem)
    return sentences + [f"{near.more} more pairs stand out"] * bool(near.more)


def pair_names(pair: Pair, names: Mapping[str, str]) -> list[str]:
    """Who is alike; of another year, the folder and the name."""
    return [names.get(id, printable_name(id)) for id in (pair.first, pair.second)]


def pair_share(pair: Pair) -> str:
    return f"{pair.share} %{f' of {named_together(pair.parts)}' if pair.parts else ''}"


def _full() -> float:
    return full_points()


def names_of(summaries: Sequence[Summary]) -> dict[str, str]:
    return {s.student.id: _who(s) for s in summaries}


def _who(summary: Summary) -> str:
    student = summary.student
    return student.id if student.shown == student.id else f"{student.shown} ({student.id})"


def _label(summary: Summary) -> str:
    return f"{_who(summary)}: {_points(summary.score)} points"


def _kind(summary: Summary) -> str:
    """The kind of its line in the chart."""
    score = summary.score or 0
    return "full" if score >= _full() else "some" if score else "none"


def _figures(
    submitted: Class, summaries: Sequence[Summary], scores: Sequence[float]
) -> Iterator[tuple[str, str]]:
    yield "submissions", str(max(submitted.handed_in, len(summaries)))
    yield "graded", str(len(scores))
    if scores:
        yield "median", short(statistics.median(scores))
        yield "mean", f"{statistics.mean(scores):.1f}"
        yield "with all points", str(sum(score >= _full() for score in scores))
    late = sum(s.student.late for s in summaries)
    if late:
        yield "late", str(late)


def _success(graded: Sequence[Summary]) -> Drawing:
    rows = []
    for part in parts():
        mean = statistics.mean(s.parts[part.number] for s in graded)
        heading = f"Part {part.number}: {part.title}"
        rows.append(Bar(heading, mean / part.points, f"{mean:.1f} of {short(part.points)}", True))
        for check in part.checks:
            share = sum(check.id in s.passed for s in graded) / len(graded)
            rows.append(Bar(check.title, share, percent(share)))
    return charts.bars(rows, "Success by part and by check")


def _failed_checks(graded: Sequence[Summary]) -> list[Row]:
    failures = Counter(id for s in graded for id in s.checks if id not in s.passed)
    checks = {check.id: (part, check) for part in parts() for check in part.checks}
    most = [(*checks[id], count) for id, count in failures.most_common(10)]
    hints = {check.id: of_check(check.id) for _, check, _ in most}
    return [
        [f"part {part.number}", check.title, hints[check.id], nudge(hints[check.id]), str(count)]
        for part, check, count in most
    ]


def _curves(summaries: Sequence[Summary], graded: Sequence[Summary]) -> Drawing | None:
    """All submissions' curves in one chart. Each one's unit of time is the solution's, measured in
    the same run."""
    own = [(s, _over_solution(s, "submission")) for s in graded]
    curves = [Curve(places, _kind(s), _label(s)) for s, places in own if places]
    usual = [_median(summaries, whose) for whose in ("solution", "least")]
    return (
        charts.error_against_time([*curves, *filter(None, usual)], speed.FINE) if curves else None
    )


def _over_solution(summary: Summary, whose: str) -> tuple[tuple[float, float | None], ...]:
    unit = [point.ns for point in summary.curves.get("solution", ()) if point.dt >= speed.STEP]
    return tuple((p.ns / unit[-1], p.error) for p in summary.curves.get(whose, ()) if unit)


def _median(summaries: Sequence[Summary], whose: str) -> Curve | None:
    """The median over all runs of the solution's or the least model's curve."""
    runs = [(s, places) for s in summaries if (places := _over_solution(s, whose))]
    if not runs:
        return None
    first, errors = runs[0]
    times = [statistics.median(step) for step in zip(*([x for x, _ in run] for _, run in runs))]
    places = tuple((x, error) for x, (_, error) in zip(times, errors))
    if whose == "least":
        return Curve(places, whose, NAMES[whose])
    steps = tuple(f"{short(1000 * point.dt)} ms" for point in first.curves[whose])
    return Curve(places, whose, NAMES[whose], steps)


def _speed_and_error(summary: Summary) -> list[str]:
    error = "none" if summary.error is None else scientific(summary.error)
    return [f"{summary.ratio:.2f}", error]


def _row(summary: Summary) -> dict[str, Any]:
    """A row of the table of all submissions."""
    of_parts = [_points(summary.parts.get(part.number)) for part in parts()]
    ends = sorted({round(one.points[0], 2) for one in summary.finals})
    return {
        "who": _who(summary),
        "page": quote(os.fsencode(f"feedback/{summary.student.feedback}"))
        if summary.student.feedback
        else "",
        "points": [_points(summary.score), *of_parts, " / ".join(map(short, ends))],
        "late": "late" if summary.student.late else "",
        "unused": first_few(summary.unused, MOST_UNUSED, "; ", summary.ignored_more),
    }


def _points(points: float | None) -> str:
    return "" if points is None else short(points)
