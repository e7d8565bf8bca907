"""A submission's source files: the parts, and the helpers beside them, as text.

Nothing is extracted or run here, and no name from a submission is ever used as a path outside the
work folder. Headers of the contract, given files and everything that isn't source are left out;
reports list the names of what was left out.
"""

import os
import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.files import digest
from bounce_grader.common.manifest import parts, Part
from bounce_grader.common.paths import HANDOUT, ROOT, STUBS
from bounce_grader.submission import intake
from bounce_grader.submission.entry import Entry, HEADERS, LARGEST_SOURCE, NotText, SOURCES, text_of

CASES = "examples.txt"  # which students write for ./check --examples
GIVEN = {file.name for file in (HANDOUT / "given").iterdir()} | {"main.cpp"}
GIVEN_IN_FOLDERS = {file.relative_to(HANDOUT).parts for file in (HANDOUT / "given").glob("*/*")}
MOST_SOURCES = 100
MOST_BYTES = 8 * 1024 * 1024
LONGEST_NAME = 255  # bytes, folders and all
JUDGED = "is judged: keep the one that counts"  # of a part that is there twice
MAC_FOLDER = "__MACOSX"
BUILT_OR_GIVEN = {"build", MAC_FOLDER, "CMakeFiles", "fixtures", "tests"}
BESIDE_SRC = ("exact/", "methods/", "study/")  # in solution/, whose src/ is graded as a submission
SOLUTION = ROOT / "solution"
INCLUDES_GTEST = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*[<"]g(?:test|mock)/', re.M)
INCLUDED = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*"([\w./-]+)"', re.M)
HAS_A_TEST = re.compile(rb"^[ \t]*TEST(?:_F|_P)?[ \t]*\(", re.M)
# Whose a file is, by its name in a service's download of a whole class.
OF_A_CLASS = re.compile(r"_(\d+_(?=(?:\d+|assignsubmission)_)|[^_/]+_attempt_)")
COPY = re.compile(r"(?:-\d+|\s?\(\d+\))$")  # the suffix of a file uploaded or downloaded again


def part_file(file: str) -> str | None:
    """part1_contacts.cpp for part1_contacts-2.cpp, a copy of it; None if the file is no part."""
    stem, dot, suffix = file.rpartition(".")
    plain = COPY.sub("", stem).lower() + dot + suffix.lower()
    return plain if plain in {part.file for part in parts()} else None


class Place(NamedTuple):
    """A line of a submission's files, and a column of it if that is known."""

    file: str
    line: int
    column: int = 0

    def __str__(self) -> str:
        return f"{self.file}:{self.line}" + (f":{self.column}" if self.column else "")


class Submission(NamedTuple):
    """The files of a submission, and which of them are parts."""

    name: str
    files: dict[str, bytes]  # path in the submission -> text to compile
    parts: dict[int, str]  # part number -> path in files
    refused: dict[int, str]  # part number -> why it isn't used
    ignored: tuple[str, ...] = ()
    top: str = "."  # the folder that held everything, from which these paths begin
    cases: bytes = b""

    @property
    def helpers(self) -> list[str]:
        """The sources beside the parts."""
        others = self.files.keys() - {*self.parts.values()}
        return sorted(f for f in others if PurePosixPath(f).suffix.lower() in SOURCES)

    @property
    def include_folders(self) -> list[str]:
        """Where #include "..." is looked for, beside the including file's own folder."""
        folders = {str(PurePosixPath(file).parent) for file in self.parts.values()}
        return sorted(folders | {".", "include"})

    @property
    def sha256(self) -> str:
        return digest(sorted(self.files.items()), self.cases)

    def instead_of(self, part: Part) -> str:
        """What to do about a missing part whose work seems to be in another file; else ""."""
        defined = re.compile(rf"[\w>&]\s+(?:\w+::)*{part.function}\s*\([^;{{}}]*\)\s*\{{".encode())
        every = (*self.files, *self.ignored)
        named = (name for name in every if part.stem in name.rpartition("/")[2].lower())
        holding = (name for name, text in self.files.items() if defined.search(text))
        for name in (*holding, *named):
            shown = printable_name(name.partition(" (")[0])
            return f"; {shown} may hold it: hand that in as {part.file}, a part in a file"
        return ""

    def shared(self, one: int, other: int) -> list[str]:
        """The helpers that two parts both include, by their names."""
        both = (set(INCLUDED.findall(self.files[self.parts[part]])) for part in (one, other))
        names = {PurePosixPath(name.decode()).name for name in set.intersection(*both)}
        return sorted(file for file in self.files if PurePosixPath(file).name in names)

    def write_to(self, folder: Path, names: Iterable[str] | None = None) -> None:
        """Writes these files, or all, into the folder, which it creates."""
        folder.mkdir(parents=True, exist_ok=True)
        for name in self.files if names is None else names:
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(self.files[name])


def read(path: Path) -> Submission:
    """Raises UsageError, with one sentence, when there is nothing to grade."""
    with about_one_submission(f"{path} can't be read"), intake.opened(path) as entries:
        _require_one_student(path, [entry.name for entry in entries])
        return take(path, entries)


def _require_one_student(path: Path, names: list[str]) -> None:
    """Raises UsageError if most names are several students' in a download, and no other is a
    part."""
    whose = [found[1] for found in map(OF_A_CLASS.search, names) if found]
    own = [n for n in names if part_file(PurePosixPath(n).name) and not OF_A_CLASS.search(n)]
    if len(set(whose)) > 1 and 2 * len(whose) > len(names) and not own:
        instead = f"./kit class {path} --out FOLDER"
        raise UsageError(f"{path} is named as the download of a whole class: {instead}")


def take(path: Path, entries: list[Entry]) -> Submission:
    """Chooses the sources among the entries, and reads them."""
    top = _common_folder(entries)
    names = {entry.name.removeprefix(f"{top}/"): entry for entry in entries}
    apart = BESIDE_SRC if path.absolute() == SOLUTION else ()
    own = (name for name, entry in names.items() if not (entry.link or name.startswith(apart)))
    wanted = {name: names[name] for name in own if _wanted(PurePosixPath(name))}
    if len(wanted) > MOST_SOURCES:
        raise _too_much(path)
    files: dict[str, bytes] = {}
    why_not: dict[str, str] = {}
    for name, entry in wanted.items():
        try:
            files[name] = text_of(entry)
        except NotText as reason:
            why_not[name] = str(reason)
        if sum(map(len, files.values())) > MOST_BYTES:
            raise _too_much(path)
    _require_a_place_for_each(path, wanted)
    chosen = {part.number: name for part in parts() for name in _choose(part, list(wanted), files)}
    others = files.keys() - {*chosen.values()}
    for part in parts():
        filled = (n for n in others if part_file(PurePosixPath(n).name) == part.file)
        own = (n for n in filled if not is_stub(part, files[n]))
        judged = printable_name(chosen.get(part.number, ""))
        why_not |= dict.fromkeys(own, f"{judged} {JUDGED}")
    tests = {name for name in others if _is_test(name, files[name])}
    why_not |= dict.fromkeys(tests, "holds GoogleTest tests, which aren't run here")
    unused = tests | {name for name in others if part_file(PurePosixPath(name).name)}
    used = {n: text for n, text in files.items() if n not in unused}
    left = sorted(names.keys() - used.keys() - {*chosen.values(), CASES})
    cases = names.get(CASES)
    return Submission(
        name=path.name,
        files=used,
        parts={number: name for number, name in chosen.items() if name in files},
        refused={n: f"{name} {why_not[name]}" for n, name in chosen.items() if name in why_not},
        ignored=tuple(f"{n} ({why_not[n]})" if n in why_not else n for n in left),
        top=top,
        cases=cases.read(LARGEST_SOURCE) if cases and not cases.link else b"",
    )


def _is_test(name: str, text: bytes) -> bool:
    """Whether a file is a GoogleTest test, which can't be linked: runners have no GoogleTest."""
    is_source = PurePosixPath(name).suffix.lower() in SOURCES
    return is_source and bool(INCLUDES_GTEST.search(text) and HAS_A_TEST.search(text))


def _too_much(path: Path) -> UsageError:
    most = f"more than {MOST_SOURCES} sources or {MOST_BYTES >> 20} MB of them"
    return UsageError(f"{path} holds {most}: submit the parts and their helpers alone")


def _require_a_place_for_each(path: Path, names: Iterable[str]) -> None:
    """Raises UsageError for a file and a folder of the same name, which a zip can hold."""
    folders = {str(folder) for name in names for folder in PurePosixPath(name).parents}
    for both in sorted(folders.intersection(names)):
        raise UsageError(f"{path} holds {printable_name(both)} as a file and as a folder: keep one")


def _common_folder(entries: list[Entry]) -> str:
    """The one folder that holds everything, as when a folder was zipped; else '.'."""
    folders = [(*PurePosixPath(entry.name).parts[:-1], ".") for entry in entries]
    tops = {folder[0] for folder in folders} - {MAC_FOLDER}
    return tops.pop() if len(tops) == 1 else "."


def _wanted(name: PurePosixPath) -> bool:
    folders = name.parts[:-1]
    theirs = not any(f in BUILT_OR_GIVEN or f.startswith((".", "cmake-build")) for f in folders)
    contract = folders[-1:] == ("bounce",)  # <bounce/...> always comes from the kit
    given = name.name in GIVEN or name.name.endswith("_test.cpp")
    given = given or name.parts[-3:] in GIVEN_IN_FOLDERS
    source = name.suffix.lower() in SOURCES | HEADERS and not name.name.startswith(".")
    return theirs and source and not contract and not given and _usable(str(name))


def _usable(name: str) -> bool:
    """Whether compilers and file systems accept the name, and no program takes it for an option."""
    spelled = all(c.isprintable() or unicodedata.category(c) == "Zs" for c in name)
    return spelled and not name.startswith(("-", "@")) and len(name.encode()) <= LONGEST_NAME


def is_stub(part: Part, text: bytes) -> bool:
    return text.split() == (STUBS / part.file).read_bytes().split()


def _choose(part: Part, names: list[str], files: Mapping[str, bytes]) -> Iterator[str]:
    """The file of a part; of several, the nearest to the top. Copies count where it is missing, and
    what is as it was handed out only where nothing else is there."""
    every = [PurePosixPath(n) for n in names if part_file(PurePosixPath(n).name) == part.file]
    copies = [n for n in every if not is_stub(part, files.get(str(n), b""))] or every
    named = [path for path in copies if path.name.lower() == part.file] or copies
    depth = min((len(f.parts) for f in named), default=0)
    nearest = sorted(str(f) for f in named if len(f.parts) == depth)
    if len(nearest) > 1:
        shown = first_few(list(map(printable_name, nearest)))
        times = f"{part.file} is there {len(nearest)} times ({shown})"
        raise UsageError(f"{times}: keep one, so that the right one is graded")
    yield from nearest
