"""Finds each student's submission in Blackboard's download of an assignment's files, packed or
unpacked.

    {assignment}_{user}_attempt_{2026-11-20-23-15-42}_{file}
    {assignment}_{user}_attempt_{2026-11-20-23-15-42}.txt     who submitted, and what else is typed

Both the assignment's title and a user's name may hold "_". The text begins with a line that
Blackboard writes, "Name: Jane Doe (jdoe)"; without it, what all entries begin with is the title.
"""

import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.intake.archive import opened
from bounce_grader.classroom.intake.student import Class, set_duplicates_aside, Unmatched, Upload
from bounce_grader.classroom.intake.uploads import not_named, take, typed_elsewhere
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting

ENTRY = re.compile(  # up to the first time: a file's own name may hold another student's
    r"(?P<head>.+?)_attempt_(?P<when>\d{4}(?:-\d\d){5})(?:_(?P<file>.+)|\.txt)", re.DOTALL
)
NAME = re.compile(r"\ufeff?Name:\s*(?P<name>.*)\((?P<user>[^()\s]+)\)\s*$")


class Entry(NamedTuple):
    """The name of a file in Blackboard's download, split into its fields."""

    head: str  # the assignment and the user
    when: int  # of the attempt, as a number that grows
    file: str  # "" for the text


class Person(NamedTuple):
    """A student, as the text file of an attempt names them."""

    user: str
    name: str


def parse(entry: str) -> Entry | None:
    match = ENTRY.fullmatch(entry)
    if not match:
        return None
    return Entry(match["head"], int(match["when"].replace("-", "")), match["file"] or "")


def wrote_all(entries: Iterable[str]) -> bool:
    """Whether Blackboard can have written all of these names."""
    return all(map(parse, entries))


def person_of(head: str, text: bytes) -> Person | None:
    """Who submitted, by the first line of the text; None if it isn't about this entry."""
    line = text.decode("utf-8", "replace").partition("\n")[0].strip()
    match = NAME.fullmatch(line)
    if not match or not head.endswith(f"_{match['user']}"):
        return None
    return Person(match["user"], match["name"].strip())


def title(heads: Iterable[str]) -> str:
    """What all entries begin with, up to a "_"; "" if that isn't known."""
    distinct = sorted(set(heads))
    common = os.path.commonprefix(distinct)
    return common[: common.rfind("_") + 1] if len(distinct) > 1 else ""


def read(path: Path, _people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Blackboard download", service="blackboard")
    parsed = {name: parse(name) for name in archive.names() if "/" not in name}
    known = {name: entry for name, entry in parsed.items() if entry}
    common = title(entry.head for entry in known.values())
    attempts: dict[str, dict[int, list[Upload]]] = {}
    people: dict[str, Person] = {}
    for name, entry in known.items():
        if not entry.file:
            person = person_of(entry.head, archive.read(name, 4096))
            if person:
                people[entry.head] = person
        attempts.setdefault(entry.head, {}).setdefault(entry.when, [])
        if entry.file:
            upload = Upload(name, "", entry.head, False, entry.when, entry.file, True)
            attempts[entry.head][entry.when].append(upload)
    for head, by_time in attempts.items():
        person = people.get(head)
        if not person and not common:
            intake.unmatched.append(Unmatched(head, "has no text that says whose it is"))
            continue
        user = person.user if person else head.removeprefix(common)
        name = person.name if person and person.name else user
        newest = [replace(upload, name=name, user=user) for upload in by_time[max(by_time)]]
        page = f"{fitting(printable_name(user))}.html"  # not by the name: it may hold a "/"
        if newest:
            take(intake, archive, user, name, newest, page)
        else:
            typed_elsewhere(intake, f"{head}.txt", "Blackboard", user, page)
    left = [name for name in archive.names() if name not in known]
    intake.unmatched += [Unmatched(name, not_named("Blackboard", name)) for name in left]
    set_duplicates_aside(intake)
    return intake
