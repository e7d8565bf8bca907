"""./kit study simulate: the motion of a scene within a tolerance."""

import json
import os
import sys
from pathlib import Path
from typing import Any

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD
from bounce_grader.sandbox import processes
from bounce_study.numbers import short

PROGRAM = BUILD / "bounce_study"
REFUSED = 1


def simulate(scene: Path, tolerance: str, out: Path | None) -> int:
    """Writes the motion to `out` and says how it was had. Returns 1, with the reason and the
    horizon on standard error, if it can't be had within the tolerance."""
    command = [str(PROGRAM), "simulate", os.path.abspath(scene), tolerance]
    done = processes.run(command)
    if not done.ok:
        message = done.err.strip().removeprefix("bounce_study: ") or f"status {done.code}"
        if done.code == REFUSED:
            print(f"kit: {message}", file=sys.stderr)
            return REFUSED
        raise (UsageError if done.code == 2 else KitError)(message)
    if out is not None:
        try:
            write_whole(out, done.out)
        except OSError as error:
            raise UsageError(f"{out} can't be written: {error.strerror}") from error
    print(_sentence(json.loads(done.out)))
    return 0


def _sentence(answer: dict[str, Any]) -> str:
    step = f", step {short(answer['step'])} s" if answer["step"] else ""
    return (
        f"{answer['method']}{step}: within {short(answer['bound'])} m up to "
        f"{answer['horizon']:g} s, in {short(1e6 * answer['seconds'])} µs"
    )
