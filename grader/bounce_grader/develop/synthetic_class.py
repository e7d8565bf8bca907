"""Makes up classes from the gallery, for tests and benchmarks. Each submission is one of the
gallery's under another name, with a comment added so that no object is in the cache."""

import io
import random
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.common.paths import ROOT
from bounce_grader.grading.gallery import expected, points
from bounce_grader.submission.submission import HEADERS, SOURCES

GALLERY = ROOT / "tests" / "submissions"
SOLUTION = ROOT / "solution" / "src"
LAST = ("Doe", "Müller", "O'Brien", "García López", "Nguyễn", "van der Berg", "Иванова", "李")
FIRST = ("Jane", "Jürgen", "Aoife", "José", "Anh", "Saskia", "Ольга", "伟")


@dataclass(frozen=True)
class Made:
    """One student of a made-up class, with a name in Canvas's order, "Doe, Jane"."""

    user: int
    sortable_name: str
    kind: str  # the folder of the gallery
    files: dict[str, bytes]
    points: float  # that the submission should get


def gallery(kinds: Sequence[str]) -> list[Path]:
    """The gallery's folders of these kinds."""
    return [f for kind in kinds for f in sorted((GALLERY / kind).iterdir()) if f.is_dir()]


def students(number: int, kinds: Sequence[str], first_user: int = 10_001) -> Iterator[Made]:
    """Makes students with submissions from the gallery, in a shuffled order and repeated if need
    be. User ids count up."""
    folders = gallery(kinds)
    random.Random(1).shuffle(folders)
    for i in range(number):
        folder = folders[i % len(folders)]
        last, first = LAST[i % len(LAST)], FIRST[(i // len(LAST)) % len(FIRST)]
        name = f"{last} {i // 64 or ''}".strip() + f", {first}"
        yield made(folder, first_user + i, name)


def made(folder: Path, user: int, name: str) -> Made:
    written = expected(folder)
    files = {} if written.get("alone") else {f.name: f.read_bytes() for f in SOLUTION.glob("*.cpp")}
    for file in folder.rglob("*"):
        if file.suffix in SOURCES | HEADERS:
            files[file.relative_to(folder).as_posix()] = file.read_bytes()
    kind = f"{folder.parent.name}/{folder.name}"
    rewritten = {file: _rewritten(text, user) for file, text in files.items()}
    return Made(user, name, kind, rewritten, sum(points(written["lost"])))


def _rewritten(text: bytes, user: int) -> bytes:
    """Adds a comment, unless the text is UTF-16 or begins with a byte order mark."""
    if not text.strip() or b"\0" in text or text.startswith((b"\xff", b"\xfe", b"\xef")):
        return text
    return text + f"\n// handed in by {user}\n".encode()


LATE, ZIPPED = 7, 3  # every seventh submission is late, every third a zip


def canvas_zip(path: Path, of: Sequence[Made]) -> Path:
    """Writes a download as Canvas does. Each submission with folders is a zip, too."""
    attachment = 500_000
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for i, student in enumerate(of):
            mark = "LATE_" if i % LATE == LATE - 1 else ""
            prefix = f"{sanitized(student.sortable_name)}_{mark}{student.user}"
            folders = any("/" in file for file in student.files)
            uploads = student.files
            if folders or i % ZIPPED == ZIPPED - 1:
                uploads = {"homework.zip": zip_bytes(student.files)}
            for file, data in uploads.items():
                attachment += 1
                archive.writestr(f"{prefix}_{attachment}_{file}", data)
    return path


def zip_bytes(files: dict[str, bytes]) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for file, data in files.items():
            archive.writestr(file, data)
    return out.getvalue()


def gradebook_csv(of: Sequence[Made]) -> str:
    """The class's grade book, as Canvas exports it."""
    lines = ["Student,ID,SIS User ID,SIS Login ID,Section,Quiz 1 (1111),HW3 (98765),Final Score"]
    lines += ["    Points Possible,,,,,10.00,100.00,(read only)"]
    for i, student in enumerate(of):
        login = f"login{student.user}"
        lines.append(
            f'"{student.sortable_name}",{student.user},u{i},{login},Section 001,7.50,,81.20'
        )
    return "".join(line + "\r\n" for line in lines)
