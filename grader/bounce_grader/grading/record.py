"""Builds the score record: one JSON object of facts, from which report.py makes what readers get.

A part's record has its number, stem, title, points and status, and
    graded_with  "own" or "given": whose earlier parts it was judged with
    why          a fact, where nothing of it could be run, else None
    notes        facts that also explain its points
    mistakes     names of known mistakes
    patterns     what its wrong numbers have in common (grader/diagnosis/tables.txt)
    remarks      facts that cost no points
    checks       each with its id, title, points and verdict (judging.Verdict)
    place        the line of the submission that it is about, if known

Facts and names of files can hold text from a submission. It is made printable and cut to a bounded
length here, so that the record is always valid JSON in UTF-8.
"""

import json
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any

from bounce_grader import __version__
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import digest
from bounce_grader.common.manifest import parts, Check, Part
from bounce_grader.common.paths import FIXTURES
from bounce_grader.grading.judging import Facts, Judged, Verdict
from bounce_grader.submission.submission import Place, Submission

Record = dict[str, Any]  # of facts, with the answers of hidden cases: for the course alone
KNOWN = FIXTURES / "public" / "mistakes"
MISTAKE_FIELDS = ("name", "title", "sentence", "equations", "hint")
MOST_IGNORED = 100  # names
NOT_RUN = Verdict(False, "graded")


@cache
def known_mistakes() -> dict[str, Record]:
    """What students are told about each known mistake, and the checks that it costs, by name."""
    files = [KNOWN / f"{part.stem}.json" for part in parts()]
    entries = [one for file in files for one in json.loads(file.read_text("utf-8"))["mistakes"]]
    return {one["name"]: {key: one[key] for key in one if key != "answers"} for one in entries}


def failed_part(part: Part, status: str, why: Facts, place: Place | None = None) -> Record:
    """The record of a part that couldn't be run at all."""
    verdicts = {check.id: NOT_RUN for check in part.checks}
    return _part(part, status, why, verdicts) | _at(place)


def part_record(part: Part, judged: Judged) -> Record:
    place = next((verdict.place for verdict in judged.ended if verdict.place), None)
    made = _part(part, judged.status, None, judged.verdicts)
    return made | {
        "score": judged.score(part),
        "graded_with": judged.graded_with,
        "mistakes": list(judged.mistakes),
        "patterns": list(judged.patterns),
        **_at(place),
    }


def _part(part: Part, status: str, why: Facts | None, verdicts: dict[str, Verdict]) -> Record:
    return {
        "part": part.number,
        "stem": part.stem,
        "title": part.title,
        "score": 0,
        "max_score": part.points,
        "status": status,
        "graded_with": "own",
        "why": why,
        **{name: [] for name in ("notes", "mistakes", "patterns", "remarks")},
        "checks": [_check(check, verdicts[check.id]) for check in part.checks],
    }


def _check(check: Check, verdict: Verdict) -> Record:
    facts = {name: x for name, x in verdict._asdict().items() if name not in ("stack", "place")}
    return {
        "id": check.id,
        "title": check.title,
        "score": check.points if verdict.passed else 0,
        "max_score": check.points,
        **facts,
        **_at(verdict.place),
    }


def _at(place: Place | None) -> Record:
    """The line of the submission that something is about, if one is known."""
    return {"place": place._asdict()} if place else {}


def with_remark(graded: Record, remark: Facts, place: Place | None) -> Record:
    """The record of a part, with a remark that costs no points."""
    return graded | {"remarks": [*graded["remarks"], remark]} | _at(place)


def whole(submission: Submission, part_records: list[Record], **facts: Any) -> Record:
    """The record of a submission, with what there is of the `facts` about its grading: the kind of
    the box, the seconds of each phase, fixtures_sha256, the speed, and the examples."""
    rest = len(submission.ignored) - MOST_IGNORED
    return {
        **{key: sum(part[key] for part in part_records) for key in ("score", "max_score")},
        "parts": [_with_paths(part, submission) for part in part_records],
        **{name: fact for name, fact in facts.items() if fact},
        "kit": __version__,
        "submission_sha256": submission.sha256,
        "ignored": [printable_name(file) for file in submission.ignored[:MOST_IGNORED]],
        **({"ignored_more": rest} if rest > 0 else {}),
    }


def _with_paths(part: Record, submission: Submission) -> Record:
    """The part and its checks with the paths that their places have in what was handed in. A part
    that isn't about a certain line has line 0 of its file."""

    def located(found: Record) -> Record:
        place = found.get("place")
        path = PurePosixPath(submission.top, place["file"]) if place else ""
        return found | ({"place": place | {"file": printable_name(str(path))}} if place else {})

    if part["part"] in submission.parts:
        part = _at(Place(submission.parts[part["part"]], 0)) | part
    return located(part) | {"checks": list(map(located, part["checks"]))}


def digest_of(folders: list[Path]) -> str:
    files = [file for folder in folders for file in sorted(folder.glob("*.json"))]
    return digest([(file.parent.name, file.name, file.read_bytes()) for file in files])
