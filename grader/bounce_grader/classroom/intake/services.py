"""How Canvas, Moodle, Blackboard and Brightspace name the entries of a download of all submissions,
packed or unpacked, and the feedback pages that they take back.

Canvas, in lib/content_zipper.rb:

    {name}[_LATE]_{user id}_{attachment id}_{file}
    [LATE_]anon_{anonymous id}_{attachment id}_{file}
    {name}[_LATE]_{user id}_text.html, or _link.html: a text entry, or a web address

A name is in lower case and holds only letters, digits and "_", so LATE is never part of it. A name
may end in "_12", as a group's does, and a file name may begin with "12_"; such an entry is
ambiguous (`read_canvas`).

Moodle, in mod/assign:

    {full name}_{participant}_assignsubmission_file/{path}      since 4.1
    {full name}_{participant}_assignsubmission_file_/{path}     since 3.1
    {full name}_{participant}_assignsubmission_file_{file}      without folders
    {full name}_{participant}_assignsubmission_onlinetext...    a text typed into Moodle

A full name holds no "_", because Moodle writes blanks in their place; a group's comes before it,
with a hyphen.

Blackboard:

    {assignment}_{user}_attempt_{2026-11-20-23-15-42}_{file}
    {assignment}_{user}_attempt_{2026-11-20-23-15-42}.txt     who submitted, and what else is typed

Both the assignment's title and a user's name may hold "_". The text begins with a line that
Blackboard writes, "Name: Jane Doe (jdoe)".

Brightspace:

    {two numbers} - {full name} - {Sep 24, 2026 926 PM}/{file}      a folder for each attempt
    index.html                                                      who submitted what, and when

The numbers, such as 152711-351765, are in no grade book.
"""

import re
import unicodedata
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from bounce_grader.classroom.intake.student import Names, Upload
from bounce_grader.classroom.intake.uploads import Archive
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting

Read = dict[str, Upload | str]  # by entry; or why it is of nobody
TYPED = dict.fromkeys(("text", "onlinetext", ".txt", "online_text_entry"), "text was typed")
TYPED |= dict.fromkeys(("link", "online_url"), "an address was typed")
UNKNOWN = "isn't named as {} names submissions"
ID = "[0-9]{1,20}"
WHO = (  # in Canvas's names
    r"(?:(?!LATE_|anon_)(?P<name>[^/]+?)_)?(?:(?P<late>LATE)_)?"
    rf"(?P<user>anon_[A-Za-z0-9]{{1,20}}|{ID})"
)
MONTHS = "Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec"
ALONE = "look in Canvas who handed it in, and grade it by itself with ./kit grade"
EITHER = f"has a name that doesn't say for certain whose it is: {ALONE}"
WHOSE = re.compile(r"\ufeff?Name:\s*(?P<name>.*)\((?P<user>[^()\s]+)\)\s*$")  # in Blackboard's text


class Service(NamedTuple):
    """A service, and how it names things."""

    title: str
    entries: Sequence[str]  # patterns of an entry's name; the first that fits counts
    read: Callable[[Archive, Names], Read]  # a download
    page_of: Callable[[Sequence[Upload]], str]  # the name for a feedback page
    as_named: bool = True  # files keep the names that students gave them

    def parse(self, entry: str) -> Upload | None:
        """What an entry's name says; None if the service doesn't write such names. Blackboard's
        `user` still has the assignment's title before it."""
        matches = (re.fullmatch(pattern, entry, re.DOTALL) for pattern in self.entries)
        match = next(filter(None, matches), None)
        if not match:
            return None
        of: Mapping[str, str] = defaultdict(str, match.groupdict(""))
        number, instead = int(of["number"].replace("-", "") or 0), TYPED.get(of["kind"], "")
        number = number or _when(of["date"])
        who = (entry, of["name"], of["user"], of["file"], bool(of["late"]))
        return Upload(*who, number, self.as_named, instead)


def read_canvas(entries: Iterable[str], people: Names) -> Read:
    """Reads the names of all entries of Canvas's download. Students choose their names and the names
    of their files, so an entry can often be split in several ways. Such an entry counts for the one
    of these `people` whose id and name it can have, unless another entry certainly has that id."""
    possible = {entry: _readings(entry) for entry in entries}
    certain = {found[0].user for found in possible.values() if len(found) == 1}
    read: Read = {}
    for entry, found in possible.items():
        known = [reading for reading in found if reading.user in people]
        named = [r for r in known if any(is_name_of(name, r.name) for name in people[r.user])]
        if len(found) == 1:
            read[entry] = found[0]
        elif known == named and len(named) == 1 and named[0].user not in certain:
            read[entry] = named[0]
        elif "/" in entry:
            read[entry] = "is in a folder; Canvas's download has none"
        else:
            read[entry] = EITHER if found else UNKNOWN.format("Canvas")
    return read


def _readings(entry: str) -> list[Upload]:
    """All ways to split an entry's name into its fields."""
    first = CANVAS.parse(entry)
    if first is None or (first.user.startswith("anon_") and not first.name):
        return [first] if first else []
    possible = [first] if first.instead or first.user.startswith("anon_") else []
    ids = re.compile(rf"(?<!_LATE)(?=(?:^|_)(LATE_)?({ID})_({ID})_(.+))", re.DOTALL)
    for match in ids.finditer(entry):
        late, user, attachment, file = match.groups()
        name = entry[: match.start()]
        possible.append(Upload(entry, name, user, file, bool(late), int(attachment), False))
    return possible


def canvas_page(uploads: Sequence[Upload]) -> str:
    """Canvas accepts a page as a comment if its name has the newest upload's ids; of typed text,
    none."""
    newest = max(uploads, key=lambda upload: upload.number)
    if newest.instead:
        return f"{fitting(newest.entry.removesuffix('.html'))}_feedback.html"
    ids = newest.entry[len(newest.name) : -len(newest.file)]
    return f"{printable_name(fitting(newest.name, 150))}{ids}feedback.html"


def sanitized(sortable_name: str) -> str:
    """What Canvas makes of "Doe, Jane": doejane. Only what Ruby's [[:word:]] matches stays."""
    flat = re.sub(r"_(\d+)_", r"\1", sortable_name).lower()
    kinds = ((c, unicodedata.category(c)) for c in flat)
    return "".join(c for c, kind in kinds if kind[0] in "LM" or kind in ("Nd", "Pc"))


def is_name_of(person: str, canvas_name: str) -> bool:
    """Letter for letter, in whichever order and however an accent is written."""
    names = (sanitized(person), canvas_name)
    one, other = (sorted(unicodedata.normalize("NFC", name)) for name in names)
    return one == other


def _moodle_page(uploads: Sequence[Upload]) -> str:
    """Moodle's importer of feedback files takes this, whichever its version: it splits at "_"."""
    name = printable_name(fitting(uploads[0].name, 150))
    return f"{name}_{uploads[0].user}_assignfeedback_file_feedback.html"


def _read_blackboard(archive: Archive, _people: Names) -> Read:
    """The files of each user's attempts, and the text of the newest if that has none."""
    heads, read = _by_user(BLACKBOARD, archive)
    whose = {head: _person(archive, head, of) for head, of in heads.items()}
    times = Counter(user for user, _ in whose.values())
    for head, uploads in heads.items():
        user, name = whose[head]
        last = max(upload.number for upload in uploads)
        files = [upload for upload in uploads if upload.file]
        if all(upload.number < last for upload in files):
            files += [upload for upload in uploads if upload.number == last]
        if not user:
            read[head] = "has no text that says whose it is"
        elif times[user] > 1:
            read[head] = f"isn't the only one that could be {user}'s: keep one of them"
        else:
            read |= _attempts(files, user, name)
    return read


def _by_user(service: Service, archive: Archive) -> tuple[dict[str, list[Upload]], Read]:
    """The uploads of each user; and the entries that aren't named as the service names them."""
    uploads: dict[str, list[Upload]] = defaultdict(list)
    unknown: Read = {}
    for entry in archive.names:
        if upload := service.parse(entry):
            uploads[upload.user].append(upload)
        else:
            unknown[entry] = UNKNOWN.format(service.title)
    return uploads, unknown


def _attempts(uploads: Sequence[Upload], user: str, name: str) -> Read:
    """What somebody has uploaded in each attempt."""
    return {u.entry: u._replace(name=name, user=user, attempt=u.number) for u in uploads}


def _person(archive: Archive, head: str, uploads: Sequence[Upload]) -> tuple[str, str]:
    """The user and the name, by the first line of a text that is about this entry."""
    user = name = ""
    for upload in filter(lambda upload: upload.instead, uploads):
        text = archive.read(upload.entry, 4096).decode("utf-8", "replace")
        match = WHOSE.fullmatch(text.partition("\n")[0].strip())
        if match and head.endswith(f"_{match['user']}"):
            user, name = match["user"], match["name"].strip() or match["user"]
    return user, name


def _read_brightspace(archive: Archive, people: Names) -> Read:
    """The files of each student. Who has the same name as exactly one of these `people`, and as nobody
    else here, is that person; anybody else has the numbers as an id."""
    attempts, read = _by_user(BRIGHTSPACE, archive)
    read.pop("index.html", None)
    named, whose = Counter(of[0].name.casefold() for of in attempts.values()), defaultdict(list)
    for id, names in people.items():
        family, _, given = names[0].partition(", ")
        whose[f"{given} {family}".strip().casefold()].append(id)
    for numbers, uploads in attempts.items():
        name, last = uploads[0].name, max(upload.number for upload in uploads)
        if not last and any(_folder([upload]) != _folder(uploads) for upload in uploads):
            why = "has several attempts, and their dates can't be read: keep the last one"
            read[f"{numbers} - {name}"] = why
        else:
            own = whose[name.casefold()]
            (user,) = own if len(own) == named[name.casefold()] == 1 else [numbers]
            read |= _attempts(uploads, user, name)
    return read


def _folder(uploads: Sequence[Upload]) -> str:
    """Of the newest attempt, in Brightspace's download."""
    return max(uploads, key=lambda upload: upload.number).entry.partition("/")[0]


def _when(date: str) -> int:
    """Brightspace's date, such as Sep 24, 2026 926 PM, as a number that grows; 0 for any other."""
    match = re.fullmatch(rf"({MONTHS})[a-z]* (\d+), (\d{{4}}) (\d+) ([AP])M", date)
    if not match:
        return 0
    month, day, year, time, half = match.groups()
    minutes = int(time) % 1200 + 1200 * (half == "P")
    return int(f"{year}{MONTHS.find(month):02}{int(day):02}{minutes:04}")


CANVAS = Service(
    "Canvas",
    (rf"{WHO}_(?P<kind>text|link)\.html", rf"{WHO}_(?P<number>{ID})_(?P<file>[^/]+)"),
    lambda archive, people: read_canvas(archive.names, people),
    canvas_page,
    as_named=False,
)
MOODLE: Service = Service(
    "Moodle",
    [
        rf"(?P<name>[^_/]+)_(?P<user>{ID})_assignsubmission_(?P<kind>file|onlinetext)"
        r"(?:_?/|_)(?P<file>.+)"
    ],
    lambda archive, _: {e: MOODLE.parse(e) or UNKNOWN.format("Moodle") for e in archive.names},
    _moodle_page,
)
BLACKBOARD = Service(
    "Blackboard",
    [  # up to the first time: a file's own name may hold another student's
        r"(?P<user>[^/]+?)_attempt_(?P<number>\d{4}(?:-\d\d){5})"
        r"(?:_(?P<file>[^/]+)|(?P<kind>\.txt))"
    ],
    _read_blackboard,
    # Not by the student's name, which may hold a "/".
    lambda uploads: f"{fitting(printable_name(uploads[0].user))}.html",
)
BRIGHTSPACE = Service(
    "Brightspace",
    [r"(?P<user>\d+-\d+) - (?P<name>[^/]+) - (?P<date>[^/]*\d{4}[^/]*)/(?P<file>.+)"],
    _read_brightspace,
    lambda uploads: f"{fitting(printable_name(_folder(uploads)))}.html",
)
# Blackboard comes last: the others write the beginning of each name themselves.
SERVICES = (MOODLE, CANVAS, BRIGHTSPACE, BLACKBOARD)
