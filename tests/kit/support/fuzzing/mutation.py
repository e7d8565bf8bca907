"""Bytes that are nearly right: one of several seeds, with a few changes."""

import random

from bounce_grader.common.paths import WORK_FOLDER

Random = random.Random
WORDS = [b"PK\1\2", b"PK\3\4", b"PK\5\6", b"PK\6\6", b"PK\6\7", b"PK\7\10", b"../", b"\\", b"\0"]
WORDS += [b"__MACOSX/", b"\xff\xfe", b"\x1b[2J", b".cpp", b'"', b"{", b"[", b"]", b"}", b"1e999"]
WORDS += [
    b"null",
    b"NaN",
    b"-1",
    b"true",
    b"\\ud800",
    b":1:1: error: ",
    b"\n",
    b"undefined symbol: ",
]
WORDS += [f"/{WORK_FOLDER}".encode(), b"/", b":12", b"\n>>> referenced by "]
EDGES = [0, 1, 2, 7, 8, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFE, 0xFFFF, 1 << 16, 1 << 20]
EDGES += [(1 << 31) - 1, 1 << 31, (1 << 32) - 1, 1 << 32, (1 << 63) - 1, (1 << 64) - 1]


def mutated(rng: Random, seeds: list[bytes], most: int = 8) -> bytes:
    """One of the seeds with a few changes; now and then with none."""
    data = bytearray(rng.choice(seeds))
    for _ in range(rng.randrange(most)):
        at = rng.randrange(len(data) + 1)
        length = min(rng.choice((1, 2, 4, 8, 40, 400)), len(data) - at)
        change = rng.randrange(7)
        if change == 0 and at < len(data):
            data[at] ^= 1 << rng.randrange(8)
        elif change == 1:
            data[at : at + length] = rng.randbytes(length)
        elif change == 2:
            del data[at : at + length]
        elif change == 3:
            data[at:at] = data[at : at + length] * rng.choice((1, 1, 1, 30))
        elif change == 4:
            data[at:at] = rng.choice(WORDS)
        elif change == 5:
            size = rng.choice((2, 4, 8))
            data[at : at + size] = (rng.choice(EDGES) % (1 << 8 * size)).to_bytes(size, "little")
        else:
            other = rng.choice(seeds)
            data[at:] = other[rng.randrange(len(other) + 1) :]
    return bytes(data)
