"""Finds each student's submission in Canvas's bulk download, packed or unpacked, by the names that
its lib/content_zipper.rb writes.

    {name}[_LATE]_{user id}_{attachment id}_{file}
    [LATE_]anon_{anonymous id}_{attachment id}_{file}
    {name}[_LATE]_{user id}_text.html, or _link.html: a text entry, or a web address

A name is in lower case and holds only letters, digits and "_", so LATE is never part of it. A name
may end in "_12", as a group's does, and a file name may begin with "12_"; such an entry is
ambiguous (`read_all`).
"""

import re
import unicodedata
from collections.abc import Iterable, Sequence

from bounce_grader.classroom.intake.archive import Archive, not_named
from bounce_grader.classroom.intake.student import Names, Upload
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting

TITLE = "Canvas"
ID = "[0-9]{1,20}"
USER = rf"(?P<user>anon_[A-Za-z0-9]{{1,20}}|{ID})"
WHO = rf"(?:(?!LATE_|anon_)(?P<name>[^/]+?)_)?(?:(?P<late>LATE)_)?{USER}"
UPLOAD = re.compile(rf"{WHO}_(?P<attachment>{ID})_(?P<file>[^/]+)", re.DOTALL)
TYPED = re.compile(rf"{WHO}_(?P<kind>text|link)\.html", re.DOTALL)
EITHER = (
    "has a name that doesn't say for certain whose it is: look in Canvas who handed it in, and grade "
    "it by itself with ./kit grade"
)


def parse(entry: str) -> Upload | None:
    """Parses an entry's name; None if Canvas doesn't write such names."""
    typed = TYPED.fullmatch(entry)
    match = typed or UPLOAD.fullmatch(entry)
    if not match:
        return None
    who = (entry, match["name"] or "", match["user"])
    if typed:
        kind = "text" if typed["kind"] == "text" else "an address"
        return Upload(*who, "", bool(typed["late"]), as_named=False, typed=kind)
    return Upload(*who, match["file"], bool(match["late"]), int(match["attachment"]), False)


def read(archive: Archive, people: Names) -> dict[str, Upload | str]:
    """Each entry; or why it is of nobody."""
    return read_all(archive.names(), people)


def read_all(entries: Iterable[str], people: Names) -> dict[str, Upload | str]:
    """Reads the names of all entries, as `read` does. Students choose their names and the names of
    their files, so an entry can often be split in several ways. Such an ambiguous entry counts for
    the one of these `people` whose id and name it can be read with, unless another entry certainly
    has that id."""
    possible = {entry: readings(entry) for entry in entries}
    certain = {found[0].user for found in possible.values() if len(found) == 1}
    read: dict[str, Upload | str] = {}
    for entry, found in possible.items():
        known = [reading for reading in found if reading.user in people]
        if len(found) == 1:
            read[entry] = found[0]
        elif len(known) == 1 and known[0].user not in certain and _is_named(known[0], people):
            read[entry] = known[0]
        elif "/" in entry:
            read[entry] = "is in a folder; Canvas's download has none"
        else:
            read[entry] = EITHER if found else not_named(TITLE)
    return read


def _is_named(reading: Upload, people: Names) -> bool:
    return any(is_name_of(name, reading.name) for name in people[reading.user])


def readings(entry: str) -> list[Upload]:
    """All ways to split an entry's name into its fields."""
    first = parse(entry)
    if first is None or (first.user.startswith("anon_") and not first.name):
        return [first] if first else []
    possible = [first] if first.typed or first.user.startswith("anon_") else []
    ids = re.compile(rf"(?<!_LATE)(?=(?:^|_)(LATE_)?({ID})_({ID})_(.+))", re.DOTALL)
    for match in ids.finditer(entry):
        late, user, attachment, file = match.groups()
        name = entry[: match.start()]
        possible.append(Upload(entry, name, user, file, bool(late), int(attachment), False))
    return possible


def page_of(uploads: Sequence[Upload]) -> str:
    """The name for a feedback page, which Canvas accepts as a comment if it has the ids of an
    upload: the newest. It can't import a page about what was typed."""
    newest = max(uploads, key=lambda upload: upload.number)
    if newest.typed:
        return f"{fitting(newest.entry.removesuffix('.html'))}_feedback.html"
    ids = newest.entry[len(newest.name) : -len(newest.file)]
    return f"{printable_name(fitting(newest.name, 150))}{ids}feedback.html"


def sanitized(sortable_name: str) -> str:
    """What Canvas makes of "Doe, Jane": doejane."""
    flat = re.sub(r"_(\d+)_", r"\1", sortable_name).lower()
    return "".join(filter(_in_a_word, flat))


def is_name_of(person: str, canvas_name: str) -> bool:
    """Letter for letter, in whichever order and however an accent is written."""
    names = (sanitized(person), canvas_name)
    one, other = (sorted(unicodedata.normalize("NFC", name)) for name in names)
    return one == other


def _in_a_word(c: str) -> bool:
    """Whether Ruby's [[:word:]] matches it, which includes combining marks."""
    return unicodedata.category(c)[0] in "LM" or unicodedata.category(c) in ("Nd", "Pc")
