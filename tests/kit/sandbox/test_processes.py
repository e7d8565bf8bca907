"""Starting processes: what they are given to read."""

import sys

from bounce_grader.sandbox import processes

LIMITS = processes.Limits(cpu_seconds=10, wall_seconds=1.0, memory=None, file_size=1 << 30)
PATIENT = LIMITS._replace(wall_seconds=60)
MUCH = bytes(range(256)) * 8192  # many times what a pipe holds


def test_what_is_longer_than_a_pipe_passes_through() -> None:
    assert processes.run(["/bin/cat"], PATIENT._replace(output=len(MUCH)), stdin=MUCH).out == MUCH


def test_who_reads_nothing_is_stopped_when_its_time_is_up() -> None:
    assert processes.run(["/bin/sleep", "60"], LIMITS, stdin=MUCH).too_long


def test_who_prints_more_than_it_may_is_stopped_and_no_more_is_kept() -> None:
    result = processes.run(["/bin/cat", "/dev/zero"], PATIENT)
    assert result.flooded and not result.ok and len(result.out) == PATIENT.output == 256 << 10


def test_of_a_stopped_process_the_time_of_children_that_ended_counts() -> None:
    busy = f"{sys.executable} -c 'import time\nwhile time.process_time() < 0.5: pass'"
    result = processes.run(["/bin/sh", "-c", f"{busy}; cat /dev/zero; true"], PATIENT)
    assert result.flooded and result.cpu_seconds > 0.4  # counted in ticks


def test_who_ends_without_reading_is_no_fault() -> None:
    assert processes.run(["/bin/true"], PATIENT, stdin=MUCH).ok


def test_what_is_read_cannot_be_changed() -> None:
    write = "import os; os.write(0, b'x')"
    result = processes.run([sys.executable, "-c", write], PATIENT, stdin=b"as it is")
    assert not result.ok and "Bad file descriptor" in result.err
