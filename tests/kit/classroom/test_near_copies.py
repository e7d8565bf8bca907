"""Near-copies in a class with submissions that take long to compare."""

import random
import time
from pathlib import Path

import pytest
from bounce_grader.classroom.intake import handed_in, students
from bounce_grader.classroom.intake.canvas import Upload
from bounce_grader.classroom.work import near_copies
from bounce_grader.classroom.work.near_copies import Similar
from bounce_grader.classroom.work.task import task_of
from bounce_grader.submission.submission import Submission
from classes import grade_class
from conftest import solution_files
from downloads import STAMP, download
from odd_students import repetitive


def compared(source: Path, out: Path) -> Similar:
    found = students.read(source).students
    tasks = {s.id: task_of(s, STAMP, out, False, False) for s in found}
    return near_copies.find(out, found, tasks, trust=False)


def class_with(path: Path, odd: list[bytes]) -> Path:
    """A class of two students who copied, and these."""
    text = solution_files()["part3_step.cpp"]
    entries = {f"doe_{user}_{user}_part3_step.cpp": text for user in (1, 2)}
    entries |= {f"roe_{user}_{user}_part3_step.cpp": text for user, text in enumerate(odd, 3)}
    return download(path, entries)


@pytest.mark.parametrize(
    "unit", [b"{", *(pytest.param(u, marks=pytest.mark.long) for u in (b"x;\n", b"if(a){b;}\n"))]
)
def test_what_repeats_itself_is_left_out_and_costs_no_other_pair(
    tmp_path: Path, unit: bytes
) -> None:
    source = class_with(tmp_path / "x.zip", [repetitive(60_000, unit)] * 6)
    start = time.monotonic()
    near = compared(source, tmp_path)
    assert time.monotonic() - start < 60
    assert not near.problem
    assert [(pair.first, pair.second, pair.share) for pair in near.pairs] == [("1", "2", 100)]
    assert set(near.incomplete) == {str(user) for user in range(3, 9)}
    assert compared(source, tmp_path) == near


SOLVED = solution_files()["part3_step.cpp"]


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


@pytest.mark.parametrize("how", HIDDEN)
@pytest.mark.usual(2)
def test_nothing_hides_a_copy(tmp_path: Path, how: str) -> None:
    before, after = HIDDEN[how]
    near = compared(class_with(tmp_path / "x.zip", [before + SOLVED + after]), tmp_path)
    assert ("1", "3") in {(pair.first, pair.second) for pair in near.pairs}
    assert not near.incomplete


def test_who_is_compared_only_in_part_is_named(tmp_path: Path) -> None:
    words = random.Random(1).choices("if for ( ) { } ; + * = x 1 return".split(), k=60_000)
    near = compared(class_with(tmp_path / "x.zip", [" ".join(words).encode()]), tmp_path)
    assert near.incomplete == {"3": near_copies.IN_PART}


@pytest.mark.parametrize(
    "unit", ["/*", 'R"x(', '\\"', "'", "#include<", "# ", "\\ ", "1'a", '"', "//", "__has_include("]
)
def test_comments_are_found_in_time_that_grows_with_the_text(unit: str) -> None:
    start = time.process_time()
    near_copies.code_of((unit * (200_000 // len(unit))).encode())
    assert time.process_time() - start < 5


def test_a_submission_is_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An archive may take seconds; one that can't be read isn't read again at all."""
    whole = handed_in.read
    read = []

    def counted(path: Path, uploads: tuple[Upload, ...]) -> Submission:
        read.append(uploads[0].user)
        return whole(path, uploads)

    monkeypatch.setattr(handed_in, "read", counted)
    source = class_with(tmp_path / "x.zip", [b"int x;\n"])
    assert not compared(source, tmp_path).problem
    in_the_digest = ["1", "2", "3"]
    assert sorted(read) == sorted(2 * in_the_digest)
    read.clear()
    broken = {"doe_1_1_part3_step.cpp": b"int x;\n", "roe_2_2_hw.zip": bytes(1000)}
    assert grade_class(download(tmp_path / "y.zip", broken), tmp_path / "out") == 0
    assert sorted(read) == ["1", "1", "2"]  # the gradings read in processes of their own


def test_who_is_left_out_needs_a_look(tmp_path: Path) -> None:
    source, out = class_with(tmp_path / "x.zip", [repetitive(60_000)]), tmp_path / "out"
    assert grade_class(source, out) == 0
    page = (out / "class.html").read_text()
    looks, near = page.split("<h2>Needs a look")[1].split("<h2>Near-copies")
    assert looks.index("<h2>Not graded, not matched") < looks.index("<h2>Points")
    assert "roe (3)</td><td>it repeats itself too much to be compared" in looks
    assert "Not compared, or only in part: roe (3). Needs a look" in near
    assert "it repeats itself" in (out / "grades.csv").read_text()


def test_a_damaged_download_of_another_year_costs_no_grades(tmp_path: Path) -> None:
    """What can be seen of it at once is said at once; an archive is read when it is compared."""
    source, out = class_with(tmp_path / "x.zip", []), tmp_path / "out"
    old = download(tmp_path / "2025.zip", {"doe_1_1_hw.zip": bytes(1000)})
    text = old.read_bytes()
    old.write_bytes(text.replace(bytes(100), b"x" * 100, 1))
    assert grade_class(source, out, corpus=(old,)) == 0
    assert "is damaged" in (out / "class.html").read_text()
    assert len((out / "grades.csv").read_text().splitlines()) == 3
