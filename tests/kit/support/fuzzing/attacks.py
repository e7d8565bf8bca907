"""Submissions that attack: pieces of nasty.py in files, folders, zips and small classes.

At least one part of each, or one student of a class, is honest: in files of its own, and without a
nasty header.
"""

import dataclasses
import io
import struct
import zipfile
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import corpus
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import ROOT
from corpus import Member
from fuzzing import nasty, nasty_words
from fuzzing.mutation import EDGES, Random, mutated
from hostile import part

Files = dict[str, bytes]


@dataclass(frozen=True)
class Attack:
    """A folder, if there are files; else an archive: a submission, or a class as Canvas has it."""

    files: Files = field(default_factory=dict)
    archive: bytes = b""
    honest_parts: frozenset[int] = frozenset()
    honest_users: frozenset[int] = frozenset()  # of a class

    @property
    def is_class(self) -> bool:
        return bool(self.honest_users)


def some_attack(rng: Random, secrets: list[str]) -> Attack:
    """`secrets` are files that a submission must not read."""
    places = [*secrets, *nasty_words.PLACES]
    kind = rng.choices(("folder", "zip", "class"), (64, 18, 18))[0]
    if kind == "class":
        return _class(rng, places)
    files, honest = _submission(rng, places)
    return Attack(files, b"", honest) if kind == "folder" else _zipped(rng, files, honest)


# --- a submission ---


@cache
def _solution() -> Files:
    return {p.file: (ROOT / "solution" / "src" / p.file).read_bytes() for p in parts()}


def _honest(rng: Random) -> Files:
    """Half of them are compiled again, beside the attack; the objects of the others are cached."""
    remark = f"// {rng.getrandbits(64):x}\n".encode() if rng.random() < 0.5 else b""
    return {name: remark + text for name, text in _solution().items()}


def _submission(rng: Random, places: list[str]) -> tuple[Files, frozenset[int]]:
    files = _honest(rng)
    numbers = range(1, 1 + len(parts()))
    nasty_parts = rng.sample(numbers, rng.choice((0, 1, 1, 1, 1, 2, 2, 3)))
    headers = [_some_name(rng, ".hpp") for _ in range(rng.choice((0, 0, 0, 1, 2)))]
    helpers = [_some_name(rng, ".cpp") for _ in range(rng.choice((0, 0, 0, 1, 1, 3)))]
    helpers += [f"many{i}.cpp" for i in range(95)] if rng.random() < 0.01 else []
    for number in nasty_parts:
        files[parts()[number - 1].file] = _nasty_part(rng, number, headers, places)
    for name in headers:
        files[name] = _text([nasty.some_piece(rng, places, nasty.KINDS)])
    linked = rng.random() < 0.3  # helpers are linked with every part, and may break each
    for name in helpers:
        kinds = nasty.KINDS if linked else nasty.OF_TEXT
        files[name] = _text([nasty.some_piece(rng, places, kinds)])
    if rng.random() < 0.3:
        files = {f"{rng.choice(FOLDERS)}/{name}": text for name, text in files.items()}
    broken = set(numbers) if linked and helpers else set(nasty_parts)
    return files, frozenset(numbers) - broken


def _text(pieces: list[nasty_words.Piece]) -> bytes:
    return (nasty_words.HEADERS + "".join(piece.head for piece in pieces)).encode()


def _nasty_part(rng: Random, number: int, headers: list[str], places: list[str]) -> bytes:
    pieces = [nasty.some_piece(rng, places, nasty.KINDS) for _ in range(rng.choice((1, 1, 2, 3)))]
    head = nasty_words.FOR_GCC if rng.random() < 0.2 else ""
    head += nasty_words.HEADERS + "".join(
        f"#include {nasty_words.quoted(name)}\n" for name in headers
    )
    head += "".join(piece.head for piece in dict.fromkeys(pieces))
    attack = "".join(f"{{ {piece.attack} }}\n" for piece in pieces)
    if rng.random() < 0.3:  # right answers
        return (head + _solution()[parts()[number - 1].file].decode()).encode()
    function = f"static void attack() {{\n{attack}}}\n"
    return part(number, head + function, f"{rng.getrandbits(64):x}")


# Names of files beside the parts. None is a system header's, which honest parts would include.
STEMS = ["helper", "part1", "part1_contacts.o", "part9_contacts", "prelude", "runner", "solvers"]
STEMS += ["a b", "é界", "=1+1", "a;b", "a'b", "$(id)", "`id`", "<b>", "%s", "a\\b", "x" * 200, "a&b"]
STEMS += ["-O2", "@x", "--", "-", "a\nb", "a\x1b[2J", "a\u202eb", "..", "a:1:1: error: b", "##[x]"]
STEMS += ["error: x", "bwrap: x", "enter: x", "ld.lld: error: undefined symbol: x", "::error::x"]
STEMS += ["not found", "No such file", "x.cpp:1:1: error: y", "crti.o", "OBJECTS", "gcc_flags"]
FOLDERS = ["src", "hw 3", "a", "include", "x-1", "sources", "é", "build.1", "error: "]


def _some_name(rng: Random, suffix: str) -> str:
    stem = rng.choice(STEMS).replace("/", "")
    folder = rng.choice(("", "", "", f"{rng.choice(FOLDERS)}/", "-I/"))
    return f"{folder}{stem}{rng.choice((suffix, suffix, suffix, suffix.upper()))}"


# --- archives ---


def _zipped(rng: Random, files: Files, honest: frozenset[int]) -> Attack:
    """A zip with misleading entries; or a damaged one, of which perhaps nothing can be read."""
    data = _lying_zip(rng, files)
    if rng.random() < 0.3:
        return Attack({}, mutated(rng, [data], 6))
    return Attack({}, data, honest)


def _lying_zip(rng: Random, files: Files) -> bytes:
    members = [
        Member(name.encode("utf-8", "surrogateescape"), text) for name, text in files.items()
    ]
    members += [_lie(rng, rng.choice(members)) for _ in range(rng.randrange(4))]
    rng.shuffle(members)
    return corpus.zip_of(members, rng.choice((b"", b"", nasty_words.some_words(rng).encode())))


def _lie(rng: Random, member: Member) -> Member:
    """A further entry with a false property, under another name or the same one."""
    words = nasty_words.some_words(rng).encode()[:200]
    # No source: its copy of a part would be linked beside the part itself.
    names = [b"x.hpp", b"x.txt", b"x/", b"", member.name, words + b".hpp", b"../x.cpp", b"/x.cpp"]
    names += [b"d/" * 99 + b"x.hpp", b"\xff\0.hpp", b"n" * 999 + b".hpp", member.name + b"/x.hpp"]
    lies: dict[str, Any] = {
        "local_name": rng.choice(names),
        "size": rng.choice(EDGES) % (1 << 32),
        "method": rng.choice((0, 8, 9, 12, 14, 99)),
        "flags": rng.choice((1, 8, 32, 64, 0x800)),
        "attributes": rng.choice((0o120777, 0o010644, 0o020666, 0o040755)) << 16,
        "extra": rng.randbytes(rng.randrange(40)),
        "at": rng.randrange(1 << rng.randrange(1, 32)),
        "data": rng.choice((words, b"\0" * 99, b"#error lie\n", b"x" * (1 << 21), b"\xff\xfe\0")),
    }
    if rng.random() < 0.3:  # sizes of eight bytes
        sizes = struct.pack("<HHQQ", 1, 16, rng.choice(EDGES), rng.choice(EDGES))
        return dataclasses.replace(member, name=rng.choice(names), size=(1 << 32) - 1, extra=sizes)
    told = {key: lies[key] for key in rng.sample(sorted(lies), rng.choice((1, 1, 2)))}
    lying: Member = dataclasses.replace(member, name=rng.choice(names), **told)
    return lying


def _class(rng: Random, places: list[str]) -> Attack:
    """Canvas's download: two honest students, and one or two that attack."""
    honest, attackers = (101, 102), rng.sample((99, 103, 104), rng.choice((1, 2)))
    entries = [(user, [(name, text) for name, text in _honest(rng).items()]) for user in honest]
    entries += [(user, _uploads(rng, places)) for user in attackers]
    rng.shuffle(entries)
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for user, uploads in entries:
            for number, (name, data) in enumerate(uploads):
                entry = f"doejane_{user}_{user}{number:02}_{name}"
                archive.writestr(zipfile.ZipInfo(entry), data)
    return Attack({}, stream.getvalue(), frozenset(), frozenset(honest))


def _uploads(rng: Random, places: list[str]) -> list[tuple[str, bytes]]:
    """Files, zips, or both; the same name more than once."""
    files, _ = _submission(rng, places)
    uploads = [
        (name.replace("/", "_").encode()[:150].decode("utf-8", "ignore"), text)
        for name, text in files.items()
        if rng.random() < 0.8
    ]
    for _ in range(rng.choice((0, 1, 1, 2))):
        more, _ = _submission(rng, places)
        data = _lying_zip(rng, more)
        data = mutated(rng, [data], 4) if rng.random() < 0.4 else data
        uploads.append((rng.choice(("hw.zip", "hw-1.zip", "part1_contacts.cpp", "x.rar")), data))
    odd = ("text.html", "102_10200_part1_contacts.cpp", "LATE_102_1_part1_contacts.cpp", "")
    uploads += [(name, b"int x;\n") for name in odd if rng.random() < 0.1]
    return uploads
