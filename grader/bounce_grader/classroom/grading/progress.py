"""Shows progress: how many are graded, the rate and the time left."""

import sys
import time


class Progress:
    """Counts the submissions that are done. A terminal shows one line, which is written over."""

    def __init__(self, total: int) -> None:
        self._total, self._done = total, 0
        self._start = self._last = time.monotonic()
        self._is_terminal = sys.stderr.isatty()

    def advance(self) -> None:
        self._done += 1
        now, is_last = time.monotonic(), self._done == self._total
        if is_last or now - self._last >= (0.5 if self._is_terminal else 15.0):
            self._last = now
            start, end = ("\r\33[K", "\n" if is_last else "") if self._is_terminal else ("", "\n")
            sentence = self._sentence(now - self._start)
            print(f"{start}kit: {sentence}", end=end, file=sys.stderr, flush=True)

    def _sentence(self, seconds: float) -> str:
        rate = self._done / max(seconds, 1e-9)
        left = (self._total - self._done) / rate
        ahead = f", {left:.0f} s left" if self._done < self._total else ""
        return f"{self._done} of {self._total} graded, {60 * rate:.0f} a minute{ahead}"
