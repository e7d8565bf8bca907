"""Parses the names in Moodle's download of all submissions, which mod/assign writes.

    {full name}_{participant}_assignsubmission_file/{path}      since 4.1
    {full name}_{participant}_assignsubmission_file_/{path}     since 3.1
    {full name}_{participant}_assignsubmission_file_{file}      without folders
    {full name}_{participant}_assignsubmission_onlinetext...    a text typed into Moodle

A full name holds no "_", because Moodle writes blanks in their place; a group's comes before it,
with a hyphen.
"""

import re
from collections.abc import Iterable
from typing import NamedTuple

from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting

ENTRY = re.compile(
    r"(?P<name>[^_/]+)_(?P<id>[0-9]{1,20})_assignsubmission_(?P<kind>file|onlinetext)"
    r"(?:_?/|_)(?P<file>.+)",
    re.DOTALL,
)
FOLDER = re.compile(r"(?P<name>[^_/]+)_(?P<id>[0-9]{1,20})_assignsubmission_(?P<kind>\w+?)_?")


class Entry(NamedTuple):
    """The name of a file or folder in Moodle's download, split into its fields."""

    name: str
    participant: str
    kind: str  # "file" or "onlinetext"
    file: str  # its path in the submission; "" for a folder


def parse(entry: str) -> Entry | None:
    match = ENTRY.fullmatch(entry)
    return Entry(match["name"], match["id"], match["kind"], match["file"]) if match else None


def wrote_all(entries: Iterable[str]) -> bool:
    """Whether Moodle can have written all of these names."""
    return all(map(parse, entries))


def parse_folder(name: str) -> Entry | None:
    match = FOLDER.fullmatch(name)
    return Entry(match["name"], match["id"], match["kind"], "") if match else None


def feedback_name(name: str, participant: str) -> str:
    """The name for a feedback page that Moodle's importer of feedback files takes, whichever its
    version: it splits at "_"."""
    return f"{printable_name(fitting(name, 150))}_{participant}_assignfeedback_file_feedback.html"
