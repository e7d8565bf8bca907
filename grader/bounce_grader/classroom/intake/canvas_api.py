"""Canvas's API: downloads the submissions of an assignment, with the token of the environment.

Where requests come too quickly, Canvas answers 403 or 429, and they are tried again after a while.
The token goes to Canvas's own address alone, and into no message.
"""

import json
import math
import os
import re
import time
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import requests
from urllib3.exceptions import HTTPError
from bounce_grader.classroom.intake.archive import opened
from bounce_grader.classroom.intake.canvas import page_of, sanitized
from bounce_grader.classroom.intake.student import Class, Unmatched, Upload
from bounce_grader.classroom.intake.uploads import may_count, MOST_UPLOADS, take, without_files
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting, write_whole

TRIES = 6
WAIT = 1.0  # s before the second try; doubled each time
REDIRECTIONS = 5  # of one request
SECONDS = 60.0  # of one request
LARGEST = 64 << 20  # bytes of one answer, and of all files of a student
FILES = "canvas"  # the folder in OUT with what was downloaded
TYPED = {"online_text_entry": "text", "online_url": "an address"}


class Refused(Exception):
    """Canvas's answer to one request, which says nothing about the others."""


def token_of_environment() -> str:
    """The token, which ./kit hands on by a descriptor, so that it isn't in the environment of a
    process that starts a submission's. Raises UsageError if there is none."""
    handed = os.environ.pop("CANVAS_TOKEN_FD", "")
    token = os.environ.pop("CANVAS_TOKEN", "")
    if handed.isdigit():
        with os.fdopen(int(handed)) as stream:
            token = stream.read()
    if not token.strip():
        raise UsageError(
            "--canvas needs CANVAS_TOKEN in the environment: in Canvas, Account, Settings, New "
            "Access Token"
        )
    return token.strip()


class Canvas:
    """One assignment of a course on Canvas, by its API."""

    def __init__(self, url: str, assignment: str, token: str) -> None:
        match = re.fullmatch(r"(\d+)/(\d+)", assignment)
        if not match:
            raise UsageError(f"--canvas takes COURSE/ASSIGNMENT, two numbers, not {assignment!r}")
        parsed = urlsplit(url)
        local = parsed.hostname in ("localhost", "127.0.0.1")
        if not parsed.hostname or parsed.scheme != "https" and not local:
            raise UsageError(
                "--canvas needs CANVAS_URL in the environment, as https://canvas.example.edu"
            )
        self.assignment = assignment
        self._origin = f"{parsed.scheme}://{parsed.netloc}"
        self.path = f"/api/v1/courses/{match[1]}/assignments/{match[2]}"
        self._token = token

    def all(self, path: str) -> Iterator[dict[str, Any]]:
        """Every entry of a list, page by page."""
        url: str | None = self._origin + path
        while url:
            body, url = self.request("GET", url)
            yield from _json(body)

    def call(self, method: str, path: str, fields: Mapping[str, str] = {}) -> Any:
        return _json(self.request(method, self._origin + path, data=fields)[0])

    def request(self, method: str, url: str, **content: Any) -> tuple[bytes, str | None]:
        """The body of an answer, and the address of the list's next page. Raises UsageError if the
        token isn't accepted, Refused if this request isn't, KitError if Canvas can't be reached."""
        for attempt in range(TRIES):
            if attempt:
                time.sleep(WAIT * 2 ** (attempt - 1))
            try:
                with self._session(url) as session:
                    answer = session.request(method, url, stream=True, timeout=SECONDS, **content)
                    body = answer.raw.read(LARGEST + 1, decode_content=True)
            except requests.TooManyRedirects:
                raise Refused("it is redirected again and again") from None
            except ValueError:  # a kind of address that isn't the web's
                raise Refused("it leads to no address of the web") from None
            except (requests.RequestException, HTTPError):
                continue
            if answer.ok:
                return body, answer.links.get("next", {}).get("url")
            _require_retryable(answer, body)
        raise KitError(
            f"Canvas doesn't answer at {self._origin}; what is done is kept, so give the same "
            "command again later"
        )

    def _session(self, url: str) -> Any:
        """A session with the token if it goes to Canvas's own address; a redirection elsewhere loses
        it. Without a way to sign, the library would take a password from ~/.netrc."""

        def sign(request: Any) -> Any:
            if f"{own.scheme}://{own.netloc}" == self._origin:
                request.headers["Authorization"] = f"Bearer {self._token}"
            return request

        own = urlsplit(url)
        session = requests.Session()
        session.max_redirects = REDIRECTIONS
        session.auth = sign
        return session


def _require_retryable(answer: Any, body: bytes) -> None:
    """Returns if the request should be tried again, because Canvas asks to wait or has an error of
    its own. Else raises UsageError or Refused."""
    code = answer.status_code
    limited = code == 429 or code == 403 and b"Rate Limit" in body
    if code == 401:
        raise UsageError(
            "Canvas doesn't accept the token: make a new one, and put it into CANVAS_TOKEN"
        )
    if not limited and code < 500:
        raise Refused(f"{code} {printable_name(answer.reason or '')}")


def _json(body: bytes) -> Any:
    try:
        return json.loads(body)
    except ValueError as error:
        raise KitError(
            "Canvas answered with something else than JSON: is CANVAS_URL right?"
        ) from error


def download(canvas: Canvas, out: Path) -> Class:
    """The class, with its files in OUT/canvas. A file that is there isn't downloaded again."""
    folder = out / FILES
    out.mkdir(mode=0o700, parents=True, exist_ok=True)
    folder.mkdir(exist_ok=True)
    try:
        listed = list(canvas.all(f"{canvas.path}/submissions?include[]=user&per_page=100"))
    except Refused as refused:
        raise UsageError(
            f"Canvas has no assignment {canvas.assignment} for you ({refused})"
        ) from None
    intake = Class("Canvas's API", service="canvas", tells_lateness=True)
    missing = []
    names: dict[str, str] = {}
    late: dict[str, int] = {}
    for submission in listed:
        user = str(submission.get("user_id", ""))
        names[user] = printable_name(str(_person(submission).get("sortable_name") or ""))
        shown = names[user] or user
        try:
            uploads = _downloaded(canvas, folder, user, submission)
        except Refused as refused:
            missing.append(Unmatched(shown, f"isn't graded: {refused}", user))
            continue
        kind = str(submission.get("submission_type") or "")
        if uploads:
            take(intake, opened(folder), uploads, page_of(uploads))
        elif kind or submission.get("submitted_at"):
            what = f"is {TYPED[kind]} typed into Canvas" if kind in TYPED else "has no file"
            missing.append(without_files(shown, what, user, f"{user}_feedback.html"))
        if submission.get("late"):
            late[user] = max(1, math.ceil(float(submission.get("seconds_late") or 0) / 86400))
    named = [replace(u, name=names.get(u.user) or u.name) for u in intake.unmatched]
    intake.unmatched = [*named, *missing]
    intake.students = [
        replace(s, person=names.get(s.id, ""), late_days=late.get(s.id, 0)) for s in intake.students
    ]
    if not intake.students:
        why = f"; {missing[0].name} {missing[0].reason}" if missing else ""
        raise UsageError(
            f"nobody has submitted a file to the assignment {canvas.assignment} yet{why}"
        )
    return intake


def _person(submission: dict[str, Any]) -> dict[str, Any]:
    return submission.get("user") or {}


def _downloaded(
    canvas: Canvas, folder: Path, user: str, submission: dict[str, Any]
) -> list[Upload]:
    """A student's uploads. Raises Refused if one can't be downloaded: without it, a grading would
    take points for what was handed in."""
    attachments = submission.get("attachments") or []
    uploads = [_upload(user, submission, attachment) for attachment in attachments]
    room = LARGEST
    for upload, attachment in zip(uploads, attachments):
        path = folder / upload.entry
        if len(attachments) > MOST_UPLOADS or not may_count(upload.file):
            continue  # named, and never read
        if not path.exists():
            _fetch(canvas, str(attachment.get("url") or ""), path)
        room -= path.stat().st_size
        if room < 0:
            raise Refused(f"all that is handed in may have {LARGEST >> 20} MB")
    return uploads


def _upload(user: str, submission: dict[str, Any], attachment: dict[str, Any]) -> Upload:
    """An attachment, with the name that it has in Canvas's download."""
    try:
        id = int(attachment["id"])
    except (KeyError, TypeError, ValueError):
        raise Refused("Canvas names a file without an id; look at it there") from None
    sortable_name = str(_person(submission).get("sortable_name") or user)
    name = fitting(sanitized(sortable_name), 80) or user
    late = bool(submission.get("late"))
    file = printable_name(str(attachment.get("display_name") or attachment.get("filename") or id))
    stem, dot, ending = file.replace("/", "_").rpartition(".")
    file = f"{fitting(stem, 80)}{dot}{fitting(ending, 20)}"
    entry = f"{name}{'_LATE' if late else ''}_{user}_{id}_{file}"
    return Upload(entry, name, user, file, late, id, as_named=False)


def _fetch(canvas: Canvas, url: str, path: Path) -> None:
    if not url:
        raise Refused(f"Canvas names no address for {path.name}; look at it there")
    try:
        data, _ = canvas.request("GET", url)
    except Refused as refused:
        raise Refused(
            f"Canvas doesn't hand out {path.name} ({refused}); look at it there"
        ) from None
    if len(data) > LARGEST:
        raise Refused(f"{path.name} is too large: it may have {LARGEST >> 20} MB")
    write_whole(path, data)
