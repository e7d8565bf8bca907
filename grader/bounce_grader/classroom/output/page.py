"""Writes class.html, the instructor's page: the numbers and charts for class.html.j2."""

import os
import statistics
from collections import Counter
from collections.abc import Iterator, Sequence
from urllib.parse import quote

from markupsafe import Markup

from bounce_grader.classroom.grading.near_copies import Similar
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.common.escaping import first_few, Value
from bounce_grader.common.manifest import full_points, part_of, parts
from bounce_grader.common.numbers import percent, short
from bounce_grader.formats import html, speed_chart as chart
from bounce_grader.grading import examples
from bounce_grader.grading.known_mistakes import for_the_instructor

MOST_NAMES = 10  # of who made a mistake; grades.csv has all
Bar = tuple[str, float, str, bool]  # label, length from 0 to 1, number, whether it is a heading


def render(summaries: Sequence[Summary], near: Similar, sentences: list[str], title: str) -> str:
    """`sentences` are on files that are nobody's, on adjustments and on the gradebook."""
    graded = [s for s in summaries if s.score is not None]
    pages = {s.student.who: s.student.feedback for s in summaries if s.student.feedback}
    return html.fill(
        "classroom/output/class.html.j2",
        title=title or "The class",
        figures=list(_figures(summaries, graded)),
        histogram=list(_histogram(graded)),
        success=list(_success(graded)),
        mistakes=list(_mistakes(graded)),
        cases=_cases(graded),
        curves=_chart(graded),
        looks=looks(summaries),
        near=near,
        pairs=[[pair.first, pair.second, pair.in_common] for pair in near.pairs],
        sentences=sentences,
        columns=["who", "points", *(f"part {part.number}" for part in parts()), "final"],
        submissions=list(map(_row, summaries)),
        links={who: quote(os.fsencode(f"feedback/{page}")) for who, page in pages.items()},
    )


def looks(summaries: Sequence[Summary]) -> list[tuple[str, str]]:
    """Who needs a look, and why; in one row if the reasons are the same, as with a reduced box."""
    who: dict[str, list[str]] = {}
    for summary in filter(lambda summary: summary.needs_a_look, summaries):
        who.setdefault(summary.needs_a_look, []).append(summary.student.who)
    return [(first_few(names, separator="; "), why) for why, names in who.items()]


def _mistakes(graded: Sequence[Summary]) -> Iterator[list[str]]:
    """Each known mistake, the most frequent first: its title and part, what it is with the hint's
    heading, and who made it."""
    made: dict[tuple[str, str], list[str]] = {}
    for summary in graded:
        for mistake in summary.mistakes.items():
            made.setdefault(mistake, []).append(summary.student.who)
    for (name, title), who in sorted(made.items(), key=lambda item: (-len(item[1]), item[0])):
        words, heading = for_the_instructor(name)
        names = f"{len(who)}: {first_few(who, MOST_NAMES, '; ')}"
        yield [title, str(part_of(name).number), f"{words} Hint {heading}.", names]


def _cases(graded: Sequence[Summary]) -> list[str]:
    """What the cases caught that were handed in, in sentences; none if nobody wrote any."""
    handed_in = [s.record.get("examples", {}).get("caught", ()) for s in graded]
    caught = [set(names) for names in handed_in if names]
    if not caught:
        return []
    folders = examples.folders()
    nobody = [f"{name} ({folders[name]})" for name in folders if not any(name in c for c in caught)]
    return [
        f"{len(caught)} handed in cases that catch a buggy program, "
        f"{statistics.mean(map(len, caught)):.1f} of {len(folders)} in the mean.",
        f"Caught by nobody: {', '.join(nobody) or 'none'}.",
    ]


def of_near_copies(near: Similar) -> list[str]:
    """A sentence for each of the nearest copies."""
    number = len(near.pairs) + near.more
    return [f"{number} pairs have much in common; those with most:"] * bool(near.more) + [
        f"{pair.first} and {pair.second} have {pair.in_common} in common: look whether one is a copy"
        for pair in near.pairs
    ]


def _figures(summaries: Sequence[Summary], graded: Sequence[Summary]) -> Iterator[tuple[str, str]]:
    scores = [s.score or 0.0 for s in graded]
    yield "submissions", str(len(summaries))
    yield "graded", str(len(scores))
    if scores:
        yield "median", short(statistics.median(scores))
        yield "mean", f"{statistics.mean(scores):.1f}"
        yield "with full marks", str(sum(s.has_all_points for s in summaries))
    if late := sum(s.student.seconds_late != 0 for s in summaries):
        yield "late", str(late)


def _histogram(graded: Sequence[Summary]) -> Iterator[Bar]:
    """How many submissions have how many points: by tenths, and full points."""
    full = full_points()
    tenths = [10 if s.has_all_points else min(9, int(10 * (s.score or 0) / full)) for s in graded]
    highest = max(Counter(tenths).values(), default=1)
    for i in range(11):
        below = f" to under {short(full * (i + 1) / 10)}" * (i < 10)
        label = f"{short(full * i / 10)}{below} points"
        yield label, tenths.count(i) / highest, str(tenths.count(i)), False


def _success(graded: Sequence[Summary]) -> Iterator[Bar]:
    """Of each part, the mean of its points; of each check, how many passed it."""
    for part in parts() if graded else ():
        mean = statistics.mean(s.parts[part.number - 1]["score"] for s in graded)
        note = f"{mean:.1f} of {short(part.points)}"
        yield f"Part {part.number}: {part.title}", mean / part.points, note, True
        for check in part.checks:
            share = sum(s.checks[check.id]["passed"] for s in graded) / len(graded)
            yield check.title, share, percent(share), False


def _chart(graded: Sequence[Summary]) -> Markup | None:
    """All submissions' curves, and the solution's and least model's as timed beside the first."""
    every = [(one, chart.curves_of(one.speed, "solution")) for one in graded]
    timed = [(one, own) for one, own in every if own["submission"].places]
    if not timed:
        return None
    curves = []
    for one, own in timed:
        kind = "full" if one.has_all_points else "some" if one.score else "none"
        words = f"{one.student.who}: {short(one.score or 0)} points"
        curves.append(own["submission"]._replace(kind=kind, title=words))
    curves += [timed[0][1][whose] for whose in ("solution", "least")]
    return chart.error_over_time(curves, "Speed against accuracy, one line for each submission")


def _row(summary: Summary) -> list[Value]:
    """A row of the table of all submissions."""
    row = summary.row()
    columns = ("score", *(part.stem for part in parts()), "final")
    return [summary.student.who, *("" if row[name] is None else row[name] for name in columns)]
