"""Finds each student's submission in Blackboard's download of an assignment's files, packed or
unpacked.

    {assignment}_{user}_attempt_{2026-11-20-23-15-42}_{file}
    {assignment}_{user}_attempt_{2026-11-20-23-15-42}.txt     who submitted, and what else is typed

Both the assignment's title and a user's name may hold "_". The text begins with a line that
Blackboard writes, "Name: Jane Doe (jdoe)".
"""

import re
from collections import Counter
from collections.abc import Sequence

from bounce_grader.classroom.intake.archive import Archive, not_named
from bounce_grader.classroom.intake.student import Names, Upload
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting

TITLE = "Blackboard"
ENTRY = re.compile(  # up to the first time: a file's own name may hold another student's
    r"(?P<head>[^/]+?)_attempt_(?P<when>\d{4}(?:-\d\d){5})(?:_(?P<file>[^/]+)|\.txt)", re.DOTALL
)
NAME = re.compile(r"\ufeff?Name:\s*(?P<name>.*)\((?P<user>[^()\s]+)\)\s*$")


def parse(entry: str) -> Upload | None:
    """An entry by its name, with the assignment and the user for the user's id, which can't be told
    apart yet."""
    match = ENTRY.fullmatch(entry)
    if not match:
        return None
    when, file = int(match["when"].replace("-", "")), match["file"] or ""
    return Upload(entry, "", match["head"], file, number=when, typed="" if file else "text")


def read(archive: Archive, _people: Names) -> dict[str, Upload | str]:
    """The files of each user, or the text of the newest attempt if that has none; for other entries, why
    they are of nobody."""
    read: dict[str, Upload | str] = {}
    heads: dict[str, list[Upload]] = {}
    for entry in archive.names():
        upload = parse(entry)
        if upload:
            heads.setdefault(upload.user, []).append(upload)
        else:
            read[entry] = not_named(TITLE)
    whose = {head: _person(archive, head, of) for head, of in heads.items()}
    times = Counter(user for user, _ in whose.values())
    for head, uploads in heads.items():
        user, name = whose[head]
        if not user:
            read[head] = "has no text that says whose it is"
        elif times[user] > 1:
            read[head] = f"isn't the only one that could be {user}'s: keep one of them"
        else:
            last = max(upload.number for upload in uploads)
            files = [u._replace(old=u.number < last) for u in uploads if u.file]
            newest = [upload for upload in uploads if upload.number == last]
            for upload in newest if all(upload.old for upload in files) else files:
                read[upload.entry] = upload._replace(name=name, user=user)
    return read


def _person(archive: Archive, head: str, uploads: Sequence[Upload]) -> tuple[str, str]:
    """The user and the name, by the first line of a text that is about this entry."""
    user = name = ""
    for upload in filter(lambda upload: upload.typed, uploads):
        text = archive.read(upload.entry, 4096).decode("utf-8", "replace")
        match = NAME.fullmatch(text.partition("\n")[0].strip())
        if match and head.endswith(f"_{match['user']}"):
            user, name = match["user"], match["name"].strip() or match["user"]
    return user, name


def page_of(uploads: Sequence[Upload]) -> str:
    """The name for a feedback page: not by the student's name, which may hold a "/"."""
    return f"{fitting(printable_name(uploads[0].user))}.html"
