"""Adds sentences to score records of facts: what a reader gets, and what every format lays out.

The program `report` has the words, which are those of ./check. Only this module makes a Report: by
its type, no format takes a record that still has the answers of hidden cases.
"""

import json
from collections.abc import Sequence
from typing import Any, NewType

from bounce_grader.common.errors import KitError
from bounce_grader.common.escaping import in_one_line, printable_text
from bounce_grader.common.paths import HANDOUT, REPORT, SENTENCES
from bounce_grader.grading.record import known_mistakes, Record
from bounce_grader.sandbox import processes

Report = NewType("Report", dict[str, Any])
NO_REPORT = Report({})  # of what isn't graded
LIMITS = processes.Limits(60, 300, memory=4 << 30, file_size=0, output=1 << 30)


def report(record: Record, reveal: bool = False) -> Report:
    """What a reader gets of a record. Raises KitError."""
    return reports([record], reveal)[0]


def reports(records: Sequence[Record], reveal: bool = False) -> list[Report]:
    """What readers get of records; only with `reveal` with the answers of hidden cases."""
    parts = [[_with_mistakes(part) for part in record["parts"]] for record in records]
    cuts = [((record.get("speed") or {}).get("cut") or {}).get("ended") for record in records]
    asked = {"parts": [part for of_one in parts for part in of_one], "endings": cuts}
    options = ["--reveal"] if reveal else []
    command = [str(REPORT), str(SENTENCES), str(HANDOUT / "hints"), *options]
    result = processes.run(command, LIMITS, stdin=json.dumps(asked).encode())
    if not result.ok:
        raise KitError(f"what the judge found can't be said: {result.err.strip() or 'it ended'}")
    said = json.loads(result.out)
    told = iter(said["parts"])
    return [
        Report(_told(record, [_bounded(next(told)) for _ in record["parts"]], end))
        for record, end in zip(records, said["endings"])
    ]


def _with_mistakes(part: Record) -> Record:
    return part | {"mistakes": [known_mistakes()[name] for name in part["mistakes"]]}


def _bounded(part: Record) -> Record:
    """The part with texts of bounded length."""
    for check in part["checks"]:
        check["message"] = printable_text(check["message"])
    for name in ("patterns", "remarks"):
        part[name] = list(map(in_one_line, part[name]))
    return part | {"message": in_one_line(part["message"])}


def _told(record: Record, parts: list[Record], end_of_curves: str) -> Record:
    """The record with these parts, and with where and why the curves of a submission end early."""
    told, speed = record | {"parts": parts}, record.get("speed") or {}
    if "cut" in speed:
        cut = speed["cut"]
        why = f"at dt = {cut['dt']:.2g} s: {end_of_curves or cut['sentence']}" if cut else ""
        told["speed"] = speed | {"cut": printable_text(why)}
    return told
