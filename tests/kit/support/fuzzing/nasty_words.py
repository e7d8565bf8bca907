"""What pieces of C++ that attack are made of: texts, places, names."""

import os
from typing import NamedTuple

from fuzzing.mutation import Random


class Piece(NamedTuple):
    head: str = ""
    attack: str = ""


# Texts by which the kit might take a submission's failure for its own.
DECISIVE = [
    *("bwrap: x", "enter: x", "bwrap: execvp /enter: No such file or directory"),
    "g++: fatal error: Killed signal terminated program cc1plus",
    "clang: error: unable to execute command: Killed",
]
# Other texts that the kit looks for in the output of compilers, linkers, judges and runners.
WORDS = [
    *("bwrap: ", "enter: ", "judge: ", "kit: ", "stopwatch: "),
    *("error: ", "fatal error: ", "part1_contacts.cpp:1:1: error: ", "x.cpp:3:9: fatal error: "),
    *("ld.lld: error: undefined symbol: ", "ld.lld: error: duplicate symbol: "),
    "ld.lld: error: undefined symbol: x\n>>> referenced by part1_contacts.cpp:1",
    *("not found", "No such file", "could not find", "can't open", "file not found"),
    *("cause of the crash: ", "cause of the crash: found: ", "cause of the crash: full stack"),
    *("stack of the crash: 0x401000 0x1", "found: ", "cause of the crash: system call 57"),
    *("terminate called after throwing an instance of 'std::bad_alloc'", "  what():  "),
    *("a.out: /usr/include/eigen3/Eigen/src/x.h:12: f: Assertion `index' failed.", "Assertion `"),
    *("==1==ERROR: AddressSanitizer: heap-buffer-overflow", "runtime error: ", "SUMMARY: "),
    *("free(): invalid pointer", "stack smashing detected", "virtual memory exhausted"),
    *("out of memory", "timed_out", "Killed", "Segmentation fault", "  got      ", "In file "),
    *("/bounce-submission-x/sources/src/part1_contacts.cpp:12", "??:0", "1 of 1 cases wrong"),
    '{"checks": [], "largest_error": 0, "mistakes": [], "patterns": []}',
    *(
        "\x7fELF\x02\x01",
        "!<arch>\n",
        "##[group]",
        "::add-mask::1",
        "::error::x",
        "<script>",
        "```",
    ),
    *("\x1b[2J\x1b[31m", "\u202e", "\r", "\n", "\n\n\n", "\t", "%n%s", "\\", '"', "'", "$(id)", ""),
]

# Where something secret may be: other processes, and what this one was given.
PLACES = [f"/proc/{who}/{what}" for who in ("self", "1", "2") for what in ("environ", "cmdline")]
PLACES += [f"/proc/self/{what}" for what in ("maps", "syscall", "mem", "fd/3", "cwd", "comm")]
PLACES += ["/proc/1/environ", "/proc/1/cmdline", "/etc/passwd", "/proc/version", "/tmp", "."]

FOR_GCC = "#ifdef __clang__\n#error for g++ alone\n#endif\n"  # what clang rejects goes to g++
HEADERS = """
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
"""


def quoted(text: str) -> str:
    """A string of C++, whatever is in the text."""
    return '"' + "".join(map(_spelled, os.fsencode(text))) + '"'


def _spelled(byte: int) -> str:
    c = chr(byte)
    return c if c.isascii() and c.isprintable() and c not in '"\\?' else f"\\{byte:03o}"


def new_name(rng: Random, name: str) -> str:
    """A name that no other piece has."""
    return f"{name}_{rng.randrange(1 << 32)}"


def some_words(rng: Random) -> str:
    """Texts, often as a whole line, as programs print their own messages."""
    words = rng.choices(WORDS, k=rng.choice((1, 1, 2, 3)))
    words = [rng.choice(DECISIVE), *words[1:]] if rng.random() < 0.3 else words
    return rng.choice(("", "", "x\n")) + rng.choice(("", "\n")).join(words)


def in_one_line(rng: Random) -> str:
    return some_words(rng).replace("\n", " ").replace("\r", " ").replace("\0", " ")
