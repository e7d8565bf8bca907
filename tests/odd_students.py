"""What a student can hand in so that reading it goes wrong, for classes in which others are honest."""

import struct

import corpus
from corpus import Member

PART = b"part2_lcp.cpp"
LIES = [2**31, 2**32 + 1, 2**62, 2**63, 2**64 - 1]  # of a size, in bytes


def zip_that_claims(size: int, name: bytes = PART) -> bytes:
    """Its table of contents says so in the fields of a large file."""
    extra = struct.pack("<HHQ", 1, 8, size)
    return corpus.zip_of([Member(name, b"// odd\n", size=0xFFFFFFFF, extra=extra)])


def bomb(sources: int, megabytes: int = 1) -> bytes:
    """Sources of nothing but spaces: a thousandth of their size as they are handed in."""
    text = b" " * (megabytes << 20)
    return corpus.zip_of(Member(b"helper%d.cpp" % i, text) for i in range(sources))


def repetitive(length: int, unit: bytes = b"{") -> bytes:
    """Compared with another of its kind, it takes the square of its length."""
    return (unit * length)[:length]


def long_names(number: int, suffix: str = ".o") -> bytes:
    """As many files as that, each with a name as long as a name may be."""
    names = (f"{i:04}{'n' * (251 - len(suffix))}{suffix}" for i in range(number))
    return corpus.zip_of(Member(name.encode(), b"") for name in names)
