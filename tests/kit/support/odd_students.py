"""Uploads of one student that are hard to read, for classes in which the others are honest."""

import corpus
from corpus import Member
from bounce_grader.submission.entry import LARGEST_SOURCE
from handed_in import packed_tar
from odd_zips import bomb, PLAIN, zips

Files = dict[str, bytes]


def repetitive(length: int, unit: bytes = b"{") -> bytes:
    """A text whose comparison with another like it takes time quadratic in its length."""
    return (unit * length)[:length]


def long_names(number: int, suffix: str = ".o") -> bytes:
    """A zip of this many files, each with a name of the greatest length."""
    names = (f"{i:04}{'n' * (251 - len(suffix))}{suffix}" for i in range(number))
    return corpus.zip_of(Member(name.encode(), b"") for name in names)


def _of(*files: str, data: bytes = b"// odd\n") -> Files:
    return {f"roe_USER_{number}_{file}": data for number, file in enumerate(files, 11)}


ZIPS = {what: _of("hw.zip", data=data) for what, _, data in zips()}
LONG = [f"{'n' * 240}{i}.jpg" for i in range(90)]
LARGE = packed_tar({"large.bin": bytes(60 << 20)})  # of sixty kilobytes
OF_TARS = corpus.zip_of(Member(b"%d.tar.gz" % i, LARGE) for i in range(3))
COUNTS = _of("part2_lcp.cpp", data=b"// remark: this one counts")
LINK = Member(b"part2_lcp.cpp", b"/etc/passwd", attributes=0o120777 << 16)

# By what is odd: names in Canvas's download, where USER is the student's number there.
UPLOADS: dict[str, Files] = {
    **{f"zip: {what}": files for what, files in ZIPS.items()},
    **{f"zip beside a file: {w}": files | {"roe_USER_9_a.hpp": b""} for w, files in ZIPS.items()},
    "many long names": _of("hw.zip", data=long_names(4900)),
    "1900 long names beside a part": _of("part2_lcp.cpp")
    | {"roe_USER_12_hw.zip": long_names(1900)},
    "a part that is there 90 times": _of("hw.zip", data=long_names(90, "/part1_contacts.cpp")),
    "90 long uploads": _of(*LONG),
    "90 long uploads beside a part": _of("part2_lcp.cpp", *LONG),
    "many": _of(*(f"helper{i}.cpp" for i in range(3000))),
    "many large ones": _of(*(f"h{i}.cpp" for i in range(99)), data=b" " * (1 << 20)),
    "ten tars, large together": _of(*(f"hw{i}a.tar.gz" for i in range(10)), data=LARGE),
    "ten zips of tars, large together": _of(*(f"hw{i}a.zip" for i in range(10)), data=OF_TARS),
    "two zips, large together": _of("a.zip", "b.zip", data=bytes(40 << 20) + PLAIN),
    "two zips, many sources together": {
        f"roe_USER_{i}_{i}.zip": bomb(60, f"h{i}_") for i in (1, 2)
    },
    "a link in a newer zip": COUNTS | {"roe_USER_13_hw.zip": corpus.zip_of([LINK])},
    "a source of more than 1 MB": COUNTS
    | {"roe_USER_12_part1_contacts.cpp": b" " * (LARGEST_SOURCE + 1)},
    "an attachment of 5,000 digits": {f"roe_USER_{'9' * 5000}_part2_lcp.cpp": b""},
    "a user of 5,000 digits": {f"roe_{'301' * 2000}_1_part2_lcp.cpp": b""},
    "an anonymous user without end": {f"roe_anon_{'301' * 9000}_1_part2_lcp.cpp": b""},
    "digits of another script": {"roe_\u0663\u0660\u0661_\u0661_part2_lcp.cpp": b"", "roe_x": b""},
    "nothing but numbers": {"roe_USER_" + "1_" * 9000: b""},
    "a name with line ends": _of("part2\n_lcp\r\x1b[2J.cpp"),
    "a name as an option": _of("-o.cpp", "@x.cpp", "..cpp", ".cpp", "-1.cpp", " (1).zip"),
    "backslashes": _of("..\\..\\part2_lcp.cpp"),
    "two bytes a letter": _of("part2_lcp.cpp", data=b"\xff\xfe\x00\xd8" * 1000),
    "no text": _of("part2_lcp.cpp", data=bytes(range(256)) * 100),
    "repetitive": _of("part2_lcp.cpp", data=repetitive(60_000)),
    "line ends alone": _of("part2_lcp.cpp", data=b"\n" * (1 << 20)),
    "typed": {"roe_USER_text.html": b"", "roe_USER_link.html": b""},
}
