"""Which archives are opened, by their names, and what is said of the others."""

from pathlib import PurePosixPath

TARS = (".tar.gz", ".tgz", ".tar.bz2", ".tar.xz", ".tar")
OPENED = (".zip", *TARS)
CLOSED = {".rar": "a RAR archive", ".7z": "a 7-Zip archive"}


def is_archive(name: str) -> bool:
    """Whether it is opened."""
    return name.lower().endswith(OPENED)


def stem(name: str) -> str:
    """The name without the archive's ending: hw from hw.tar.gz."""
    for ending in OPENED:
        if name.lower().endswith(ending):
            return name[: -len(ending)]
    return name


def why_not(name: str) -> str:
    """Continues a sentence that begins with the name of a file which is no source: what it is, and
    what to ask the student for."""
    kind = CLOSED.get(PurePosixPath(name).suffix.lower())
    return (
        f"is {kind}, which isn't opened: ask for a zip" if kind else "is no C++ source and no zip"
    )
