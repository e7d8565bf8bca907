"""The handout, as a student has it."""

import zipfile
from pathlib import Path

from bounce_grader.publish import handout


def unzipped(folder: Path) -> Path:
    """Into the folder; gives the handout's own, which is in it."""
    handout.write(folder / "handout.zip")
    with zipfile.ZipFile(folder / "handout.zip") as archive:
        for entry in archive.infolist():
            path = Path(archive.extract(entry, folder))
            path.chmod(entry.external_attr >> 16 & 0o777)
    return folder / "bounce"
