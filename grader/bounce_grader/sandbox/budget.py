"""The time that one grading may take in total: reading the submission, compilers, linkers and
judges together."""

import resource
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Condition

from bounce_grader.common.errors import KitError
from bounce_grader.sandbox.processes import Limits

CPU_SECONDS = 60.0
WALL_SECONDS = 120.0


SPARE = 5  # CPU seconds that a process may get less than it asks for, rather than wait


class Shares:
    """CPU seconds that concurrent processes share: each takes as many as it may need, and gives
    them back when it has ended. `left` says how many are left."""

    def __init__(self, left: Callable[[], float]) -> None:
        self._left = left
        self._taken: list[int] = []
        self._given_back = Condition()

    @contextmanager
    def take(self, limit: int) -> Iterator[int]:
        """Waits until about `limit` seconds are free, or until no other process has any. Yields how
        many this process may use: at most `limit`, and at least 1."""
        with self._given_back:
            self._given_back.wait_for(lambda: not self._taken or self._free() >= limit - SPARE)
            taken = int(max(1, min(limit, self._free() + 1)))
            self._taken.append(taken)
        try:
            yield taken
        finally:
            with self._given_back:
                self._taken.remove(taken)
                self._given_back.notify_all()

    def _free(self) -> float:
        return self._left() - sum(self._taken)


class Overrun(Exception):
    """A grading has used up its time, and what isn't done yet gets no result. The text says why."""


class Budget:
    """A limit, counted from now on, on the wall-clock time and on the CPU time of this process and
    of all children that it has waited for."""

    def __init__(
        self,
        cpu_seconds: float = CPU_SECONDS,
        wall_seconds: float = WALL_SECONDS,
        part_of: "Budget | None" = None,
    ):
        self._part_of = part_of
        self._shares: Shares = part_of._shares if part_of else Shares(lambda: self.left()[0])
        self._limits = cpu_seconds, wall_seconds
        self._cpu_end = _cpu() + cpu_seconds
        self._wall_end = time.monotonic() + wall_seconds

    def charge(self, cpu_seconds: float) -> None:
        """Adds CPU time that the system doesn't count as our children's: that of processes which
        `processes.run` killed."""
        self._cpu_end -= cpu_seconds
        if self._part_of:
            self._part_of.charge(cpu_seconds)

    def left(self) -> tuple[float, float]:
        """The CPU seconds and wall-clock seconds that are left; negative if overdrawn."""
        return self._cpu_end - _cpu(), self._wall_end - time.monotonic()

    def require_time(self) -> None:
        """Raises Overrun if the time is used up; KitError if the machine used it up, and not the
        submission."""
        self.require_responsive_machine()
        cpu, wall = self.left()
        if cpu <= 0:
            raise Overrun(f"the grading as a whole had used its {self._limits[0]:g} s of CPU time")
        if wall <= 0:
            raise Overrun(f"the grading as a whole had taken its {self._limits[1]:g} s")

    def require_responsive_machine(self) -> None:
        """Raises KitError if the wall-clock time is used up but little of the CPU time: the machine
        was too busy, or the grading was suspended. A submission can't cause this, because each of
        its programs may sleep for a few seconds only."""
        cpu, wall = self.left()
        if wall <= 0 and cpu > self._limits[0] / 2:
            raise KitError(
                f"in {self._limits[1]:.0f} s this grading had {self._limits[0] - cpu:.0f} s of CPU "
                "time: the machine was too busy, or it was stopped; run the same command again"
            )

    @contextmanager
    def within(self, limits: Limits) -> Iterator[Limits]:
        """Yields these limits, or lower ones if less is left, for a process that runs while this
        context lasts. Raises Overrun if nothing is left."""
        with self._shares.take(limits.cpu_seconds) as free:
            self.require_time()
            cpu, wall = self.left()
            yield limits._replace(
                cpu_seconds=int(min(free, cpu + 1)),
                wall_seconds=min(limits.wall_seconds, wall + 0.01),
            )


def _cpu() -> float:
    of = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in of)


UNLIMITED = Budget(float("inf"), float("inf"))
