"""Makes submissions for the tests of reading them, and returns the sentence that refuses one."""

import io
import resource
import shutil
import tarfile
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import ROOT
from bounce_grader.grading.known_mistakes import expected
from bounce_grader.submission import submission


def zipped(path: Path, files: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return path


def submission_of(folder: Path, to: Path) -> Path:
    """One of the gallery: the solution with the folder's files laid over it; or the folder alone, if
    it says so."""
    if not expected(folder).get("alone"):
        shutil.copytree(ROOT / "solution" / "src", to)
    ignore = shutil.ignore_patterns("expected.json", "*.md")
    shutil.copytree(folder, to, dirs_exist_ok=True, ignore=ignore)
    return to


def points_without(lost: list[str]) -> list[float]:
    """The points of each part without these checks."""
    return [sum(c.points for c in part.checks if c.id not in lost) for part in parts()]


def packed_tar(files: dict[str, bytes], kind: str = "gz") -> bytes:
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode=f"w:{kind}") as archive:
        for name, text in files.items():
            info = tarfile.TarInfo(name)
            info.size = len(text)
            archive.addfile(info, io.BytesIO(text))
    return data.getvalue()


def refusal(path: Path) -> str:
    with pytest.raises(UsageError) as refused:
        submission.read(path)
    sentence = str(refused.value)
    assert "\n" not in sentence
    return sentence


@contextmanager
def limited_memory(more: int, file_size: int = resource.RLIM_INFINITY) -> Iterator[None]:
    """At most so many bytes more than this process has now, and of each file that it writes."""
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    memory = pages * resource.getpagesize() + more
    limits = {resource.RLIMIT_AS: memory, resource.RLIMIT_FSIZE: file_size}
    before = {kind: resource.getrlimit(kind) for kind in limits}
    for kind, most in limits.items():
        resource.setrlimit(kind, (most, before[kind][1]))
    try:
        yield
    finally:
        for kind, old in before.items():
            resource.setrlimit(kind, old)
