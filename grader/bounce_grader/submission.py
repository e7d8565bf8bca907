"""What is taken from a submission: the four parts, and the sources beside them, as text.

Nothing is extracted or run here, and no name from a submission is ever used as a path outside of
the work folder. Headers of the contract, given files and everything that isn't source are left
out; the names left out are kept, to be said.
"""

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from bounce_grader import intake
from bounce_grader.errors import UsageError
from bounce_grader.manifest import Part, parts
from bounce_grader.paths import HANDOUT

SOURCES = {".cpp", ".cc", ".cxx"}
HEADERS = {".hpp", ".h", ".hh", ".hxx", ".ipp", ".inl"}
GIVEN = {file.name for file in (HANDOUT / "given").iterdir()} | {"main.cpp"}
MOST_SOURCES = 100
MOST_BYTES = 8 * 1024 * 1024
NOT_THEIRS = {"build", "__MACOSX", "CMakeFiles", "fixtures", "tests"}


@dataclass(frozen=True)
class Submission:
    name: str
    files: dict[str, bytes]  # path inside the submission -> text, as it is compiled
    parts: dict[int, str]  # part number -> path in files
    refused: dict[int, str] = field(default_factory=dict)  # part number -> why it isn't used
    ignored: tuple[str, ...] = ()

    @property
    def helpers(self) -> list[str]:
        """The sources beside the parts."""
        own = set(self.parts.values())
        return sorted(f for f in self.files if PurePosixPath(f).suffix in SOURCES and f not in own)

    @property
    def include_folders(self) -> list[str]:
        """Where #include "..." is looked for, beside the including file's own folder."""
        folders = {str(PurePosixPath(file).parent) for file in self.parts.values()}
        return sorted(folders | {".", "include"})

    @property
    def sha256(self) -> str:
        digest = hashlib.sha256()
        for name in sorted(self.files):
            digest.update(f"{name}\0{len(self.files[name])}\0".encode() + self.files[name])
        return digest.hexdigest()

    def write_to(self, folder: Path) -> None:
        for name, text in self.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)


def read(path: Path) -> Submission:
    """Raises UsageError, with one sentence, when there is nothing to grade."""
    entries = list(intake.entries(path))
    top = _common_folder(entries)
    files: dict[str, bytes] = {}
    too_large: dict[str, str] = {}
    ignored: list[str] = []
    for entry in entries:
        name = str(PurePosixPath(entry.name).relative_to(top))
        if not _wanted(PurePosixPath(name)) or entry.link:
            ignored.append(name)
            continue
        try:
            files[name] = intake.text_of(entry)
            _require_small(path, files)
        except intake.NotText as reason:
            too_large[name] = str(reason)
    chosen = _choose_parts([*files, *too_large])
    unused = _other_copies([*files], chosen)
    return Submission(
        name=path.name,
        files={n: t for n, t in files.items() if n not in unused},
        parts={number: name for number, name in chosen.items() if name in files},
        refused={n: f"{name} {too_large[name]}" for n, name in chosen.items() if name in too_large},
        ignored=tuple(
            sorted(ignored + unused + [n for n in too_large if n not in chosen.values()])
        ),
    )


def _require_small(path: Path, files: dict[str, bytes]) -> None:
    if len(files) > MOST_SOURCES or sum(map(len, files.values())) > MOST_BYTES:
        raise UsageError(
            f"{path} holds more than {MOST_SOURCES} sources or {MOST_BYTES >> 20} MB of them: "
            "submit the four parts and their helpers alone"
        )


def _common_folder(entries: list[intake.Entry]) -> str:
    """The folder that everything is in, as when a folder was zipped; else '.'."""
    tops = {PurePosixPath(e.name).parts[0] for e in entries if not e.name.startswith("__MACOSX/")}
    nested = all(len(PurePosixPath(e.name).parts) > 1 for e in entries)
    return tops.pop() if len(tops) == 1 and nested else "."


def _wanted(name: PurePosixPath) -> bool:
    folders = name.parts[:-1]
    theirs = not any(f in NOT_THEIRS or f.startswith((".", "cmake-build")) for f in folders)
    contract = folders[-2:] == ("include", "bounce")
    given = name.name in GIVEN or name.name.endswith("_test.cpp")
    source = name.suffix in SOURCES | HEADERS and not name.name.startswith(".")
    return theirs and source and not contract and not given


def _choose_parts(names: list[str]) -> dict[int, str]:
    return {part.number: name for part in parts() for name in _choose(part, names)}


def _choose(part: Part, names: list[str]) -> Iterator[str]:
    """The file of a part: the one nearest to the top, where there are several."""
    found = [PurePosixPath(n) for n in names if PurePosixPath(n).name.lower() == part.file]
    if not found:
        return
    depth = min(len(f.parts) for f in found)
    nearest = sorted(str(f) for f in found if len(f.parts) == depth)
    if len(nearest) > 1:
        raise UsageError(
            f"{part.file} is there {len(nearest)} times ({', '.join(nearest)}): "
            "keep one, so that the right one is graded"
        )
    yield nearest[0]


def _other_copies(names: list[str], chosen: dict[int, str]) -> list[str]:
    part_files = {part.file for part in parts()}
    return [
        n for n in names if PurePosixPath(n).name.lower() in part_files and n not in chosen.values()
    ]
