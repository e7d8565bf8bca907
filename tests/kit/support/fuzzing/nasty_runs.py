"""Attacks that run with a submission: what they print, steal and call, and how they end."""

from fuzzing.mutation import Random
from fuzzing.nasty_words import Piece, new_name, quoted, some_words

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
    theft = new_name(rng, "stolen")
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
    place, name = quoted(rng.choice(places)), new_name(rng, "kept")
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
        f"{inner.head}__attribute__(({when})) static void {new_name(rng, 'early')}() {{ {inner.attack} }}\n",
    )
