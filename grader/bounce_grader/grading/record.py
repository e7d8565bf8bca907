"""Builds the score record: one JSON object, from which every report is made. Pure functions.

Messages and names of files can hold text from a submission. They are made printable and cut to a
bounded length here, so that the record is always valid JSON in UTF-8.
"""

import hashlib
import json
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any

from bounce_grader import __version__
from bounce_grader.common.escaping import printable_name, printable_text
from bounce_grader.common.manifest import parts, Check, Part
from bounce_grader.common.paths import FIXTURES
from bounce_grader.grading import words
from bounce_grader.grading.judging import Judged
from bounce_grader.grading.words import Verdict
from bounce_grader.submission.submission import Place, Submission

Record = dict[str, Any]
KNOWN = FIXTURES / "public" / "mistakes"
MISTAKE_FIELDS = ("name", "title", "sentence", "equations", "hint")
LONGEST_SENTENCE = 1000
MOST_IGNORED = 100  # names


@cache
def known_mistakes() -> dict[str, Record]:
    """What students are told about each known mistake, and the checks that it costs, by its
    name."""
    files = [KNOWN / f"{part.stem}.json" for part in parts()]
    entries = [one for file in files for one in json.loads(file.read_text("utf-8"))["mistakes"]]
    return {one["name"]: {key: one[key] for key in one if key != "answers"} for one in entries}


def failed_part(part: Part, status: str, message: str, place: Place | None = None) -> Record:
    """The record of a part that couldn't be run at all."""
    made = {
        "part": part.number,
        "stem": part.stem,
        "title": part.title,
        "score": 0,
        "max_score": part.points,
        "status": status,
        "message": sentence(message),
        "graded_with": "own",
        "mistakes": [],
        "patterns": [],
        "remarks": [],
        "checks": [_check_record(check, False, "", []) for check in part.checks],
    }
    return made | _at(place)


def _at(place: Place | None) -> Record:
    """The line of the submission that something is about, if one is known."""
    return {"place": place._asdict()} if place else {}


def part_record(part: Part, judged: Judged) -> Record:
    ended = [verdict for verdict in judged.verdicts.values() if verdict.status != "graded"]
    place = next((verdict.place for verdict in ended if verdict.place), None)
    if judged.status == "does_not_compile":  # no function to ask: said once, and of no check
        return failed_part(part, judged.status, _part_message(part, judged), place)
    mistakes = [
        {key: known_mistakes()[name][key] for key in MISTAKE_FIELDS} for name in judged.mistakes
    ]
    return failed_part(part, judged.status, _part_message(part, judged), place) | {
        "score": judged.score(part),
        "graded_with": judged.graded_with,
        "mistakes": mistakes,
        "patterns": [printable_text(sentence) for sentence in judged.patterns],
        "checks": [
            _check_record(check, verdict.passed, message, mistakes) | _at(verdict.place) | numbers
            for check, verdict, message, numbers in _with_each_reason_once(part, judged)
        ],
    }


def with_remark(graded: Record, remark: str, place: Place | None) -> Record:
    """The record of a part, with a remark that costs no points."""
    return graded | {"remarks": [*graded["remarks"], sentence(remark)]} | _at(place)


def _with_each_reason_once(
    part: Part, judged: Judged
) -> Iterator[tuple[Check, Verdict, str, Record]]:
    """The checks with their verdicts, messages and numbers. One that fails by the same exception or
    crash as an earlier check refers to that check, in place of repeating its case."""
    first: dict[str, Check] = {}
    for check in part.checks:
        verdict = judged.verdicts[check.id]
        reason = verdict.reason
        if reason in first and verdict.failure:
            cases = words.counts(verdict.failure)
            yield check, verdict, f'{cases}, as in "{first[reason].title}": {reason}', {}
            continue
        yield check, verdict, words.of_check(verdict), _numbers(verdict)
        if reason:
            first[reason] = check


def _mistake_of(check: Check, mistakes: list[Record]) -> Record | None:
    """The mistake to name for a failed check: the part's only one, or the first that costs this
    check."""
    if len(mistakes) == 1:
        return mistakes[0]
    return next((m for m in mistakes if check.id in known_mistakes()[m["name"]]["checks"]), None)


def _check_record(check: Check, passed: bool, message: str, mistakes: list[Record]) -> Record:
    return {
        "id": check.id,
        "title": check.title,
        "score": check.points if passed else 0,
        "max_score": check.points,
        "passed": passed,
        "message": printable_text(message),
        "mistake": None if passed else _mistake_of(check, mistakes),
    }


def _numbers(verdict: Verdict) -> Record:
    """The failed case in numbers; for a hidden case also the message with its answer, which only
    some may see."""
    failure = verdict.failure
    if not failure or verdict.status != "graded":
        return {}
    shown = {"shown": words.shown(failure)}
    return shown | ({"revealed": words.of_check(verdict, True)} if failure["hidden"] else {})


def for_readers(record: Record, answers: bool) -> Record:
    """The record without what tells the answers to hidden cases, as a student may see it; or with
    it."""

    def read(check: Record) -> Record:
        kept = dict(check)
        revealed = kept.pop("revealed", None)
        if answers:
            return kept | ({"message": revealed} if revealed else {})
        shown = kept.get("shown", {})
        if shown.get("hidden"):
            own = [{k: q[k] for k in q if k != "expected"} for q in shown["quantities"]]
            kept["shown"] = shown | {"contact": "", "quantities": own}
        return kept

    parts_ = [{**part, "checks": list(map(read, part["checks"]))} for part in record["parts"]]
    return {**record, "parts": parts_}


def _part_message(part: Part, judged: Judged) -> str:
    lost = [c for c in part.checks if not judged.verdicts[c.id].passed]
    if not lost:
        return "everything right"
    ended = [v for v in judged.verdicts.values() if v.status != "graded"]
    if ended:
        return ended[0].end
    nothing = len(lost) == len(part.checks)
    return "no check passed yet" if nothing else f"{len(lost)} of {len(part.checks)} checks failed"


def sentence(text: str) -> str:
    """One printable line of bounded length."""
    return printable_text(text, LONGEST_SENTENCE).replace("\n", " ")


def whole(
    submission: Submission,
    part_records: list[Record],
    box: str,
    seconds: Mapping[str, float],
    fixtures_sha256: str,
    speed: Record | None,
) -> Record:
    record: Record = {
        "score": sum(p["score"] for p in part_records),
        "max_score": sum(p["max_score"] for p in part_records),
        "parts": [_with_paths(part, submission) for part in part_records],
        "box": box,
        "seconds": {phase: round(value, 3) for phase, value in seconds.items()},
        "kit": __version__,
        "fixtures_sha256": fixtures_sha256,
        "submission_sha256": submission.sha256,
        "ignored": [printable_name(file) for file in submission.ignored[:MOST_IGNORED]],
    }
    if len(submission.ignored) > MOST_IGNORED:
        record["ignored_more"] = len(submission.ignored) - MOST_IGNORED
    return {**record, "speed": speed} if speed else record


def _with_paths(part: Record, submission: Submission) -> Record:
    """The part and its checks with the paths that their places have in what was handed in. A part
    that isn't about a certain line has line 0 of its file."""

    def path(file: str) -> str:
        return printable_name(str(PurePosixPath(submission.top, file)))

    def located(found: Record) -> Record:
        place = found.get("place")
        return found | {"place": place | {"file": path(place["file"])}} if place else found

    if part["part"] in submission.parts and "place" not in part:
        part = part | _at(Place(submission.parts[part["part"]], 0))
    return {**located(part), "checks": list(map(located, part["checks"]))}


def digest_of(folders: list[Path]) -> str:
    digest = hashlib.sha256()
    for folder in folders:
        for file in sorted(folder.glob("*.json")):
            digest.update(f"{folder.name}/{file.name}\0".encode() + file.read_bytes())
    return digest.hexdigest()
