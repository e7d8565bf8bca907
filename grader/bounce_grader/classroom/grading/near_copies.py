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
from functools import cache
from itertools import combinations, islice
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.grading.results import digest_of
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import students as students_of, uploads
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.manifest import named_together, parts
from bounce_grader.common.paths import STUBS

RUN = 8  # tokens
LEAST = 60  # per cent in common
LEAST_OF_PART = 90  # per cent of one part; right answers to a short task look alike
LEAST_PARTS = 2  # alike, for a pair that isn't alike as a whole
MOST = 20  # pairs that are named
LONGEST = 16_000  # tokens that are compared of each
LONGER = f"it is longer than {LONGEST} words and signs"
IN_PART = f"{LONGER}, and only its beginning is compared with others: look whether it is a copy"
KEYWORDS = set(
    "auto bool break case catch class const constexpr continue default do double else enum false "
    "float for if inline int namespace new operator return static struct switch template this throw "
    "true try typename unsigned using void while".split()
)
# Comments and blanks are skipped. Literals and names of headers may hold the signs that begin a
# comment. Matching takes time that grows with the text, whatever a student writes.
TOKEN = re.compile(
    r"""(?P<skipped>\s+ | //[^\n]* | /\*.*?(?:\*/|\Z))
    | (?P<header>(?:\#\s*include | __has_include\s*\()\s*<[^>\n]{0,200}>)
    | (?P<literal>(?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?(?:\)(?P=mark)"|\Z)
        | "(?:\\.|[^"\\\n])*"? | '(?:\\.|[^'\\\n])*'?)
    | (?P<number>\.?\d(?:'?[\w.])*) | (?P<name>[^\W\d]\w*) | .""",
    re.DOTALL | re.VERBOSE,
)
Runs = Mapping[str, Mapping[int, set[int]]]  # by whose they are


class Pair(NamedTuple):
    """Two submissions that have much in common."""

    first: str  # whose it is
    second: str  # perhaps of another year
    share: int  # per cent of the one of which it is more
    parts: tuple[int, ...] = ()  # if only these are alike, and not the submissions as a whole

    @property
    def in_common(self) -> str:
        return f"{self.share} %{f' of {named_together(self.parts)}' if self.parts else ''}"


class Similar(NamedTuple):
    """The near-copies of a class."""

    pairs: Sequence[Pair]
    usual: int  # per cent: the median share with the closest relative
    more: int = 0  # pairs that stand out, too


def corpus(folder: Path) -> list[Summary]:
    """Another year's submissions, to compare with. Raises UsageError if they are damaged."""
    others = []
    for student in students_of.read(folder).students:
        digest_of(student)
        name = f"{folder.name}/{printable_name(student.who)}"
        others.append(Summary(student._replace(id=name, name=name), "graded"))
    return others


def find(summaries: Sequence[Summary], others: Sequence[Summary] = ()) -> Similar:
    """Finds similar submissions among these, and between these and others. Notes which can't be
    compared, or only in part."""
    own = [summary for summary in summaries if summary.state != "unreadable"]
    names = {summary.student.who for summary in own}
    runs = {summary.student.who: own_runs(summary) for summary in (*own, *others)}
    whole, usual = _alike(runs, 0, LEAST)
    pairs = [Pair(*both, share) for both, share in whole.items()]
    of_parts: dict[tuple[str, str], dict[int, int]] = defaultdict(dict)
    for part in parts():
        for both, share in _alike(runs, part.number, LEAST_OF_PART)[0].items():
            of_parts[both][part.number] = share
    for both, shares in of_parts.items():
        if both not in whole and len(shares) >= LEAST_PARTS:
            pairs.append(Pair(*both, min(shares.values()), tuple(shares)))
    wanted = [pair for pair in pairs if pair.first in names]
    wanted.sort(key=lambda pair: (bool(pair.parts), -pair.share, pair.first, pair.second))
    return Similar(wanted[:MOST], usual, len(wanted[MOST:]))


def _alike(runs: Runs, number: int, least: int) -> tuple[dict[tuple[str, str], int], int]:
    """The shares that stand out, in per cent, by whose submissions they are; and the usual share."""
    those = {who: of[number] for who, of in runs.items() if number in of}
    closest = dict.fromkeys(those, 0)
    shares: dict[tuple[str, str], int] = {}
    for (one, own), (other, others) in combinations(those.items(), 2):
        share = round(100 * len(own & others) / min(len(own), len(others)))
        closest[one], closest[other] = max(closest[one], share), max(closest[other], share)
        if share >= least:
            shares[one, other] = share
    usual = round(statistics.median(closest.values())) if closest else 0
    # At least halfway between the usual share and 100.
    return {both: share for both, share in shares.items() if share >= (usual + 100) // 2}, usual


def own_runs(summary: Summary) -> dict[int, set[int]]:
    """The runs that aren't the handout's: of all files under 0, of part n under n. Notes why they
    can't be compared, or are cut. They are read once, because a reading may take seconds."""
    own: dict[str, set[int]] = {}
    room = LONGEST
    try:
        with about_one_submission("it can't be compared with others"):
            taken = uploads.read(summary.student)
            for name in dict.fromkeys([*taken.parts.values(), *sorted(taken.files)]):
                tokens = tokens_of(taken.files[name])
                summary.notes += [IN_PART] * (len(tokens) > room)
                own[name] = runs_of(tokens[:room]) - _handout()
                room -= min(room, len(tokens))
    except UsageError as error:
        summary.notes.append(str(error))
        return {}
    runs = {0: set().union(*own.values()), **{n: own[file] for n, file in taken.parts.items()}}
    return {number: of for number, of in runs.items() if len(of) >= RUN}


def runs_of(tokens: Sequence[str]) -> set[int]:
    """Their hashes."""
    return set(map(hash, zip(*(tokens[start:] for start in range(RUN)))))


def tokens_of(text: bytes) -> list[str]:
    """A source's first tokens, in which all names are the same, all numbers and all literals."""
    whole = io.StringIO(text.decode("utf-8", "replace"), newline=None).read()
    spliced = re.sub(r"\\[ \t]*\n", "", whole)
    found = (match for match in TOKEN.finditer(spliced) if match.lastgroup != "skipped")
    first = islice(found, LONGEST + 1)
    return [match[0] if match[0] in KEYWORDS else match.lastgroup or match[0] for match in first]


@cache
def _handout() -> set[int]:
    """The runs in the handout's stubs, which are nobody's own."""
    return {run for stub in STUBS.glob("*.cpp") for run in runs_of(tokens_of(stub.read_bytes()))}
