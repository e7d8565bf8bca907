"""Many inputs for one reader, in every process that there is room for."""

import resource
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from fuzzing import READERS, run

MOST_MEMORY = 512 << 20  # more than the program has at its start
CHUNK = 2000


def limit_memory() -> None:
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    most = pages * resource.getpagesize() + MOST_MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (most, most))


def main(name: str, count: int) -> None:
    start = time.monotonic()
    firsts = range(0, count, CHUNK)
    with ProcessPoolExecutor(initializer=limit_memory) as pool:
        try:
            taken = sum(pool.map(run, [name] * len(firsts), firsts, [CHUNK] * len(firsts)))
        except AssertionError as error:
            pool.shutdown(cancel_futures=True)
            sys.exit(f"{name}: {error}")
    count = len(firsts) * CHUNK
    seconds = time.monotonic() - start
    print(f"   {name}: {count} inputs, {taken / count:.0%} of them taken, in {seconds:.0f} s")
    if taken < READERS[name].least_taken * count:
        sys.exit(f"{name}: too few inputs were taken for this to show anything")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
