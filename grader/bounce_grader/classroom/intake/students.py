"""Finds each student's submission in a download from Canvas, Moodle or Blackboard, in a folder of
folders or zips, or in a checkout of repositories. What can't be matched is listed, with the
reason."""

import os
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePosixPath

from bounce_grader.classroom.intake import blackboard, canvas, moodle
from bounce_grader.classroom.intake.archive import opened, Archive, Damaged
from bounce_grader.classroom.intake.canvas import TextEntry, Upload
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.files import fitting
from bounce_grader.common.manifest import parts
from bounce_grader.submission import submission
from bounce_grader.submission.archives import is_archive, why_not, stem as archive_stem
from bounce_grader.submission.entry import LARGEST_SOURCE
from bounce_grader.submission.submission import HEADERS, MOST_BYTES, SOURCES, part_file

MOST_UPLOADS = 100  # of a student's
HAND_IN = f"Hand in the parts, {parts()[0].file} to {parts()[-1].file}, as files or as one zip."
EITHER = (
    "could be one of several users', by its name: look in Canvas who handed it in, and grade it by "
    "itself with ./kit grade"
)


@dataclass(frozen=True)
class Student:
    """One submission: a person's, or a group's."""

    id: str  # Canvas's user id, a login, or the name of a folder
    name: str
    path: Path  # the folder or zip; for Canvas, the whole download
    uploads: tuple[Upload, ...] = ()  # for Canvas: the files that count
    late: bool = False
    feedback: str = ""  # the name of the feedback page
    unused: tuple[str, ...] = ()  # a sentence for each file that doesn't count
    person: str = ""  # the name in the grade book or the roster, as "Doe, Jane"
    late_days: int = 0  # days begun after the due date, where that is known

    @property
    def shown(self) -> str:
        """The name for people to read."""
        return self.person or self.name


@dataclass(frozen=True)
class Unmatched:
    """Something in SUBMISSIONS that can't be graded."""

    name: str
    reason: str  # continues a sentence that begins with the name
    user: str = ""  # the user's id, if known
    feedback: str = ""  # the name of the feedback page
    page_text: str = ""  # the text of that page


@dataclass
class Class:
    source: str  # what kind of folder or zip SUBMISSIONS is
    students: list[Student] = field(default_factory=list)
    unmatched: list[Unmatched] = field(default_factory=list)
    logins: bool = False  # whether a student's id is a login of GitHub's, which students choose
    service: str = ""  # "canvas", "moodle" or "blackboard", if it is a download of it

    @property
    def handed_in(self) -> int:
        """How many students or groups submitted something, whatever it is."""
        return len({s.id for s in self.students} | {u.user for u in self.unmatched if u.user})


def read(path: Path, people: Mapping[str, str] = {}) -> Class:
    """`people` are those of the grade book, by Canvas's ids. Raises UsageError where there is no
    class in it."""
    path = path.absolute()
    if path.is_dir():
        children = sorted(path.iterdir())
        names = [child.name for child in children if _is_file(child)]
        service = _service(names)
        if service:
            intake = service(path, people)
        elif any(moodle.parse_folder(child.name) for child in children):
            intake = _moodle_folders(children)
        else:
            intake = _folder(path, children)
    elif not path.exists():
        raise UsageError(f"there is no file or folder {path}")
    elif zipfile.is_zipfile(path):
        service = _service(opened(path).names()) or _canvas
        intake = service(path, people)
    else:
        cut = is_archive(path.name) or not path.stat().st_size
        reason = "is broken, or was cut short: download it again"
        other = "is neither a folder nor a zip: give Canvas's download as it is"
        raise UsageError(f"{path} {reason if cut else other}")
    if not intake.students:
        raise UsageError(f"no submission is found in {path}: {_expected(intake)}")
    intake.students.sort(key=lambda student: (student.name, student.id))
    return intake


def _service(names: Sequence[str]) -> Callable[[Path, Mapping[str, str]], Class] | None:
    """Which service's download has such files. Students choose a part of each name, so one that looks
    like another service's proves nothing: all that look like any have to look like this one's."""
    services = ((blackboard.parse, _blackboard), (moodle.parse, _moodle), (canvas.parse, _canvas))
    known = [name for name in names if any(parse(name) for parse, _ in services)]
    for parse, reader in services:
        if known and all(map(parse, known)):
            return reader
    return _canvas if known else None


def _expected(intake: Class) -> str:
    first = intake.unmatched[0] if intake.unmatched else None
    seen = f"the first entry, {first.name!r}, {first.reason}" if first else "it is empty"
    return (
        f"{seen}; it should be the download of Canvas, Moodle or Blackboard, or a folder with one "
        "folder or zip a student"
    )


def _is_file(path: Path) -> bool:
    return os.path.isfile(path) and not os.path.islink(path)


def _is_folder(path: Path) -> bool:
    return os.path.isdir(path) and not os.path.islink(path)


def _canvas(path: Path, people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Canvas download", service="canvas")
    if path.is_dir():
        folders = [child.name for child in sorted(path.iterdir()) if _is_folder(child)]
        intake.unmatched += [
            Unmatched(f, "is a folder; Canvas's download has none") for f in folders
        ]
    users: dict[str, list[Upload]] = {}
    texts: dict[str, list[TextEntry]] = {}
    entries = archive.names()
    read_as = canvas.read_all((name for name in entries if "/" not in name), people)
    for name in entries:
        parsed = read_as.get(name)
        if isinstance(parsed, Upload):
            users.setdefault(parsed.user, []).append(parsed)
        elif parsed:
            texts.setdefault(parsed.user, []).append(parsed)
            intake.unmatched.append(_typed(name, parsed))
        else:
            either = canvas.parse(name) and "/" not in name
            intake.unmatched.append(Unmatched(name, EITHER if either else _no_name(name)))
    take_uploads(intake, archive, users)
    return intake


def take_uploads(intake: Class, archive: Archive, users: Mapping[str, list[Upload]]) -> None:
    """Adds the students who submitted these uploads to Canvas."""
    for user, uploads in users.items():
        page = canvas.feedback_name(tuple(uploads))
        name = page.removesuffix("_feedback.html")
        try:
            student = _student(archive, user, uploads)
        except Damaged:
            raise
        except UsageError as error:
            page_text = f"What you handed in {error}. {HAND_IN}"
            intake.unmatched.append(Unmatched(name, str(error), user, page, page_text))
            continue
        if student.uploads:
            intake.students.append(student)
        else:
            reason = (
                f"holds nothing that can be graded: {first_few(student.unused, separator='; ')}"
            )
            page_text = f"{first_few(student.unused, separator='. ')}. {HAND_IN}"
            intake.unmatched.append(Unmatched(name, reason, user, page, page_text))


def _moodle(path: Path, _people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Moodle download", service="moodle")
    files: dict[tuple[str, str], list[Upload]] = {}
    for number, name in enumerate(archive.names()):
        parsed = moodle.parse(name)
        if not parsed:
            intake.unmatched.append(Unmatched(name, _no_name_of("Moodle", name)))
        elif parsed.kind == "onlinetext":
            page = moodle.feedback_name(parsed.name, parsed.participant)
            _typed_elsewhere(intake, name, "Moodle", parsed.participant, page)
        elif not _is_inside(parsed.file):
            intake.unmatched.append(Unmatched(name, "points outside of the submission"))
        else:
            who = (parsed.participant, parsed.name)
            upload = Upload(name, parsed.name, parsed.participant, False, number, parsed.file, True)
            files.setdefault(who, []).append(upload)
    for (participant, name), uploads in files.items():
        page = moodle.feedback_name(name, participant)
        _take(intake, archive, participant, name, uploads, page)
    return intake


def _moodle_folders(children: list[Path]) -> Class:
    """Moodle's download, unpacked."""
    intake = Class("a Moodle download", service="moodle")
    for child in children:
        parsed = moodle.parse_folder(child.name) if _is_folder(child) else None
        if not parsed:
            intake.unmatched.append(Unmatched(child.name, _no_name_of("Moodle", child.name)))
            continue
        page = moodle.feedback_name(parsed.name, parsed.participant)
        if parsed.kind == "onlinetext":
            _typed_elsewhere(intake, child.name, "Moodle", parsed.participant, page)
        else:
            there = _zip_alone(child) or child
            intake.students.append(Student(parsed.participant, parsed.name, there, feedback=page))
    _require_distinct(intake.students)
    return intake


def _blackboard(path: Path, _people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Blackboard download", service="blackboard")
    parsed = {name: blackboard.parse(name) for name in archive.names() if "/" not in name}
    known = {name: entry for name, entry in parsed.items() if entry}
    title = blackboard.title(entry.head for entry in known.values())
    attempts: dict[str, dict[int, list[Upload]]] = {}
    people: dict[str, blackboard.Person] = {}
    for name, entry in known.items():
        if not entry.file:
            person = blackboard.person_of(entry.head, archive.read(name, 4096))
            if person:
                people[entry.head] = person
        attempts.setdefault(entry.head, {}).setdefault(entry.when, [])
        if entry.file:
            upload = Upload(name, "", entry.head, False, entry.when, entry.file, True)
            attempts[entry.head][entry.when].append(upload)
    for head, by_time in attempts.items():
        person = people.get(head)
        if not person and not title:
            intake.unmatched.append(Unmatched(head, "has no text that says whose it is"))
            continue
        user = person.user if person else head.removeprefix(title)
        name = person.name if person and person.name else user
        newest = [replace(upload, name=name, user=user) for upload in by_time[max(by_time)]]
        page = f"{fitting(printable_name(user))}.html"  # not by the name: it may hold a "/"
        if newest:
            _take(intake, archive, user, name, newest, page)
        else:
            _typed_elsewhere(intake, f"{head}.txt", "Blackboard", user, page)
    left = [name for name in archive.names() if name not in known]
    intake.unmatched += [Unmatched(name, _no_name_of("Blackboard", name)) for name in left]
    _require_distinct(intake.students)
    return intake


def _is_inside(file: str) -> bool:
    parts_of = PurePosixPath(file).parts
    return not file.startswith("/") and ".." not in parts_of and "\\" not in file


def _take(
    intake: Class, archive: Archive, id: str, name: str, uploads: list[Upload], page: str
) -> None:
    """Adds a student whose uploads all count."""
    if len(uploads) > MOST_UPLOADS:
        reason = f"is {len(uploads)} files; a submission may have {MOST_UPLOADS}"
        page_text = f"What you handed in {reason}. {HAND_IN}"
        intake.unmatched.append(Unmatched(name, reason, id, page, page_text))
        return
    usable = [upload for upload in uploads if may_count(upload.file)]
    unused = tuple(
        f"{printable_name(upload.file)} {why_not(upload.file)}"
        for upload in uploads
        if upload not in usable
    )
    if usable:
        student = Student(id, name, archive.path, tuple(usable), feedback=page, unused=unused)
        intake.students.append(student)
        return
    reason = f"holds nothing that can be graded: {first_few(unused, separator='; ')}"
    page_text = f"{first_few(unused, separator='. ')}. {HAND_IN}"
    intake.unmatched.append(Unmatched(name, reason, id, page, page_text))


def _typed_elsewhere(intake: Class, name: str, service: str, user: str, page: str) -> None:
    what = f"is text typed into {service}"
    reason = f"{what}, with no file to grade: ask for the files of the parts"
    intake.unmatched.append(Unmatched(name, reason, user, page, f"It {what}. {HAND_IN}"))


def _no_name_of(service: str, name: str) -> str:
    if name.startswith("__MACOSX") or name.endswith(".DS_Store"):
        return "was made by macOS, and is no submission"
    return f"isn't named as {service} names submissions"


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
        feedback=canvas.feedback_name(tuple(uploads)),
        unused=tuple(unused),
    )


def _newest(archive: Archive, uploads: list[Upload]) -> tuple[list[Upload], list[str]]:
    """The newest upload of each file, and a sentence for each upload that isn't used."""
    texts = texts_of(archive, uploads)
    newest: dict[str, Upload] = {}
    unused = []
    for upload in sorted(uploads, key=lambda u: -u.attachment):
        file = canvas.plain_file(upload.file, texts)
        if not may_count(file):
            unused.append(f"{printable_name(upload.file)} {why_not(upload.file)}")
        elif file in newest:
            newer = printable_name(newest[file].file)
            unused.append(f"{printable_name(upload.file)} is older than {newer}")
        else:
            newest[file] = upload
    return sorted(newest.values(), key=lambda u: u.attachment), unused


def texts_of(archive: Archive, uploads: Iterable[Upload]) -> list[bytes]:
    """The text of the sources, as far as they may be read. One that can't be read is reported
    later, by the grading."""
    texts, room = [], MOST_BYTES
    for upload in uploads:
        if is_source(upload.file):
            try:
                texts.append(archive.read(upload.entry, min(room, LARGEST_SOURCE)))
                room -= len(texts[-1])
            except Damaged:
                raise
            except UsageError:
                continue
    return texts


def may_count(file: str) -> bool:
    return is_source(file) or is_archive(file)


def is_source(file: str) -> bool:
    return os.path.splitext(file)[1].lower() in SOURCES | HEADERS


def _folder(path: Path, children: list[Path]) -> Class:
    _require_a_folder_of_submissions(path, children)
    folders = [c for c in children if _is_folder(c)]
    folders = [c for c in folders if not c.name.startswith((".", "__MACOSX"))]
    folders = [c for c in folders if not _is_output(c)]
    zips = [c for c in children if _is_file(c) and is_archive(c.name)]
    cloned = [folder for folder in folders if os.path.exists(folder / ".git")]
    intake = Class("a folder of submissions")
    cut = 0
    if 2 * len(cloned) > len(folders) + len(zips):
        cut = _common_prefix(path, cloned)
        before = f", named {cloned[0].name[:cut]!r} and a login" if cut else ""
        intake.source = f"a checkout of repositories{before}"
        intake.logins = True
        folders = cloned
    for child in [*folders, *zips]:
        name = child.name[cut:] if _is_folder(child) else archive_stem(child.name)
        submitted = _zip_alone(child) or child
        page = f"{fitting(name)}.html"
        intake.students.append(Student(name, name, submitted, feedback=page))
    left = [child for child in children if child not in folders and child not in zips]
    intake.unmatched += [Unmatched(child.name, _no_submission(child)) for child in left]
    _require_distinct(intake.students)
    if intake.students and not any(_has_a_part(student.path) for student in intake.students):
        _require_no_download(path, zips)
        raise UsageError(
            f"no folder or zip in {path} holds a part, as {parts()[0].file}: it should be "
            "Canvas's download, or a folder with one folder or zip a student"
        )
    return intake


def _require_a_folder_of_submissions(path: Path, children: list[Path]) -> None:
    """Raises UsageError if the folder is itself a submission. A student may be called src."""
    own = (path / "src").iterdir() if (path / "src").is_dir() else ()
    others = [c for c in children if c.name != "src" and (_is_folder(c) or is_archive(c.name))]
    in_src = any(map(_is_part, own)) and not any(map(_has_a_part, others))
    if in_src or any(map(_is_part, children)):
        raise UsageError(f"{path} is one submission, and no class: ./kit grade {path}")


def _is_part(child: Path) -> bool:
    return part_file(child.name) is not None and _is_file(child)


def _require_no_download(path: Path, zips: list[Path]) -> None:
    """Raises UsageError if a zip here is Canvas's download. Called only if no submission has a
    part, because a student's own zip may hold names like Canvas's."""
    for child in zips:
        try:
            with about_one_submission("it can't be read"):
                names = [name for name in opened(child).names() if "/" not in name]
        except UsageError:
            continue
        if any(map(canvas.parse, names)):
            raise UsageError(f"{path} holds a download of Canvas's: give {child} itself")


def _is_output(folder: Path) -> bool:
    return os.path.exists(folder / "log.jsonl") and os.path.isdir(folder / "results")


def _no_submission(child: Path) -> str:
    if child.name.startswith((".", "__MACOSX")):
        return "is no submission"
    if not _is_folder(child):
        return "is neither a folder nor a zip"
    if _is_output(child):
        return "was written by ./kit class, and is no submission"
    return "is no repository, as the others are"


def _zip_alone(folder: Path) -> Path | None:
    """The zip, if it is all that a student's folder holds. None if the folder can't be listed."""
    try:
        names = [n for n in os.listdir(folder) if not n.startswith((".", "__MACOSX"))]
    except OSError:
        return None
    inside = [folder / name for name in names]
    alone = len(inside) == 1 and is_archive(inside[0].name) and _is_file(inside[0])
    return inside[0] if alone else None


def _has_a_part(path: Path) -> bool:
    try:
        return bool(submission.read(path).parts)
    except UsageError:
        return False


def _common_prefix(path: Path, folders: list[Path]) -> int:
    """The length of the assignment's name, with which each repository's name begins; the login
    follows."""
    named = path.name.removesuffix("-submissions") + "-"
    if all(folder.name.startswith(named) for folder in folders):
        return len(named)
    common = os.path.commonprefix([folder.name for folder in folders])
    return common.rfind("-") + 1 if len(folders) > 1 else 0


def _require_distinct(students: list[Student]) -> None:
    seen: dict[str, Path] = {}
    for student in students:
        if student.id in seen:
            raise UsageError(
                f"{seen[student.id].name} and {student.path.name} would both be {student.id}: "
                "keep one of them"
            )
        seen[student.id] = student.path
