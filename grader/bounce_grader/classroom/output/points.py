"""Fills points into the gradebook of whichever service. What a person has entered stays, and so does
each cell that isn't filled in."""

import json
import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.gradebook import Gradebook, Line
from bounce_grader.classroom.intake.instructor_files import ROSTER
from bounce_grader.classroom.intake.student import Class, Member
from bounce_grader.classroom.intake.table import number_in
from bounce_grader.classroom.output.people import People
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import first_few
from bounce_grader.common.files import read_object, write_whole
from bounce_grader.common.manifest import full_points
from bounce_grader.common.numbers import short

WRITTEN = "written.json"  # the points that runs have filled in: what differs, a person has changed
# A column's title -> the service's id -> all points that runs have filled in there, or the page.
Written = dict[str, dict[str, Any]]


def require_same_class(book: Gradebook, intake: Class) -> None:
    """Raises UsageError if gradebook and submissions are of different services, where the same id
    can be different students, or have nobody in common."""
    if book.service and intake.service not in ("", book.service):
        file = f"{book.name} is a file from {book.service.capitalize()}"
        raise UsageError(f"{file}, and the submissions are {intake.source}: give both from one")
    members = [member for student in intake.students for member in student.members]
    from_canvas = intake.service == "canvas"
    if book.service and members and not (intake.logins or _whose(book, members, from_canvas)):
        raise UsageError(f"nobody who handed in is in {book.name}: is it of another course?")


def _whose(book: Gradebook, people: Sequence[Member], from_canvas: bool) -> dict[int, list[Member]]:
    """These people by the number of their lines. In a Canvas download, only the service's own ids and
    the roster's count: students choose all other numbers."""
    own, every = book.by_id(own=True), book.by_id()
    whose: dict[int, list[Member]] = {}
    for one in people:
        for line in (own if from_canvas and not one.listed else every).get(one.id, ()):
            whose.setdefault(line.number, []).append(one)
    return whose


def fill(
    book: Gradebook, finals: Sequence[Member], from_canvas: bool, written: Written, overwrite: bool
) -> tuple[list[tuple[Line, float]], list[str]]:
    """The lines that take points, which are also noted in `written`; and what the instructor should
    know. `from_canvas` says that the ids are those of a Canvas download. Points that already stand
    in a line are kept, unless earlier runs have `written` them, or if `overwrite` is set."""
    whose = _whose(book, finals, from_canvas)
    times = Counter(final.id for finals in whose.values() for final in finals)
    ours = written.setdefault(book.title, {})
    filled, sentences, without = [], _other_points_possible(book), []
    for line in filter(lambda line: any(line.ids), book.lines):
        meant, before = whose.get(line.number, []), ours.get(line.ids[0], [])
        who = f"{line.person} ({next(filter(None, line.ids))})"
        if not meant:
            without.append(who)
            continue
        if len(meant) == 1 and (count := times[meant[0].id]) > 1:
            why = f"has {count} rows in {book.name}: none is filled"
        else:
            why = _unfilled(line, meant, before, overwrite)
        if why:
            sentences.append(f"{who} {why}")
            continue
        points, name = f"{meant[0].points:.2f}", meant[0].name
        filled.append((line, float(points)))
        ours[line.ids[0]] = list(dict.fromkeys([*before, points]))
        if from_canvas and not meant[0].listed and name != line.person:
            whose_points = f"has the points of {name}: give the others of a group the same"
            sentences.append(f"{who} {whose_points}")
    others = sorted((one for one in finals if one.id not in times), key=lambda one: one.id)
    unsure = f"is graded, but {book.name} has no row that is surely theirs"
    sentences += [f"{one.name} ({one.id}) {unsure}" for one in others]
    if without:
        sentences.append(f"{first_few(without, 20, '; ')}: no score, so nothing is filled in")
    return filled, list(dict.fromkeys(sentences))


def _unfilled(line: Line, meant: Sequence[Member], before: Sequence[str], overwrite: bool) -> str:
    """Why a line takes no points of those that are meant; "" if it does."""
    if len(meant) > 1:
        several = " and ".join(f"{final.name} ({final.id})" for final in meant)
        return f"is meant by {several}: none is filled in"
    points, there = round(meant[0].points, 2), number_in(line.there)
    if line.stays or overwrite or not line.there or there in (points, *map(number_in, before)):
        return line.stays
    return f"keeps {line.there}, where {points:.2f} is graded; --overwrite replaces it"


def _other_points_possible(book: Gradebook) -> list[str]:
    return [
        f"{book.service.capitalize()} has {short(points)} points possible for {book.title}, the "
        f"kit {short(full_points())}: if it is the right column, change it there"
        for points in dict.fromkeys(map(number_in, book.possible))
        if points is not None and points != full_points()
    ]


def note(out: Path, written: Written) -> None:
    """Notes what runs have filled in and posted."""
    write_whole(out / WRITTEN, json.dumps(written, indent=1, sort_keys=True), durable=True)


def write(path: Path, people: People, summaries: Sequence[Summary], overwrite: bool) -> list[str]:
    """Fills a file in, for everyone who has a score: a missing one must not become a zero. A
    submission that is known by its GitHub login alone gets no points: its student could have chosen
    somebody else's id as a login. Returns sentences for the instructor."""
    book, submitted = people.book, people.intake
    assert book.table
    finals = [one._replace(name=one.name or s.student.shown) for s in summaries for one in s.finals]
    given = [one for one in finals if one.listed or not submitted.logins]
    written = read_object(path.with_name(WRITTEN))
    before = written.get(book.title, {})
    emptied = sum(line.ids[0] in before and not line.there for line in book.lines)
    from_canvas = submitted.service == "canvas"
    filled, sentences = fill(book, given, from_canvas, written, overwrite)
    is_decimal = re.compile(r"\d+[.,](\d\d?|\d{4,})").fullmatch  # "1,000" may be a thousand
    decimals = list(filter(is_decimal, (line.there for line in book.lines)))
    has_comma = any("," in points for points in decimals or list(filter(is_decimal, book.possible)))
    for line, points in filled:
        text = f"{points:.2f}".replace(".", "," if has_comma else ".")
        book.table.rows[line.number].cells[book.column] = text
    write_whole(path, book.table.encoded())
    note(path.parent, written)
    if emptied:  # in an old file, which lacks corrections since an earlier run, too
        cells = f"what an earlier run has filled into {emptied} cell{'s' * (emptied > 1)}"
        again = "export the grades again, or corrections made there since then are lost"
        sentences = [f"{book.name} lacks {cells}: if that is imported, {again}", *sentences]
    if unknown := [one.id for one in finals if one not in given]:
        where = f"not in {ROSTER}, so their points are in grades.csv alone"
        sentences = [f"{first_few(unknown, 20, '; ')}: {where}", *sentences]
    return sentences
