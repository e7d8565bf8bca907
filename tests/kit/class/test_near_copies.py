"""Near-copies: what is found however it is hidden, what isn't one, and who can't be compared."""

import random
import re
import time
from collections.abc import Sequence
from pathlib import Path

from bounce_grader.classroom.grading import near_copies
from bounce_grader.classroom.grading.near_copies import Similar
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import students
from bounce_grader.common.paths import STUBS
from conftest import ROOT, solution_files, write
from odd_students import repetitive

Files = dict[str, bytes]
SOLUTION = solution_files()
STEP = SOLUTION["part3_step.cpp"]


def summaries_of(folder: Path, submissions: Sequence[Files]) -> list[Summary]:
    """Of a class whose students are called 1, 2 and so on."""
    for number, files in enumerate(submissions, 1):
        write(folder / "all" / str(number), files)
    return [Summary(student, "graded") for student in students.read(folder / "all").students]


def compared(tmp_path: Path, submissions: Sequence[Files]) -> Similar:
    return near_copies.find(summaries_of(tmp_path, submissions))


def step(*texts: bytes) -> list[Files]:
    """Two students with the solution's part 3, and these."""
    return [{"part3_step.cpp": text} for text in (STEP, STEP, *texts)]


def pairs(near: Similar) -> set[tuple[str, str]]:
    return {(pair.first, pair.second) for pair in near.pairs}


def renamed(text: bytes) -> bytes:
    """Disguises a copy: other names, other comments, another layout."""
    for name in (b"corner", b"params", b"lowest", b"impulse", b"contact_"):
        text = re.sub(rb"\b" + name + rb"\b", b"my_" + name[::-1], text)
    return b"// my own work\n\n" + text.replace(b"\n", b"\n\n")


COPY = {name: renamed(text) for name, text in SOLUTION.items()}


def test_a_renamed_copy_is_found_and_the_handout_is_no_copy(tmp_path: Path) -> None:
    """Two students who left the stubs unchanged share nothing of their own."""
    stubs = {file.name: file.read_bytes() for file in STUBS.glob("*.cpp")}
    near = compared(tmp_path, [SOLUTION, COPY, stubs, stubs])
    assert pairs(near) == {("1", "2")} and near.pairs[0].share >= 90


def test_copies_of_another_year_and_of_two_parts_are_found(tmp_path: Path) -> None:
    """One has handed in last year's; another has two parts of somebody's, and two of their own."""
    own = ("corner_in_closed_form/part1_contacts.cpp", "lcp_entry_by_entry/part2_lcp.cpp")
    others = [ROOT / "tests/submissions/accepted" / path for path in own]
    other = {path.name: path.read_bytes() for path in others}
    last_year = write(tmp_path / "2025" / "old", COPY).parent
    write(last_year / "older", COPY)
    summaries = summaries_of(tmp_path, [SOLUTION, {**COPY, **other}])
    near = near_copies.find(summaries, near_copies.corpus(last_year))
    assert ("1", "2025/old") in pairs(near) and {"1", "2"} <= {id for p in pairs(near) for id in p}
    assert not any(pair.first.startswith("2025") for pair in near.pairs)


def code(seed: int, size: int) -> bytes:
    words = "if for while ( ) { } [ ] ; , + - * / = < x 1 return double".split()
    return " ".join(random.Random(seed).choices(words, k=size)).encode()


def test_what_a_whole_class_has_in_common_is_no_copy(tmp_path: Path) -> None:
    """As from an exercise of before: two thirds of each program."""
    shared = [{"part3_step.cpp": code(0, 400) + code(n, 200)} for n in range(1, 7)]
    near = compared(tmp_path, shared)
    assert not near.pairs and 50 < near.usual < 80


HIDDEN = {  # how a copy is hidden, as text before and after it
    "a long comment": (b"/*" + b"x y " * 16_500 + b"*/\n", b""),
    "many comments": (b"// x y z\n" * 8_000, b""),
    "blanks": (b" " * 70_000 + b"\n" * 70_000, b""),
    "a comment that goes on": (b"// x \\\ny /*\n", b"// */\n"),
    "a string": (b'const char* s = "/*";\n', b'const char* t = "*/";\n'),
    "a header's name": (b"#if __has_include(</*>)\n#endif\n", b"// */\n"),
    "digits apart": (b"const int n = 1'000; const char c = '\"';\n", b"// \"'\n"),
    "a raw string": (b'auto r = R"x(" /* )x";\n', b'auto s = R"(*/)";\n'),
}


def test_nothing_hides_a_copy(tmp_path: Path) -> None:
    for number, (how, (before, after)) in enumerate(HIDDEN.items()):
        summaries = summaries_of(tmp_path / str(number), step(before + STEP + after))
        assert ("1", "3") in pairs(near_copies.find(summaries)), how
        assert not any(summary.notes for summary in summaries), how


def test_who_is_compared_only_in_part_is_named(tmp_path: Path) -> None:
    words = random.Random(1).choices("if for ( ) { } ; + * = x 1 return".split(), k=60_000)
    summaries = summaries_of(tmp_path, step(" ".join(words).encode()))
    near_copies.find(summaries)
    assert [set(summary.notes) for summary in summaries] == [set(), set(), {near_copies.IN_PART}]


def test_what_repeats_itself_is_compared_as_quickly(tmp_path: Path) -> None:
    """However long it is, and whatever it repeats."""
    units = (b"{", b"x;\n", b"if(a){b;}\n", b"/*", b"'", b"1'")
    start = time.process_time()
    near = compared(tmp_path, step(*(repetitive(60_000, unit) for unit in units)))
    assert ("1", "2") in pairs(near) and time.process_time() - start < 5
