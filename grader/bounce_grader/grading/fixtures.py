"""Writes the fixtures: public ones, and hidden ones made from the course secret. Committed are the
public ones, and the hidden ones of a course that has set no secret."""

import hashlib
import tempfile
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import BUILD, FIXTURES, SECRET
from bounce_grader.sandbox import processes

PUBLIC = FIXTURES / "public"
HIDDEN = FIXTURES / "hidden"
DEFAULT = FIXTURES / "default" / "hidden"  # the judge takes a folder of this name for hidden ones
WRITER = BUILD / "write_fixtures"
DEFAULT_SECRET = "the secret of a course that has set none"
LIMITS = processes.Limits(cpu_seconds=120, wall_seconds=600, memory=4 << 30, file_size=64 << 20)


def secret() -> str:
    """The course's secret, from the file course-secret; without that file, a default."""
    return SECRET.read_text().strip() if SECRET.exists() else DEFAULT_SECRET


def write(kind: str, folder: Path, secret: str = DEFAULT_SECRET) -> None:
    """Writes a set, "public" or "hidden", from a secret. It replaces each file at once, so that a
    concurrent grading never reads half of one."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder) as name:
        result = processes.run([str(WRITER), kind, name], LIMITS, stdin=secret.encode())
        if not result.ok:
            raise KitError(f"the {kind} fixtures can't be written: {result.err.strip()}")
        for file in Path(name).iterdir():
            file.replace(folder / file.name)


def hidden_folder() -> Path:
    """The folder of the hidden fixtures. Those of a course's own secret are written again if the
    secret or the program that writes them has changed."""
    if not SECRET.exists():
        return DEFAULT
    stamp = hashlib.sha256(secret().encode() + WRITER.read_bytes()).hexdigest()
    noted = HIDDEN / "made-from"
    if not noted.exists() or noted.read_text() != stamp:
        HIDDEN.mkdir(mode=0o700, exist_ok=True)
        write("hidden", HIDDEN, secret())
        noted.write_text(stamp)
    return HIDDEN
