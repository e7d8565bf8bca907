"""Writes log.jsonl: what was graded, when and from what, and which grade books were made up. Lines
are only ever appended."""

import hashlib
import json
import os
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

from bounce_grader.classroom.grading.results import Task


class Log:
    """OUT/log.jsonl: what happened to each submission, one event a line."""

    def __init__(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self._path = path
        lines = read(path)
        self._known = {line["result"] for line in lines if line["event"] == "graded"}
        self._made_up = {line["sha256"] for line in lines if line["event"] == "gradebook"}
        self._file = os.open(path, os.O_CREAT | os.O_APPEND | os.O_RDWR, 0o644)
        self._end_a_torn_line()

    def write(self, event: str, task: Task | None = None, **more: Any) -> None:
        fields: dict[str, Any] = {"at": datetime.now(timezone.utc).isoformat(timespec="seconds")}
        fields["event"] = event
        if task:
            fields |= {"result": task.key, "submission": task.submission, "kit": task.stamp.kit}
            fields |= {"fixtures": task.stamp.fixtures, "options": task.stamp.options}
        line = json.dumps({**fields, **more}, ensure_ascii=False) + "\n"
        os.write(self._file, line.encode(errors="backslashreplace"))  # surrogates, as in JSON

    def graded(self, task: Task, state: str, seconds: float | None) -> None:
        """Logs each grading once. If a run was killed before it logged one, the next run does,
        without the seconds."""
        if seconds is not None or task.key not in self._known:
            self._known.add(task.key)
            self.write("graded", task, state=state, seconds=seconds)

    def make_up(self, gradebook: bytes) -> None:
        """Logs a made-up grade book. Called before it is written, in case the run ends in
        between."""
        if not self.has_made_up(gradebook):
            self._made_up.add(_digest(gradebook))
            self.write("gradebook", sha256=_digest(gradebook))

    def has_made_up(self, gradebook: bytes) -> bool:
        return _digest(gradebook) in self._made_up

    def close(self) -> None:
        os.fsync(self._file)
        os.close(self._file)

    def _end_a_torn_line(self) -> None:
        """Ends the last line, if a full disk cut it off."""
        size = os.fstat(self._file).st_size
        if size and os.pread(self._file, 1, size - 1) != b"\n":
            os.write(self._file, b"\n")


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def read(path: Path) -> list[dict[str, Any]]:
    """The complete lines, parsed."""
    lines = []
    for line in path.read_bytes().splitlines() if path.exists() else []:
        try:
            lines.append(json.loads(line))
        except ValueError:
            continue
    return lines
