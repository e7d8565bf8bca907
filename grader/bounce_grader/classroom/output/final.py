"""Works out final points: those of the grading, with what lateness costs and the adjustments of
the instructor. Records stay as they are."""

import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from bounce_grader.classroom.grading.summary import Applied, Final, Summary
from bounce_grader.classroom.intake.adjustments import EVERYBODY, NAME, Adjustment
from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.classroom.intake.course import Course
from bounce_grader.classroom.intake.roster import Member, Roster
from bounce_grader.classroom.intake.student import Class, Student
from bounce_grader.common.escaping import first_few
from bounce_grader.common.manifest import parts
from bounce_grader.common.numbers import short


Person = tuple[Member, Student]  # who gets the points, and what was submitted


@dataclass(frozen=True)
class Rules:
    """What an instructor has written into the files of the output folder."""

    course: Course = Course()
    roster: Roster = field(default_factory=lambda: Roster({}))
    adjustments: Sequence[Adjustment] = ()
    same_person: Mapping[str, str] = field(default_factory=dict)  # Canvas's id, by each other id
    names: Mapping[str, str] = field(default_factory=dict)  # of the grade book, by Canvas's ids
    logins: bool = False  # whether students choose the ids of submissions


@dataclass
class Meant:
    """Whom the adjustments are for."""

    # By the member's and the submission's id.
    own: dict[tuple[str, str], list[Adjustment]] = field(default_factory=dict)
    unclear: dict[str, list[str]] = field(default_factory=dict)  # why, by the submission's id
    left_out: list[str] = field(default_factory=list)  # a sentence for each that changes nothing


def meant_by(rules: Rules, students: Sequence[Student], others: Mapping[str, str]) -> Meant:
    """An adjustment changes nothing if its name is nobody's, or that of several people, or that
    person has no submission. `others` are the names of the whole course, by id."""
    people = [(member, s) for s in students for member in members(s, rules.roster)]
    found = Meant()
    for adjustment in rules.adjustments:
        meant = _people_of(adjustment.student, people, rules)
        why = _unclear(adjustment, meant, rules)
        if why or not meant and adjustment.student != EVERYBODY:
            found.left_out.append(why or _unknown(adjustment, others))
        for member, student in meant:
            if why:
                found.unclear.setdefault(student.id, []).append(why)
            else:
                found.own.setdefault((member.id, student.id), []).append(adjustment)
    return found


def with_finals(summaries: Iterable[Summary], rules: Rules, meant: Meant) -> list[Summary]:
    """Adds the final points of each person. Somebody whom the roster finds in several submissions
    gets points from none of them: students choose the names of groups, so one group may have taken
    another's name."""
    with_all = [
        replace(
            s,
            finals=tuple(_finals(s, rules, meant.own)),
            notes=(*s.notes, *dict.fromkeys(meant.unclear.get(s.student.id, []))),
        )
        for s in summaries
    ]
    by_id: dict[str, list[str]] = {}
    for summary in with_all:
        for one in summary.finals:
            if one.listed or not rules.logins:  # a login alone gets no points
                by_id.setdefault(one.id, []).append(summary.student.shown)
    return [_without_disputed_members(summary, by_id) for summary in with_all]


def _without_disputed_members(summary: Summary, by_id: Mapping[str, list[str]]) -> Summary:
    rivals = [one for one in summary.finals if one.listed and len(by_id[one.id]) > 1]
    for one in rivals:
        names = " and ".join(map(repr, by_id[one.id]))
        summary = summary.with_note(
            f"roster.csv gives {one.name or one.id} the points of several submissions ({names}): "
            "none is filled in; write the submission's id there that is theirs"
        )
    return replace(summary, finals=tuple(one for one in summary.finals if one not in rivals))


def members(student: Student, roster: Roster) -> list[Member]:
    """Who gets the points of a submission: its members in the roster, or the student."""
    return roster.members_of(student) or [Member(student.id, student.shown)]


def _finals(
    summary: Summary, rules: Rules, adjustments: Mapping[tuple[str, str], list[Adjustment]]
) -> Iterable[Final]:
    if summary.score is None:
        return
    for member in members(summary.student, rules.roster):
        own = adjustments.get((member.id, summary.student.id), [])
        listed = bool(rules.roster.members_of(summary.student))
        yield replace(_final(summary, member, own, rules.course), listed=listed)


def _final(summary: Summary, member: Member, own: list[Adjustment], course: Course) -> Final:
    most = sum(part.points for part in parts())
    points = {0: summary.score or 0.0, **summary.parts}
    applied: list[Applied] = []

    def change(by: float, reason: str, comment: str = "") -> None:
        points[0] += by
        applied.append(Applied(round(by, 2), reason, comment))

    for adjustment in own:
        given = _dropped(summary, adjustment)
        for part, by in given.items():
            points[part] += by
        if adjustment.drop:
            change(sum(given.values()), adjustment.reason, adjustment.comment)
    days = _late_days(summary.student, own)
    if days and course.percent_per_day:
        percent = min(days * course.percent_per_day, course.at_most_percent)
        words = f"{days} day{'s' * (days > 1)} late, {short(percent)} %"
        change(-min(points[0], most * percent / 100), words)
    for adjustment in own:
        by = adjustment.points + most * adjustment.percent / 100
        if by:
            change(max(by, -points[0]), adjustment.reason, adjustment.comment)
        elif adjustment.late_days is not None:
            change(0.0, adjustment.reason, adjustment.comment)
    for adjustment in own:
        if adjustment.cap is not None and points[0] > adjustment.cap:
            change(adjustment.cap - points[0], adjustment.reason, adjustment.comment)
    return Final(member.id, member.name, points, tuple(applied))


def _dropped(summary: Summary, adjustment: Adjustment) -> dict[int, float]:
    """The points of the dropped checks that were lost, by part."""
    lost: dict[int, float] = {}
    for part in parts():
        for check in part.checks:
            if check.id in adjustment.drop and check.id not in summary.passed:
                lost[part.number] = lost.get(part.number, 0.0) + summary.most.get(check.id, 0.0)
    return lost


def unknown_lateness(course: Course, intake: Class, is_told: bool) -> list[str]:
    """A sentence if lateness costs points, and isn't known of somebody."""
    vague = [s.shown for s in intake.students if s.late and not s.late_days]
    if not course.percent_per_day or (is_told and not vague):
        return []
    if is_told:
        service = intake.service.capitalize()
        return [
            f"how many days late these are can't be read from {service}'s files, and counts as one "
            f"day unless {NAME} says otherwise: {first_few(vague)}"
        ]
    worksheet = ", except in the grading worksheet, under Status (give it as --gradebook)"
    return [
        f"lateness costs points by course.toml, but {intake.source} doesn't say who was late"
        f"{worksheet if intake.service == 'moodle' else ''}: only {NAME} can tell"
    ]


def _late_days(student: Student, own: Iterable[Adjustment]) -> int:
    """The days that count as late: those that were written down, or the service's; where it says
    only that a submission is late, that counts as one day."""
    given = [a.late_days for a in own if a.late_days is not None]
    return given[-1] if given else student.late_days or int(student.late)


def _people_of(who: str, people: Sequence[Person], rules: Rules) -> list[Person]:
    """The people whom an adjustment is for. The first rule that finds somebody counts:

    1. an id or a name in the grade book; if it has that person, only this rule is tried;
    2. an id in the roster, or an id that the service gave;
    3. the id of a submission, such as a login;
    4. a name in the roster or the grade book;
    5. the name of a submission.

    What students can choose comes last: a login never stands for a person of the grade book, and a
    number is never a name.
    """
    if who == EVERYBODY:
        return list(people)
    persons = _persons(who, rules)
    ranked: dict[int, list[Person]] = {}
    for member, student in people:
        chosen_id = rules.logins and member.id == student.id
        ids = [
            not chosen_id and rules.same_person.get(member.id) in persons,
            not persons and not chosen_id and who == member.id,
            not persons and who == student.id,
        ]
        listed = member.name if member.id != student.id else student.person
        names = [_is_called(who, listed), not rules.logins and _is_called(who, student.name)]
        ways = [*ids, *(is_so and not persons and not who.isdigit() for is_so in names)]
        if True in ways:
            ranked.setdefault(ways.index(True), []).append((member, student))
    return ranked[min(ranked)] if ranked else []


def _persons(who: str, rules: Rules) -> set[str]:
    """The grade book's ids of the people there that have this id or this name."""
    if who in rules.same_person:
        return {rules.same_person[who]}
    return {person for person, name in rules.names.items() if _is_called(who, name)}


def _is_called(who: str, name: str) -> bool:
    """Whether a person has this name, as "Doe, Jane" or "Jane Doe", or as Canvas spells it in a
    download, "doejane"."""
    if not name:
        return False
    one, other = (
        sorted(unicodedata.normalize("NFC", text).casefold().replace(",", " ").split())
        for text in (who, name)
    )
    return one == other or sanitized(who) == name


def adjusted(summaries: list[Summary]) -> list[str]:
    """A sentence for each person whose points were changed after the grading."""
    lines = []
    for summary in summaries:
        for one in summary.finals:
            changes = ", ".join(f"{a.reason} {a.points:+g}" for a in one.applied)
            if changes:
                who = f"{one.name or one.id} ({one.id})"
                before, after = short(summary.score or 0.0), short(round(one.points[0], 2))
                lines.append(f"{who}: {before} -> {after} points ({changes})")
    return lines


def _unclear(adjustment: Adjustment, meant: list[Person], rules: Rules) -> str:
    """Why it isn't clear which of several people an adjustment is for; "" if it is clear."""
    who = adjustment.student
    ids = sorted(_persons(who, rules))
    if len(ids) < 2:
        is_id = who in rules.same_person or any(who in (m.id, s.id) for m, s in meant)
        is_group = len({s.id for _, s in meant}) == 1 and any(
            _is_called(who, s.name) for _, s in meant
        )
        ids = [] if who == EVERYBODY or is_id or is_group else [m.id for m, _ in meant]
    if len(ids) < 2:
        return ""
    return (
        f"{_where(adjustment)} {who!r} is the name of {len(ids)} persons ({first_few(ids)}), and "
        "changes nothing for any of them: give the id of the one that is meant"
    )


def _unknown(adjustment: Adjustment, others: Mapping[str, str]) -> str:
    who = adjustment.student
    if who in others or any(_is_called(who, name) for name in others.values()):
        return f"{who} has no submission: the adjustment ({adjustment.reason}) changes nothing"
    return (
        f"{_where(adjustment)} nobody here is {who!r}, so it changes nothing: give an id or a name "
        "as in grades.csv, or * for everybody"
    )


def _where(adjustment: Adjustment) -> str:
    return f"{NAME}, line {adjustment.line}:"
