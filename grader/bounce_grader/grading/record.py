"""Builds the score record: one JSON object, from which every report is made. Pure functions.

Messages and names of files can hold text from a submission. They are made printable and cut to a
bounded length here, so that the record is always valid JSON in UTF-8.
"""

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any

from bounce_grader import __version__
from bounce_grader.common.escaping import printable_name, printable_text
from bounce_grader.common.files import digest
from bounce_grader.common.manifest import parts, Check, Part
from bounce_grader.common.paths import FIXTURES
from bounce_grader.grading import words
from bounce_grader.grading.judging import Judged
from bounce_grader.grading.words import Said, Verdict
from bounce_grader.submission.submission import Place, Submission

Record = dict[str, Any]
KNOWN = FIXTURES / "public" / "mistakes"
MISTAKE_FIELDS = ("name", "title", "sentence", "equations", "hint")
SHOWN = ("name", "input", "hidden", "contact", "sentence", "quantities")  # of a failed case
LONGEST_SENTENCE = 1000
MOST_IGNORED = 100  # names


@cache
def known_mistakes() -> dict[str, Record]:
    """What students are told about each known mistake, and the checks that it costs, by name."""
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
    place = next((verdict.place for verdict in judged.ended if verdict.place), None)
    verdicts = [judged.verdicts[check.id] for check in part.checks]
    said = words.say(verdicts)
    end = next((s.end for v, s in zip(verdicts, said) if v.status != "graded"), "")
    whole = failed_part(part, judged.status, end or _part_message(part, judged), place)
    if judged.status == "does_not_compile":  # no function to ask: said once, and of no check
        return whole
    known = [known_mistakes()[name] for name in judged.mistakes]
    mistakes = [{key: mistake[key] for key in MISTAKE_FIELDS} for mistake in known]
    return whole | {
        "score": judged.score(part),
        "graded_with": judged.graded_with,
        "mistakes": mistakes,
        "patterns": [printable_text(sentence) for sentence in judged.patterns],
        "checks": list(_checks(part, verdicts, said, mistakes)),
    }


def with_remark(graded: Record, remark: str, place: Place | None) -> Record:
    """The record of a part, with a remark that costs no points."""
    return graded | {"remarks": [*graded["remarks"], sentence(remark)]} | _at(place)


def _checks(
    part: Part, verdicts: list[Verdict], all_said: list[Said], mistakes: list[Record]
) -> Iterator[Record]:
    """The records of the checks. One that fails by the same exception or crash as an earlier check
    refers to that check, in place of repeating its case."""
    first: dict[str, str] = {}  # the title of the check, by the reason
    for check, verdict, said in zip(part.checks, verdicts, all_said):
        reason, numbers, message = said.reason(verdict), _numbers(verdict, said), said.lines
        if reason in first and verdict.failure:
            message = f'{said.counts}, as in "{first[reason]}": {reason}'
            numbers = {}
        elif reason:
            first[reason] = check.title
        made = _check_record(check, verdict.passed, message or said.end, mistakes)
        yield made | _at(verdict.place) | numbers


def _mistake_of(check: Check, mistakes: list[Record]) -> Record | None:
    """The mistake to name for a failed check: the part's only one, or the first that costs it."""
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


def _numbers(verdict: Verdict, said: Said) -> Record:
    """The failed case in numbers; if hidden, also the message with its answer, for some to see."""
    failure = verdict.failure
    if not failure or verdict.status != "graded":
        return {}
    shown = {"shown": {name: failure[name] for name in SHOWN}}
    return shown | ({"revealed": said.revealed} if failure["hidden"] else {})


def for_readers(record: Record, answers: bool) -> Record:
    """The record without what tells answers to hidden cases, as students may see it; or with it."""

    def read(check: Record) -> Record:
        kept = {key: check[key] for key in check if key != "revealed"}
        shown = kept.get("shown", {})
        if answers:
            kept["message"] = check.get("revealed", check["message"])
        elif shown.get("hidden"):
            own = [{k: q[k] for k in q if k != "expected"} for q in shown["quantities"]]
            kept["shown"] = shown | {"contact": "", "quantities": own}
        return kept

    parts_ = [{**part, "checks": list(map(read, part["checks"]))} for part in record["parts"]]
    return {**record, "parts": parts_}


def _part_message(part: Part, judged: Judged) -> str:
    lost = sum(not judged.verdicts[check.id].passed for check in part.checks)
    if not lost:
        return "everything right"
    every = len(part.checks)
    return f"{lost} of {every} checks failed" if lost < every else "no check passed yet"


def sentence(text: str) -> str:
    """One printable line of bounded length."""
    return printable_text(text, LONGEST_SENTENCE).replace("\n", " ")


def whole(submission: Submission, part_records: list[Record], **facts: Any) -> Record:
    """The record of a submission, with what there is of the `facts` about its grading: the kind of
    the box, the seconds of each phase, fixtures_sha256, the speed, and the examples."""
    rest = len(submission.ignored) - MOST_IGNORED
    return {
        "score": sum(p["score"] for p in part_records),
        "max_score": sum(p["max_score"] for p in part_records),
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
    return digest(
        [
            (folder.name, file.name, file.read_bytes())
            for folder in folders
            for file in sorted(folder.glob("*.json"))
        ]
    )
