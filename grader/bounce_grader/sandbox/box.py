"""The boxes that untrusted programs are compiled and run in.

The full box uses bubblewrap: a program sees only the files named here, has no network, and runs in
its own PID namespace, so that all its processes end with it. The reduced box is for places without
namespaces, such as a container: Landlock hides the files, and leftover processes are killed. In
both, `enter` (grader/box/) does the last steps: it drops privileges, sets limits and installs the
filter of system calls. It stays as the box's first process, reports over its own descriptor whether
the box was made, and passes out the one file that a build has made.
"""

import os
import stat
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from shutil import which
from typing import Any, NamedTuple

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import ENTER, GIVEN_RUNNER
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.budget import UNLIMITED, Budget

FULL_OR_REDUCED = ("full", "reduced")
NOBODY = "65534"
USER = 60578  # that root's boxes run as: one that no system assigns
# Debian's headers of the kernel are links into /usr/lib/linux/uapi from version 13 on.
LIBRARIES = "/usr/include /usr/lib/linux/uapi /usr/lib/gcc /usr/lib64 /usr/libexec/gcc".split()
PROGRAMS = ("g++", "as", "ld", "addr2line")
LARGE_PAGES = "/sys/kernel/mm/transparent_hugepage"  # malloc reads it
TEMPORARY = 256 * 1024 * 1024  # of a build, in bytes
LARGEST_FILE = 16 * 1024 * 1024  # that a running program writes where it has no box, in bytes
Words = Iterable[str]
TO_KIT = ("--status", processes.STATUS, "--output", processes.OUTPUT)
TO_JUDGE = ("--status", "5")  # as in grader/judge/runner_process.cpp


class Box(NamedTuple):
    """`kind` is "full", "reduced", or "none" for a trusted submission. What runs in it uses up the
    budget."""

    kind: str
    budget: Budget = UNLIMITED

    def run(self, command: list[str], limits: processes.Limits, **given: Any) -> processes.Result:
        """Runs a command of to_run or to_build, or a program that runs them, as processes.run does.
        Raises Overrun if the grading has used up its time."""
        result = processes.run(command, self.budget.within(limits), **given)
        if result.stopped:
            Budget.killed += result.cpu_seconds
        if not result.ok:
            self.budget.require_time()
        return result

    def to_run(self, program: Path, sanitized: bool = False) -> list[str]:
        """The command that runs a statically linked program. The program sees only its own file,
        read-only; and it may make only the system calls that the filter allows, none of which
        opens a file. One with sanitizers also sees the system's libraries, only in the full box."""
        if self.kind == "none":
            return [str(program)]
        step = ["check" if sanitized else "run", "--user", str(USER), *TO_JUDGE]
        if self.kind == "reduced":
            name = str(program)
            return [str(ENTER), *step, "--box", "reduced", "--see", name, "--", name]
        command = _bubblewrap([])
        if sanitized:
            libraries = (p for p in toolchain() if p.endswith(("-linux-gnu", "/usr/lib64")))
            command = _bubblewrap(libraries)
            command += ["--symlink", "usr/lib", "/lib", "--symlink", "usr/lib64", "/lib64"]
        command += ["--ro-bind", str(program), "/runner", "--remount-ro", "/"]
        return [*command, "--", "/enter", *step, "--", "/runner"]

    def to_build(
        self, folder: Path, visible: Iterable[Path], programs: Words = PROGRAMS
    ) -> list[str]:
        """A prefix that runs a compiler or linker in `folder`, which it can only read. It can write
        to a temporary folder, where it makes OUTPUT. clang and its linker need no `programs`."""
        entering = ["build", *TO_KIT, "--in", str(folder)]
        if self.kind == "none":
            return [str(ENTER), *entering, "--box", "none", "--"]
        used = [f"/usr/bin/{name}" for name in programs]
        seen = list(dict.fromkeys([*toolchain(), *used, str(folder), *map(str, visible)]))
        entering += ["--user", str(USER)]
        if self.kind == "reduced":
            places = [word for path in [*seen, str(ENTER)] for word in ("--see", path)]
            return [str(ENTER), *entering, "--box", "reduced", *places, "--"]
        bounded = ["--size", str(TEMPORARY)] if _knows("--size") else []
        # clang looks for the system's headers in /usr/bin/../lib, even if /usr/bin is empty.
        temporary = ["--perms", "1777", *bounded, "--tmpfs", "/tmp"]
        command = _bubblewrap(seen, ["/dev/null", "/usr/bin/any"], temporary)
        command += ["--dev-bind", "/dev/null", "/dev/null"]
        for name in ("bin", "lib", "lib64"):
            command += ["--symlink", f"usr/{name}", f"/{name}"]
        return [*command, "--remount-ro", "/", "--", "/enter", *entering, "--"]

    @property
    def enter(self) -> str:
        """The path of `enter` inside the box of a build."""
        return "/enter" if self.kind == "full" else str(ENTER)

    def give(self, folder: Path) -> None:
        """Gives a folder and all in it to the user of root's boxes, who alone can then read it."""
        if self.kind != "none" and os.geteuid() == 0:
            for path in [folder, *folder.rglob("*")]:
                os.chown(path, USER, USER, follow_symlinks=False)


def kinds(trust: bool) -> tuple[str, ...]:
    """The kinds of box that are acceptable, best first."""
    return (*FULL_OR_REDUCED, "none") if trust else FULL_OR_REDUCED


@cache
def choose(kinds: tuple[str, ...] = FULL_OR_REDUCED) -> Box:
    """The first of these kinds in which a program known to be good runs; a process tries once."""
    problems = []
    for kind in kinds:
        problem = problem_of(Box(kind))
        if problem is None:
            return Box(kind)
        problems.append(f"{kind}: {problem}")
    install = "install bubblewrap where user namespaces are allowed"
    trust = "or pass --trust-submission for code that you would run yourself"
    raise KitError(f"no box can be had here ({'; '.join(problems)}); {install}, {trust}")


def problem_of(box: Box) -> str | None:
    """Why a program known to be good doesn't run in the box; None if it does."""
    if box.kind == "none":
        return None
    if box.kind == "full" and which("bwrap") is None:
        return "bubblewrap isn't installed"
    if box.kind == "reduced" and os.geteuid() == 0:
        for folder in GIVEN_RUNNER.resolve().parents:
            if not folder.stat().st_mode & stat.S_IXOTH:
                advice = f"move it, or chmod o+x {folder}"
                return f"other users can't enter {folder}, where the kit is; {advice}"
    limits = processes.Limits(cpu_seconds=5, wall_seconds=20, memory=1 << 30, file_size=0)
    tried = processes.run(box.to_run(GIVEN_RUNNER), limits)
    if tried.ok:
        return None
    return tried.err.strip().splitlines()[-1] if tried.err.strip() else "it ended"


@cache
def toolchain() -> list[str]:
    """The files and folders of the compilers and the linker, except programs in /usr/bin."""
    libraries = [path for path in (*LIBRARIES, LARGE_PAGES) if Path(path).exists()]
    found = [*Path("/usr/lib").glob("*-linux-gnu"), *Path("/usr/lib").glob("llvm-*")]
    return [*libraries, *sorted(map(str, found))]


@cache
def _knows(option: str) -> bool:
    """Whether this bubblewrap has an option, which older ones lack."""
    return option.encode() in processes.run(["/usr/bin/bwrap", "--help"]).out


def _bubblewrap(seen: Words, others: Words = (), mounts: Words = ()) -> list[str]:
    """A box in which these paths can be read, over these mounts. Folders above them and above the
    others are for every user; by default bubblewrap makes them readable for its own user only."""
    bound = list(seen)
    above = {str(folder) for path in (*bound, *others) for folder in Path(path).parents} - {"/"}
    return [
        *("/usr/bin/bwrap", "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts"),
        *("--die-with-parent", "--new-session", "--clearenv", "--hostname", "box", "--as-pid-1"),
        *_privileges(),
        *("--ro-bind", str(ENTER), "/enter"),
        *mounts,
        *(word for path in sorted(above) for word in ("--perms", "0755", "--dir", path)),
        *(word for path in bound for word in ("--ro-bind", path, path)),
    ]


def _privileges() -> list[str]:
    """Options that drop privileges. Root needs no user namespace, and in one it would still count
    as root, whose processes aren't limited. So it keeps just the capabilities to become another
    user and to end that user's processes."""
    if os.geteuid() == 0:
        kept = ("CAP_SETUID", "CAP_SETGID", "CAP_KILL")
        return ["--cap-drop", "ALL", *(w for name in kept for w in ("--cap-add", name))]
    no_more = ["--disable-userns"] if _knows("--disable-userns") else []
    return ["--unshare-user", *no_more, "--uid", NOBODY, "--gid", NOBODY, "--cap-drop", "ALL"]
