"""docs/studies/peers.md, written from the tables beside it."""

from pathlib import Path


def page(folder: Path) -> str:
    return f"# Peers\n\n{folder.name}\n"
