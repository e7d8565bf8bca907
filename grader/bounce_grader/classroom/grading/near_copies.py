"""Finds near-copies by the structure of the code: which runs of tokens two programs have in common,
whatever their names, numbers, comments and layout.

Each text becomes the set of all its runs of eight tokens, about a line, in which every name is the
same token. What two sets have in common, as a share of the smaller one, is found for every pair:
a class of a thousand takes ten seconds.
"""

import io
import re
import statistics
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.grading.results import digest
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import students as students_of, uploads
from bounce_grader.classroom.intake.student import Student
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.manifest import named_together, parts
from bounce_grader.common.paths import STUBS

RUN = 8  # tokens
LEAST = 60  # per cent in common
LEAST_OF_PART = 90  # per cent of one part; right answers to a short task look alike
LEAST_PARTS = 2  # alike, for a pair that isn't alike as a whole
MOST = 20  # pairs that are named
LONGEST = 64 * 1024  # characters that are compared of each, without comments and blanks
IN_PART = (
    f"it is longer than {LONGEST >> 10} KB even without comments, and only its beginning is compared "
    "with others: look whether it is a copy"
)
TOKEN = re.compile(r"(?P<name>[^\W\d]\w*)|(?P<number>\.?\d[\w.]*)|\S")
KEYWORDS = set(
    "auto bool break case catch class const constexpr continue default do double else enum false "
    "float for if inline int namespace new operator return static struct switch template this throw "
    "true try typename unsigned using void while".split()
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
# Whole submissions' under 0, those of part n under n, by whose they are.
Runs = defaultdict[int, dict[str, set[int]]]


class Pair(NamedTuple):
    """Two submissions that have much in common: whose they are, and the share in per cent of the
    one of which it is more."""

    first: str
    second: str  # perhaps of another year
    share: int
    parts: tuple[int, ...] = ()  # if only these are alike, and not the submissions as a whole

    @property
    def in_common(self) -> str:
        return f"{self.share} %{f' of {named_together(self.parts)}' if self.parts else ''}"


class Similar(NamedTuple):
    """The near-copies of a class."""

    pairs: Sequence[Pair]
    usual: int  # per cent: the median share with the closest relative
    more: int = 0  # pairs that stand out, too


def corpus(folder: Path) -> list[Student]:
    """Another year's submissions, to compare with. Raises UsageError if they are damaged."""
    others = [other for other in students_of.read(folder).students if not other.refused]
    for other in others:
        digest(other)
    names = [f"{folder.name}/{printable_name(other.who)}" for other in others]
    return [replace(other, id=name, name=name) for other, name in zip(others, names)]


def find(summaries: Sequence[Summary], others: Sequence[Student] = ()) -> Similar:
    """Finds near-copies among the submissions that can be read, and between them and others. Notes
    which can't be compared, or only in part."""
    own = [summary for summary in summaries if summary.state != "unreadable"]
    runs: Runs = defaultdict(dict)
    for summary in own:
        _add(runs, summary.student, summary.notes)
    for other in others:
        _add(runs, other, [])
    whole, usual = _alike(runs[0], LEAST)
    pairs = [Pair(*both, share) for both, share in whole.items()]
    of_parts: dict[tuple[str, str], dict[int, int]] = defaultdict(dict)
    for part in parts():
        for both, share in _alike(runs[part.number], LEAST_OF_PART)[0].items():
            of_parts[both][part.number] = share
    for both, shares in of_parts.items():
        if both not in whole and len(shares) >= LEAST_PARTS:
            pairs.append(Pair(*both, min(shares.values()), tuple(sorted(shares))))
    names = {summary.student.who for summary in own}
    wanted = [pair for pair in pairs if pair.first in names]
    wanted.sort(key=lambda pair: (bool(pair.parts), -pair.share, pair.first, pair.second))
    return Similar(wanted[:MOST], usual, len(wanted[MOST:]))


def _add(runs: Runs, student: Student, notes: list[str]) -> None:
    """Adds a submission's runs; or notes why they can't be compared, or are cut. It is read once,
    because a reading may take seconds."""
    try:
        with about_one_submission("it can't be compared with others"):
            texts = own_texts(student)
    except UsageError as error:
        notes.append(str(error))
        return
    for number, text in texts.items():
        if len(text) > LONGEST:
            notes.append(IN_PART)
        if found := runs_of(text[:LONGEST]):
            runs[number][student.who] = found


def _alike(runs: Mapping[str, set[int]], least: int) -> tuple[dict[tuple[str, str], int], int]:
    """The shares that stand out, in per cent, by whose submissions they are; and the usual share."""
    closest = dict.fromkeys(runs, 0)
    shares: dict[tuple[str, str], int] = {}
    for (one, own), (other, others) in combinations(runs.items(), 2):
        share = round(100 * len(own & others) / min(len(own), len(others)))
        closest[one], closest[other] = max(closest[one], share), max(closest[other], share)
        if share >= least:
            shares[one, other] = share
    usual = round(statistics.median(closest.values())) if closest else 0
    # At least halfway between the usual share and 100.
    return {both: share for both, share in shares.items() if share >= (usual + 100) // 2}, usual


def runs_of(text: str) -> set[int]:
    """The hashes of all runs of tokens; none of a text that is only a few runs long."""
    tokens = [
        "name"
        if token["name"] and token[0] not in KEYWORDS
        else "number"
        if token["number"]
        else token[0]
        for token in TOKEN.finditer(text)
    ]
    if len(tokens) < 2 * RUN:
        return set()
    return set(map(hash, zip(*(tokens[start:] for start in range(RUN)))))


def own_texts(student: Student) -> dict[int, str]:
    """The code that a student wrote, without comments and lines of the handout: of all files under
    0, the parts first; of part n under n. Raises UsageError."""
    taken = uploads.read(student.path, student.uploads)
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
