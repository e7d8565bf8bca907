"""What one grading may take in all, whatever it does: our own reading of a submission, compilers,
linkers and judges together."""

import resource
import time

from bounce_grader.sandbox.processes import Limits

CPU_SECONDS = 60.0
WALL_SECONDS = 120.0


class Overrun(Exception):
    """A grading has used up its time: what is left of it has no result. Says why."""


class Budget:
    """CPU seconds, of this process and of all that it has started and waited for, and seconds on
    the wall, from now on."""

    def __init__(
        self,
        cpu_seconds: float = CPU_SECONDS,
        wall_seconds: float = WALL_SECONDS,
        part_of: "Budget | None" = None,
    ):
        self._part_of = part_of
        self._limits = cpu_seconds, wall_seconds
        self._cpu_end = _cpu() + cpu_seconds
        self._wall_end = time.monotonic() + wall_seconds

    def charge(self, cpu_seconds: float) -> None:
        """For what the system doesn't count: processes that were stopped."""
        self._cpu_end -= cpu_seconds
        if self._part_of:
            self._part_of.charge(cpu_seconds)

    def left(self) -> tuple[float, float]:
        """CPU seconds and seconds on the wall; below 0 where they are used up."""
        return self._cpu_end - _cpu(), self._wall_end - time.monotonic()

    def require(self) -> None:
        """Raises Overrun where nothing is left."""
        cpu, wall = self.left()
        if cpu <= 0:
            raise Overrun(f"the grading as a whole had used its {self._limits[0]:g} s of CPU time")
        if wall <= 0:
            raise Overrun(f"the grading as a whole had taken its {self._limits[1]:g} s")

    def within(self, limits: Limits) -> Limits:
        """The same limits, or less where less is left. Raises Overrun where nothing is."""
        self.require()
        cpu, wall = self.left()
        return limits._replace(
            cpu_seconds=int(min(limits.cpu_seconds, cpu + 1)),
            wall_seconds=min(limits.wall_seconds, wall + 0.01),
        )


def _cpu() -> float:
    of = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in of)


UNLIMITED = Budget(float("inf"), float("inf"))
