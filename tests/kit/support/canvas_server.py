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
OTHER = {"limited", "broken_after", "refused", "gone", "elsewhere"}


@dataclass
class State:
    submissions: dict[int, dict[str, Any]] = field(default_factory=dict)
    files: dict[int, bytes] = field(default_factory=dict)
    comments: dict[int, list[bytes]] = field(default_factory=dict)
    limited: int = 0  # requests that are answered by a limit of the rate
    broken_after: int = -1  # posts of points until the server fails for good
    refused: Sequence[int] = ()  # users
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
            self.submissions[int(user)] |= {name: value or None for name, value in values.items()}
        for user, values in changes.get("attachment", {}).items():
            self.submissions[int(user)]["attachments"][0] |= values  # "" is none
        for name in OTHER & changes.keys():
            setattr(self, name, changes[name])

    def shown(self) -> str:
        """The points and the number of pages that everybody has, and where the token went."""
        return "".join(
            f"{user} {one['user']['sortable_name']}: {one['score']} points, "
            f"{sum(page.startswith(HTML) for page in self.comments.get(user, []))} pages\n"
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

    def _is_refused(self) -> bool:
        if self.state.limited:
            self.state.limited -= 1
            code = 403 if self.state.limited % 2 else 429
            self._answer(code, b"403 Forbidden (Rate Limit Exceeded)")
            return True
        if self.headers.get("Authorization") != f"Bearer {TOKEN}":
            self._answer(401, {"errors": [{"message": "Invalid access token."}]})
            return True
        return False

    @property
    def _origin(self) -> str:
        return f"http://{self.headers['Host']}"

    @property
    def _elsewhere(self) -> str:
        """Another server, to which the token must not go."""
        return self._origin.replace("127.0.0.1", "localhost")

    def do_GET(self) -> None:
        url = urllib.parse.urlsplit(self.path)
        if url.path.startswith("/stored/"):  # elsewhere, as on a server of files
            self.state.tokens_elsewhere += filter(None, [self.headers.get("Authorization")])
            self._answer(200, self.state.files[int(url.path.split("/")[2])])
            return
        if self._is_refused():
            return
        file = re.fullmatch(r"/files/(\d+)/download", url.path)
        if file and int(file[1]) in self.state.gone:
            self._answer(404, b"gone")
        elif file:
            stored = f"{self._elsewhere}/stored/{file[1]}"
            self._answer(302, b"", Location=self.state.elsewhere.get(file[1], stored))
        elif url.path == "/api/v1/courses/7/assignments/9/submissions":
            first = int(urllib.parse.parse_qs(url.query).get("page", ["0"])[0])
            some = list(self.state.submissions.values())[first : first + PAGE]
            text = json.dumps(some).replace("@/files", f"{self._origin}/files").encode()
            more = first + PAGE < len(self.state.submissions)
            link = f'<{self._origin}{url.path}?page={first + PAGE}>; rel="next"' if more else ""
            self._answer(200, text, Link=f'<{self._origin}{url.path}>; rel="current",{link}')
        else:
            self._answer(404, {"errors": [{"message": "not found"}]})

    def do_POST(self) -> None:
        data = self.rfile.read(int(self.headers["Content-Length"]))
        if self.path == "/upload":
            self.state.tokens_elsewhere += filter(None, [self.headers.get("Authorization")])
            assert b'name="key"' in data
            body = data.partition(b'filename="feedback.html"')[2].partition(b"\r\n\r\n")[2]
            id = 900_000 + len(self.state.files)
            self.state.files[id] = body.rpartition(b"\r\n--")[0]
            self._answer(201, {"id": id})
            return
        if self._is_refused():
            return
        assert self.path.endswith("/comments/files") and b"content_type=text%2Fhtml" in data
        url = f"{self._elsewhere}/upload"
        self._answer(200, {"upload_url": url, "upload_params": {"key": "x"}})

    def do_PUT(self) -> None:
        data = self.rfile.read(int(self.headers["Content-Length"]))
        if self._is_refused():
            return
        user = int(self.path.rpartition("/")[2])
        if user in self.state.refused:
            self._answer(400, {"errors": [{"message": "bad"}]})
            return
        if self.state.broken_after == 0:
            self._answer(500, b"broken")
            return
        self.state.broken_after -= 1
        fields = urllib.parse.parse_qs(data.decode())
        if "submission[posted_grade]" in fields:
            self.state.submissions[user]["score"] = float(fields["submission[posted_grade]"][0])
        for id in fields.get("comment[file_ids][]", []):
            self.state.comments.setdefault(user, []).append(self.state.files[int(id)])
        self._answer(200, {"id": user})


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
