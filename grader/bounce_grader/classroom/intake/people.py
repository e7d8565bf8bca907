"""Who gets the points of each submission, and whom an id means, by what is known of people: the grade
book, the instructor's roster, and the download."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from bounce_grader.classroom.intake.gradebook import Gradebook, only_one
from bounce_grader.classroom.intake.instructor_files import EVERYBODY, ROSTER
from bounce_grader.classroom.intake.services import is_name_of
from bounce_grader.classroom.intake.student import Class, Member, Names, Student
from bounce_grader.common.escaping import first_few

Person = tuple[Member, Student]  # who gets the points, and what was submitted


class People:
    """The people of a course."""

    def __init__(self, roster: Mapping[str, list[Member]], book: Gradebook) -> None:
        lines = only_one(book.by_any_id)
        names = {id: line.person for id, line in lines.items()}
        self._own_ids = {id: line.ids[0] for id, line in lines.items()}  # at the service
        self._in_book, self._late = only_one(book.by_own_id), book.late
        self._roster = {
            submission.casefold(): [m._replace(name=m.name or names.get(m.id, "")) for m in members]
            for submission, members in roster.items()
        }
        listed = [member for members in self._roster.values() for member in members]
        self._names = names | {member.id: member.name for member in listed}
        self._logins, self._submissions = False, set[str]()

    def assign(self, intake: Class) -> None:
        """Gives each submission its members, the name of its person, and the lateness that the grade
        book has."""
        self._logins = intake.logins
        self._submissions = {student.id.casefold() for student in intake.students}
        assigned = []
        for student in intake.students:
            listed = self._listed(student)
            late = self._late.get(student.id, student.late_days)
            student = replace(student, person=self._name(student, listed, intake), late_days=late)
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
        groups = [name for name in self._groups_of(own) if name not in self._submissions]
        return self._roster[groups[0]] if groups else []

    def _groups_of(self, own: str) -> list[str]:
        """What the roster calls the submissions of whoever has this id at the service."""
        same = self._own_ids
        return [n for n, of in self._roster.items() if own in [same.get(m.id, m.id) for m in of]]

    def names(self) -> Names:
        return {id: [line.person, *self._groups_of(id)] for id, line in self._in_book.items()}

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
