"""Writes class.html, the instructor's page: the numbers and charts for class.html.j2."""

import os
import statistics
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple
from urllib.parse import quote

from bounce_grader.classroom.grading.near_copies import Pair, Similar
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.instructor_files import Course
from bounce_grader.classroom.intake.student import Class
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.manifest import full_points, named_together, part_of, parts
from bounce_grader.common.numbers import percent, seconds, short
from bounce_grader.formats.html import fill
from bounce_grader.formats.speed_chart import Curve, Drawing, error_over_time, NAMES
from bounce_grader.formats.speed_chart import over_solution, STYLE
from bounce_grader.grading import examples
from bounce_grader.grading.known_mistakes import for_the_instructor

MOST_UNUSED = 10  # names of unused files of one submission; grades.csv has more


class Bar(NamedTuple):
    """One bar of a chart: its label, its length from 0 to 1, and its number."""

    label: str
    share: float
    note: str
    heading: bool = False


def render(
    submitted: Class,
    summaries: Sequence[Summary],
    near: Similar,
    gradebook_sentences: Sequence[str],
    course: Course = Course(),
) -> str:
    names = names_of(summaries)
    graded = [s for s in summaries if s.score is not None]
    return fill(
        "classroom/output/class.html.j2",
        title=course.title or "The class",
        figures=list(_figures(submitted, summaries)),
        histogram=_histogram(graded),
        success=list(_success(graded)) if graded else [],
        mistakes=[_mistake(*made) for made in _who_made_mistakes(graded)],
        cases=_cases(graded),
        curves=_chart(graded, names),
        chart_style=STYLE,
        chart_names=NAMES,
        looks=_looks(summaries),
        near=near,
        incomplete=first_few([names[id] for id in near.incomplete], separator="; "),
        pairs=[[*pair_names(p, names), pair_share(p)] for p in near.pairs],
        unmatched=[[printable_name(entry.name), entry.reason] for entry in submitted.unmatched],
        gradebook_sentences=gradebook_sentences,
        adjusted=any(s.is_adjusted for s in summaries),
        columns=["points", *(f"part {part.number}" for part in parts()), "in the end"],
        submissions=list(map(_row, summaries)),
        names=names,
    )


def names_of(summaries: Sequence[Summary]) -> dict[str, str]:
    """Who each submission is of, by its id."""
    students = [s.student for s in summaries]
    return {s.id: s.id if s.shown == s.id else f"{s.shown} ({s.id})" for s in students}


def _looks(summaries: Sequence[Summary]) -> list[list[str]]:
    """Who needs a look, and why; in one row if the reasons are the same, as with a reduced box."""
    who: dict[str, list[str]] = {}
    for summary in summaries:
        if summary.needs_a_look:
            own = who.setdefault("; ".join(summary.needs_a_look), [])
            own += names_of([summary]).values()
    return [[first_few(names, separator="; "), why] for why, names in who.items()]


def _who_made_mistakes(graded: Sequence[Summary]) -> list[tuple[str, str, list[str]]]:
    """The name, the title and the students of each known mistake, the most frequent first,
    and then by part."""
    made: dict[str, tuple[str, str, list[str]]] = {}
    for summary in graded:
        for name, title in summary.mistakes.items():
            who = made.setdefault(name, (name, title, []))[2]
            who += names_of([summary]).values()
    return sorted(made.values(), key=lambda mistake: (-len(mistake[2]), mistake[0]))


def _mistake(name: str, title: str, who: list[str]) -> dict[str, Any]:
    """A mistake with the line for the instructor, and the heading of the students' hint."""
    words, heading = for_the_instructor(name)
    return dict(part=part_of(name).number, title=title, words=words, heading=heading, who=who)


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
    """A sentence for each of the nearest copies."""
    names = names_of(summaries)
    sentences = [
        f"{' and '.join(pair_names(pair, names))} have {pair_share(pair)} in common: look whether "
        "one is a copy"
        for pair in near.pairs
    ]
    return sentences + [f"{near.more} more pairs stand out"] * bool(near.more)


def pair_names(pair: Pair, names: Mapping[str, str]) -> list[str]:
    """Who is alike; of another year, the folder and the name."""
    return [names.get(id, printable_name(id)) for id in (pair.first, pair.second)]


def pair_share(pair: Pair) -> str:
    return f"{pair.share} %{f' of {named_together(pair.parts)}' if pair.parts else ''}"


def _figures(submitted: Class, summaries: Sequence[Summary]) -> Iterator[tuple[str, str]]:
    scores = [s.score for s in summaries if s.score is not None]
    yield "submissions", str(max(submitted.handed_in, len(summaries)))
    yield "graded", str(len(scores))
    if scores:
        yield "median", short(statistics.median(scores))
        yield "mean", f"{statistics.mean(scores):.1f}"
        yield "with all points", str(sum(s.has_all_points for s in summaries))
    late = sum(s.student.late for s in summaries)
    if late:
        yield "late", str(late)


def _histogram(graded: Sequence[Summary]) -> list[Bar]:
    """How many submissions have how many points: by tenths, and full points."""
    full = full_points()
    columns = Counter(
        10 if s.has_all_points else min(9, int(10 * (s.score or 0) / full)) for s in graded
    )
    highest = max(columns.values(), default=1)
    labels = [f"{short(full * i / 10)}–{short(full * (i + 1) / 10)}" for i in range(10)]
    return [
        Bar(f"{label} points", columns[i] / highest, str(columns[i]))
        for i, label in enumerate([*labels, short(full)])
    ]


def _success(graded: Sequence[Summary]) -> Iterator[Bar]:
    """Of each part, the mean of its points; of each check, how many passed it."""
    for part in parts():
        mean = statistics.mean(s.parts[part.number] for s in graded)
        note = f"{mean:.1f} of {short(part.points)}"
        yield Bar(f"Part {part.number}: {part.title}", mean / part.points, note, True)
        for check in part.checks:
            share = sum(check.id in s.passed for s in graded) / len(graded)
            yield Bar(check.title, share, percent(share))


def _chart(graded: Sequence[Summary], names: Mapping[str, str]) -> Drawing | None:
    """All submissions' curves, with those of the solution and of the least model, as timed beside
    the first."""
    curves = []
    for one in graded:
        kind = "full" if one.has_all_points else "some" if one.score else "none"
        words = f"{names[one.student.id]}: {short(one.score or 0)} points"
        curves.append(Curve(over_solution(one.curves, "submission"), kind, words))
    curves = [curve for curve in curves if curve.places]
    if not curves:
        return None
    first = next(one.curves for one in graded if over_solution(one.curves, "submission"))
    steps = [seconds(1e9 * point.dt) for point in first["solution"]]
    for whose in ("solution", "least"):
        labels = steps if whose == "solution" else []
        curves.append(Curve(over_solution(first, whose), whose, NAMES[whose], labels))
    return error_over_time(curves, "Speed against accuracy, one line for each submission")


def _row(summary: Summary) -> dict[str, Any]:
    """A row of the table of all submissions."""
    page = f"feedback/{summary.student.feedback}" if summary.student.feedback else ""
    points = [summary.score, *(summary.parts.get(part.number) for part in parts())]
    ends = sorted({round(one.points, 2) for one in summary.finals})
    shown = ["" if one is None else short(one) for one in points]
    return {
        "id": summary.student.id,
        "page": quote(os.fsencode(page)),
        "points": [*shown, " / ".join(map(short, ends))],
        "late": "late" if summary.student.late else "",
        "unused": first_few(summary.unused, MOST_UNUSED, "; ", summary.ignored_more),
    }
