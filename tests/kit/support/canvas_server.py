"""A small server that speaks as much of Canvas's documented API as ./kit class uses: lists in
pages, uploads in three steps, limits of the rate, and failures on request."""

import json
import re
import threading
import urllib.parse
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

TOKEN = "7~secretsecretsecret"
PAGE = 3  # entries
HTML = b"<!doctype html>"


@dataclass
class State:
    submissions: dict[int, dict[str, Any]] = field(default_factory=dict)
    files: dict[int, bytes] = field(default_factory=dict)
    names: dict[int, str] = field(default_factory=dict)  # of uploaded files
    comments: dict[int, list[int]] = field(default_factory=dict)  # a file in each
    assignment: dict[str, Any] = field(default_factory=dict)  # its settings
    late_policy: bool = False
    rights: int = 200  # or the answer to somebody without rights
    limited: int = 0  # requests that are answered by a limit of the rate
    shown_times: int = -1  # until the list of submissions is gone
    broken_after: int = -1  # posts of points until the server fails for good
    refused: Sequence[int] = ()  # users
    lost: Sequence[
        int
    ] = ()  # users whose points and pages are taken, without an answer that says so
    dead: bool = False  # after that
    gone: Sequence[int] = ()  # files
    elsewhere: dict[str, str] = field(default_factory=dict)  # where a file's address leads
    tokens_elsewhere: list[str] = field(default_factory=list)

    def add(self, user: int, name: str, files: dict[str, str | int], **more: Any) -> None:
        attachments = []
        for number, (file, text) in enumerate(files.items()):
            id = user * 10 + number
            self.files[id] = text.encode() if isinstance(text, str) else bytes(text)
            attachments.append({"id": id, "display_name": file, "url": f"@/files/{id}/download"})
        self.submissions[user] = {
            "user_id": user,
            "attachments": attachments,
            "user": {"id": user, "sortable_name": name},
            "score": None,
            "late": False,
            "seconds_late": 0,
            **more,
        }

    def change(self, changes: dict[str, Any]) -> None:
        """What is added, becomes other or goes wrong from now on."""
        for one in changes.get("add", []):
            self.add(**one)
        for user, values in changes.get("set", {}).items():
            self.submissions[int(user)].pop("entered_score", None)
            self.submissions[int(user)] |= {name: value or None for name, value in values.items()}
        for user, values in changes.get("attachment", {}).items():
            self.submissions[int(user)]["attachments"][0] |= values  # "" is none
        for name in vars(self).keys() & changes.keys():
            setattr(self, name, changes[name])

    def listed(self, user: int) -> dict[str, Any]:
        """A submission as the API tells of it."""
        names = [self.names[id] for id in self.comments.get(user, [])]
        comments = [{"attachments": [{"display_name": name}]} for name in names]
        also = {"submission_comments": comments, "assignment": self.assignment}
        return {"entered_score": self.submissions[user]["score"], **self.submissions[user], **also}

    def enter(self, user: int, points: float) -> None:
        """Enters points, for all of a group if they get one grade; less what lateness costs."""
        one = self.submissions[user]
        all_get = not self.assignment.get("grade_group_students_individually", True)
        for other in self.submissions.values():
            if other is one or all_get and other.get("group") == one.get("group"):
                other["entered_score"] = points
                other["score"] = points - other.get("points_deducted", 0)

    def shown(self) -> str:
        """The points and the number of pages that everybody has, and where the token went."""
        return "".join(
            f"{user} {one['user']['sortable_name']}: {one['score']} points, "
            f"{sum(self.files[id].startswith(HTML) for id in self.comments.get(user, []))} pages\n"
            for user, one in self.submissions.items()
        ) + "".join(f"elsewhere: {token}\n" for token in self.tokens_elsewhere)


class Handler(BaseHTTPRequestHandler):
    state: State

    def log_message(self, *_: Any) -> None:
        pass

    def _answer(self, code: int, body: Any = None, **headers: str) -> None:
        data = body if isinstance(body, bytes) else json.dumps(body).encode()
        self.send_response(code)
        for name, value in headers.items():
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def _request(self) -> None:
        data = self.rfile.read(int(self.headers.get("Content-Length") or 0))
        token = self.headers.get("Authorization")
        self.here = f"http://{self.headers['Host']}"
        host = self.headers["Host"].replace("127.0.0.1", "localhost")
        self.elsewhere = f"{self.here}@{host}"  # where no token must go, though it begins as ours
        if self.path.startswith(("/stored/", "/upload")):
            self.state.tokens_elsewhere += filter(None, [token])
            self._stored(data)
        elif self.state.limited:
            self.state.limited -= 1
            code = 403 if self.state.limited % 2 else 429
            self._answer(code, b"403 Forbidden (Rate Limit Exceeded)")
        elif token != f"Bearer {TOKEN}":
            bearer = {"WWW-Authenticate": 'Bearer realm="canvas-lms"'}
            self._answer(401, {"errors": [{"message": "Invalid access token."}]}, **bearer)
        elif self.state.rights != 200:
            self._answer(self.state.rights, {"status": "unauthorized"})
        elif self.command == "GET":
            self._get()
        elif self.command == "POST":
            assert self.path.endswith("/comments/files") and b"content_type=text%2Fhtml" in data
            upload = {"upload_url": f"{self.elsewhere}/upload", "upload_params": {"key": "x"}}
            self._answer(200, upload)
        else:
            self._put(urllib.parse.parse_qs(data.decode()))

    do_GET = do_POST = do_PUT = _request

    def _stored(self, data: bytes) -> None:
        """As a server of files answers."""
        files = self.state.files
        if self.command == "GET":
            self._answer(200, files[int(self.path.split("/")[2])])
            return
        assert b'name="key"' in data
        id = 900_000 + len(files)
        head, _, body = data.partition(b'filename="')[2].partition(b"\r\n\r\n")
        self.state.names[id] = head.partition(b'"')[0].decode().replace(".html", "-1.html")
        files[id] = body.rpartition(b"\r\n--")[0]
        canvas = self.here.replace("localhost", "127.0.0.1")
        made = f"{canvas}/api/v1/files/{id}/create_success"
        if id % 2:
            self._answer(303, b"", Location=made)
        else:
            self._answer(201, {"id": id})

    def _get(self) -> None:
        url, state = urllib.parse.urlsplit(self.path), self.state
        file = re.fullmatch(r"/files/(\d+)/download", url.path)
        if file and int(file[1]) not in state.gone:
            stored = f"{self.elsewhere}/stored/{file[1]}"
            self._answer(302, b"", Location=state.elsewhere.get(file[1], stored))
        elif url.path == "/api/v1/courses/7/assignments/9/submissions" and state.shown_times:
            state.shown_times -= 1
            first = int(urllib.parse.parse_qs(url.query).get("page", ["0"])[0])
            some = list(state.submissions)[first : first + PAGE]
            text = (
                json.dumps(list(map(state.listed, some)))
                .replace("@/files", f"{self.here}/files")
                .encode()
            )
            more = first + PAGE < len(state.submissions)
            link = f'<{self.here}{url.path}?page={first + PAGE}>; rel="next"' if more else ""
            self._answer(200, text, Link=f'<{self.here}{url.path}>; rel="current",{link}')
        elif made := re.fullmatch(r"/api/v1/files/(\d+)/create_success", url.path):
            self._answer(200, {"id": int(made[1])})
        elif url.path == "/api/v1/courses/7/late_policy" and state.late_policy:
            self._answer(200, {"late_policy": {"late_submission_deduction_enabled": True}})
        elif url.path.startswith("/api/v1/courses/7/assignments/9/submissions/"):
            user = int(url.path.rpartition("/")[2])
            self._answer(500 if state.dead and user in state.lost else 200, state.listed(user))
        else:
            self._answer(404, {"errors": [{"message": "not found"}]})

    def _put(self, fields: dict[str, list[str]]) -> None:
        user, state = int(self.path.rpartition("/")[2]), self.state
        if user in state.refused:
            self._answer(400, {"errors": [{"message": "bad"}]})
            return
        if state.broken_after == 0:
            self._answer(500, b"broken")
            return
        state.broken_after -= 1
        if "submission[posted_grade]" in fields:
            state.enter(user, float(fields["submission[posted_grade]"][0]))
        for id in fields.get("comment[file_ids][]", []):
            state.comments.setdefault(user, []).append(int(id))
        self._answer(500 if user in state.lost else 200, {"id": user})


@contextmanager
def running() -> Iterator[tuple[str, State]]:
    state = State()
    handler = type("Bound", (Handler,), {"state": state})
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}", state
    finally:
        server.shutdown()
        server.server_close()
