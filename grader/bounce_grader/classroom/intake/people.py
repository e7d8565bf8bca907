"""Who gets the points of each submission, and whom an id means, by what is known of people: the grade
book, the instructor's roster, and the download."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from bounce_grader.classroom.intake.canvas import is_name_of
from bounce_grader.classroom.intake.instructor_files import EVERYBODY, ROSTER
from bounce_grader.classroom.intake.student import Class, Member, Student
from bounce_grader.common.escaping import first_few

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
        self._own_ids = own_ids
        self._roster = {
            submission.casefold(): [m._replace(name=m.name or names.get(m.id, "")) for m in members]
            for submission, members in roster.items()
        }
        listed = [member for members in self._roster.values() for member in members]
        self._names = {**names, **{member.id: member.name for member in listed if member.name}}
        self._logins, self._submissions = False, set[str]()

    def assign(self, intake: Class) -> None:
        """Gives each submission its members, and the name of its person."""
        self._logins = intake.logins
        self._submissions = {student.id.casefold() for student in intake.students}
        assigned = []
        for student in intake.students:
            listed = self._listed(student)
            student = replace(student, person=self._name(student, listed, intake))
            members = tuple(listed or [Member(student.id, student.shown)])
            assigned.append(replace(student, members=members))
        intake.students = sorted(assigned, key=lambda s: (s.shown.casefold(), s.id))

    def _listed(self, student: Student) -> list[Member]:
        """A submission's members: those that the roster gives for its id, such as a login; or the
        group of whoever handed it in, unless the roster gives that group another's id. A group's
        name doesn't count, since students choose it; nor does a login count as an id."""
        members = self._roster.get(student.id.casefold(), [])
        if members or self._logins:
            return members
        own = self._own_ids.get(student.id, student.id)
        groups = [name for name in self.groups_of(own) if name not in self._submissions]
        return self._roster[groups[0]] if groups else []

    def groups_of(self, own: str) -> list[str]:
        """What the roster calls the submissions of whoever has this id at the service."""
        same = self._own_ids
        return [n for n, of in self._roster.items() if own in [same.get(m.id, m.id) for m in of]]

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

    def without_submission(self, students: Sequence[Student]) -> list[str]:
        """A sentence on lines of the roster that are of no submission; none if there are no such
        lines."""
        listed = {member.id for s in students for member in s.members if member.listed}
        idle = [name for name, of in self._roster.items() if not {m.id for m in of} & listed]
        words = "no submission is matched with that id or with a member"
        return [f"{ROSTER} lists {first_few(idle, separator='; ')}: {words}"] * bool(idle)

    def meant_by(self, id: str, students: Sequence[Student]) -> list[Person]:
        """The people whom an instructor means by an id: the one who has it in the grade book; else
        whoever has it in the roster or from the service; else the members of the submission with
        this id, such as a login. Students choose their logins, so a login never stands for a person
        of the grade book or of the roster."""
        people = [(member, student) for student in students for member in student.members]
        if id == EVERYBODY:
            return people
        known = [(m, s) for m, s in people if not (self._logins and m.id == s.id)]
        if own := self._own_ids.get(id):
            return [(m, s) for m, s in known if self._own_ids.get(m.id) == own]
        return [p for p in known if p[0].id == id] or [p for p in people if p[1].id == id]
