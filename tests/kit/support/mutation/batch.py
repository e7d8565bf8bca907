"""Many changes of a part in one object, since to compile each by itself takes minutes.

Each changed function stands in a namespace of its own, in which calls find the other parts as they
do in the file itself. The part's function calls the one whose number is the program's last
argument. Compiler and flags are those of a submission.
"""

import hashlib
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.build.compiler import compiler
from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import CACHE, CONTRACT, RUNNER
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import Box

from mutation.changes import Change

COMPILE = processes.Limits(600, 3600, 8 << 30, file_size=64 << 20, output=64 << 20, errors=64 << 20)
NAMESPACE = "namespace bounce {"
MOST_ROUNDS = 20

CHOICE = """
#line 1 "choice"
#include <cstdlib>
namespace bounce {{
namespace {{
int chosen = 0;
[[gnu::constructor]] void choose(int argc, char** argv) {{ chosen = std::atoi(argv[argc - 1]); }}
}}
{signature} {{
  switch (chosen) {{
{cases}
  }}
  std::abort();
}}
}}
"""


@dataclass(frozen=True)
class Batch:
    """An object in which each of these changes is chosen by its place in the list."""

    object: Path
    changes: tuple[Change, ...]


def compiled(changes: list[Change], box: Box) -> Batch:
    """The changes of one file that compile, in one object."""
    left = list(changes)
    for _ in range(MOST_ROUNDS):
        refused = _refused(left, box)
        if not refused:
            return Batch(_object(left, box), tuple(left))
        left = [change for number, change in enumerate(left) if number not in refused]
    raise KitError("the compiler refuses one change after the other")


def _text(changes: list[Change]) -> str:
    """The first of a file's changes gives the includes, and the signature, which none changes."""
    includes, _ = changes[0].text.split(NAMESPACE)
    parts = [includes]
    for number, change in enumerate(changes):
        _, function = change.text.split(NAMESPACE)
        parts.append(f'#line 1 "change_{number}"\nnamespace bounce::change_{number} {{{function}')
    found = re.search(r"^\w+ (\w+)\((.*)\)(?= \{)", function, re.MULTILINE)
    assert found
    arguments = ", ".join(re.findall(r"(\w+)(?:,|$)", found.group(2)))
    called = f"{found.group(1)}({arguments})"
    cases = [f"    case {n}: return change_{n}::{called};" for n in range(len(changes))]
    return "".join(parts) + CHOICE.format(signature=found.group(), cases="\n".join(cases))


def _run(changes: list[Change], box: Box, *flags: str) -> processes.Result:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "batch.cpp").write_text(_text(changes))
        folder.chmod(0o755)
        box.give(folder)
        command = [compiler(), f"@{RUNNER / 'clang_flags.txt'}", "-ferror-limit=0", *flags]
        command += ["-include-pch", str(RUNNER / "prelude.pch"), "batch.cpp"]
        built = [*box.to_build(folder, [CONTRACT, RUNNER]), *command]
        return processes.run(built, COMPILE, cwd=folder)


def _refused(changes: list[Change], box: Box) -> set[int]:
    """The numbers of those in which the compiler finds an error, or for which it meets one in a
    header. Of several changes with the same error in a header it may name the first alone, and
    of some errors in a header it doesn't say where they come from."""
    result = _run(changes, box, "-fsyntax-only")
    if result.ok:
        return set()
    blocks = re.split(r"^(?=.*: (?:fatal )?error: )", result.err, flags=re.MULTILINE)[1:]
    places = (re.search(r"^change_(\d+):", block, re.MULTILINE) for block in blocks)
    refused = {int(place.group(1)) for place in places if place}
    if not refused:
        raise KitError(f"an error is in none of the changes: {result.err[:1000]}")
    return refused


def _object(changes: list[Change], box: Box) -> Path:
    digest = hashlib.sha256(_text(changes).encode() + (RUNNER / "prelude.pch").read_bytes())
    path = CACHE / digest.hexdigest()[:2] / digest.hexdigest()[2:]
    if not path.exists():
        result = _run(changes, box, "-c", "-o", "-")
        if not result.ok:
            raise KitError(f"a batch of changes can't be compiled: {result.err[:1000]}")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(result.out)
        path.chmod(0o644)
    return path
