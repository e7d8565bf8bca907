"""The time that one grading may take: to read the submission, compile, link and judge it."""

import math
import resource
import time

from bounce_grader.common.errors import KitError
from bounce_grader.sandbox.processes import Limits

CPU_SECONDS = 60.0
WALL_SECONDS = 120.0
WHOLE = "the grading as a whole"


class Overrun(Exception):
    """A grading has used up its time, and what isn't done yet gets no result. The text says why."""


class Budget:
    """A limit, counted from now on, on the wall-clock time and on the CPU time of this process and
    of all children that it has waited for. `whose` begins the sentence when that is used up."""

    killed = 0.0  # s, of CPU: what `processes.run` killed, which the system counts as nobody's
    _part_of: "Budget | None" = None

    def __init__(self, cpu: float = CPU_SECONDS, wall: float = WALL_SECONDS, whose: str = WHOLE):
        self._limits, self._whose = (cpu, wall), whose
        self._cpu_end, self._wall_end = _cpu() + cpu, time.monotonic() + wall

    def part(self, cpu: float, wall: float = math.inf, whose: str = "") -> "Budget":
        """A part of this one, which has no more time than is left."""
        left = self.left()
        made = Budget(min(cpu, left[0]), min(wall, left[1]), whose)
        made._part_of = self
        return made

    def left(self) -> tuple[float, float]:
        """The CPU seconds and wall-clock seconds that are left; negative if overdrawn."""
        return self._cpu_end - _cpu(), self._wall_end - time.monotonic()

    def require_time(self) -> None:
        """Raises Overrun if the time is used up; KitError if the machine used it up."""
        if self._part_of:
            self._part_of.require_time()
        self.require_responsive_machine()
        cpu, wall = self.left()
        if cpu <= 0:
            raise Overrun(f"{self._whose} had used its {self._limits[0]:g} s of CPU time")
        if wall <= 0:
            raise Overrun(f"{self._whose} had taken its {self._limits[1]:g} s")

    def require_responsive_machine(self) -> None:
        """Raises KitError if the wall-clock time is used up but little of the CPU time: the machine
        was too busy, or the grading was suspended. A submission can't cause this, because each of
        its programs may sleep for a few seconds only."""
        (cpu_limit, wall_limit), (cpu, wall) = self._limits, self.left()
        if wall <= 0 and cpu > cpu_limit / 2:
            had = f"in {wall_limit:.0f} s this grading had {cpu_limit - cpu:.0f} s of CPU time"
            busy = "the machine was too busy, or it was stopped"
            raise KitError(f"{had}: {busy}; run the same command again")

    def within(self, limits: Limits) -> Limits:
        """These limits, lowered to what is left, which parallel processes may each use. Raises
        Overrun."""
        self.require_time()
        cpu, wall = self.left()
        cpu, wall = min(limits.cpu_seconds, cpu + 1), min(limits.wall_seconds, wall + 0.01)
        return limits._replace(cpu_seconds=int(cpu), wall_seconds=wall)


def _cpu() -> float:
    of = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return Budget.killed + sum(usage.ru_utime + usage.ru_stime for usage in of)


UNLIMITED = Budget(math.inf, math.inf)
