"""The student's folder without ./check: CMake builds it and runs its tests part by part, and
editors and debuggers find their way."""

import shutil
import signal
from pathlib import Path

import pytest
from handed_out import Done, check, put, run, unzipped

STEMS = ["part1_contacts", "part2_lcp", "part3_step", "part4_simulate"]
STUBS = ["stub 1", "stub 2", "stub 3", "stub 4"]


def configure(folder: Path, *options: str) -> Done:
    return run(folder, "cmake", "-S", ".", "-B", "build", "-G", "Ninja", *options)


@pytest.mark.long
def test_builds_without_a_warning_and_goes_from_no_part_to_all(tmp_path: Path) -> None:
    folder = unzipped(tmp_path)
    assert configure(folder, "-DCMAKE_CXX_FLAGS=-Werror").returncode == 0
    for right in (0, 1, 4):
        put(folder, *STUBS[right:])
        built = run(folder, "cmake", "--build", "build")
        assert built.returncode == 0 and "warning" not in built.stdout + built.stderr, built.stdout
        out = run(folder, "ctest", "--test-dir", "build").stdout
        assert [stem for stem in STEMS if f"{stem} (Failed)" in out] == STEMS[right:]
        drawn = run(folder, "./build/bounce")
        if right < 4:
            assert (drawn.returncode, drawn.stdout) == (1, "")
            assert "fill in src/part4_simulate.cpp" in drawn.stderr
    assert drawn.returncode == 0 and (folder / "animation.html").stat().st_size > 10_000


def test_takes_an_eigen_of_any_later_version_and_says_what_is_gone(tmp_path: Path) -> None:
    """Its package refuses whoever asks for another major version."""
    folder = unzipped(tmp_path)
    eigen = shutil.copytree("/usr/share/eigen3/cmake", tmp_path / "share/eigen3/cmake")
    (tmp_path / "include").mkdir()
    (tmp_path / "include/eigen3").symlink_to("/usr/include/eigen3")
    [config] = eigen.glob("*ConfigVersion.cmake")
    text = config.read_text()
    for version, is_taken in {"3.3.9": False, "3.4.1": True, "5.0.1": True}.items():
        config.write_text(text.replace("3.4.0", version))
        done = configure(folder, f"-DEigen3_DIR={eigen}")
        assert (done.returncode == 0) == is_taken, done.stderr
        assert ("Too old:         Eigen3 3.3.9" in done.stderr) != is_taken, done.stderr
    shutil.rmtree(folder / "tests")
    assert "unpack the handout again" in configure(folder).stderr


# ---- editors and debuggers ----


@pytest.mark.xdist_group("student")
def test_a_debugger_stops_before_the_first_wrong_case_is_asked_again(home: Path) -> None:
    put(home, "mistakes/part2_force_is_g")
    check(home, "part2_lcp")
    done = run(home, "build/part2_lcp_test", "--debug")
    assert done.returncode == -signal.SIGTRAP and "yours, >wrong<" in done.stdout, done.stdout
