"""Several parts compiled by one start of clang, which saves the others.

Each is still compiled by itself, and its object is the one that it would get alone: it is kept
under the same name. Only files take part that can neither change how the compiler reads the next
one nor read another that they don't name. What doesn't come about here is compiled alone.
"""

import hashlib
import os
import re
from pathlib import Path

from bounce_grader import compiler, kept
from bounce_grader.box import Box
from bounce_grader.paths import SOURCES
from bounce_grader.side_by_side import each
from bounce_grader.submission import Submission

# Other directives than these, and what may be one that isn't seen as such; what asks for files; and
# the assembler, which includes them.
APART = re.compile(
    rb"#(?!\s*(?:include\s*[<\"]|define\b|undef\b|if|el|endif\b|pragma\s+once\b))"
    rb"|%:|\\\s*\n|_Pragma|__has_include|asm"
)

# Where an ELF file of 64 bits says at which byte its section headers stand, and how many of which
# size: LLVM writes them last.
HEADERS = ((40, 48), (58, 60), (60, 62))


def compile_missing(submission: Submission, work: Path, box: Box, jobs: int) -> None:
    """Leaves objects of the parts that have none yet among those that are kept."""
    needed = {file: kept.needed(file, submission) for file in submission.parts.values()}
    names = {f: kept.name_of(f, needed[f], submission, box, timed=False) for f in needed}
    missing = [file for file in names if not kept.is_there(kept.place(names[file]))]
    if any(map(APART.search, submission.files.values())):
        return
    alike: dict[str, list[str]] = {}  # by the precompiled header
    for file in missing:
        alike.setdefault(compiler.header_of(needed[file], submission), []).append(file)
    groups = [(h, files[i::jobs]) for h, files in alike.items() for i in range(jobs) if files[i:]]

    def fill_in(group: tuple[str, list[str]]) -> None:
        for file, data in zip(group[1], _objects(*group, submission, work, box)):
            kept.store(data, kept.place(names[file]))

    each(fill_in, groups, jobs)


def _objects(
    header: str, group: list[str], submission: Submission, work: Path, box: Box
) -> list[bytes]:
    """One for each file; or none, where there is anything wrong with one of them."""
    folder = work / f"{SOURCES}-{hashlib.sha256(os.fsencode(str(group))).hexdigest()[:16]}"
    submission.write_to(folder, {n for file in group for n in kept.needed(file, submission)})
    box.give(folder)
    command = compiler.clang_of_many(group, submission, folder, header)
    result = compiler.run(command, folder, box)
    objects = apart(result.out) if result.ok else []
    return objects if len(objects) == len(group) else []


def apart(row: bytes) -> list[bytes]:
    """The objects in a row of them; none where it is something else."""
    objects: list[bytes] = []
    while row:
        if row[:6] != b"\x7fELF\2\1":
            return []
        offset, size, number = (int.from_bytes(row[a:b], "little") for a, b in HEADERS)
        end = offset + size * number
        if not 64 <= end <= len(row):
            return []
        objects.append(row[:end])
        row = row[end:]
    return objects
