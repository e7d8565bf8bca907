"""Parses the names in Blackboard's download of an assignment's files.

    {assignment}_{user}_attempt_{2026-11-20-23-15-42}_{file}
    {assignment}_{user}_attempt_{2026-11-20-23-15-42}.txt     who submitted, and what else is typed

Both the assignment's title and a user's name may hold "_". The text begins with a line that
Blackboard writes, "Name: Jane Doe (jdoe)"; without it, what all entries begin with is the title.
"""

import os
import re
from collections.abc import Iterable
from typing import NamedTuple

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
