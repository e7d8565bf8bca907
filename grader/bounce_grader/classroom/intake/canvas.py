"""Finds each student's submission in Canvas's bulk download, packed or unpacked, by the names that
its lib/content_zipper.rb writes.

    {name}[_LATE]_{user id}_{attachment id}_{file}
    [LATE_]anon_{anonymous id}_{attachment id}_{file}
    {name}[_LATE]_{user id}_text.html, or _link.html: a text entry, or a web address

A name is in lower case and holds only letters, digits and "_", so LATE is never part of it. A name
may end in "_12", as a group's does, and a file name may begin with "12_"; such an entry is
ambiguous (`read_all`).
"""

import re
import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.classroom.intake.archive import Archive, Damaged, is_folder, opened
from bounce_grader.classroom.intake.student import Class, Student, Unmatched, Upload
from bounce_grader.classroom.intake.uploads import (
    HAND_IN,
    may_count,
    MOST_UPLOADS,
    of_no_use,
    refused,
    texts_of,
)
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting
from bounce_grader.submission.intake import NOT_USED
from bounce_grader.submission.submission import COPY, part_file

ID = "[0-9]{1,20}"
USER = rf"(?P<user>anon_[A-Za-z0-9]{{1,20}}|{ID})"
WHO = rf"(?:(?!LATE_|anon_)(?P<name>.+?)_)?(?:(?P<late>LATE)_)?{USER}"
UPLOAD = re.compile(rf"{WHO}_(?P<attachment>{ID})_(?P<file>.+)", re.DOTALL)
ENTRY = re.compile(rf"{WHO}_(?P<kind>text|link)\.html", re.DOTALL)
EITHER = (
    "could be one of several users', by its name: look in Canvas who handed it in, and grade it by "
    "itself with ./kit grade"
)


@dataclass(frozen=True)
class TextEntry:
    """A text or a web address that a student or a group typed into Canvas."""

    name: str
    user: str
    late: bool
    kind: str  # "text" or "link"


def parse(entry: str) -> Upload | TextEntry | None:
    """Parses an entry's name; None if Canvas doesn't write such names."""
    match = ENTRY.fullmatch(entry)
    if match:
        return TextEntry(match["name"] or "", match["user"], bool(match["late"]), match["kind"])
    match = UPLOAD.fullmatch(entry)
    if not match:
        return None
    user, attachment, file = match["user"], int(match["attachment"]), match["file"]
    return Upload(entry, match["name"] or "", user, bool(match["late"]), attachment, file)


def wrote_all(entries: Iterable[str]) -> bool:
    """Whether Canvas can have written all of these names. It gives each file an id of its own; what
    Blackboard writes of the user 12345 and an assignment "HW_3" looks like one file, several times.
    """
    parsed = [parse(entry) for entry in entries]
    ids = [upload.attachment for upload in parsed if isinstance(upload, Upload)]
    return all(parsed) and len(set(ids)) == len(ids)


def read_all(
    entries: Iterable[str], people: Mapping[str, str] = {}
) -> dict[str, Upload | TextEntry | None]:
    """Reads the names of all entries. The value is None for a name that Canvas doesn't write, and
    for an ambiguous one: students choose their names and the names of their files, so an entry can
    often be split in several ways. `people` are the names in the grade book, by Canvas's ids. An
    ambiguous entry counts for the one person there whose id and name it can be read with, unless
    another entry certainly has that id, or can be read with that id and another name."""
    possible = {entry: readings(entry) for entry in entries}
    read = {entry: found[0] if len(found) == 1 else None for entry, found in possible.items()}
    certain = {found[0].user for found in possible.values() if len(found) == 1}
    names: dict[str, set[str]] = {}  # that stand before a user's id
    for reading in (reading for found in possible.values() for reading in found):
        names.setdefault(reading.user, set()).add(reading.name)
    for entry in (entry for entry, found in possible.items() if len(found) > 1):
        known = [reading for reading in possible[entry] if reading.user in people]
        users = {reading.user for reading in known}
        if len(known) == 1 and not users & certain and len(names[known[0].user]) == 1:
            if is_name_of(people[known[0].user], known[0].name):
                read[entry] = known[0]
    return read


def readings(entry: str) -> list[Upload | TextEntry]:
    """All ways to split an entry's name into its fields."""
    first = parse(entry)
    if first is None or (first.user.startswith("anon_") and not first.name):
        return [first] if first else []
    typed_or_anonymous = isinstance(first, TextEntry) or first.user.startswith("anon_")
    possible: list[Upload | TextEntry] = [first] if typed_or_anonymous else []
    ids = re.compile(rf"(?<!_LATE)(?=(?:^|_)(LATE_)?({ID})_({ID})_(.+))", re.DOTALL)
    for match in ids.finditer(entry):
        late, user, attachment, file = match.groups()
        name = entry[: match.start()]
        possible.append(Upload(entry, name, user, bool(late), int(attachment), file))
    return possible


def feedback_name(uploads: tuple[Upload, ...]) -> str:
    """The name for a feedback page that Canvas accepts as a comment: it has the ids of the newest
    upload."""
    newest = max(uploads, key=lambda upload: upload.attachment)
    ids = newest.entry[len(newest.name) : -len(newest.file)]
    return f"{printable_name(fitting(newest.name, 150))}{ids}feedback.html"


def sanitized(sortable_name: str) -> str:
    """What Canvas makes of "Doe, Jane": doejane."""
    flat = re.sub(r"_(\d+)_", r"\1", sortable_name).lower()
    return "".join(filter(_in_a_word, flat))


def is_name_of(person: str, canvas_name: str) -> bool:
    """Letter for letter, in whichever order and however an accent is written."""
    names = (sanitized(person), canvas_name)
    one, other = (sorted(unicodedata.normalize("NFC", name)) for name in names)
    return one == other


def _in_a_word(c: str) -> bool:
    """Whether Ruby's [[:word:]] matches it, which includes combining marks."""
    return unicodedata.category(c)[0] in "LM" or unicodedata.category(c) in ("Nd", "Pc")


def plain_file(file: str, texts: list[bytes]) -> str:
    """The original name of an uploaded file, without the number that Canvas adds: rotation-1.hpp
    becomes rotation.hpp, unless the sources themselves mention "rotation-1.hpp"."""
    part = part_file(file)
    if part:
        return part
    names = [file, *_without_number(file)]
    named = [name for name in names if any(name.encode() in text for text in texts)]
    return named[0] if named else names[-1]


def _without_number(file: str) -> list[str]:
    """The names without Canvas's number, which may be before the first dot or before the last."""
    names = []
    for dot in (file.find("."), file.rfind(".")):
        name = COPY.sub("", file[:dot]) + file[dot:]
        names += [name] if dot > 0 and name != file else []
    return names


def read(path: Path, people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Canvas download", service="canvas", tells_lateness=True)
    if path.is_dir():
        folders = [child.name for child in sorted(path.iterdir()) if is_folder(child)]
        intake.unmatched += [
            Unmatched(f, "is a folder; Canvas's download has none") for f in folders
        ]
    users: dict[str, list[Upload]] = {}
    entries = archive.names()
    read_as = read_all((name for name in entries if "/" not in name), people)
    for name in entries:
        parsed = read_as.get(name)
        if isinstance(parsed, Upload):
            users.setdefault(parsed.user, []).append(parsed)
        elif parsed:
            intake.unmatched.append(_typed(name, parsed))
        else:
            either = parse(name) and "/" not in name
            intake.unmatched.append(Unmatched(name, EITHER if either else _no_name(name)))
    take_uploads(intake, archive, users)
    return intake


def take_uploads(intake: Class, archive: Archive, users: Mapping[str, list[Upload]]) -> None:
    """Adds the students who submitted these uploads to Canvas."""
    for user, uploads in users.items():
        page = feedback_name(tuple(uploads))
        name = page.removesuffix("_feedback.html")
        try:
            student = _student(archive, user, uploads)
        except Damaged:
            raise
        except UsageError as error:
            intake.unmatched.append(refused(name, str(error), user, page))
            continue
        if student.uploads:
            intake.students.append(student)
        else:
            intake.unmatched.append(of_no_use(name, student.unused, user, page))


def _student(archive: Archive, user: str, uploads: list[Upload]) -> Student:
    """The student who submitted these uploads. Raises UsageError if they can't be read."""
    if len(uploads) > MOST_UPLOADS:
        raise UsageError(f"is {len(uploads)} files; a submission may have {MOST_UPLOADS}")
    with about_one_submission("can't be read"):
        counted, unused = _newest(archive, uploads)
    newest = max(uploads, key=lambda upload: upload.attachment)
    return Student(
        id=user,
        name=newest.name or user,
        path=archive.path,
        uploads=tuple(counted),
        late=any(upload.late for upload in uploads),
        feedback=feedback_name(tuple(uploads)),
        unused=tuple(unused),
    )


def _newest(archive: Archive, uploads: list[Upload]) -> tuple[list[Upload], list[str]]:
    """The newest upload of each file, and a sentence for each upload that isn't used."""
    texts = texts_of(archive, uploads)
    newest: dict[str, Upload] = {}
    unused = []
    for upload in sorted(uploads, key=lambda u: -u.attachment):
        file = plain_file(upload.file, texts)
        if not may_count(file):
            unused.append(f"{printable_name(upload.file)} {NOT_USED}")
        elif file in newest:
            newer = printable_name(newest[file].file)
            unused.append(f"{printable_name(upload.file)} is older than {newer}")
        else:
            newest[file] = upload
    return sorted(newest.values(), key=lambda u: u.attachment), unused


def _typed(name: str, entry: TextEntry) -> Unmatched:
    """A text entry or address, which can't be graded. Canvas can't import its feedback page, whose
    name would need the id of an attachment."""
    what = "text typed into Canvas" if entry.kind == "text" else "an address typed into Canvas"
    reason = f"is {what}, with no file to grade: ask for the files of the parts"
    page = f"{fitting(name.removesuffix('.html'))}_feedback.html"
    return Unmatched(name, reason, entry.user, page, f"It is {what}. {HAND_IN}")


def _no_name(name: str) -> str:
    if name.startswith("__MACOSX/") or name.endswith(".DS_Store"):
        return "was made by macOS, and is no submission"
    if "/" in name:
        return "is in a folder; Canvas's download has none"
    return "isn't named as Canvas names submissions (name_user_attachment_file)"
