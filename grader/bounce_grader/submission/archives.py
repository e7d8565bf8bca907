"""Which archives are opened, what is said of others, and what kind a file's first bytes show."""

from pathlib import PurePosixPath

TARS = (".tar.gz", ".tgz", ".tar.bz2", ".tar.xz", ".tar")
SEVEN = ".7z"
OPENED = (".zip", *TARS, SEVEN)
CLOSED = {".rar": "a RAR archive"}
START = 512  # bytes that show the kind
MAGIC = {
    b"7z\xbc\xaf\x27\x1c": SEVEN,
    b"Rar!\x1a\x07": ".rar",
    b"PK\x03\x04": ".zip",
    b"PK\x05\x06": ".zip",
    b"\x1f\x8b": ".tar.gz",
    b"BZh": ".tar.bz2",
    b"\xfd7zXZ": ".tar.xz",
}


def is_archive(name: str) -> bool:
    """Whether it is opened."""
    return name.lower().endswith(OPENED)


def kind(name: str, start: bytes) -> str:
    """The ending that fits an archive's first bytes, whatever its name; else that of its name."""
    for magic, ending in MAGIC.items():
        if start.startswith(magic):
            return ending
    if start[257:262] == b"ustar":
        return ".tar"
    return next((ending for ending in OPENED if name.lower().endswith(ending)), "")


def stem(name: str) -> str:
    """The name without the archive's ending: hw from hw.tar.gz."""
    for ending in OPENED:
        if name.lower().endswith(ending):
            return name[: -len(ending)]
    return name


def why_not(name: str) -> str:
    """Continues a sentence that begins with the name of a file which is no source: what it is, and
    what is needed in its place."""
    ending = PurePosixPath(name).suffix.lower()
    return closed(ending) if ending in CLOSED else "is no C++ source and no zip"


def closed(ending: str) -> str:
    return f"is {CLOSED[ending]}, which isn't opened: the parts are needed as files, or as one zip"
