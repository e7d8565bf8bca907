"""Works out final points: those of the grading, with what lateness costs and the adjustments of
the instructor. Records stay as they are."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from bounce_grader.classroom.grading.summary import Applied, Final, Summary
from bounce_grader.classroom.intake.instructor_files import (
    Adjustment,
    ADJUSTMENTS,
    Course,
    EVERYBODY,
    ROSTER,
)
from bounce_grader.classroom.intake.people import People
from bounce_grader.classroom.intake.student import Class, Member, Student
from bounce_grader.common.escaping import first_few
from bounce_grader.common.manifest import full_points
from bounce_grader.common.numbers import short


class Assigned(NamedTuple):
    """Whom the adjustments are for."""

    # By the member's and the submission's id.
    own: Mapping[tuple[str, str], Sequence[Adjustment]]
    sentences: list[str]  # one for each that changes nothing


def assign(
    adjustments: Sequence[Adjustment], people: People, students: Sequence[Student]
) -> Assigned:
    """An adjustment changes nothing if its id is nobody's, or that person has no submission."""
    own: dict[tuple[str, str], list[Adjustment]] = {}
    sentences = []
    for adjustment in adjustments:
        who = adjustment.student
        meant = people.meant_by(who, students)
        for member, student in meant:
            own.setdefault((member.id, student.id), []).append(adjustment)
        if not meant and who != EVERYBODY:
            sentences.append(
                f"{who} has no submission: the adjustment ({adjustment.reason}) changes nothing"
                if people.known(who)
                else f"{adjustment.where} nobody here has the id {who!r}, so it changes nothing: "
                "give an id as in grades.csv, or * for everybody"
            )
    return Assigned(own, sentences)


def with_finals(
    summaries: Sequence[Summary], assigned: Assigned, course: Course, logins: bool
) -> list[Summary]:
    """Adds the final points of each person. Whom the roster finds in several submissions gets points
    from none of them; whom it finds in one, from no other. A login alone, which its student chose,
    gets no points."""
    finals = {
        s.student.id: [
            _final(s, member, assigned.own.get((member.id, s.student.id), []), course)
            for member in s.student.members
            if s.score is not None
        ]
        for s in summaries
    }
    shown = {s.student.id: f"{s.student.name} ({s.student.id})" for s in summaries}
    given: dict[str, list[str]] = {}  # submissions that the roster gives to each person
    for id, of in finals.items():
        for one in of:
            if one.listed:
                given.setdefault(one.id, []).append(shown[id])
    done = []
    for summary in summaries:
        counting = []
        for one in finals[summary.student.id]:
            of_person = given.get(one.id, [])
            names = " and ".join(of_person)
            if one.listed and len(of_person) > 1:
                summary = summary.with_note(
                    f"{ROSTER} gives {one.name or one.id} the points of several submissions "
                    f"({names}): none is filled in; write the submission's id there that is theirs"
                )
            elif of_person and not one.listed and not logins:
                summary = summary.with_note(f"{ROSTER} gives {one.id} the points of {names} alone")
            else:
                counting.append(one)
        done.append(summary.with_finals(counting))
    return done


def _final(summary: Summary, member: Member, own: Sequence[Adjustment], course: Course) -> Final:
    """Applies, in this order: dropped checks, lateness, points, caps."""
    points = summary.score or 0.0
    applied: list[Applied] = []

    def change(by: float, reason: str, comment: str = "") -> None:
        nonlocal points
        points += by
        applied.append(Applied(round(by, 2), reason, comment))

    for adjustment in own:
        if adjustment.drop:
            lost = set(adjustment.drop) - summary.passed
            given = sum(summary.most.get(id, 0.0) for id in lost)
            change(given, adjustment.reason, adjustment.comment)
    days = _late_days(summary.student, own)
    if days and course.percent_per_day:
        percent = min(days * course.percent_per_day, course.at_most_percent)
        words = f"{days} day{'s' * (days > 1)} late, {short(percent)} %"
        change(-min(points, full_points() * percent / 100), words)
    for adjustment in own:
        if adjustment.points or adjustment.late_days is not None:
            change(max(adjustment.points, -points), adjustment.reason, adjustment.comment)
    for adjustment in own:
        if adjustment.cap is not None and points > adjustment.cap:
            change(adjustment.cap - points, adjustment.reason, adjustment.comment)
    return Final(member.id, member.name, points, tuple(applied), member.listed)


def _late_days(student: Student, own: Sequence[Adjustment]) -> int:
    """The days that count as late: those that were written down, or the service's; where it says
    only that a submission is late, that counts as one day."""
    given = [a.late_days for a in own if a.late_days is not None]
    return given[-1] if given else student.late_days or int(student.late)


def unknown_lateness(
    course: Course, intake: Class, own: Mapping[tuple[str, str], Sequence[Adjustment]]
) -> list[str]:
    """A sentence if lateness costs points, and neither the service nor an adjustment says how late
    somebody was."""
    if not course.percent_per_day:
        return []
    if not intake.tells_lateness:
        worksheet = ", except in the grading worksheet, under Status (give it as --gradebook)"
        return [
            f"lateness costs points by course.toml, but {intake.source} doesn't say who was late"
            f"{worksheet if intake.service == 'moodle' else ''}: only {ADJUSTMENTS} can tell"
        ]
    vague = [
        student.shown
        for student in intake.students
        if student.late and not student.late_days
        if any(
            all(a.late_days is None for a in own.get((member.id, student.id), []))
            for member in student.members
        )
    ]
    return [
        f"how many days late these are can't be read from {intake.service.capitalize()}'s files, "
        f"and counts as one day unless {ADJUSTMENTS} says otherwise: "
        f"{first_few(vague, separator='; ')}"
    ] * bool(vague)


def adjusted(summaries: Sequence[Summary]) -> list[str]:
    """A sentence for each person whose points were changed after the grading."""
    return [
        f"{one.name or one.id} ({one.id}): {short(summary.score or 0.0)} -> "
        f"{short(round(one.points, 2))} points ({one.changes})"
        for summary in summaries
        for one in summary.finals
        if one.applied
    ]
