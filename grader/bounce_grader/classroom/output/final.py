"""Works out final points: those of the grading, with what lateness costs and the adjustments of
the instructor. Records stay as they are."""

from collections.abc import Mapping, Sequence

from bounce_grader.classroom.grading.summary import Final, Summary
from bounce_grader.classroom.intake.instructor_files import (
    Adjustment,
    ADJUSTMENTS,
    Course,
    EVERYBODY,
    ROSTER,
)
from bounce_grader.classroom.intake.people import People
from bounce_grader.classroom.intake.student import Member, Student
from bounce_grader.common.manifest import full_points
from bounce_grader.common.numbers import short

# By the member's and the submission's id.
Own = Mapping[tuple[str, str], Sequence[Adjustment]]


def assign(
    adjustments: Sequence[Adjustment], people: People, students: Sequence[Student]
) -> tuple[Own, list[str]]:
    """Whom the adjustments are for, a person's own after everybody's; and a sentence for each that
    changes nothing, because its id is nobody's, or that person has no submission."""
    own: dict[tuple[str, str], list[Adjustment]] = {}
    sentences = []
    for adjustment in sorted(adjustments, key=lambda one: one.student != EVERYBODY):
        who = adjustment.student
        meant = people.meant_by(who, students)
        for member, student in meant:
            own.setdefault((member.id, student.id), []).append(adjustment)
        if all(student.refused for _, student in meant) and who != EVERYBODY:
            words = f"nothing of {who!r} is graded, so it changes nothing; ids are as in grades.csv"
            sentences.append(f"{adjustment.where} {words}")
    return own, sentences


def give(summaries: Sequence[Summary], own: Own, course: Course, logins: bool) -> None:
    """Adds the final points of each person. Whom the roster finds in several submissions gets points
    from none of them; whom it finds in one, from no other. A login alone, which its student chose,
    gets no points."""
    graded = [summary for summary in summaries if summary.score is not None]
    given: dict[str, list[str]] = {}  # submissions that the roster gives to each person
    for student in (summary.student for summary in graded):
        for member in student.members:
            if member.listed:
                given.setdefault(member.id, []).append(f"{student.name} ({student.id})")
    for summary in graded:
        for member in summary.student.members:
            names = given.get(member.id, [])
            if member.listed and len(names) > 1:
                several = f"{ROSTER} gives {member.name or member.id} {' and '.join(names)}"
                summary.notes.append(
                    f"{several}: no points are filled in; write the id of theirs there"
                )
            elif names and not member.listed and not logins:
                why = f"{ROSTER} gives {member.id} the points of {' and '.join(names)} alone"
                summary.notes.append(why)
            else:
                adjustments = own.get((member.id, summary.student.id), [])
                summary.finals.append(_final(summary, member, adjustments, course))


def _final(summary: Summary, member: Member, own: Sequence[Adjustment], course: Course) -> Final:
    """Applies, in this order: dropped checks, lateness, points, caps."""
    points = summary.score or 0.0
    applied: list[Adjustment] = []

    def change(by: float, why: Adjustment) -> None:
        nonlocal points
        points += by
        applied.append(why._replace(points=round(by, 2)))

    lost = {id: check["max_score"] for id, check in summary.checks.items() if not check["passed"]}
    for adjustment in own:
        if adjustment.drop:
            given = sum(lost.pop(id, 0) for id in adjustment.drop)  # once, whoever drops it again
            change(given, adjustment)
    days = _late_days(summary, own) if course.percent_per_day else 0
    if days:
        percent = min(days * course.percent_per_day, course.at_most_percent)
        words = f"{short(days)} day{'s' * (days > 1)} late, {short(percent)} %"
        change(-min(points, full_points() * percent / 100), Adjustment("", "", reason=words))
    for adjustment in own:
        if adjustment.points or adjustment.late_days is not None:
            change(max(adjustment.points, -points), adjustment)
    for adjustment in own:
        if adjustment.cap is not None and points > adjustment.cap:
            change(adjustment.cap - points, adjustment)
    return Final(member.id, member.name, points, tuple(applied), member.listed)


def _late_days(summary: Summary, own: Sequence[Adjustment]) -> float:
    """The days that count as late: those that were written down, or the service's; where it says
    only that a submission is late, that counts as one day."""
    given = [a.late_days for a in own if a.late_days is not None]
    days = given[-1] if given else summary.student.late_days
    if days is None:
        unknown = "by how many days it is late can't be read, and counts as one"
        summary.notes.append(f"{unknown} unless {ADJUSTMENTS} says otherwise")
    return 1 if days is None else days
