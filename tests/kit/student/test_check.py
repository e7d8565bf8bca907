"""The handout as a student meets it: unzipped into an empty folder, and driven by ./check alone."""

import json
import os
import pty
import re
import shutil
import subprocess
import time
from pathlib import Path

import pytest
from conftest import ROOT, SOLUTION
from handed_out import unzipped

pytestmark = pytest.mark.xdist_group("student")

MISTAKES = ROOT / "tests/submissions/mistakes"
BROKEN = ROOT / "tests/submissions/broken"
UNDEFINED = ROOT / "tests/submissions/undefined"
SYSTEM = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "LANG": "C.UTF-8", "TERM": "xterm"}


def check(home: Path, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["./check", *arguments],
        cwd=home,
        env=SYSTEM | environment,
        capture_output=True,
        text=True,
        check=False,
    )


def timed(home: Path, *arguments: str) -> tuple[subprocess.CompletedProcess[str], float]:
    """Runs ./check, and returns its output and CPU time."""
    before = os.times()
    run = check(home, *arguments)
    after = os.times()
    return run, sum(after[2:4]) - sum(before[2:4])


def put(home: Path, *folders: Path) -> None:
    """The solution's parts, with some replaced. What is there already isn't built again."""
    files = {
        file.name: file for folder in (SOLUTION, *folders) for file in folder.glob("part*.cpp")
    }
    for name, file in files.items():
        there = home / "src" / name
        if not there.exists() or there.read_bytes() != file.read_bytes():
            there.write_bytes(file.read_bytes())


def score(run: subprocess.CompletedProcess[str]) -> str:
    found = re.search(r"^Score on the public checks: (\d+ / \d+)\.", run.stdout, re.M)
    assert found, run.stdout + run.stderr
    return found[1]


def first(run: subprocess.CompletedProcess[str]) -> str:
    """The text under the first thing to do."""
    return run.stdout.partition("\nFirst: ")[2].partition("\nScore on")[0]


def test_a_student_goes_from_the_stubs_to_full_points(home: Path) -> None:
    started, building = timed(home)
    assert (score(started), started.returncode) == ("0 / 100", 1)
    assert "for the first time" in started.stderr
    assert first(started).startswith("phi is the height of the lowest corner")
    assert "it is 0: not filled in" in first(started)
    assert "Hint 1.1 The height of the lowest corner" in first(started)
    assert "known mistake" not in started.stdout
    assert "warning" not in (home / "build/check/build.txt").read_text()

    shutil.copy(SOLUTION / "part1_contacts.cpp", home / "src")
    second = check(home)
    assert score(second) == "30 / 100" and second.stderr == ""
    assert first(second).startswith("the 3x3 block of V")

    put(home)
    done = check(home)
    assert (score(done), done.returncode) == ("100 / 100", 0)
    assert "./build/bounce" in done.stdout and "First" not in done.stdout
    assert "./check --study" in done.stdout

    part2 = home / "src/part2_lcp.cpp"  # the one that takes longest to compile
    part2.write_text(part2.read_text() + "// one line more\n")
    changed, used = timed(home, "--hint")
    assert "Every public check passes" in changed.stdout
    # Both take longer on a busy machine, and so the one is measured by the other.
    assert used < building / 6, f"{used:.1f} s of the processor after {building:.1f} s"


def points(run: subprocess.CompletedProcess[str]) -> list[str]:
    return re.findall(r"^Part \d  .*?(\d+ / \d+)$", run.stdout, re.M)


def only_parts(folder: Path) -> bool:
    return all(file.name[:4] == "part" for file in folder.iterdir() if file.suffix != ".json")


STUBS = ROOT / "student/src"
ACCEPTED = sorted((ROOT / "tests/submissions/accepted").iterdir())
RIGHT = [
    folder
    for folder in ACCEPTED
    if any(folder.glob("part[34]*.cpp")) and only_parts(folder) and "main_" not in folder.name
]
WRONG = sorted(MISTAKES.glob("part[123]_*"))


@pytest.mark.parametrize("folder", RIGHT, ids=lambda folder: folder.name)
@pytest.mark.usual(3)
def test_a_right_part_loses_nothing_beside_stubs(home: Path, folder: Path) -> None:
    put(home, folder)
    for stub in STUBS.glob("part[12]*.cpp"):
        shutil.copy(stub, home / "src")
    run = check(home)
    if points(run)[2:] != ["30 / 30", "10 / 10"]:  # what it asks can't be recorded
        assert re.search(
            r"^ +22 more can be decided once the earlier", run.stdout, re.M
        ), run.stdout
        assert folder.name == "relative_to_the_start" and points(run)[2:] == ["8 / 30", "10 / 10"]


@pytest.mark.parametrize("number, wrong", enumerate(WRONG), ids=lambda x: getattr(x, "name", ""))
@pytest.mark.usual(4)
def test_a_wrong_part_costs_the_right_ones_nothing(home: Path, number: int, wrong: Path) -> None:
    put(home, RIGHT[number % len(RIGHT)], wrong)
    run = check(home)
    part = int(wrong.name[4])
    full = ["30 / 30", "30 / 30", "30 / 30", "10 / 10"]
    assert [p for i, p in enumerate(points(run), 1) if i != part] == full[: part - 1] + full[part:]


def test_parts_that_cannot_be_linked_together_keep_their_points(home: Path) -> None:
    """As where the course grades each by itself."""
    put(home, ROOT / "tests/submissions/accepted/same_helper_in_two_parts")
    run = check(home)
    assert points(run) == ["30 / 30", "30 / 30", "30 / 30", "10 / 10"]
    assert "First: make part3_step.cpp link" in run.stdout and "drop" in run.stdout
    assert run.returncode == 1


def test_a_fault_that_its_own_checks_miss_is_not_the_later_parts(home: Path) -> None:
    """Part 1 is wrong beyond two turns, where only part 3 has public cases."""
    put(home)
    part1 = home / "src/part1_contacts.cpp"
    side = "(std::abs(q(2) - 16) < 4 ? 0.9 : 1) * (params.l / 2)"
    part1.write_text(part1.read_text().replace("(params.l / 2)", side))
    run = check(home)
    assert points(run) == ["30 / 30", "30 / 30", "30 / 30", "10 / 10"], run.stdout
    assert "Part 3 does better with right earlier parts in place of yours" in run.stdout
    assert run.returncode == 1 and "Then submit" not in run.stdout


def test_no_earlier_part_alone_is_blamed_for_what_a_part_may_keep(home: Path) -> None:
    """With recorded earlier parts a chain of its steps can't be asked, and so it passes."""
    put(home, ROOT / "tests/submissions/rarely_wrong/part3_contact_ends_at_twice_delta")
    run = check(home)
    assert "unless part 3 keeps\nsomething from one call to the next." in run.stdout
    assert "is something kept from one call to the next?" in run.stdout and run.returncode == 1


def test_each_kind_of_failure_is_named_and_hides_no_other_part(home: Path) -> None:
    put(home, MISTAKES / "part3_friction_sign")
    wrong = check(home)
    assert score(wrong) != "100 / 100"
    assert re.search(r"corner \d touches and ", first(wrong))
    assert "the contact force (f_t2 - f_t1, f_n) that v' tells of" in first(wrong)
    assert "    | v of the centre" in first(wrong)
    known = "\n  This looks like a known mistake.\n  Friction pushes the wrong way. In contact"
    assert known in first(wrong) and "See eq. (13) and hint 3.3" in " ".join(first(wrong).split())
    narrow = check(home, TERM="dumb")
    assert "    |" not in narrow.stdout and first(narrow)

    put(home, BROKEN / "part3_missing_semicolon_in_line_12")
    broken = check(home)
    assert score(broken) == "70 / 100"
    assert re.search(r"^  src/part3_step.cpp:1[23]: .*expected", first(broken), re.M)
    assert re.search(
        r"^Part 4  Trajectory +10 / 10\n +with right earlier parts", broken.stdout, re.M
    )
    assert first(broken).count("\n") < 8

    put(home)
    part2 = home / "src/part2_lcp.cpp"
    sizes = "lcp.V.topLeftCorner<3, 3>() = J.transpose() * params.M() * J;"
    stub = (ROOT / "student/src/part2_lcp.cpp").read_text()
    part2.write_text(stub.replace("  // TODO", f"  Lcp lcp;\n  {sizes}\n  // TODO"))
    mixed = first(check(home, "2"))
    assert "src/part2_lcp.cpp:7: you mixed matrices of different sizes" in mixed, mixed

    put(home)
    part1 = home / "src/part1_contacts.cpp"
    right = part1.read_text()
    part1.write_text(right.replace("{", "{ int x = ;", 1))
    needing = check(home, "1")
    assert first(needing).startswith("make part1_contacts.cpp compile")
    assert "src/part1_contacts.cpp:" in first(needing)
    part3 = home / "src/part3_step.cpp"
    right3 = part3.read_text()
    part3.write_text(right3.replace("{", "{ int x = ;", 1))
    both = check(home, "3")
    assert "Part 3  not run: it needs part 1, which does not compile" in both.stdout
    assert first(both).startswith("make part1_contacts.cpp compile")
    part3.write_text(right3)
    part1.write_text(right.replace("get_contacts(const Vector3& q,", "get_contacts(Vector3& q,"))
    unlinked = first(check(home, "1"))
    assert "get_contacts" in unlinked and "ld returned" not in unlinked, unlinked


@pytest.mark.long
def test_each_way_to_end_is_named_and_hides_no_other_part(home: Path) -> None:
    put(home, BROKEN / "part2_aborts")
    ended = check(home)
    assert "Part 1  Contact distance and Jacobian                          30 / 30" in ended.stdout
    assert "aborted" in first(ended) and "It was asked: a corner at the ground" in first(ended)
    assert "Hint 2.1" in first(ended) and "./check --hint opens it" in first(ended)
    assert "Aborted" not in ended.stderr

    put(home, BROKEN / "part4_counter_stands_still")
    loops = check(home, "4")
    assert "an endless loop?" in first(loops) and score(loops) == "0 / 10"

    put(home, BROKEN / "part3_exits")
    exits = check(home, "3")
    assert "ended by itself, with status 0" in first(exits)
    assert "Your program printed" in first(exits) and "phi = " in first(exits)


@pytest.mark.parametrize(
    "constructor, told",
    [
        ("__builtin_trap();", "Before the first check began, the program crashed"),
        ("std::exit(0);", "Before the first check began, the program ended by itself"),
    ],
    ids=["crashes", "exits"],
)
def test_what_ends_before_main_is_told(home: Path, constructor: str, told: str) -> None:
    put(home)
    part1 = home / "src/part1_contacts.cpp"
    early = f"struct Early {{ Early() {{ {constructor} }} }};\nconst Early early;\n"
    part1.write_text("#include <cstdlib>\n" + part1.read_text() + early)
    run = check(home, "1")
    assert (score(run), run.returncode) == ("0 / 30", 1)
    assert told in first(run) and "Look at what runs before main" in first(run)


def test_an_older_file_that_comes_back_is_built(home: Path) -> None:
    """As from a backup or a zip, with the time that it had."""
    put(home)
    part1, right = home / "src/part1_contacts.cpp", (home / "src/part1_contacts.cpp").read_bytes()
    assert score(check(home, "1")) == "30 / 30"
    part1.write_bytes(b"")
    os.utime(part1, (1, 1))
    assert score(check(home, "1")) == "0 / 30"
    part1.write_bytes(right)
    os.utime(part1, (2, 2))
    assert score(check(home, "1")) == "30 / 30"


def test_one_part_alone_says_what_else_may_be_wrong(home: Path) -> None:
    put(home, MISTAKES / "part3_friction_sign")
    alone = check(home, "3")
    assert "Part 3 calls earlier ones; where ./check finds one of them wrong" in alone.stdout
    assert "./check 3 --hint opens it" in alone.stdout
    both = check(home, "2", "3")
    assert both.returncode == 3 and "one part at a time, or all: ./check 3" in both.stderr


def test_says_the_score_that_the_checks_add_up_to_and_one_part_alone(home: Path) -> None:
    put(home, MISTAKES / "part2_force_is_g")
    whole, alone = check(home), check(home, "2")
    assert score(alone) == "16 / 30"
    assert "Part 1" in whole.stdout and "Part 1" not in alone.stdout
    points = re.findall(r"^Part \d .* (\d+) / \d+$", whole.stdout, re.M)
    assert score(whole) == f"{sum(map(int, points))} / 100"


def worth(lost: list[str]) -> int:
    """The points of the checks, or of whole parts, that are lost."""
    manifest = json.loads((ROOT / "grader/parts.json").read_text())["parts"]
    return sum(
        check["points"]
        for part in manifest
        for check in part["checks"]
        if check["id"] in lost or check["id"].split(".")[0] in lost
    )


@pytest.mark.parametrize(
    "names",
    [
        ("mistakes/part1_turned_clockwise",),
        ("mistakes/part2_force_is_g",),
        ("mistakes/part1_turned_clockwise", "mistakes/part3_friction_sign"),
        ("mistakes/part2_force_is_g", "broken/part3_missing_semicolon_in_line_12"),
    ],
    ids=["part 1", "part 2", "parts 1 and 3", "parts 2 and 3"],
)
@pytest.mark.usual(2)
def test_the_points_are_those_that_the_course_gives(home: Path, names: tuple[str, ...]) -> None:
    """A mistake is paid for once: later parts are judged with right earlier ones."""
    folders = [ROOT / "tests/submissions" / name for name in names]
    put(home, *folders)
    lost = [
        check for f in folders for check in json.loads((f / "expected.json").read_text())["lost"]
    ]
    run = check(home)
    assert score(run) == f"{100 - worth(lost)} / 100", run.stdout
    assert "with right earlier parts in place of yours" in run.stdout
    assert re.search(r"^  ✗ .* 0 / [1-9]$", run.stdout, re.M)  # what it is worth


def test_what_no_right_part_asks_is_left_undecided_beside_a_wrong_part(home: Path) -> None:
    put(
        home,
        MISTAKES / "part1_turned_clockwise",
        MISTAKES / "part3_contact_of_the_next_configuration",
    )
    run = check(home, "3")
    assert "20 more can be decided once the earlier parts are right" in run.stdout
    assert "  ✗" not in run.stdout and run.returncode == 1


def test_opens_a_stage_of_the_hint_at_a_time(home: Path) -> None:
    (home / "build/check/hint").unlink(missing_ok=True)
    put(home, MISTAKES / "part2_force_is_g")
    shown = [check(home, "2", "--hint").stdout for _ in range(4)]
    stages = ["A nudge", "The formula", "A worked number", "A worked number"]
    for n, (text, stage) in enumerate(zip(shown, stages), 1):
        assert f"Hint 2.3 The normal row of p, stage {min(n, 3)} of 3: {stage}" in text
        assert "```" not in text
        assert ("The worked numbers use the state of the handout: q = (0.5" in text) == (n > 2)
    assert "That was the last stage." in shown[2] and "That was the last stage again" in shown[3]
    assert shown[3].startswith(shown[2].partition("That was the last")[0])
    put(home)
    assert "no hint is needed" in check(home, "2", "--hint").stdout


def test_watches_until_it_is_stopped(home: Path) -> None:
    put(home)
    watch = subprocess.Popen(
        ["./check", "1", "--watch"], cwd=home, env=SYSTEM, stdout=subprocess.PIPE, text=True
    )
    assert watch.stdout
    try:
        lines: list[str] = []

        def until(word: str) -> str:
            while not (lines and word in lines[-1]):
                lines.append(watch.stdout.readline())  # type: ignore[union-attr]
                assert lines[-1], "".join(lines)
            return "".join(lines)

        assert "30 / 30" in until("Waiting")
        lines.clear()
        time.sleep(0.1)
        put(home, MISTAKES / "part1_turned_clockwise")
        assert "First: " in until("Waiting")
    finally:
        watch.terminate()
        watch.wait()


def test_keys_while_watching_open_hints_choose_parts_and_end_it(home: Path) -> None:
    put(home, MISTAKES / "part1_turned_clockwise")
    (home / "build/check/hint").unlink(missing_ok=True)
    terminal, of_check = pty.openpty()
    watch = subprocess.Popen(
        ["./check", "1", "--watch"],
        cwd=home,
        env=SYSTEM,
        stdin=of_check,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert watch.stdout

    def shown() -> str:
        lines: list[str] = []
        while not (lines and "Waiting" in lines[-1]):
            lines.append(watch.stdout.readline())  # type: ignore[union-attr]
            assert lines[-1], "".join(lines)
        return "".join(lines)

    try:
        assert "Part 2" not in shown()
        os.write(terminal, b"h")
        said = shown()
        assert "the result above is the last one" in said and "stage 1 of 3" in said
        os.write(terminal, b"a")
        assert "Part 2" in shown()
        os.write(terminal, b"q")
        assert watch.wait(timeout=30) == 0
    finally:
        watch.kill()
        watch.wait()
        os.close(terminal)
        os.close(of_check)


def test_checks_at_the_same_time_give_one_score(home: Path) -> None:
    put(home, MISTAKES / "part3_friction_sign")
    several = [
        subprocess.Popen(
            ["./check"],
            cwd=home,
            env=SYSTEM,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for _ in range(3)
    ]
    said = [check.communicate() for check in several]
    assert len({out for out, _ in said}) == 1 and "Score on the public checks: 83" in said[0][0]
    assert sum("this one waits for it" in err for _, err in said) == 2, said


def test_an_unknown_option_is_answered_with_the_known_ones(home: Path) -> None:
    run = check(home, "--hints")
    assert run.returncode == 2 and "--hints is not known" in run.stderr
    assert "./check --watch" in run.stderr
    assert check(home, "--help").stdout.startswith("./check ")


def test_names_the_part_that_is_missing(tmp_path: Path, home: Path) -> None:
    fresh = unzipped(tmp_path)
    for folder in (fresh, home):
        part = folder / "src/part2_lcp.cpp"
        part.unlink()
        run = check(folder)
        assert run.returncode == 3 and run.stdout == ""
        assert run.stderr == "check: src/part2_lcp.cpp is missing: copy it from the handout's zip\n"
        part.write_bytes((SOLUTION / part.name).read_bytes())


@pytest.mark.usual(1)
@pytest.mark.parametrize(
    "name",
    [
        "-HW #3 [2] 100% $HOME it's ~a & b (c), {d}=e@f@+^:!`x` Ü  ",
        *("HW #3", "C#", "$HOME", "it's", "100%d", "R&D (2)", "Übung 1 für Müller", "-dash"),
        *("  blanks  ", "[abc]"),
    ],
)
def test_a_folder_may_have_any_name(tmp_path: Path, name: str) -> None:
    folder = unzipped(tmp_path).rename(tmp_path / name)
    put(folder)
    run = check(folder, "1")
    assert score(run) == "30 / 30", run.stderr
    (folder / "src/part1_contacts.cpp").write_text("int x = ;\n")
    assert "src/part1_contacts.cpp:1:" in first(check(folder, "1"))


@pytest.mark.parametrize(
    "name", ["a;b", '"a"', "a\\b", "a|b", "<a>", "a*", "a?", "$(HOME)", "${HOME}", "a\nb"]
)
def test_a_name_that_cmake_cannot_hold_is_refused_in_a_sentence(tmp_path: Path, name: str) -> None:
    folder = unzipped(tmp_path).rename(tmp_path / name)
    run = check(folder)
    assert run.returncode == 3 and not (folder / "build").exists()
    assert run.stderr.startswith("check: CMake cannot build in a folder whose path has ")
    assert run.stderr.count("\n") == 1


def test_goes_on_where_a_check_was_killed_while_it_prepared(tmp_path: Path) -> None:
    folder = unzipped(tmp_path)
    (folder / "build").mkdir()
    (folder / "build/preparing").symlink_to("999999999")  # a process that isn't there any more
    (folder / "CMakeLists.txt").write_text("message(FATAL_ERROR reached)\n")
    run = check(folder)
    assert run.returncode == 3 and "CMake could not prepare the build" in run.stderr
    assert not (folder / "build/preparing").is_symlink()


@pytest.mark.parametrize(
    "gone, sentence",
    [
        ({"cmake"}, "check: CMake is missing; install it with: sudo apt install cmake"),
        (
            {"c++", "g++", "clang++", "gcc", "cc"},
            "check: a C++ compiler is missing; install it with",
        ),
        (
            {"ninja", "make", "gmake"},
            "check: Ninja is missing; install it with: sudo apt install ninja-build",
        ),
    ],
    ids=["cmake", "compiler", "make"],
)
def test_names_the_program_that_is_missing(tmp_path: Path, gone: set[str], sentence: str) -> None:
    folder = unzipped(tmp_path)
    programs = tmp_path / "bin"
    programs.mkdir()
    for name in {*os.listdir("/usr/bin"), *os.listdir("/bin")}:
        versioned = re.sub(r"-[\d.]+$", "", name)
        if versioned not in gone and not (
            "c++" in gone and re.search(r"(g|clang)\+\+|c\+\+|icpx", name)
        ):
            (programs / name).symlink_to(Path("/usr/bin") / name)
    run = check(folder, PATH=str(programs))
    assert run.returncode == 3
    assert sentence in run.stderr and run.stdout == ""


@pytest.mark.parametrize(
    "package, apt",
    [
        ("Eigen3", "libeigen3-dev"),
        ("GTest", "libgtest-dev"),
        ("nlohmann_json", "nlohmann-json3-dev"),
    ],
)
def test_names_the_library_that_is_missing(tmp_path: Path, package: str, apt: str) -> None:
    folder = unzipped(tmp_path)
    build = folder / "CMakeLists.txt"
    text = build.read_text()
    build.write_text(
        text.replace(
            "LANGUAGES CXX)", f"LANGUAGES CXX)\nset(CMAKE_DISABLE_FIND_PACKAGE_{package} ON)"
        )
    )
    run = check(folder)
    assert run.returncode == 3
    last = run.stderr.strip().splitlines()[-1]
    assert last.startswith(f"check: missing: {package}") and last.endswith(
        f"sudo apt install {apt}"
    )
