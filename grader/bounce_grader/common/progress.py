"""Says how far a command is that takes longer than two seconds."""

import sys
import time
from threading import Lock
from typing import TypeVar

X = TypeVar("X")


class Progress:
    """Counts steps, side by side too. Says every few seconds, on standard error, how many of all
    are done, the rate and the time left; on a terminal in a line that changes."""

    def __init__(self, total: int, what: str = "done") -> None:
        self._total, self._what, self._done = total, what, 0
        self._start = self._last = time.monotonic()
        self._lock, self._is_terminal = Lock(), sys.stderr.isatty()

    def after(self, made: X) -> X:
        """Counts the step that made this, and returns it."""
        with self._lock:
            self._done += 1
            now, left = time.monotonic(), self._total - self._done
            if not left or now - self._last > (2.0 if self._is_terminal else 15.0):
                self._last, rate = now, self._done / max(now - self._start, 1e-9)
                ahead = f", {left / rate:.0f} s left" if left else ""
                words = f"{self._done} of {self._total} {self._what}, {60 * rate:.0f} a minute"
                end = "   \r" if left and self._is_terminal else "\n"
                print(f"kit: {words}{ahead}", file=sys.stderr, flush=True, end=end)
        return made
