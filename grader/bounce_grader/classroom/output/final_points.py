"""The points that count for a person: those of the submission, with what lateness costs and the
instructor's adjustments. Records stay as they are."""

import math
from collections.abc import Callable, Sequence

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import instructor_files as files
from bounce_grader.classroom.intake.course import Course
from bounce_grader.classroom.intake.student import Adjustment, Member
from bounce_grader.common.manifest import full_points
from bounce_grader.common.numbers import short

DAY = 86400  # s
# What the points become, by the points so far and those of a row.
Set = Callable[[float, float], float]
SETS: dict[str, Set] = {"=": lambda _, to: to, "at least": max, "at most": min}


def final(
    summary: Summary, member: Member, own: Sequence[Adjustment], course: Course, used: int
) -> Member:
    """Applies, in this order: dropped checks, lateness, added points, points that are set. `used`
    is the number of free days that the person has used in earlier assignments."""
    points = summary.score or 0.0
    applied = [Adjustment("", "", reason=summary.attempt)] if summary.attempt else []

    def change(by: float, why: Adjustment) -> None:
        nonlocal points
        points += by
        applied.append(why._replace(points=round(by, 2)))

    lost = {id: check["max_score"] for id, check in summary.checks.items() if not check["passed"]}
    for row in own:
        if row.drop:
            change(sum(lost.pop(id, 0) for id in row.drop), row)  # each once
    days = _late_days(summary, own, course) if course.percent_per_day else 0
    left = max(0, course.slip_days - used)
    free = min(days, left)
    if days:
        percent = min((days - free) * course.percent_per_day, course.at_most_percent)
        words = f"{days} day{'s' * (days > 1)} late"
        if course.slip_days:
            words += f", {free} of them free, with {left - free} left"
        words += f", {short(percent)} %" * (percent > 0)
        change(-min(points, full_points() * percent / 100), Adjustment("", "", reason=words))
    for row in own:
        added = 0.0 if row.sets else row.points
        if added >= full_points() / 2 and points + added > full_points():
            adds = f"{row.where} adds {short(added)} points to {short(points)}"
            summary.notes.append(f"{adds}: to set them, write 'exactly {short(added)}'")
        if added or row.late_days is not None:
            change(max(added, -points), row)
    for row in filter(lambda row: row.sets, own):
        if by := SETS[row.sets](points, row.points) - points:
            change(by, row)
    return member._replace(points=points, applied=tuple(applied), slip_days=free)


def _late_days(summary: Summary, own: Sequence[Adjustment], course: Course) -> int:
    """The days late that are begun: the instructor's, else the service's. An unknown number counts
    as one."""
    given = [row.late_days for row in own if row.late_days is not None]
    if given:
        return given[-1]
    seconds = summary.student.seconds_late
    if seconds is None:
        unknown = "late by an unknown number of days, counted as one"
        summary.notes.append(f"{unknown} unless {files.ADJUSTMENTS} says otherwise")
        return 1
    return max(0, math.ceil((seconds - 60 * course.grace_minutes) / DAY))
