"""The handout with another compiler, and as built for Windows, where Wine runs it."""

import os
import re
import shutil
import subprocess
import time
from pathlib import Path

import pytest
from conftest import ROOT, SOLUTION
from handed_out import unzipped

SYSTEM = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "LANG": "C.UTF-8", "TERM": "xterm"}
PATIENCE = 120  # s
WINE = Path("/usr/lib/wine/wine64")
MINGW = "x86_64-w64-mingw32-g++-posix"
TOOLCHAIN = f"""set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER {MINGW})
set(CMAKE_EXE_LINKER_FLAGS -static)
"""
# All that a check may ask CMake for.
TARGETS = ("all", "study", "real", "part3_step_given_test", "part4_simulate_given_test")
SUBMISSIONS = ROOT / "tests/submissions"
# What is said of each on Windows, where there are no signals.
FAILURES = {
    "mistakes/part3_friction_sign": "Friction pushes the wrong way",
    "broken/part2_aborts": "the program was aborted",
    "broken/part3_null_pointer": "an index or a pointer out of bounds",
    "broken/part4_counter_stands_still": "no answer within 3 s of work: an endless loop?",
    "broken/part3_exits": "ended by itself, with status 0",
}


def run(*command: str | Path, cwd: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        list(map(str, command)),
        cwd=cwd,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


def put(home: Path, *folders: Path) -> None:
    for folder in (SOLUTION, *folders):
        for file in folder.glob("part*.cpp"):
            shutil.copyfile(file, home / "src" / file.name)


def test_files_that_are_compiled_together_name_no_constant_twice() -> None:
    """Those of the check program, on every system; those for Windows are built in the long run."""
    together = {*(ROOT / "student/given/check").glob("*.cpp")}
    for other in ("posix", "windows"):
        named = [
            name
            for file in together - {ROOT / f"student/given/check/process_{other}.cpp"}
            for name in {*re.findall(r"^constexpr [\w:]+ (k\w+)", file.read_text(), re.MULTILINE)}
        ]
        assert sorted(named) == sorted(set(named)) and len(named) > 5


@pytest.mark.long
def test_with_clang_a_check_says_the_same(tmp_path: Path) -> None:
    if not shutil.which("clang++"):
        pytest.skip("there is no clang++ here")
    home = unzipped(tmp_path)
    for name, said in FAILURES.items():
        put(home, SUBMISSIONS / name)
        done = subprocess.run(
            ["./check"],
            cwd=home,
            env={**SYSTEM, "CXX": "clang++"},
            capture_output=True,
            text=True,
            check=False,
        )
        assert said in done.stdout, done.stdout + done.stderr
    put(home)
    part2 = home / "src/part2_lcp.cpp"
    part2.write_text(part2.read_text().replace("{", "{ int x = ;", 1))
    broken = subprocess.run(
        ["./check", "2"],
        cwd=home,
        env={**SYSTEM, "CXX": "clang++"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert "  src/part2_lcp.cpp:" in broken.stdout and "expected expression" in broken.stdout


def built_for_windows(home: Path, prefix: Path) -> None:
    """With GoogleTest made for it, too; Eigen and nlohmann-json are headers alone."""
    prefix.mkdir()
    (prefix / "windows.cmake").write_text(TOOLCHAIN)
    for_windows = f"-DCMAKE_TOOLCHAIN_FILE={prefix / 'windows.cmake'}"
    gtest = shutil.copytree("/usr/src/googletest", prefix / "googletest")
    to = [f"-DCMAKE_INSTALL_PREFIX={prefix}", "-DBUILD_GMOCK=OFF"]
    shutil.copytree("/usr/include/nlohmann", prefix / "include/nlohmann")
    [config] = Path("/usr").rglob("nlohmann_jsonConfig.cmake")
    own = shutil.copytree(config.parent, prefix / config.parent.relative_to("/usr"))
    found = [
        f"-DGTest_DIR={prefix}/lib/cmake/GTest",
        "-DEigen3_DIR=/usr/share/eigen3/cmake",
        f"-Dnlohmann_json_DIR={own}",
    ]
    for command in (
        ["cmake", "-S", gtest, "-B", prefix / "gtest", for_windows, *to],
        ["cmake", "--build", prefix / "gtest", "--parallel", "--target", "install"],
        ["cmake", "-S", ".", "-B", "build", for_windows, *found],
    ):
        done = run(*command, cwd=home)
        assert done.returncode == 0, done.stdout + done.stderr


def says(file: str, words: str) -> None:
    """Waits until these words are in the file."""
    deadline = time.monotonic() + PATIENCE
    while words not in Path(file).read_text("utf-8"):
        assert time.monotonic() < deadline, Path(file).read_text("utf-8")
        time.sleep(0.2)


@pytest.mark.long
def test_on_windows_a_check_says_the_same(tmp_path: Path) -> None:
    if not shutil.which(MINGW) or not WINE.exists():
        pytest.skip("g++-mingw-w64-x86-64-posix and wine64 aren't installed")
    home = unzipped(tmp_path).rename(tmp_path / "Übung 1 von Müller")
    built_for_windows(home, tmp_path / "prefix")
    # The check itself starts a build; here it has been built already, by a CMake that isn't Windows'.
    (tmp_path / "cmake.cpp").write_text("int main() { return 0; }\n")
    nothing = tmp_path / "cmake.exe"
    assert run(MINGW, "-static", "-o", nothing, "cmake.cpp", cwd=tmp_path).returncode == 0
    program = home / "build/check_program.exe"
    wine = {
        "WINEPREFIX": str(tmp_path / "wine"),
        "WINEDEBUG": "-all",
        "WINEPATH": f"Z:{tmp_path}",
        "LC_ALL": "C.UTF-8",
    }

    def build() -> None:
        built = run("cmake", "--build", "build", "--parallel", "--target", *TARGETS, cwd=home)
        assert built.returncode == 0 and "warning" not in built.stdout, built.stdout + built.stderr

    def check(*options: str) -> subprocess.CompletedProcess[str]:
        build()
        return run(WINE, program, *options, cwd=home, **wine)

    put(home)
    for file in (home / "src").glob("*.cpp"):
        file.write_bytes(file.read_bytes().replace(b"\n", b"\r\n"))
    right = check()
    assert right.returncode == 0 and "Score on the public checks: 100 / 100." in right.stdout
    for page in ("study", "real"):
        assert check(f"--{page}").returncode == 0
        assert "<svg" in (home / f"{page}.html").read_text("utf-8")
    with open(tmp_path / "watched.txt", "w+", encoding="utf-8") as seen:
        watching = subprocess.Popen(
            [WINE, program, "--watch"], cwd=home, stdout=seen, env={**os.environ, **wine}
        )
        try:
            says(seen.name, "100 / 100")
            put(home, SUBMISSIONS / "mistakes/part3_friction_sign")
            build()
            with open(home / "src/part3_step.cpp", "a", encoding="utf-8") as part:
                part.write("// Saved once more, now that it is built.\n")
            says(seen.name, FAILURES["mistakes/part3_friction_sign"])
        finally:
            watching.kill()
            watching.wait()
    for name, said in FAILURES.items():
        put(home, SUBMISSIONS / name)
        done = check()
        assert done.returncode == 1 and said in done.stdout, done.stdout + done.stderr
    assert "stage 1 of 3: A nudge" in check("3", "--hint").stdout
    assert check("--nonsense").returncode == 2
    sanitized = check("--sanitize")
    assert sanitized.returncode == 3
    assert "--sanitize needs g++ or clang on Linux or macOS" in sanitized.stderr
