"""Who gets the points of each submission, and whom a name or an id means, by what is known of people:
the grade book, the instructor's roster, and the download."""

import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import replace

from bounce_grader.classroom.intake.canvas import is_name_of, sanitized
from bounce_grader.classroom.intake.instructor_files import EVERYBODY
from bounce_grader.classroom.intake.student import Class, Member, Student

Person = tuple[Member, Student]  # who gets the points, and what was submitted


class People:
    """The people of a course."""

    def __init__(
        self,
        roster: Mapping[str, list[Member]],
        names: Mapping[str, str] = {},
        own_ids: Mapping[str, str] = {},
    ) -> None:
        """`names` are those in the grade book, by each id that one person has there; `own_ids`, the
        service's own ids, by the same ids."""
        named = {
            submission: [m._replace(name=m.name or names.get(m.id, "")) for m in members]
            for submission, members in roster.items()
        }
        self._own_ids = own_ids
        self._roster = {name.casefold(): members for name, members in named.items()}
        self._in_canvas = {sanitized(name): members for name, members in named.items()}
        self._names = {**names, **{m.id: m.name for of in named.values() for m in of if m.name}}
        self._logins = False

    def assign(self, intake: Class) -> None:
        """Gives each submission its members, and the name of its person."""
        self._logins = intake.logins
        assigned = []
        for student in intake.students:
            listed = self._listed(student)
            student = replace(student, person=self._name(student, listed, intake))
            members = tuple(listed or [Member(student.id, student.shown)])
            assigned.append(replace(student, members=members))
        intake.students = sorted(assigned, key=lambda s: (s.shown.casefold(), s.id))

    def _listed(self, student: Student) -> list[Member]:
        """A submission's members in the roster, which may have its id or its name. Students choose
        that name, so it counts only if the student who handed in is one of the members."""
        own = self._roster.get(student.id.casefold(), [])
        named = self._roster.get(student.name.casefold(), [])
        if not named and student.uploads:
            named = self._in_canvas.get(student.name, [])
        ids = {self._own_ids.get(member.id, member.id) for member in named}
        return own or (named if self._own_ids.get(student.id, student.id) in ids else [])

    def _name(self, student: Student, members: Sequence[Member], intake: Class) -> str:
        """The name of a submission's person, as the roster or the grade book has it. In a Canvas
        download, a group has the id of one of its members, but a name of its own."""
        if members:
            names = [member.name for member in members]
            return " and ".join(names) if all(names) else student.person
        person = "" if intake.logins else self._names.get(student.id, "")
        if intake.service == "canvas":
            own = self._own_ids.get(student.id) == student.id
            return person if own and is_name_of(person, student.name) else student.person
        return person or (student.name if intake.service else student.person)

    def known(self, who: str) -> bool:
        return who in self._names or any(_is_called(who, name) for name in self._names.values())

    def meant_by(self, who: str, students: Sequence[Student]) -> list[Person]:
        """The people whom an instructor means. The first rule that finds somebody counts:

        1. an id or a name in the grade book; if it has that person, only this rule is tried;
        2. an id in the roster, or an id that the service gave;
        3. the id of a submission, such as a login;
        4. a name in the roster or the grade book;
        5. the name of a submission.

        What students can choose comes last: a login never stands for a person of the grade book, and
        a number is never a name.
        """
        people = [(member, student) for student in students for member in student.members]
        if who == EVERYBODY:
            return people
        in_book = self._in_book(who)
        by_name = not in_book and not who.isdigit()
        ranked: dict[int, list[Person]] = {}
        for member, student in people:
            chosen_id = self._logins and member.id == student.id
            listed = member.name if member.id != student.id else student.person
            ways = [
                not chosen_id and self._own_ids.get(member.id) in in_book,
                not in_book and not chosen_id and who == member.id,
                not in_book and who == student.id,
                by_name and _is_called(who, listed),
                by_name and not self._logins and _is_called(who, student.name),
            ]
            if True in ways:
                ranked.setdefault(ways.index(True), []).append((member, student))
        return ranked[min(ranked)] if ranked else []

    def several(self, who: str, meant: Sequence[Person]) -> list[str]:
        """The ids of the people of whom it isn't clear which one is meant; none if it is clear."""
        in_book = sorted(self._in_book(who))
        if len(in_book) > 1:
            return in_book
        is_id = who in self._own_ids or any(who in (m.id, s.id) for m, s in meant)
        submissions = {s.id: s.name for _, s in meant}
        is_group = len(submissions) == 1 and any(_is_called(who, n) for n in submissions.values())
        clear = who == EVERYBODY or is_id or is_group or len(meant) < 2
        return [] if clear else [member.id for member, _ in meant]

    def _in_book(self, who: str) -> set[str]:
        """The service's ids of the people in the grade book that have this id or this name."""
        if who in self._own_ids:
            return {self._own_ids[who]}
        names = ((own, self._names[id]) for id, own in self._own_ids.items() if id in self._names)
        return {own for own, name in names if _is_called(who, name)}


def _is_called(who: str, name: str) -> bool:
    """Whether a person has this name, as "Doe, Jane" or "Jane Doe", or as Canvas spells it in a
    download, "doejane"."""
    one, other = (
        sorted(unicodedata.normalize("NFC", text).casefold().replace(",", " ").split())
        for text in (who, name)
    )
    return bool(name) and (one == other or sanitized(who) == name)
