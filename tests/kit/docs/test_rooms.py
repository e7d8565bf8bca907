"""The packages (rooms) of the grader: each declares what it may import, which is only packages that
stand above it in the table of docs/architecture.md."""

import ast
import re
from collections.abc import Iterator
from graphlib import TopologicalSorter

import pytest
from conftest import ROOT

PACKAGE = ROOT / "grader" / "bounce_grader"
ROOMS = sorted(
    str(folder.parent.relative_to(PACKAGE)).replace("/", ".")
    for folder in PACKAGE.rglob("__init__.py")
    if folder.parent != PACKAGE
)


def room_of(module: str) -> str:
    """The innermost room that a module is in; "" for the command itself."""
    within = [room for room in ROOMS if module == room or module.startswith(f"{room}.")]
    return max(within, key=len, default="")


def imported(room: str) -> Iterator[str]:
    for file in (PACKAGE / room.replace(".", "/")).glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(
                "bounce_grader."
            ):
                for name in node.names:
                    found = room_of(f"{node.module}.{name.name}".removeprefix("bounce_grader."))
                    if found != room:
                        yield found


def allowed(room: str) -> set[str]:
    """The imports that a room's docstring allows."""
    text = ast.get_docstring(
        ast.parse((PACKAGE / room.replace(".", "/") / "__init__.py").read_text())
    )
    listed = re.search(r"May import: ([^\n]*?)\.$", text or "", re.MULTILINE)
    assert listed, f"{room} doesn't say what it may import"
    return set() if listed[1] == "nothing of this package" else set(listed[1].split(", "))


@pytest.mark.parametrize("room", ROOMS)
def test_a_room_imports_what_it_says_and_nothing_else(room: str) -> None:
    assert set(imported(room)) == allowed(room)


def test_imports_run_one_way() -> None:
    order = [name for name in rows("docs/architecture.md", "The folders") if name in ROOMS]
    for room in ROOMS:
        above = order[: order.index(room.split(".")[0]) + 1]
        assert {other.split(".")[0] for other in imported(room)} <= set(above), room
    TopologicalSorter({room: set(imported(room)) for room in ROOMS}).prepare()  # no cycle


def rows(page: str, heading: str) -> dict[str, str]:
    """The folders in a page's tables below a heading, with their descriptions."""
    text = (ROOT / page).read_text().split(f"## {heading}\n")[1].split("\n## ")[0]
    return dict(re.findall(r"^\| `([a-z_/]+)/` \| (.+) \|$", text, re.MULTILINE))
