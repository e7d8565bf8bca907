"""Who gets the points of each submission, by what is known of people: the gradebook, the
instructor's roster, and the download; and what the instructor changes and says for whom."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import course, instructor_files as files
from bounce_grader.classroom.intake.gradebook import Gradebook
from bounce_grader.classroom.intake.services import is_name_of
from bounce_grader.classroom.intake.student import Adjustment, Class, Member, Names, Student
from bounce_grader.classroom.intake.table import in_csv
from bounce_grader.classroom.output.final_points import final
from bounce_grader.common.escaping import alphabetical, first_few

Person = tuple[Member, Student]  # who gets the points, and what was submitted


class People:
    """The people of a course."""

    def __init__(self, out: Path, book: Gradebook) -> None:
        """Reads the instructor's files in the folder `out`. Raises UsageError."""
        self.book, self.course = book, course.course(out)
        self._used = course.used_before(out, self.course)
        self._adjustments, self.comments = files.adjustments(out), files.comments(out)
        names = {id: line.person for id, line in book.people().items()}
        self._own_ids = {id: line.ids[0] for id, line in book.people().items()}  # at the service
        self._roster: dict[str, list[Member]] = defaultdict(list)
        for submission, member in files.roster(out):
            named = member._replace(name=member.name or names.get(member.id, ""))
            self._roster[submission.casefold()].append(named)
        listed = [member for members in self._roster.values() for member in members]
        self._names = names | {member.id: member.name for member in listed}
        self.intake = Class("")  # until assign reads it
        self._adjusted: dict[tuple[str, str], list[Adjustment]] = defaultdict(list)

    def names(self) -> Names:
        lines = self.book.people(own=True)
        return {id: [line.person, *self._groups_of(id)] for id, line in lines.items()}

    def _groups_of(self, own: str) -> list[str]:
        """What the roster calls the submissions of whoever has this id at the service."""
        same = self._own_ids
        return [n for n, of in self._roster.items() if own in [same.get(m.id, m.id) for m in of]]

    def assign(self, intake: Class) -> list[str]:
        """Gives each submission its members, the name of its person, and the gradebook's lateness.
        Returns sentences if nobody tells that, and on what the instructor's files say of nobody."""
        self.intake = intake
        submissions = {student.id.casefold() for student in intake.students}
        assigned = []
        for student in intake.students:
            own = self._listed(student, submissions)
            late = self.book.late.get(student.id, student.seconds_late)
            student = student._replace(person=self._name(student, own), seconds_late=late)
            members = tuple(own or [Member(student.id, student.shown)])
            assigned.append(student._replace(members=members))
        intake.students = sorted(assigned, key=lambda s: (alphabetical(s.shown), s.id))
        listed = {member.id for member, _ in self._people() if member.listed}
        return [*self._idle_policy(intake), *self._adjust(), *self._idle(listed)]

    def _people(self) -> list[Person]:
        return [(member, student) for student in self.intake.students for member in student.members]

    def _listed(self, student: Student, submissions: set[str]) -> list[Member]:
        """A submission's members: those that the roster gives for its id, such as a login; or the
        group of whoever handed it in, unless the roster gives that group another's id. A group's
        name doesn't count, since students choose it; nor does a login count as an id."""
        members = self._roster.get(student.id.casefold(), [])
        if members or self.intake.logins:
            return members
        own = self._own_ids.get(student.id, student.id)
        groups = [name for name in self._groups_of(own) if name not in submissions]
        return self._roster[groups[0]] if groups else []

    def _name(self, student: Student, members: Sequence[Member]) -> str:
        """The name of a submission's person, from the roster or the gradebook. A group in a Canvas
        download has a member's id, but its own name."""
        if members:
            names = [member.name for member in members]
            return " and ".join(names) if all(names) else student.person
        person = "" if self.intake.logins else self._names.get(student.id, "")
        if self.intake.service == "canvas":
            own = self._own_ids.get(student.id) == student.id
            return person if own and is_name_of(person, student.name) else student.person
        return person or (student.name if self.intake.service else student.person)

    def _idle_policy(self, intake: Class) -> Iterator[str]:
        """A sentence on each part of the policy that changes nothing here."""
        ids, policy = [student.id for student in intake.students], self.course
        given = sum(one.late_days is not None for one in self._adjustments)
        if given and not policy.percent_per_day:
            lines = f"late_days in {given} line{'s' * (given > 1)} of {files.ADJUSTMENTS}"
            yield f"{lines} changes nothing: {course.COURSE} has no percent_per_day below [late]"
        if policy.percent_per_day and not (intake.service == "canvas" or self.book.late):
            worksheet = ", and so does the grading worksheet (--gradebook)"
            can = f"{files.ADJUSTMENTS} can{worksheet * (intake.service == 'moodle')}"
            costs = f"lateness costs points by {course.COURSE}"
            yield f"{costs}, but {intake.source} doesn't say who was late: {can}"
        if policy.earlier and not self._used.keys() & {in_csv(m.id) for m, _ in self._people()}:
            none = "has none of these students' ids, so all of their free days are left"
            yield f"{course.SLIP_DAYS} of earlier assignments {none}"
        if policy.attempt == "best" and len({*ids}) == len(ids):
            yield f"the best attempt counts, but {intake.source} has one of each student"

    def _adjust(self) -> list[str]:
        """Notes whom each adjustment is for, a person's own after everybody's. Returns a sentence
        for each that changes nothing."""
        sentences = []
        for adjustment in sorted(self._adjustments, key=lambda one: one.student != files.EVERYBODY):
            who = adjustment.student
            meant = self._people() if who == files.EVERYBODY else self.meant_by(who)
            for member, student in meant:
                rows = self._adjusted[member.id, student.id]
                rows += [adjustment] * (adjustment not in rows)  # once for all attempts
            if all(student.refused for _, student in meant) and who != files.EVERYBODY:
                words = "is graded, so it changes nothing; ids are as in grades.csv"
                sentences.append(f"{adjustment.where} nothing of {who!r} {words}")
        return sentences

    def meant_by(self, id: str) -> list[Person]:
        """The people whom an instructor means by an id: the one who has it in the gradebook; else
        whoever has it in the roster or from the service; else the members of the submission with
        this id, such as a login. Students choose their logins, so a login never stands for a person
        of the gradebook or of the roster."""
        people = self._people()
        known = [(m, s) for m, s in people if not (self.intake.logins and m.id == s.id)]
        if own := self._own_ids.get(id):
            return [(m, s) for m, s in known if self._own_ids.get(m.id) == own]
        return [p for p in known if p[0].id == id] or [p for p in people if p[1].id == id]

    def _idle(self, listed: set[str]) -> list[str]:
        """A sentence on lines of the roster that are of no submission, if there are any."""
        idle = [name for name, of in self._roster.items() if not {m.id for m in of} & listed]
        words = "no submission is matched with that id or with a member"
        return [f"{files.ROSTER} lists {first_few(idle, separator='; ')}: {words}"] * bool(idle)

    def give_points(self, summaries: Sequence[Summary]) -> list[Summary]:
        """Adds the final points of each person. Returns the submissions that count: of several
        attempts, the one with most points in the end, or the latest of these. If the roster lists
        somebody for several submissions, none of them gives points; if for one, no other does. A
        login alone gets no points."""
        attempts: dict[str, list[Summary]] = defaultdict(list)
        for summary in summaries:
            attempts[summary.student.id].append(summary)
        counting = [self._best(of) for of in attempts.values()]
        graded = [(m, s) for s in counting if s.score is not None for m in s.student.members]
        given: dict[str, list[str]] = defaultdict(list)  # submissions, by the roster's ids
        for member, summary in graded:
            if member.listed:
                given[member.id].append(f"{summary.student.name} ({summary.student.id})")
        for member, summary in graded:
            names = " and ".join(given[member.id])
            note, gives = summary.notes.append, f"{files.ROSTER} gives"
            if member.listed and len(given[member.id]) > 1:
                why = "no points are filled in; write the id of theirs there"
                note(f"{gives} {member.name or member.id} {names}: {why}")
            elif names and not member.listed and not self.intake.logins:
                note(f"{gives} {member.id} the points of {names} alone")
            else:
                summary.finals.append(self._final(summary, member))
        return counting

    def _final(self, summary: Summary, member: Member) -> Member:
        own = self._adjusted[member.id, summary.student.id]
        return final(summary, member, own, self.course, self._used.get(in_csv(member.id), 0))

    def _best(self, attempts: Sequence[Summary]) -> Summary:
        def points(one: Summary) -> float:
            return sum(self._final(one, member).points for member in one.student.members)

        if len(attempts) == 1:
            return attempts[0]
        graded = [one for one in attempts if one.score is not None] or attempts
        best = max(reversed(graded), key=points)
        best.attempt = f"attempt {attempts.index(best) + 1} of {len(attempts)}, the best"
        return best
