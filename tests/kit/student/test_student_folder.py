"""The student's folder by itself: it builds without a warning, its tests run part by part, and it
says what to install where something is missing."""

import shutil
import subprocess
from pathlib import Path

import pytest
from bounce_grader.publish import handout as kit_handout
from conftest import SOLUTION

STEMS = ["part1_contacts", "part2_lcp", "part3_step", "part4_simulate"]


def run(*command: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def handout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder as it is handed out, with the public tests and fixtures inside."""
    folder = tmp_path_factory.mktemp("handout") / "bounce"
    for name, file in kit_handout.files().items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, folder / name)
    return folder


def configure(folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    return run("cmake", "-S", ".", "-B", "build", "-G", "Ninja", *options, cwd=folder)


def failed_tests(folder: Path) -> list[str]:
    out = run("ctest", "--test-dir", "build", cwd=folder).stdout
    return [stem for stem in STEMS if f"{stem} (Failed)" in out]


@pytest.mark.long
def test_builds_without_a_warning_and_goes_from_no_part_to_all(handout: Path) -> None:
    assert configure(handout, "-DCMAKE_CXX_FLAGS=-Werror").returncode == 0
    built = run("cmake", "--build", "build", cwd=handout)
    assert built.returncode == 0, built.stdout
    assert "warning" not in built.stdout + built.stderr
    assert failed_tests(handout) == STEMS

    nothing = run("./build/bounce", cwd=handout)
    assert (
        nothing.returncode == 1
        and nothing.stdout == ""
        and "fill in src/part4_simulate.cpp" in nothing.stderr
    )

    shutil.copy(SOLUTION / "part1_contacts.cpp", handout / "src")
    assert run("cmake", "--build", "build", cwd=handout).returncode == 0
    assert failed_tests(handout) == STEMS[1:]

    for stem in STEMS[1:]:
        shutil.copy(SOLUTION / f"{stem}.cpp", handout / "src")
    assert run("cmake", "--build", "build", cwd=handout).returncode == 0
    assert failed_tests(handout) == []
    assert run("./build/bounce", cwd=handout).returncode == 0
    assert (handout / "animation.html").stat().st_size > 10_000


@pytest.mark.parametrize(
    "package, apt, brew, vcpkg",
    [
        ("Eigen3", "libeigen3-dev", "eigen", "eigen3"),
        ("GTest", "libgtest-dev", "googletest", "gtest"),
        ("nlohmann_json", "nlohmann-json3-dev", "nlohmann-json", "nlohmann-json"),
    ],
)
def test_says_what_to_install(
    handout: Path, tmp_path: Path, package: str, apt: str, brew: str, vcpkg: str
) -> None:
    folder = shutil.copytree(handout, tmp_path / "bounce", ignore=shutil.ignore_patterns("build"))
    done = configure(folder, f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON")
    assert done.returncode != 0
    for hint in (f"apt install {apt}", f"brew install {brew}", f"vcpkg install {vcpkg}"):
        assert hint in done.stderr


EIGEN = Path("/usr/share/eigen3/cmake")


@pytest.mark.parametrize("version, is_taken", [("3.3.9", False), ("3.4.1", True), ("5.0.1", True)])
def test_takes_an_eigen_of_any_later_version(
    handout: Path, tmp_path: Path, version: str, is_taken: bool
) -> None:
    """Its package refuses whoever asks for another major version."""
    folder = shutil.copytree(handout, tmp_path / "bounce", ignore=shutil.ignore_patterns("build"))
    eigen = shutil.copytree(EIGEN, tmp_path / "share/eigen3/cmake")
    (tmp_path / "include").mkdir()
    (tmp_path / "include/eigen3").symlink_to("/usr/include/eigen3")
    [says] = eigen.glob("*ConfigVersion.cmake")
    says.write_text(says.read_text().replace("3.4.0", version))
    done = configure(folder, f"-DEigen3_DIR={eigen}")
    assert (done.returncode == 0) == is_taken, done.stderr
    assert is_taken or "Missing:         Eigen3-3.4" in done.stderr, done.stderr


def test_says_what_is_gone_when_the_tests_are(handout: Path, tmp_path: Path) -> None:
    ignore = shutil.ignore_patterns("build", "tests")
    folder = shutil.copytree(handout, tmp_path / "bounce", ignore=ignore)
    assert "unpack the handout anew" in configure(folder).stderr
