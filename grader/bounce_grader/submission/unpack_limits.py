"""How much memory, how many headers and how much time the archives of one submission may take
together."""

from pathlib import Path

from bounce_grader.common.errors import UsageError

LARGEST = 64 * 1024 * 1024  # bytes of one archive, unpacked
TOGETHER = 4 * LARGEST  # bytes that are unpacked, or read from other archives
HEADERS = 8 * 1024 * 1024  # bytes of tars: 5000 entries have that with a pax header each
SECONDS = 10.0  # of 7-Zip's CPU time


class UnpackLimits:
    """What is left."""

    memory = TOGETHER
    headers = HEADERS
    seconds = SECONDS

    @property
    def for_one(self) -> int:
        """The bytes that the next archive may have, unpacked."""
        return min(LARGEST, self.memory)

    def take(self, path: Path, size: int) -> None:
        """Raises UsageError if an archive with so many bytes is too large."""
        if size > self.for_one:
            raise UsageError(
                f"{path} has more than {LARGEST >> 20} MB unpacked, or more than "
                f"{TOGETHER >> 20} MB with the other archives: submit the parts alone"
            )
        self.memory -= size
