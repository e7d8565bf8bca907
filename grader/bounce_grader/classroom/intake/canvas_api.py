"""Canvas's API: downloads the submissions of an assignment, with the token of the environment.

Where requests come too quickly, Canvas answers 403 or 429, and they are tried again after a while.
The token goes to Canvas's own address alone, and into no message.
"""

import json
import math
import os
import re
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import requests
from urllib3.exceptions import HTTPError
from bounce_grader.classroom.intake.services import canvas_page, sanitized, TYPED
from bounce_grader.classroom.intake.student import Class, Student, Upload
from bounce_grader.classroom.intake.uploads import may_count, MOST_UPLOADS, student_of
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting, write_whole

TRIES = 6
WAIT = 1.0  # s before the second try; doubled each time
BUSY = (403, 429, 500, 502, 503, 504)  # where Canvas asks to wait, or has an error of its own
SECONDS = 60.0  # of one request
LARGEST = 64 << 20  # bytes of one answer, and of all files of a student
ALSO = "&include[]=".join(("", "user", "group", "assignment", "submission_comments"))
FILES = "canvas"  # the folder in OUT with what was downloaded

Fields = Mapping[str, str]
IsDone = Callable[[], bool] | None
Answer = tuple[bytes, str | None]
Submission = dict[str, Any]  # one, and its person's name and files, as the API describes them


class Refused(Exception):
    """Canvas's answer to one request, which says nothing about the others."""


def _token() -> str:
    """The token. ./kit passes it by a descriptor: a submission could read it in an environment.
    Raises UsageError if there is none."""
    handed = os.environ.pop("CANVAS_TOKEN_FD", "")
    token = os.environ.pop("CANVAS_TOKEN", "")
    if handed.isdigit():
        with os.fdopen(int(handed)) as stream:
            token = stream.read()
    if not token.strip():
        where = "in Canvas, Account, Settings, New Access Token"
        raise UsageError(f"--canvas needs CANVAS_TOKEN in the environment: {where}")
    return token.strip()


class NoAnswer(KitError):
    """Canvas, or the server that keeps its files, can't be reached, or is too busy."""

    def __init__(self, url: str) -> None:
        parsed = urlsplit(url)
        self.server = f"{parsed.scheme}://{parsed.netloc.rpartition('@')[2]}"
        again = "give the same command again later, which goes on where this one stopped"
        super().__init__(f"{self.server} is too busy, or gives no answer: {again}")


class Canvas:
    """One assignment of a course on Canvas, by its API."""

    def __init__(self, assignment: str) -> None:
        """Reads the address and the token from the environment. Raises UsageError."""
        self._token = _token()
        match = re.fullmatch(r"(\d+)/(\d+)", assignment)
        if not match:
            raise UsageError(f"--canvas takes COURSE/ASSIGNMENT, two numbers, not {assignment!r}")
        parsed = urlsplit(os.environ.get("CANVAS_URL", ""))
        local = parsed.hostname in ("localhost", "127.0.0.1")
        if not parsed.hostname or parsed.scheme != "https" and not local:
            raise UsageError("--canvas needs CANVAS_URL, as https://canvas.example.edu")
        self.assignment = assignment
        self._origin = f"{parsed.scheme}://{parsed.netloc.lower()}"  # as the library has it
        self.course = f"/api/v1/courses/{match[1]}"
        self.path = f"{self.course}/assignments/{match[2]}"
        self._session = requests.Session()

    def submissions(self, more: str = "") -> Iterator[Submission]:
        """Those of all students, page by page, with `more` of each. Raises UsageError where Canvas
        doesn't show them."""
        url: str | None = f"{self._origin}{self.path}/submissions?per_page=100{ALSO}{more}"
        while url:
            try:
                body, url = self.request("GET", url)
            except Refused as refused:
                what = f"Canvas shows no assignment {self.assignment} ({refused})"
                raise UsageError(what) from None
            yield from _json(body)

    def call(self, method: str, path: str, fields: Fields = {}, is_done: IsDone = None) -> Any:
        """What the API answers. Before a request is repeated, `is_done` looks whether it was taken
        and only its answer was lost."""
        return _json(self.request(method, self._origin + path, is_done, data=fields)[0])

    def request(self, method: str, url: str, is_done: IsDone = None, **content: Any) -> Answer:
        """The body of an answer, and the address of the list's next page, or of what was made.
        Raises UsageError if the token isn't accepted, Refused if this request isn't, NoAnswer if
        there is none."""
        for attempt in range(TRIES - 1):
            try:
                return self._request(method, url, content)
            except NoAnswer as error:
                words = f"kit: {error.server} is busy or down; trying again for half a minute\n"
                sys.stderr.write(words * (not attempt))
                time.sleep(WAIT * 2**attempt)
            if is_done and is_done():
                return b"null", None
        return self._request(method, url, content)

    def _request(self, method: str, url: str, content: dict[str, Any]) -> Answer:
        wanted: dict[str, Any] = {"stream": True, "timeout": SECONDS, "auth": self._sign, **content}
        try:
            with self._session.request(method, url, **wanted) as answer:
                body = answer.raw.read(LARGEST + 1, decode_content=True)
        except requests.TooManyRedirects:
            raise Refused("it is redirected again and again") from None
        except ValueError:  # a kind of address that isn't the web's
            raise Refused("it leads to no address of the web") from None
        except (requests.RequestException, HTTPError) as error:
            asked = getattr(error, "request", None)  # the last, after redirections
            raise NoAnswer(getattr(asked, "url", url)) from None
        if answer.status_code == 401 and "WWW-Authenticate" in answer.headers:
            raise UsageError("Canvas doesn't accept CANVAS_TOKEN: make a new one there")
        if answer.status_code in BUSY and (answer.status_code != 403 or b"Rate Limit" in body):
            raise NoAnswer(answer.url)
        if not answer.ok:
            lacks = ": CANVAS_TOKEN's owner lacks the right" * (answer.status_code in (401, 403))
            raise Refused(f"{answer.status_code} {printable_name(answer.reason or '')}{lacks}")
        made = answer.headers.get("Location") if answer.status_code != 200 else None
        return body, answer.links.get("next", {}).get("url", made)

    def _sign(self, request: Any) -> Any:
        """Adds the token if a request goes to Canvas's own address; a redirection elsewhere loses
        it. Without a way to sign, the library would take a password from ~/.netrc."""
        if str(request.url).startswith(f"{self._origin}/"):
            request.headers["Authorization"] = f"Bearer {self._token}"
        return request


def _json(body: bytes) -> Any:
    try:
        return json.loads(body)
    except ValueError as error:
        raise KitError("Canvas's answer is no JSON: is CANVAS_URL right?") from error


def download(canvas: Canvas, out: Path, best: bool) -> Class:
    """The class, with its files in OUT/canvas; if the `best` attempt counts, with all attempts. A file
    that is there isn't downloaded again."""
    folder = out / FILES
    out.mkdir(mode=0o700, parents=True, exist_ok=True)
    listed = list(canvas.submissions("&include[]=submission_history" * best))
    if best:
        listed = [last | one for last in listed for one in _attempts(last)]
    students = [_student(canvas, folder, submission) for submission in listed]
    intake = Class("Canvas's API", list(filter(None, students)), service="canvas")
    if not intake.students:
        raise UsageError(f"nobody has submitted a file to the assignment {canvas.assignment} yet")
    return intake


def _attempts(submission: Submission) -> list[Submission]:
    """The oldest first."""
    every = submission.get("submission_history") or [submission]
    return sorted(every, key=lambda one: int(one.get("attempt") or 0))


def _student(canvas: Canvas, folder: Path, submission: Submission) -> Student | None:
    """None if nothing is handed in."""
    user = str(submission.get("user_id", ""))
    name = name_of(submission)
    kind = str(submission.get("submission_type") or "")
    try:
        uploads = _downloaded(canvas, folder, user, submission)
    except Refused as refused:
        return Student(user, name or user, folder, refused=str(refused))
    if not uploads and (kind or submission.get("submitted_at")):
        instead = TYPED.get(kind, "no file was handed in")
        uploads = [Upload(f"{user}.html", "", user, "", instead=instead)]
    if not uploads:
        return None
    student = student_of(folder, uploads, canvas_page(uploads))
    late = math.ceil(float(submission.get("seconds_late") or 0)) or None
    return student._replace(person=name, seconds_late=late if submission.get("late") else 0)


def name_of(submission: Submission) -> str:
    """The name of a submission's person, as "Doe, Jane"; "" if Canvas gives none."""
    return printable_name(str((submission.get("user") or {}).get("sortable_name") or ""))


def _downloaded(canvas: Canvas, folder: Path, user: str, submission: Submission) -> list[Upload]:
    """A student's uploads. Raises Refused if one can't be downloaded: its part would count as
    missing."""
    attachments = submission.get("attachments") or []
    uploads = [_upload(user, submission, attachment) for attachment in attachments]
    size = 0
    for upload, attachment in zip(uploads, attachments):
        path = folder / upload.entry
        if len(attachments) > MOST_UPLOADS or not may_count(upload.file):
            continue  # named, and never read
        if not path.exists():
            try:
                write_whole(path, canvas.request("GET", str(attachment.get("url")))[0])
            except Refused as refused:
                raise Refused(f"Canvas doesn't hand out {path.name} ({refused}): look at it there")
        size += path.stat().st_size
        if size > LARGEST:
            raise Refused(f"all that is handed in may have {LARGEST >> 20} MB")
    return uploads


def _upload(user: str, submission: Submission, attachment: dict[str, Any]) -> Upload:
    """An attachment, with the name that it has in Canvas's download."""
    try:
        id = int(attachment["id"])
    except (KeyError, TypeError, ValueError):
        raise Refused("Canvas names a file without an id: look at it there") from None
    name = fitting(sanitized(name_of(submission) or user), 80) or user
    late = bool(submission.get("late"))
    file = printable_name(str(attachment.get("display_name") or attachment.get("filename") or id))
    stem, dot, ending = file.replace("/", "_").rpartition(".")
    file = f"{fitting(stem, 80)}{dot}{fitting(ending, 20)}"
    entry = f"{name}{'_LATE' if late else ''}_{user}_{id}_{file}"
    return Upload(entry, name, user, file, late, id, as_named=False)
