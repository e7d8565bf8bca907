"""What is taken from a submission, and what every odd one is told."""

import os
import resource
import shutil
import subprocess
import sys
import time
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import corpus
import pytest
from bounce_grader import entry, intake, submission
from bounce_grader.errors import UsageError
from conftest import ROOT, solution_files, write

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


HELPERS = {"helpers/rotation.cpp", "helpers/rotation.hpp", "methods/rotation.hpp"}


def test_helpers_are_taken_and_what_the_kit_gives_is_not(tmp_path: Path) -> None:
    extra = {
        "src/helpers/rotation.cpp": b"int one();",
        "src/helpers/rotation.hpp": b"#pragma once",
        "src/methods/rotation.hpp": b"#pragma once",
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
    helpers = {f"src/{name}" for name in HELPERS}
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


@pytest.mark.parametrize("copy", ["part1_contacts (1).cpp", "part1_contacts-1.cpp"])
def test_a_part_under_the_name_of_a_copy_is_taken_where_it_is_the_only_one(
    tmp_path: Path, copy: str
) -> None:
    taken = submission.read(write(tmp_path / "one", {f"a/{copy}": b"// x"}))
    assert taken.parts == {1: copy} and not taken.ignored
    both = write(tmp_path / "both", {copy: b"no C++", "part1_contacts.cpp": b"// x"})
    taken = submission.read(both)
    assert taken.parts == {1: "part1_contacts.cpp"} and taken.ignored == (copy,)
    assert not taken.helpers


def test_two_copies_without_the_part_itself_are_refused(tmp_path: Path) -> None:
    copies = {f"part2_lcp-{number}.cpp": b"// x" for number in (1, 2)}
    assert "part2_lcp.cpp is there 2 times" in refusal(write(tmp_path, copies))


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
    bomb = {f"helper{i}.cpp": b" " * entry.LARGEST_SOURCE for i in range(64)}
    assert "submit the four parts" in refusal(zip_of(tmp_path / "x.zip", bomb))


def test_too_many_files_are_refused(tmp_path: Path) -> None:
    files = {f"{i}.txt": b"" for i in range(entry.MOST_ENTRIES + 1)}
    assert "more than" in refusal(zip_of(tmp_path / "x.zip", files))


def test_a_zip_that_lies_about_a_size_is_no_source(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b" " * 2 * entry.LARGEST_SOURCE})
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


def test_a_long_name_in_an_error_is_cut_and_moves_no_cursor(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "bounce_grader", "grade", f"{tmp_path}/\x1b[2J\n::error::x\udcff"],
        env={**os.environ, "PYTHONPATH": str(ROOT / "grader")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith("kit: there is no file or folder")
    assert "\x1b" not in done.stderr and "\n::" not in done.stderr


# --- zips as other programs write them, and as nobody should ---


def test_a_mac_zip_of_a_folder_is_read(tmp_path: Path) -> None:
    files = {f"hw/{name}": text for name, text in solution_files().items()}
    mac = {f"__MACOSX/hw/._{name}": b"\0\5\x16\7" for name in PARTS}
    taken = submission.read(zip_of(tmp_path / "x.zip", {**files, **mac, "hw/.DS_Store": b"\0"}))
    assert set(taken.files) == PARTS and set(taken.ignored) == {*mac, ".DS_Store"}


def test_a_part_named_in_capitals_is_taken(tmp_path: Path) -> None:
    taken = submission.read(write(tmp_path, {"PART1_CONTACTS.CPP": b"int x;", "H.CPP": b""}))
    assert taken.parts == {1: "PART1_CONTACTS.CPP"} and taken.helpers == ["H.CPP"]


def test_a_zip_written_as_a_stream_is_read(tmp_path: Path) -> None:
    """Sizes follow the data, in a descriptor, as Java and macOS write it; and as zip64."""
    (tmp_path / "x.zip").write_bytes(corpus.streamed({"part1_contacts.cpp": b"int x;"}))
    assert submission.read(tmp_path / "x.zip").files == {"part1_contacts.cpp": b"int x;"}
    (tmp_path / "x.zip").write_bytes(corpus.zip64({"part1_contacts.cpp": b"int x;"}))
    assert submission.read(tmp_path / "x.zip").files == {"part1_contacts.cpp": b"int x;"}


@pytest.mark.parametrize("again", ["a//x.cpp", "a/./x.cpp", "./a/x.cpp", "a\\x.cpp"])
def test_one_name_spelled_in_two_ways_is_refused(tmp_path: Path, again: str) -> None:
    files = {"a/x.cpp": b"int a;", again: b"int b;"}
    assert "two entries of the same name" in refusal(zip_of(tmp_path / "x.zip", files))


def test_a_file_that_is_a_folder_too_is_refused(tmp_path: Path) -> None:
    files = {"part1_contacts.cpp": b"", "a.hpp": b"", "a.hpp/b/c.hpp": b""}
    assert "a.hpp as a file and as a folder" in refusal(zip_of(tmp_path / "x.zip", files))


@pytest.mark.parametrize("name", ["\0x.cpp", ".", "./."])
def test_an_entry_without_a_name_is_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / "x.zip").write_bytes(corpus.renamed(name))
    assert "without a name" in refusal(tmp_path / "x.zip")


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_an_unusual_compression_is_refused(tmp_path: Path, method: int) -> None:
    """LZMA allocates what its header asks for: 4 GB for one byte."""
    with zipfile.ZipFile(tmp_path / "x.zip", "w", method) as archive:
        archive.writestr("part1_contacts.cpp", "int x;")
    assert "unusual" in refusal(tmp_path / "x.zip")


def test_a_table_of_contents_without_end_is_not_read(tmp_path: Path) -> None:
    """65,535 entries, as many as a zip without zip64 can have."""
    (tmp_path / "x.zip").write_bytes(corpus.many_entries(65535))
    with limited_memory(64 << 20):
        assert "more than 5000 files" in refusal(tmp_path / "x.zip")


def test_entries_that_hold_one_another_are_read_no_further_than_the_limits(tmp_path: Path) -> None:
    (tmp_path / "x.zip").write_bytes(corpus.overlapping(90, entry.LARGEST_SOURCE // 2))
    start = time.process_time()
    sentence = refusal(tmp_path / "x.zip")
    assert "broken" in sentence or "8 MB" in sentence
    assert time.process_time() - start < 5


def test_what_cannot_be_used_counts_towards_the_limits(tmp_path: Path) -> None:
    """5000 sources that are no text: each would have to be unpacked to say so."""
    files = {f"{i}.cpp": b"\0" * 1000 for i in range(entry.MOST_ENTRIES)}
    assert "more than 100 sources" in refusal(zip_of(tmp_path / "x.zip", files))


def test_a_zip_inside_a_zip_is_not_opened(tmp_path: Path) -> None:
    inner = zip_of(tmp_path / "inner.zip", solution_files()).read_bytes()
    taken = submission.read(zip_of(tmp_path / "x.zip", {"inner.zip": inner}))
    assert taken.parts == {} and taken.ignored == ("inner.zip",)


@pytest.mark.parametrize(
    "name",
    ["-o.cpp", "@options.cpp", "a\nb.hpp", "\x1b[2J.cpp", "a\u202eppc.hpp", f"{'a' * 300}.cpp"]
    + ["/".join(["a"] * 200) + ".cpp"],
)
def test_a_name_that_could_mislead_a_compiler_or_a_reader_is_not_used(
    tmp_path: Path, name: str
) -> None:
    files = {**solution_files(), name: b"int x;"}
    taken = submission.read(zip_of(tmp_path / "x.zip", files))
    assert set(taken.files) == PARTS and taken.ignored == (name,)


def test_an_odd_blank_in_a_name_is_used_but_not_shown(tmp_path: Path) -> None:
    files = {"a\u00a0b/part1_contacts.cpp": b"", "a\u3000b/part1_contacts.cpp": b""}
    assert refusal(zip_of(tmp_path / "x.zip", files)).isprintable()
    del files["a\u3000b/part1_contacts.cpp"]
    taken = submission.read(zip_of(tmp_path / "x.zip", {**files, "README": b""}))
    assert taken.parts == {1: "a\u00a0b/part1_contacts.cpp"}


# --- folders that aren't what they seem ---


def test_a_name_that_is_no_utf8_is_not_used(tmp_path: Path) -> None:
    write(tmp_path, solution_files())
    (tmp_path / os.fsdecode(b"L\xf6sung.hpp")).write_bytes(b"")
    taken = submission.read(tmp_path)
    assert set(taken.files) == PARTS and len(taken.sha256) == 64
    assert taken.ignored == ("L\udcf6sung.hpp",)
    used = replace(taken, files={**taken.files, taken.ignored[0]: b""})
    assert len({taken.sha256, used.sha256, replace(used, files={}).sha256}) == 3


@pytest.mark.parametrize("path", ["/dev/zero", "/dev/null", "pipe"])
def test_a_device_or_a_pipe_is_not_opened(tmp_path: Path, path: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert "neither a folder nor a zip" in refusal(tmp_path / path)


def test_a_folder_of_folders_without_end_is_refused(tmp_path: Path) -> None:
    for i in range(entry.MOST_ENTRIES + 1):
        (tmp_path / f"{i}").mkdir()
    assert "more than" in refusal(tmp_path)


def test_a_very_deep_folder_is_read_to_a_depth(tmp_path: Path) -> None:
    write(tmp_path, solution_files())
    here = os.open(tmp_path, os.O_RDONLY)
    for _ in range(3000):  # deeper than a path can be long
        os.mkdir("d", dir_fd=here)
        below = os.open("d", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = below
    os.close(here)
    assert set(submission.read(tmp_path).files) == PARTS
    subprocess.run(["rm", "-rf", tmp_path / "d"], check=True)


def nothing_instead(path: Path) -> None:
    path.unlink()


def link_instead(path: Path) -> None:
    path.unlink()
    path.symlink_to("/etc/passwd")


def pipe_instead(path: Path) -> None:
    path.unlink()
    os.mkfifo(path)


def folder_link_instead(path: Path) -> None:
    elsewhere = path.parent.parent / "elsewhere"
    shutil.move(path.parent, elsewhere)
    path.parent.symlink_to(elsewhere)


def larger_instead(path: Path) -> None:
    path.write_bytes(b" " * 2 * entry.LARGEST_SOURCE)


CHANGES: list[Callable[[Path], None]] = [
    nothing_instead,
    link_instead,
    pipe_instead,
    folder_link_instead,
]


@pytest.mark.parametrize("change", CHANGES)
def test_a_folder_that_changes_while_it_is_read_leads_nowhere_else(
    tmp_path: Path, change: Callable[[Path], None]
) -> None:
    write(tmp_path / "x", {"src/part1_contacts.cpp": b"int x;", "README": b""})
    with intake.opened(tmp_path / "x") as entries:
        change(tmp_path / "x" / "src" / "part1_contacts.cpp")
        with pytest.raises(UsageError, match="src/part1_contacts.cpp can't be read: "):
            submission.take(tmp_path, entries)


def test_a_file_that_grows_while_it_is_read_is_no_source(tmp_path: Path) -> None:
    write(tmp_path, {"part1_contacts.cpp": b"int x;"})
    with intake.opened(tmp_path) as entries:
        larger_instead(tmp_path / "part1_contacts.cpp")
        assert "larger than it says" in submission.take(tmp_path, entries).refused[1]


def test_a_zip_that_is_replaced_while_it_is_read_stays_the_first_one(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b"int first;"})
    second = zip_of(tmp_path / "y.zip", {"part1_contacts.cpp": b"int second;"})
    with intake.opened(path) as entries:
        second.replace(path)
        assert submission.take(path, entries).files["part1_contacts.cpp"] == b"int first;"


@contextmanager
def limited_memory(more: int) -> Iterator[None]:
    """At most so many bytes more than this process has now."""
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    before = resource.getrlimit(resource.RLIMIT_AS)
    most = pages * resource.getpagesize() + more
    resource.setrlimit(resource.RLIMIT_AS, (most, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)
