"""Pieces of C++ that attack: what they say, what they steal, and how they end.

A piece stands at the top of a file (`head`), in a function that each answer calls (`attack`), or in
both. Which one is drawn, and what is in it, depends on the random numbers alone.
"""

import os
from collections.abc import Callable
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


def _new(rng: Random, name: str) -> str:
    """A name that no other piece has."""
    return f"{name}_{rng.randrange(1 << 32)}"


def some_words(rng: Random) -> str:
    """Texts, often as a whole line, as programs print their own messages."""
    words = rng.choices(WORDS, k=rng.choice((1, 1, 2, 3)))
    words = [rng.choice(DECISIVE), *words[1:]] if rng.random() < 0.3 else words
    return rng.choice(("", "", "x\n")) + rng.choice(("", "\n")).join(words)


def in_one_line(rng: Random) -> str:
    return some_words(rng).replace("\n", " ").replace("\r", " ").replace("\0", " ")


# --- what compilers and assemblers are told to say, or to read ---


def saying(rng: Random, _: list[str]) -> Piece:
    return Piece("".join(_directive(rng) for _ in range(rng.choice((1, 3, 9)))))


def _directive(rng: Random) -> str:
    words, line, name = some_words(rng), in_one_line(rng), _new(rng, "x")
    return rng.choice(
        [
            *(f"#warning {line}\n", f"#error {line}\n", f"#ident {quoted(words)}\n", f"{line}\n"),
            f"#pragma message({quoted(words)})\n",
            f"#pragma message({quoted(words)})\nint {name} = ;\n",
            f"#pragma GCC {rng.choice(('error', 'warning'))} {quoted(words)}\n",
            f"_Pragma({quoted(f'message({quoted(words)})')})\n",
            f"static_assert(false, {quoted(words)});\n",
            f"static_assert(sizeof(int) == 4, {quoted(words)});\n",
            f"[[deprecated({quoted(words)})]] void {name}(); void also{name}() {{ {name}(); }}\n",
            f"static int {name}[] = {{ {quoted(words)} }};\n",
            f"#line {rng.choice((0, 1, 7, 2147483647))} {quoted(words)}\nint {name} = ;\n",
            f"#line 3 {quoted(words)}\nint {name}() {{ return missing; }}\n",
            f"#line 3 {quoted(words)}\n",
            f"#include {quoted(line)}\n",
            f"#include <{line}>\n",
            f"#if __has_include({quoted(line)})\n#error there\n#endif\n",
            f"#define EIGEN_ASM_COMMENT(X) __asm__({quoted(f'.print {quoted(words)}')})\n"
            "#include <Eigen/Dense>\n",
            FOR_GCC,
        ]
    )


def assembling(rng: Random, places: list[str]) -> Piece:
    word, place = quoted(some_words(rng)), quoted(rng.choice(places))
    lines = rng.choice(
        [
            *(f".print {word}", f".error {word}", f".warning {word}", ".err", f".ident {word}"),
            *(f".incbin {place}", f".include {place}", f".file {word}", f".file 1 {word} {place}"),
            f".macro m\n.print {word}\n.endm\nm\nm",
            f".rept {rng.choice((3, 300))}\n.print {word}\n.endr",
            f".section {word},{quoted('awx')},@progbits\nnop\n.text",
            f".section .init_array,{quoted('aw')}\n.quad {rng.choice(('0', '1', 'abort'))}\n.text",
            f".globl {word}\n{word}:\n",
            f".symver get,{word}",
            f".comm huge,{rng.choice((1 << 20, 1 << 34, 1 << 50))},8",
            f".zero {rng.choice((1 << 12, 9 << 20))}",
            *(".org 0x100000", ".balign 65536", ".weak main\n.set main,0", ".bundle_align_mode 5"),
            ".pushsection .text.startup\nud2\n.popsection",
            f".ascii {word}\n.err",
            f".linker_option {word}",
            f".section .note.GNU-stack,{quoted('x')},@progbits\n.text",
            f".section .gnu.warning.abort,{quoted('')},@progbits\n.ascii {word}\n.text",
        ]
    )
    quiet = rng.choice(("asm", "__asm__", "asm volatile", "__asm"))
    inside = f"void {_new(rng, 'assembled')}() {{ {quiet.split()[0]}({quoted(lines)}); }}\n"
    return Piece(rng.choice((f"asm({quoted(lines)});\n", inside)), "")


def burning(rng: Random, _: list[str]) -> Piece:
    """Work for a compiler, of some seconds at most; and never much of it in one submission."""
    depth, x = rng.choice((50, 400, 1500)), _new(rng, "x")
    tower = f"#define {x}0 1 +\n"
    tower += "".join(f"#define {x}{i} {x}{i - 1} {x}{i - 1}\n" for i in range(1, 14))
    work = f"int s = 0; for (int i = 0; i < {depth * 100}; ++i) s += i % 7; return s;"
    below = f"{x}<N - 1> below; static constexpr int n = {x}<N - 1>::n + 1;"
    return Piece(
        rng.choice(
            [
                f"template <int N> struct {x} {{ {below} }};\n"
                f"template <> struct {x}<0> {{ static constexpr int n = 0; }};\n"
                f"static_assert({x}<{depth}>::n == {depth});\n",
                f"constexpr int {x}() {{ {work} }}\nstatic_assert({x}() > 0);\n",
                f"{tower}static int {x} = {x}13 0;\n",
                f"static int {x} = {'(' * depth}1{')' * depth};\n",
                f"static char {x}[{rng.choice((1 << 10, 9 << 20, 1 << 33))}] = {{1}};\n",
                "".join(f"int {x}{i} = undeclared{i};\n" for i in range(rng.choice((5, 300)))),
                f"template <class T> auto {x}(T t) {{ return {x}(&t); }}\nauto {x}2 = {x}(1);\n",
            ]
        )
    )


# --- what linkers and loaders are told ---

SYMBOLS = ["main", "_start", "write", "read", "malloc", "free", "abort", "memcpy", "_exit", "exit"]
SYMBOLS += [
    "__cxa_throw",
    "__assert_fail",
    "__libc_start_main",
    "environ",
    "stdout",
    "sqrt",
    "_init",
]
SYMBOLS += ["_ZN6bounce6runner4sendERKNS_6frames5FrameE", "_ZN6bounce6runner7receiveEv"]
SYMBOLS += [
    "_ZN6bounce9solve_lcpERKN5Eigen6MatrixIdLi4ELi4ELi0ELi4ELi4EEERKNS1_IdLi4ELi1ELi0ELi4ELi1EEE"
]
SYMBOLS += [
    "__asan_default_options",
    "__ubsan_default_options",
    "__asan_on_error",
    "__sanitizer_report",
]


def linking(rng: Random, _: list[str]) -> Piece:
    symbol = rng.choice([*SYMBOLS, some_words(rng)])
    label = f"asm({quoted(symbol)})"
    name = _new(rng, "taken")
    linkage = rng.choice(("", "__attribute__((weak)) ", "__attribute__((used)) "))
    return Piece(
        rng.choice(
            [
                f'extern "C" {linkage}int {name}() {label};\nint {name}() {{ return 0; }}\n',
                f"{linkage}int number {label};\nint number = 7;\n",
                f'extern "C" int missing() {label};\nint uses() {{ return missing(); }}\n',
                'extern "C" { static int (*resolve())() { return nullptr; }\n'
                f'int chosen() __attribute__((ifunc("resolve"))); }}\nint calls() {{ return chosen(); }}\n',
                'extern "C" int real() { return 1; }\n'
                f'extern "C" int other() {label} __attribute__((alias("real")));\n',
                "namespace bounce { Contact get_contacts(const Vector3&, const Parameters&) "
                "{ return {}; } }\n",
                "namespace bounce { __attribute__((weak)) State step(const Vector3& q, const Vector3& v, "
                "const Parameters&) { return {q, v}; } }\n",
            ]
        )
    )


# --- what runs ---

FRAMES = """
#ifndef FRAMES
#define FRAMES
namespace bounce::frames { struct Frame {
  unsigned magic = 0x31424E42, kind = 2, part = 1, silent = 0; unsigned long number = 1;
  long q_columns = 3, v_columns = 3; double scene[9] = {}; long T = 3; double values[20] = {};
  char text[160] = {}; }; }
namespace bounce::runner { void send(const frames::Frame&); frames::Frame receive();
  frames::Frame call_back(frames::Frame); }
#endif
"""


def asking(rng: Random, _: list[str]) -> Piece:
    """The runner's own functions."""
    kind, part = rng.choice((0, 1, 2, 3, 4, 5, 6, 77)), rng.choice((0, 1, 2, 3, 4, 99))
    call = rng.choice(("send(f)", "call_back(f)", "receive()", "send(receive())"))
    text = f"std::strncpy(f.text, {quoted(some_words(rng))}, 159);"
    times = rng.choice((1, 1, 3, 50))
    return Piece(
        FRAMES,
        f"{{ bounce::frames::Frame f; f.kind = {kind}; f.part = {part}; {text} "
        f"for (int i = 0; i < {times}; ++i) bounce::runner::{call}; }}\n",
    )


def stolen(rng: Random, places: list[str], name: str) -> str:
    """A function that looks for secrets in some places, first for the variable of attack_run.py."""
    some = ", ".join(quoted(place) for place in rng.sample(places, min(6, len(places))))
    how = rng.choice(
        (
            "syscall(SYS_openat, AT_FDCWD, place, O_RDONLY)",
            "syscall(SYS_open, place, O_RDONLY)",
            "open(place, O_RDONLY)",
            "syscall(SYS_openat2, AT_FDCWD, place, nullptr, 24)",
        )
    )
    return f"""static std::string {name}() {{
  std::string all;
  for (const char* place : {{ {some} }}) {{
    const int fd = static_cast<int>({how});
    char text[4000];
    const long n = fd < 0 ? 0 : syscall(SYS_read, fd, text, sizeof text);
    if (n > 0) all.append(text, static_cast<std::size_t>(n));
  }}
  for (const char* name : {{ "BOUNCE_CANARY=", "/tmp-" }}) {{
    const auto at = all.find(name);
    if (at != std::string::npos) return all.substr(at, 60);
  }}
  return all.empty() ? "nothing" : all;
}}
"""


def stealing(rng: Random, places: list[str]) -> Piece:
    theft = _new(rng, "stolen")
    words = quoted(some_words(rng))
    fd = rng.choice((0, 1, 2, 2, 3, 4, 5, 9))
    say = f"const std::string said = {words} + {theft}(); "
    tell = rng.choice(
        [
            f"{say} throw std::runtime_error(said);",
            f"{say} (void)!write({fd}, said.data(), said.size());",
            f'{say} std::fprintf(stderr, "%s\\n", said.c_str()); {ending(rng)}',
            f'{say} std::printf("%s\\n", said.c_str()); std::fflush(stdout); {ending(rng)}',
            f"{say} [&]() noexcept {{ throw std::runtime_error(said); }}();",
            f"{say} prctl(PR_SET_NAME, said.c_str());",
            f"{say} open(said.c_str(), O_CREAT | O_WRONLY, 0600);",
            *[
                f'const std::string said = "\\ncause of the crash: found: " + {theft}() + "\\n"; '
                f"(void)!write(2, said.data(), said.size()); {crash}"
                for crash in ("std::abort();", "__builtin_trap();", ending(rng))
            ],
            f'const std::string said = "x: /a/b.h:1: f: Assertion `" + {theft}() + "\' failed.\\n"; '
            "(void)!write(2, said.data(), said.size()); std::abort();",
        ]
    )
    return Piece(stolen(rng, places, theft), f"{{ {tell} }}\n")


def including(rng: Random, places: list[str]) -> Piece:
    """A secret as a string, while it compiles."""
    place, name = quoted(rng.choice(places)), _new(rng, "kept")
    bytes_of = quoted(f".data\n.globl {name}\n{name}: .incbin {place}\n.byte 0\n.text")
    throw = f"throw std::runtime_error({name});\n"
    return rng.choice(
        [
            Piece(f"static const char* {name} =\n#include {place}\n;\n", throw),
            Piece(f"static_assert(false,\n#include {place}\n);\n"),
            Piece(f'asm({bytes_of});\nextern "C" const char {name}[];\n', throw),
            Piece(f"#embed {place}\n"),
        ]
    )


def ending(rng: Random) -> str:
    signal = rng.choice(
        ("SIGSEGV", "SIGKILL", "SIGSTOP", "SIGABRT", "SIGXCPU", "SIGSYS", "SIGTERM")
    )
    return rng.choice(
        [
            *(
                "std::abort();",
                "__builtin_trap();",
                "*(volatile int*)nullptr = 1;",
                "std::terminate();",
            ),
            *(f"_exit({code});" for code in (0, 1, 2, 3, 125, 127, 137)),
            *(f"std::exit({code});" for code in (0, 125, 137)),
            *(
                f"raise({signal});",
                f"kill(getpid(), {signal});",
                "int z = 0; volatile int y = 1 / z;",
            ),
            *(
                "throw 7;",
                "throw std::bad_alloc();",
                "throw std::runtime_error(std::string(9999, 'x'));",
            ),
            'std::string("x").at(9);',
            "int* p = new int[3]; p[3] = 1; delete p; delete[] p;",
            'asm volatile("ud2");',
            "Eigen::VectorXd v(3); v(7) = 1;",
            "volatile char deep[9 << 20]; deep[0] = 1;",
        ]
    )


def crashing(rng: Random, _: list[str]) -> Piece:
    return Piece("", f"{{ {ending(rng)} }}\n")


def printing(rng: Random, _: list[str]) -> Piece:
    words, fd = quoted(some_words(rng) + "\n"), rng.choice((0, 1, 1, 2, 2, 2, 3, 4, 5, 7, 9))
    times = rng.choice((1, 1, 1, 40))
    end = rng.choice(("", ending(rng)))
    return Piece(
        "",
        f"for (int i = 0; i < {times}; ++i) (void)!write({fd}, {words}, sizeof {words} - 1); {end}\n",
    )


def calling(rng: Random, _: list[str]) -> Piece:
    """The system."""
    fds = f"for (int fd = 0; fd < 10; ++fd) if (fd != {rng.randrange(12)}) close(fd);"
    return Piece(
        "",
        rng.choice(
            [
                *(fds, "close(3);", "close(4);", "dup2(2, 4);", "dup2(4, 1);"),
                *(
                    "fork();",
                    'execl("/bin/sh", "sh", "-c", "id", nullptr);',
                    "setsid();",
                    'chdir("/");',
                ),
                *(
                    "kill(1, SIGKILL);",
                    "kill(-1, SIGKILL);",
                    "kill(getppid(), SIGTERM);",
                    "alarm(1);",
                ),
                *("prctl(PR_SET_DUMPABLE, 0);", "prctl(PR_SET_PDEATHSIG, 0);", "nice(19);"),
                "signal(SIGSEGV, SIG_IGN); signal(SIGTERM, SIG_IGN); signal(SIGPIPE, SIG_DFL);",
                f"syscall({rng.randrange(460)}, 0, 0, 0, 0, 0, 0);",
                f"syscall({rng.choice((57, 58, 59, 101, 165, 272, 425, 435))}, 1, 1, 1, 1, 1, 1);",
                "char t[4096]; (void)!read(3, t, 100);",
                "char t[4096] = {}; (void)!write(4, t, sizeof t);",
            ]
        )
        + "\n",
    )


def napping(rng: Random, _: list[str]) -> Piece:
    return Piece(
        "",
        rng.choice(
            [
                f"usleep({rng.choice((100, 20000, 600000))});\n",
                f"for (;;) usleep({rng.choice((50, 1000, 30000))});\n",
                "for (;;) { for (volatile int i = 0; i < 9999; i = i + 1) {} usleep(900); }\n",
                "for (;;) syscall(SYS_sched_yield);\n",
                "pause();\n",
                "for (volatile int i = 0;; i = 1 - i) {}\n",
                "for (volatile long i = 0; i < 20000000; i = i + 1) {}\n",
                "std::vector<double> all; for (;;) all.resize(all.size() + 99999);\n",
                'while (true) std::puts("x");\n',
            ]
        ),
    )


def early(rng: Random, places: list[str]) -> Piece:
    """Something of the others, before main or after it."""
    inner = rng.choice([crashing, printing, calling, stealing, asking])(rng, places)
    when = rng.choice(
        ("constructor", "constructor(101)", "destructor", "constructor, destructor, used")
    )
    return Piece(
        f"{inner.head}__attribute__(({when})) static void {_new(rng, 'early')}() {{ {inner.attack} }}\n",
    )


Kinds = list[tuple[Callable[[Random, list[str]], Piece], int]]  # with how often each is drawn
KINDS: Kinds = [
    (saying, 14),
    (assembling, 10),
    (linking, 6),
    (stealing, 10),
    (including, 4),
    (crashing, 6),
    (printing, 8),
    (calling, 5),
    (asking, 4),
    (early, 5),
    (burning, 2),
    (napping, 1),
]
# They only say something while they are compiled, and change nothing that is linked or runs.
OF_TEXT: Kinds = [(saying, 3), (burning, 1)]
CONDITIONS = ["__SANITIZE_ADDRESS__", "__clang__", "NDEBUG", "__OPTIMIZE__", "__GNUC__"]


def some_piece(rng: Random, places: list[str], kinds: Kinds) -> Piece:
    piece = rng.choices([make for make, _ in kinds], [often for _, often in kinds])[0](rng, places)
    if rng.random() < 0.75:
        return piece
    # In one build alone; what crashes is built with sanitizers, too.
    test = f"#{rng.choice(('ifdef', 'ifdef', 'ifndef'))} {rng.choice(CONDITIONS)}\n"
    head, attack = (f"\n{test}{text}\n#endif\n" if text else "" for text in piece)
    return Piece(head, attack + rng.choice(("", "__builtin_trap();\n", "std::abort();\n")))
