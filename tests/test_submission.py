"""What is taken from a submission, and what every odd one is told."""

import os
import zipfile
from pathlib import Path

import pytest
from bounce_grader import intake, submission
from bounce_grader.errors import UsageError
from conftest import solution_files, write

PARTS = {f"{stem}.cpp" for stem in ("part1_contacts", "part2_lcp", "part3_step", "part4_simulate")}


def zip_of(path: Path, files: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return path


def refusal(path: Path) -> str:
    with pytest.raises(UsageError) as refused:
        submission.read(path)
    sentence = str(refused.value)
    assert "\n" not in sentence
    return sentence


def test_takes_the_four_parts_of_a_folder(tmp_path: Path) -> None:
    taken = submission.read(write(tmp_path, solution_files()))
    assert set(taken.files) == PARTS and set(taken.parts) == {1, 2, 3, 4}


def test_a_zip_gives_the_same_as_its_folder(tmp_path: Path) -> None:
    folder = submission.read(write(tmp_path / "folder", solution_files()))
    for inside in ("", "my homework/", "a/b/"):
        files = {inside + name: text for name, text in solution_files().items()}
        zipped = submission.read(zip_of(tmp_path / "x.zip", files))
        assert zipped.parts.keys() == folder.parts.keys()
        assert sorted(zipped.files.values()) == sorted(folder.files.values())


def test_the_name_of_a_submission_is_its_content(tmp_path: Path) -> None:
    first = submission.read(write(tmp_path / "a", solution_files()))
    again = submission.read(write(tmp_path / "b", solution_files()))
    other = submission.read(write(tmp_path / "c", {**solution_files(), "part2_lcp.cpp": b"\n"}))
    assert first.sha256 == again.sha256 != other.sha256


def test_helpers_are_taken_and_what_the_kit_gives_is_not(tmp_path: Path) -> None:
    extra = {
        "src/helpers/rotation.cpp": b"int one();",
        "src/helpers/rotation.hpp": b"#pragma once",
        "include/bounce/types.hpp": b"#error not the kit's",
        "given/solve_lcp.cpp": b"#error not the kit's",
        "main.cpp": b"int main() {}",
        "CMakeLists.txt": b"message(FATAL_ERROR)",
        "src/part1_contacts.o": b"\x7fELF",
        "libstudent.a": b"!<arch>",
        "evil.so": b"\x7fELF",
        "bounce/types.hpp.gch": b"gpch",
        "build/CMakeFiles/part1_contacts.cpp": b"#error a stale copy",
        "__MACOSX/._part1_contacts.cpp": b"\0\5\x16\7",
    }
    files = {f"src/{name}": text for name, text in solution_files().items()}
    taken = submission.read(write(tmp_path, {**files, **extra}))
    helpers = {"src/helpers/rotation.cpp", "src/helpers/rotation.hpp"}
    assert set(taken.files) == {f"src/{name}" for name in PARTS} | helpers
    assert taken.helpers == ["src/helpers/rotation.cpp"]
    assert set(taken.ignored) == set(extra) - helpers


def test_the_part_nearest_to_the_top_counts(tmp_path: Path) -> None:
    old = {"old/part1_contacts.cpp": b"// last week's"}
    taken = submission.read(write(tmp_path, {**solution_files(), **old}))
    assert taken.parts[1] == "part1_contacts.cpp"
    assert "old/part1_contacts.cpp" in taken.ignored


def test_two_candidates_for_a_part_are_refused_by_name(tmp_path: Path) -> None:
    files = {"a/part1_contacts.cpp": b"", "b/part1_contacts.cpp": b""}
    sentence = refusal(write(tmp_path, files))
    assert "a/part1_contacts.cpp, b/part1_contacts.cpp" in sentence and "keep one" in sentence


def test_a_missing_path_is_said(tmp_path: Path) -> None:
    assert "there is no file or folder" in refusal(tmp_path / "nowhere")


def test_an_empty_folder_is_said(tmp_path: Path) -> None:
    assert "is empty" in refusal(tmp_path)


def test_a_file_that_is_neither_is_said(tmp_path: Path) -> None:
    path = tmp_path / "part1_contacts.cpp"
    path.write_text("int x;")
    assert "neither a folder nor a zip" in refusal(path)


def test_a_broken_zip_is_said(tmp_path: Path) -> None:
    path = tmp_path / "x.zip"
    path.write_bytes(b"PK\x03\x04 and then nothing")
    assert "broken" in refusal(path)
    zip_of(path, solution_files())
    data = bytearray(path.read_bytes())
    data[60:90] = bytes(30)  # inside the first entry's compressed bytes
    path.write_bytes(data)
    assert "broken" in refusal(path)


def test_an_encrypted_zip_is_said(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b"int x;"})
    data = bytearray(path.read_bytes())
    for header, flags in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        data[data.index(header) + flags] |= 1
    path.write_bytes(data)
    assert "encrypted" in refusal(path)


@pytest.mark.parametrize(
    "name", ["/etc/x.cpp", "../x.cpp", "a/../../x.cpp", "..\\x.cpp", "C:/x.cpp"]
)
def test_an_entry_that_points_outside_is_refused(tmp_path: Path, name: str) -> None:
    assert "outside" in refusal(zip_of(tmp_path / "x.zip", {name: b"int x;"}))


def test_a_bomb_is_refused_without_unpacking_it(tmp_path: Path) -> None:
    bomb = {f"helper{i}.cpp": b" " * intake.LARGEST_SOURCE for i in range(64)}
    assert "submit the four parts" in refusal(zip_of(tmp_path / "x.zip", bomb))


def test_too_many_files_are_refused(tmp_path: Path) -> None:
    files = {f"{i}.txt": b"" for i in range(intake.MOST_ENTRIES + 1)}
    assert "more than" in refusal(zip_of(tmp_path / "x.zip", files))


def test_a_zip_that_lies_about_a_size_is_no_source(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b" " * 2 * intake.LARGEST_SOURCE})
    data = bytearray(path.read_bytes())
    for header, size in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        at = data.index(header) + size
        data[at : at + 4] = (100).to_bytes(4, "little")
    path.write_bytes(data)
    taken = None
    try:
        taken = submission.read(path)
    except UsageError as refused:
        assert "broken" in str(refused)
    assert taken is None or 1 not in taken.parts or len(taken.files[taken.parts[1]]) <= 100


def test_links_are_never_followed(tmp_path: Path) -> None:
    secret = tmp_path / "secret.cpp"
    secret.write_text("a secret")
    folder = write(tmp_path / "submission", solution_files())
    (folder / "helper.cpp").symlink_to(secret)
    os.mkfifo(folder / "pipe.cpp")
    archive = zipfile.ZipInfo("part1_contacts.cpp")
    archive.external_attr = 0o120777 << 16
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as out:
        out.writestr(archive, str(secret))
        out.writestr("part2_lcp.cpp", "int x;")
    assert {"helper.cpp", "pipe.cpp"} <= set(submission.read(folder).ignored)
    assert set(submission.read(tmp_path / "x.zip").parts) == {2}


def test_a_huge_part_is_refused_and_the_others_stay(tmp_path: Path) -> None:
    folder = write(tmp_path, solution_files())
    with (folder / "part2_lcp.cpp").open("wb") as stream:
        stream.truncate(1_000_000_000)
    taken = submission.read(folder)
    assert set(taken.parts) == {1, 3, 4}
    assert taken.refused[2] == "part2_lcp.cpp is 1.0 GB large; a source file may have 1 MB"


def test_utf16_is_read_and_binary_is_refused(tmp_path: Path) -> None:
    text = "// Höhe\nint x;\n"
    files = {"part1_contacts.cpp": text.encode("utf-16"), "part2_lcp.cpp": b"int\0x;"}
    taken = submission.read(write(tmp_path, files))
    assert taken.files["part1_contacts.cpp"].decode() == text
    assert "isn't a text file" in taken.refused[2]
