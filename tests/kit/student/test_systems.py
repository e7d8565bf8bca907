"""The handout with another compiler or standard library; and as built for Windows, where Wine runs it,
and for ARM64, where qemu does and the compiler fuses multiplications and additions by itself."""

import shutil
import subprocess
from pathlib import Path

import pytest
from bounce_grader.common.manifest import parts
from handed_out import SUBMISSIONS, SYSTEM, Done, check, put, run, unzipped
from waiting import wait_for

WINE = Path("/usr/lib/wine/wine64")
MINGW = "x86_64-w64-mingw32-g++-posix"
TOOLCHAIN = f"""set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER {MINGW})
set(CMAKE_EXE_LINKER_FLAGS -static)
"""
ARM, QEMU = "aarch64-linux-gnu-g++", "qemu-aarch64-static"
FOR_ARM = f"""set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER {ARM})
set(CMAKE_EXE_LINKER_FLAGS -static)
set(CMAKE_CROSSCOMPILING_EMULATOR {QEMU})
"""
WITH_LIBCXX = """set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_FLAGS -stdlib=libc++)
"""
# All that a check may ask CMake for.
TARGETS = "all study optimised_test real part3_step_given_test part4_simulate_given_test".split()
FRICTION = "mistakes/part3_friction_sign"
# What is told of each with any compiler, and on Windows, where there are no signals.
FAILURES = {
    FRICTION: "Friction pushes the wrong way",
    "broken/part2_aborts": "the program was aborted",
    "broken/part3_null_pointer": "an index or a pointer out of bounds",
    "broken/part4_counter_stands_still": "no answer within 3 s of work: an endless loop?",
    "broken/part3_exits": "ended by itself, with status 0",
}


@pytest.mark.long
def test_with_clang_a_check_says_the_same(tmp_path: Path) -> None:
    if not shutil.which("clang++"):
        pytest.skip("there is no clang++ here")
    home = unzipped(tmp_path)
    for name, told in FAILURES.items():
        put(home, name)
        done = check(home, CXX="clang++")
        assert told in done.stdout, done.stdout + done.stderr
    put(home, edits={"part2_lcp": [["{", "{ int x = ;"]]})
    broken = check(home, "2", CXX="clang++")
    assert "  src/part2_lcp.cpp:" in broken.stdout and "expected expression" in broken.stdout


def build_for(toolchain: str, home: Path, prefix: Path) -> None:
    """With GoogleTest made for it, too; Eigen and nlohmann-json are headers alone."""
    prefix.mkdir()
    (prefix / "toolchain.cmake").write_text(toolchain)
    for_it = f"-DCMAKE_TOOLCHAIN_FILE={prefix / 'toolchain.cmake'}"
    gtest = shutil.copytree("/usr/src/googletest", prefix / "googletest")
    to = [f"-DCMAKE_INSTALL_PREFIX={prefix}", "-DBUILD_GMOCK=OFF"]
    shutil.copytree("/usr/include/nlohmann", prefix / "include/nlohmann")
    [config] = Path("/usr").rglob("nlohmann_jsonConfig.cmake")
    own = shutil.copytree(config.parent, prefix / config.parent.relative_to("/usr"))
    found = [
        f"-DGTest_DIR={prefix}/lib/cmake/GTest",
        "-DEigen3_DIR=/usr/share/eigen3/cmake",
        f"-Dnlohmann_json_DIR={own}",
        "-DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON",  # which finds libraries of this system
    ]
    for command in (
        ["cmake", "-S", gtest, "-B", prefix / "gtest", for_it, *to],
        ["cmake", "--build", prefix / "gtest", "--parallel", "--target", "install"],
        ["cmake", "-S", ".", "-B", "build", for_it, *found],
    ):
        done = run(home, *map(str, command))
        assert done.returncode == 0, done.stdout + done.stderr


ACCEPTED = sorted((SUBMISSIONS / "accepted").iterdir())
RIGHT = [folder for folder in ACCEPTED if {*folder.rglob("*.*pp")} == {*folder.glob("part*.cpp")}]
KINDS: dict[str, tuple[str, str, list[str]]] = {
    "arm64": (FOR_ARM, ARM, [QEMU]),
    "libc++": (WITH_LIBCXX, "/usr/include/c++/v1", []),
}


@pytest.mark.long
@pytest.mark.parametrize("kind", KINDS)
def test_right_programs_pass_the_public_checks_on(kind: str, tmp_path: Path) -> None:
    toolchain, needed, start = KINDS[kind]
    if not shutil.which(needed) and not [*Path("/usr/lib").glob("llvm-*" + needed[4:])]:
        pytest.skip(f"{needed} isn't installed")
    home = unzipped(tmp_path)
    build_for(toolchain, home, tmp_path / "prefix")
    stems = [part.stem for part in parts()]

    def failing(*laid: str) -> list[str]:
        put(home, *laid)
        targets = [f"{stem}_test" for stem in stems]
        built = run(home, "cmake", "--build", "build", "--parallel", "--target", *targets)
        assert built.returncode == 0, built.stdout + built.stderr
        tried = {stem: run(home, *start, str(home / "build" / f"{stem}_test")) for stem in stems}
        return [stem for stem, done in tried.items() if done.returncode]

    assert failing() == []
    assert {folder.name: failing(f"accepted/{folder.name}") for folder in RIGHT[::8]} == {
        folder.name: [] for folder in RIGHT[::8]
    }
    assert failing(FRICTION) == ["part3_step", "part4_simulate"]  # which calls it


@pytest.mark.long
def test_on_windows_a_check_says_the_same(tmp_path: Path) -> None:
    if not shutil.which(MINGW) or not WINE.exists():
        pytest.skip("g++-mingw-w64-x86-64-posix and wine64 aren't installed")
    home = unzipped(tmp_path).rename(tmp_path / "Übung 1 von Müller")
    build_for(TOOLCHAIN, home, tmp_path / "prefix")
    # The check itself starts a build; here it is built already, by a CMake that isn't Windows'.
    (tmp_path / "cmake.cpp").write_text("int main() { return 0; }\n")
    built = run(tmp_path, MINGW, "-static", "-o", "cmake.exe", "cmake.cpp")
    assert built.returncode == 0, built.stderr
    program = [str(WINE), str(home / "build/check_program.exe")]
    wine = {"WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all"}
    wine |= {"WINEPATH": f"Z:{tmp_path}", "LC_ALL": "C.UTF-8"}

    def build() -> None:
        built = run(home, "cmake", "--build", "build", "--parallel", "--target", *TARGETS)
        assert built.returncode == 0 and "warning" not in built.stdout, built.stdout + built.stderr

    def check_there(*options: str) -> Done:
        build()
        return run(home, *program, *options, **wine)

    put(home)
    for file in (home / "src").glob("*.cpp"):
        file.write_bytes(file.read_bytes().replace(b"\n", b"\r\n"))
    right = check_there()
    assert right.returncode == 0 and "Score on the public checks: 100 / 100." in right.stdout
    for page in ("study", "real"):
        assert check_there(f"--{page}").returncode == 0
        assert '"sentence":' in (home / f"{page}.html").read_text("utf-8")
    printed = tmp_path / "printed.txt"
    with open(printed, "w") as out:
        watch = subprocess.Popen([*program, "--watch"], cwd=home, stdout=out, env=SYSTEM | wine)
    try:
        wait_for(lambda: "100 / 100" in printed.read_text("utf-8"))
        put(home, FRICTION)
        build()
        part3 = home / "src/part3_step.cpp"
        part3.write_text(part3.read_text() + "// Saved once more, now that it is built.\n")
        wait_for(lambda: FAILURES[FRICTION] in printed.read_text("utf-8"))
    finally:
        watch.kill()
        watch.wait()
    for name, told in FAILURES.items():
        put(home, name)
        done = check_there()
        assert done.returncode == 1 and told in done.stdout, done.stdout + done.stderr
    assert "stage 1 of 3: A nudge" in check_there("3", "--hint").stdout
    assert check_there("--nonsense").returncode == 2
    sanitized = check_there("--sanitize")
    assert sanitized.returncode == 3
    assert "--sanitize needs g++ or clang on Linux or macOS" in sanitized.stderr
