"""Whose submissions these are: from Canvas's download, a folder of folders or of zips, or a
checkout of GitHub Classroom. What belongs to nobody is kept, with its reason."""

import os
import zipfile
from dataclasses import dataclass, field
from pathlib import Path

from bounce_grader.classroom import canvas
from bounce_grader.classroom.archive import Archive, opened
from bounce_grader.classroom.canvas import TextEntry, Upload
from bounce_grader.entry import LARGEST_SOURCE
from bounce_grader.errors import UsageError
from bounce_grader.files import fitting
from bounce_grader.submission import HEADERS, SOURCES


@dataclass(frozen=True)
class Student:
    """One submission: a person's, or a group's."""

    id: str  # Canvas's user id, a login, or the name of a folder
    name: str
    path: Path  # the folder or zip; of a Canvas download, the whole of it
    uploads: tuple[Upload, ...] = ()  # in a Canvas download: the files that count
    late: bool = False
    feedback: str = ""  # the name of the page that goes back
    unused: tuple[str, ...] = ()  # a sentence for each file that doesn't count


@dataclass(frozen=True)
class Unmatched:
    """Something in SUBMISSIONS that can't be graded."""

    name: str
    reason: str


@dataclass
class Class:
    source: str  # what SUBMISSIONS was taken for
    students: list[Student] = field(default_factory=list)
    unmatched: list[Unmatched] = field(default_factory=list)


def read(path: Path) -> Class:
    """Raises UsageError where there is no class in it."""
    path = path.absolute()
    if path.is_dir():
        children = sorted(path.iterdir())
        if any(canvas.parse(child.name) and _is_file(child) for child in children):
            found = _canvas(path)
        else:
            found = _folder(path, children)
    elif not path.exists():
        raise UsageError(f"there is no file or folder {path}")
    elif zipfile.is_zipfile(path):
        found = _canvas(path)
    else:
        raise UsageError(f"{path} is neither a folder nor a zip: give Canvas's download as it is")
    if not found.students:
        raise UsageError(f"no submission is found in {path}: {_expected(found)}")
    found.students.sort(key=lambda student: (student.name, student.id))
    return found


def _expected(found: Class) -> str:
    first = found.unmatched[0] if found.unmatched else None
    seen = f"the first entry, {first.name!r}, {first.reason}" if first else "it is empty"
    return f"{seen}; it should be Canvas's download, or a folder with one folder or zip a student"


def _is_file(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()


def _canvas(path: Path) -> Class:
    archive = opened(path)
    found = Class("a Canvas download")
    if path.is_dir():
        folders = [child.name for child in sorted(path.iterdir()) if child.is_dir()]
        found.unmatched += [
            Unmatched(f, "is a folder; Canvas's download has none") for f in folders
        ]
    users: dict[str, list[Upload]] = {}
    texts: dict[str, list[TextEntry]] = {}
    for name in archive.names():
        parsed = canvas.parse(name) if "/" not in name else None
        if isinstance(parsed, Upload):
            users.setdefault(parsed.user, []).append(parsed)
        elif parsed:
            texts.setdefault(parsed.user, []).append(parsed)
            found.unmatched.append(Unmatched(name, _no_file(parsed)))
        else:
            found.unmatched.append(Unmatched(name, _no_name(name)))
    for user, uploads in users.items():
        student = _student(archive, user, uploads)
        if student.uploads:
            found.students.append(student)
        else:
            reason = f"holds nothing that can be graded: {'; '.join(student.unused)}"
            found.unmatched.append(
                Unmatched(student.feedback.removesuffix("_feedback.html"), reason)
            )
    return found


def _no_file(entry: TextEntry) -> str:
    what = "text typed into Canvas" if entry.kind == "text" else "an address typed into Canvas"
    return f"is {what}, with no file to grade: ask for the four files"


def _no_name(name: str) -> str:
    if name.startswith("__MACOSX/") or name.endswith(".DS_Store"):
        return "was made by macOS, and is no submission"
    if "/" in name:
        return "is in a folder; Canvas's download has none"
    return "isn't named as Canvas names submissions (name_user_attachment_file)"


def _student(archive: Archive, user: str, uploads: list[Upload]) -> Student:
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
    """Each file once: its newest upload; and a sentence for each that isn't used."""
    texts = [_text(archive, upload) for upload in uploads if is_source(upload.file)]
    newest: dict[str, Upload] = {}
    unused = []
    for upload in sorted(uploads, key=lambda u: -u.attachment):
        file = canvas.plain_file(upload.file, texts) if is_source(upload.file) else upload.file
        if not is_source(file) and not is_zip(file):
            unused.append(f"{upload.file} is no C++ source and no zip")
        elif file in newest:
            unused.append(f"{upload.file} is older than {newest[file].file}")
        else:
            newest[file] = upload
    return sorted(newest.values(), key=lambda u: u.attachment), unused


def _text(archive: Archive, upload: Upload) -> bytes:
    """One that can't be read is found out when it is graded, and costs nobody else anything."""
    try:
        return archive.read(upload.entry, LARGEST_SOURCE)
    except UsageError:
        return b""


def is_source(file: str) -> bool:
    return os.path.splitext(file)[1].lower() in SOURCES | HEADERS


def is_zip(file: str) -> bool:
    return file.lower().endswith(".zip")


def _folder(path: Path, children: list[Path]) -> Class:
    folders = [c for c in children if c.is_dir() and not c.is_symlink()]
    folders = [c for c in folders if not c.name.startswith((".", "__MACOSX"))]
    zips = [c for c in children if _is_file(c) and is_zip(c.name)]
    repositories = bool(folders) and all((folder / ".git").exists() for folder in folders)
    found = Class("a checkout of repositories" if repositories else "a folder of submissions")
    cut = _common_prefix(path, folders) if repositories else 0
    for child in [*folders, *zips]:
        name = child.name[cut:] if child.is_dir() else child.stem
        found.students.append(Student(name, name, child, feedback=f"{fitting(name)}.html"))
    for child in children:
        if child not in folders and child not in zips:
            hidden = child.name.startswith((".", "__MACOSX"))
            reason = "is no submission" if hidden else "is neither a folder nor a zip"
            found.unmatched.append(Unmatched(child.name, reason))
    _require_distinct(found.students)
    return found


def _common_prefix(path: Path, folders: list[Path]) -> int:
    """GitHub Classroom names a repository after the assignment and the login."""
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
