"""The box that untrusted programs are compiled and run in: bubblewrap, with nothing to see but
what is named here, no network, its own process space, and nobody's user id."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from shutil import which

from bounce_grader import processes
from bounce_grader.errors import KitError
from bounce_grader.paths import FILTER, REFERENCE_RUNNER

NOBODY = "65534"
TOOLCHAIN = ("/usr/bin", "/usr/lib", "/usr/lib64", "/usr/include", "/usr/libexec")
TEMPORARY = 256 * 1024 * 1024


@dataclass(frozen=True)
class Box:
    """kind is "full", or "none" when the instructor trusts the submission."""

    kind: str

    def to_run(self, program: Path) -> list[str]:
        """The command that runs a statically linked program: it sees itself alone, read-only,
        and may make the system calls of the filter alone."""
        if self.kind == "none":
            return [str(program)]
        opened = ["/bin/sh", "-c", 'exec "$@" 5<"$0"', str(FILTER)]
        command = [*_bubblewrap(), "--seccomp", "5", "--ro-bind", str(program), "/runner"]
        return [*opened, *command, "--remount-ro", "/", "--", "/runner"]

    def to_build(self, folder: Path, visible: list[Path]) -> list[str]:
        """A prefix for the toolchain in `folder`, which it can read; it can write to /tmp alone."""
        if self.kind == "none":
            return []
        command = _bubblewrap()
        for place in TOOLCHAIN:
            command += ["--ro-bind-try", place, place]
        for link in ("bin", "lib", "lib64"):
            command += ["--symlink", f"usr/{link}", f"/{link}"]
        command += [*_bounded(), "--tmpfs", "/tmp", "--dev-bind", "/dev/null", "/dev/null"]
        for path in [folder, *visible]:
            command += ["--ro-bind", str(path), str(path)]
        return [*command, "--setenv", "PATH", "/usr/bin", "--chdir", str(folder), "--"]


def choose(trust: bool) -> Box:
    """The full box; none, where it can't be had and the submission is trusted."""
    full = Box("full")
    problem = _problem(full)
    if problem is None:
        return full
    if trust:
        return Box("none")
    raise KitError(
        f"no box can be had here ({problem}); install bubblewrap where user namespaces are "
        "allowed, or pass --trust-submission for code that you would run yourself"
    )


def _problem(box: Box) -> str | None:
    """Why the box doesn't hold a program that is known to be good; None when it does."""
    if which("bwrap") is None:
        return "bubblewrap isn't installed"
    limits = processes.Limits(cpu_seconds=5, wall_seconds=20, memory=1 << 30, file_size=0)
    tried = processes.run(box.to_run(REFERENCE_RUNNER), limits)
    return None if tried.ok else tried.err.strip().splitlines()[-1] if tried.err else "it ended"


@cache
def _options() -> str:
    return processes.run(["/usr/bin/bwrap", "--help"]).out.decode()


def _bounded() -> list[str]:
    return ["--size", str(TEMPORARY)] if "--size" in _options() else []


def _bubblewrap() -> list[str]:
    command = [
        "/usr/bin/bwrap",
        *("--unshare-user", "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts"),
        *("--die-with-parent", "--new-session", "--clearenv", "--hostname", "box"),
        *("--uid", NOBODY, "--gid", NOBODY, "--cap-drop", "ALL"),
    ]
    return command + (["--disable-userns"] if "--disable-userns" in _options() else [])
