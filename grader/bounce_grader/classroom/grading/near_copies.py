"""Finds near-copies with sim_c++, which compares the structure of sources and ignores names.

Comparing every pair in detail would take long in a large class. So sim_c++ runs twice: first on all
at once, to find each submission's closest relatives; then on these pairs alone, for the share that
they have in common. Its time grows with the square of the repetition in a text. Comparing two
submissions never takes longer than comparing the slower one with itself. So each is first compared
with itself, and those that take too long are left out.
"""

import io
import re
import statistics
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from shutil import which

from bounce_grader.classroom.grading.results import digest
from bounce_grader.classroom.intake import handed_in, students as students_of
from bounce_grader.classroom.intake.student import Student, Upload
from bounce_grader.common.errors import about_one_submission, KitError, UsageError
from bounce_grader.common.files import CLASS_FOLDER, temporary_folder
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import STUBS
from bounce_grader.sandbox import box as boxes, processes

PROGRAM = "/usr/bin/sim_c++"
RUN = "16"  # consecutive tokens that have to match, about two lines
RELATIVES = 3  # of each submission
LEAST = 60  # per cent in common
LEAST_OF_PART = 90  # per cent of one part; right answers to a short task look alike
LEAST_PARTS = 2  # alike, for a pair that isn't alike as a whole
MOST = 20  # pairs that are named
LONGEST = 64 * 1024  # characters that are compared of each, without comments and blanks
WITH_ITSELF = 4  # copies, which make six pairs; ulimit can only limit whole seconds
SECONDS = 1  # of CPU time, for those six, and later for each pair
LIMITS = processes.Limits(900, 1800, memory=2 << 30, file_size=64 << 20, output=64 << 20)
FOUND = re.compile(r"^(\d+)\.cpp consists for (\d+) % of (\d+)\.cpp material$", re.MULTILINE)
ENDED = re.compile(r"^ended (\d+)\.cpp (\d+)\.cpp", re.MULTILINE)
ALL_AT_ONCE = [PROGRAM, "-p", "-a", "-t", "10", "-r", RUN, "-T", "-i"]
EACH_LINE = (  # compares the files named on a line with each other
    "while read -r files; do "
    f"(ulimit -t {SECONDS}; exec {PROGRAM} -p -ae -t 1 -r {RUN} -T $files) || echo ended $files; "
    "done"
)


# What hides code, or seems to: comments, and what may hold the signs that begin one. Matching takes
# time that grows with the text, whatever a student writes.
HIDING = re.compile(
    r"""(?P<comment>//[^\n]* | /\*.*?\*/) | /\*(?P<never_closed>.*)\Z
    | (?P<header>(?:\#\s*include | __has_include\s*\()\s*<[^>\n]{0,200}>)
    | (?<!\w)(?P<number>\.?\d(?:'?[\w.])*)
    | (?P<literal>(?<!\w)(?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?(?:\)(?P=mark)"|\Z)
        | "(?:\\.|[^"\\\n])*(?:"|\\?$) | '(?:\\.|[^'\\\n])*(?:'|\\?$))""",
    re.DOTALL | re.MULTILINE | re.VERBOSE,
)
IN_PART = (
    f"it is longer than {LONGEST >> 10} KB even without comments, and only its beginning is compared "
    "with others: look whether it is a copy"
)
TOO_SLOW = "it repeats itself too much to be compared with others: look whether it is a copy"


@dataclass(frozen=True)
class Pair:
    """Two submissions that have much in common."""

    first: str  # a student's id
    second: str  # another's; or one of another year's
    share: int  # per cent, of the submission of which it is more
    parts: tuple[int, ...] = ()  # if only these are alike, and not the submissions as a whole


@dataclass(frozen=True)
class Similar:
    """The near-copies of a class."""

    pairs: tuple[Pair, ...]
    usual: int  # per cent: the median share with the closest relative
    more: int = 0  # pairs that stand out, too
    problem: str = ""  # why there is no result
    # Why somebody is left out or compared in part alone, by a student's id.
    incomplete: Mapping[str, str] = field(default_factory=dict)


def corpus(folder: Path) -> list[Student]:
    """Another year's submissions, to compare with. Raises UsageError if they are damaged."""
    others = students_of.read(folder).students
    for other in others:
        digest(other)
    return [replace(other, id=f"{folder.name}/{other.name}") for other in others]


def find(students: list[Student], trust: bool, others: Sequence[Student] = ()) -> Similar:
    """Finds near-copies among students, and between them and others."""
    if which(PROGRAM) is None:
        missing = "similarity-tester isn't installed: apt-get install similarity-tester"
        return Similar((), 0, problem=missing)
    try:
        return _find(students, others, boxes.choose(boxes.kinds(trust)))
    except KitError as error:
        return Similar((), 0, problem=str(error))


def _find(students: list[Student], of_others: Sequence[Student], box: boxes.Box) -> Similar:
    others = {student.id for student in of_others}
    left_out: dict[str, str] = {}
    in_part: dict[str, str] = {}
    texts = _texts([*students, *of_others], left_out, in_part)
    whole, usual = _alike(texts[0], LEAST, box, left_out)
    pairs = {ids: Pair(*ids, share) for ids, share in whole.items()}
    of_parts: dict[tuple[str, str], dict[int, int]] = defaultdict(dict)
    for part in parts():
        there = [(id, text) for id, text in texts[part.number] if id not in left_out]
        for ids, share in _alike(there, LEAST_OF_PART, box, left_out)[0].items():
            of_parts[ids][part.number] = share
    for ids, shares in of_parts.items():
        if ids not in pairs and len(shares) >= LEAST_PARTS:
            pairs[ids] = Pair(*ids, min(shares.values()), tuple(sorted(shares)))
    wanted = [pair for pair in pairs.values() if not {pair.first, pair.second} <= others]
    wanted.sort(key=lambda pair: (bool(pair.parts), -pair.share, pair.first, pair.second))
    notes = {id: why for id, why in {**in_part, **left_out}.items() if id not in others}
    return Similar(tuple(wanted[:MOST]), usual, len(wanted[MOST:]), incomplete=notes)


def _texts(
    students: list[Student], left_out: dict[str, str], in_part: dict[str, str]
) -> dict[int, list[tuple[str, str]]]:
    """The texts to compare, each with its id: the whole ones under 0, those of part n under n. Each
    submission is read once, because a reading may take seconds. Adds to `left_out` what can't be
    compared, and to `in_part` what is cut."""
    texts: dict[int, list[tuple[str, str]]] = defaultdict(list)
    for one in students:
        try:
            with about_one_submission("it can't be compared with others"):
                own = own_texts(one.path, one.uploads)
        except UsageError as error:
            left_out[one.id] = str(error)
            continue
        for number, text in own.items():
            if len(text) > LONGEST:
                in_part[one.id] = IN_PART
            if text:
                texts[number].append((one.id, text[:LONGEST] + "\n"))
    return texts


def _alike(
    texts: list[tuple[str, str]], least: int, box: boxes.Box, left_out: dict[str, str]
) -> tuple[dict[tuple[str, str], int], int]:
    """The pairs of texts whose shares stand out, by id; and the usual share. Adds to `left_out`
    what takes too long."""
    with temporary_folder(CLASS_FOLDER) as folder:
        files: dict[str, str] = {}
        for number, (id, text) in enumerate(texts):
            (folder / f"{number:06}.cpp").write_text(text)
            files[f"{number:06}"] = id
        box.give(folder)
        output = _by_line([[file] * WITH_ITSELF for file in files], folder, box)
        left_out |= {files.pop(file): TOO_SLOW for file, _ in ENDED.findall(output)}
        names = [f"{file}.cpp" for file in files]
        relatives = _relatives(_sim(ALL_AT_ONCE, names, folder, box))
        output = _by_line(sorted(relatives), folder, box)
        left_out |= {files[file]: TOO_SLOW for pair in ENDED.findall(output) for file in pair}
        shares = _shares(output)
    usual = _usual(shares, len(files))
    least = max(least, (usual + 100) // 2)  # halfway between the usual share and 100
    alike = {(files[a], files[b]): share for (a, b), share in shares.items() if share >= least}
    return alike, usual


def _by_line(lines: Iterable[Iterable[str]], folder: Path, box: boxes.Box) -> str:
    """The output of sim_c++ on the files of each line, compared with each other."""
    names = [" ".join(f"{file}.cpp" for file in line) for line in lines]
    return _sim(["/bin/sh", "-c", EACH_LINE], names, folder, box)


def _sim(command: list[str], lines: list[str], folder: Path, box: boxes.Box) -> str:
    if not lines:
        return ""
    stdin = "".join(f"{line}\n" for line in lines).encode()
    command = box.to_build(folder, [Path(PROGRAM)], ("sh",)) + command
    result = processes.run(command, LIMITS, stdin=stdin, cwd=folder)
    if not result.ok:
        raise KitError(f"sim_c++ failed: {result.err.strip()[:200] or 'it was ended'}")
    return result.out.decode("utf-8", "replace")


def _relatives(output: str) -> set[tuple[str, str]]:
    """The pairs to compare closely: each submission with its closest relatives."""
    of: dict[str, list[tuple[int, str]]] = defaultdict(list)
    for file, share, other in FOUND.findall(output):
        of[file].append((-int(share), other))
    best = [(file, other) for file in of for _, other in sorted(of[file])[:RELATIVES]]
    return {(min(pair), max(pair)) for pair in best}


def _shares(output: str) -> dict[tuple[str, str], int]:
    shares: dict[tuple[str, str], int] = defaultdict(int)
    for file, share, other in FOUND.findall(output):
        pair = (min(file, other), max(file, other))
        shares[pair] = max(shares[pair], int(share))
    return shares


def _usual(shares: dict[tuple[str, str], int], number: int) -> int:
    closest: dict[str, int] = defaultdict(int)
    for pair, share in shares.items():
        for file in pair:
            closest[file] = max(closest[file], share)
    all_closest = [*closest.values(), *([0] * (number - len(closest)))]
    return round(statistics.median(all_closest)) if all_closest else 0


def own_texts(path: Path, uploads: tuple[Upload, ...]) -> dict[int, str]:
    """The code that a student wrote, without comments and lines of the handout: of all files under
    0, the parts first; of part n under n. Empty if the submission can't be read."""
    try:
        taken = handed_in.read(path, uploads)
    except UsageError:
        return {}
    handout = _handout()
    own = {
        name: "".join(f"{line}\n" for line in code_of(text) if line not in handout)
        for name, text in taken.files.items()
    }
    of_parts = {number: own[file] for number, file in taken.parts.items()}
    helpers = [own[name] for name in sorted(own.keys() - set(taken.parts.values()))]
    return {0: "".join([*of_parts.values(), *helpers]), **of_parts}


def code_of(text: bytes) -> list[str]:
    """The lines of a source that hold code, without comments, indentation and the contents of
    literals."""
    whole = io.StringIO(text.decode("utf-8", "replace"), newline=None).read()
    spliced = re.sub(r"\\[ \t]*\n", "", whole)
    code = HIDING.sub(_without_content, spliced)
    return [line for line in (" ".join(line.split()) for line in code.split("\n")) if line]


def _without_content(match: re.Match[str]) -> str:
    if match["comment"]:
        return " "
    if match["number"]:
        return match["number"].replace("'", "")
    return match["never_closed"] or ("#include" if match["header"] else '""')


@cache
def _handout() -> set[str]:
    return {line for f in STUBS.glob("*.cpp") for line in code_of(f.read_bytes())} - {"{", "}"}
