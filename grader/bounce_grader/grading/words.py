"""A check's verdict as facts, and what the program of grader/words says of it, which has the words
of ./check."""

import json
from collections.abc import Sequence
from typing import Any, NamedTuple

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import SENTENCES, WORDS
from bounce_grader.sandbox import processes
from bounce_grader.submission.submission import Place

Facts = dict[str, Any]  # a failed check in numbers (grader/judge/facts.hpp)
LIMITS = processes.Limits(10, 60, memory=1 << 30, file_size=0, output=1 << 24)


class Verdict(NamedTuple):
    """What became of one check."""

    passed: bool
    status: str
    ended: Facts | None = None  # how the program ended, if it did (grader/judge/termination.hpp)
    stack: str = ""  # addresses, where it crashed
    failure: Facts | None = None  # None if the check passed, or failed as a whole
    place: Place | None = None  # of a crash in the submission, if known
    found: str = ""  # what sanitizers found, where a crash didn't say why


class Said(NamedTuple):
    """A verdict in words."""

    id: str = ""  # of the way in which the program ended; empty if it didn't
    end: str = ""  # how it ended, and where
    lines: str = ""  # what was asked, what came, and what is right, unless the case is hidden
    revealed: str = ""  # the same, with what is right of a hidden case
    counts: str = ""  # how many cases are wrong

    def reason(self, verdict: Verdict) -> str:
        """The exception of the failed case, or how the program crashed; or empty."""
        if verdict.status == "crashed":
            return self.end
        failure = verdict.failure if verdict.status == "graded" else None
        return str(failure["sentence"]) if failure and not failure["quantities"] else ""


def say(verdicts: Sequence[Verdict]) -> list[Said]:
    """What there is to say of each. Raises KitError."""
    if not any(verdict.ended or verdict.failure for verdict in verdicts):
        return [Said()] * len(verdicts)
    facts = [
        {
            "ended": verdict.ended,
            "failure": verdict.failure,
            "place": str(verdict.place or ""),
            "found": verdict.found,
        }
        for verdict in verdicts
    ]
    result = processes.run([str(WORDS), str(SENTENCES)], LIMITS, stdin=json.dumps(facts).encode())
    if not result.ok:
        raise KitError(f"what the judge found can't be said: {result.err.strip() or 'it ended'}")
    return [Said(**said) for said in json.loads(result.out)]
