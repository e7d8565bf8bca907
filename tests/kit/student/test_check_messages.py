"""The messages of ./check about unset numbers, warnings, exceptions and printed text, and its
hints."""

import re
from pathlib import Path

import pytest
from conftest import SOLUTION
from test_check import check, first, MISTAKES, put, score, UNDEFINED

pytestmark = pytest.mark.xdist_group("student")


def change(home: Path, stem: str, old: str, new: str) -> None:
    """The solution's part with one change."""
    text = (SOLUTION / f"{stem}.cpp").read_text()
    assert text.count(old) == 1
    (home / f"src/{stem}.cpp").write_text(text.replace(old, new))


def test_an_entry_that_was_never_set_is_seen(home: Path) -> None:
    put(home)
    old = "lcp.p << J_n.dot(v_free + params.epsilon * v), -J_t.dot(v_free), J_t.dot(v_free), 0;"
    rows = "lcp.p.head<3>() << J_n.dot(v_free + params.epsilon * v), -J_t.dot(v_free), J_t.dot(v_free);"
    change(home, "part2_lcp", old, rows)
    run = check(home, "2")
    assert score(run) != "30 / 30"
    assert ">nan<" in first(run) and "an entry is nan: was it ever set?" in first(run)

    put(home)
    whole = "return {J, q(1) + r.y()};"
    change(home, "part1_contacts", whole, "Contact contact;\n  contact.J = J;\n  return contact;")
    lone = first(check(home, "1"))
    assert re.search(r"it is (nan|-\d.*e\+\d+): was it ever set\?", lone), lone


def test_warnings_of_the_students_own_files_follow_the_result(home: Path) -> None:
    put(home)
    assert "compiler warns" not in check(home, "1").stdout
    unused = "namespace bounce {\n" + "".join(
        f"static int unused_{k}() {{ return 0; }}\n" for k in range(4)
    )
    change(home, "part1_contacts", "namespace bounce {\n", unused)
    told = check(home, "1").stdout
    assert "30 / 30" in told
    result, _, warnings = told.partition("The compiler warns")
    assert "Score on the public checks" in result
    lines = warnings.splitlines()[1:]
    assert len(lines) == 4 and lines[3].endswith("and 1 more, in build/check/warnings")
    for k, line in enumerate(lines[:3]):
        assert re.match(rf"  src/part1_contacts.cpp:{k + 5}: .*unused_{k}", line), line
        assert "[-W" not in line
    assert check(home, "1").stdout == told  # nothing was compiled, and they still stand

    change(home, "part1_contacts", "return {J,", "int x; return {-J,")
    wrong = check(home, "1").stdout
    assert wrong.index("First: ") < wrong.index("The compiler warns")
    assert "unused_" not in wrong and "unused variable" in wrong


def test_a_helpers_warnings_go_with_it(home: Path) -> None:
    put(home)
    helper = home / "src/helper.cpp"
    helper.write_text('#include "helper.hpp"\nint helper() { int x; return 0; }\n')
    (home / "src/helper.hpp").write_text(
        "inline int sum(int n) { return n < 3u; }\nint helper();\n"
    )
    told = check(home, "1").stdout
    assert "src/helper.cpp:2: unused variable" in told and "src/helper.hpp:1: comp" in told, told
    for file in home.glob("src/helper.*"):
        file.unlink()
    assert "compiler warns" not in check(home, "1").stdout


@pytest.mark.parametrize(
    "thrown, told",
    [
        ('throw std::runtime_error("oh");', "part 1 threw an exception: oh"),
        ("throw 5;", "part 1 threw something that isn't a std::exception"),
    ],
)
def test_an_exception_is_told_with_its_part(home: Path, thrown: str, told: str) -> None:
    put(home)
    change(
        home, "part1_contacts", "namespace bounce {\n", "#include <stdexcept>\nnamespace bounce {\n"
    )
    part1 = home / "src/part1_contacts.cpp"
    part1.write_text(
        part1.read_text().replace("const Eigen::Matrix2d R", f"{thrown}\n  const Eigen::Matrix2d R")
    )
    assert f"\n    {told}\n" in first(check(home, "1"))


def test_a_shape_that_the_tests_refuse_is_not_an_exception_of_the_part(home: Path) -> None:
    put(home)
    part4 = home / "src/part4_simulate.cpp"
    text = part4.read_text()
    part4.write_text(text.replace("params.T", "params.T + 1", 1))
    told = first(check(home, "4"))
    assert "both should be 3x" in told and "threw" not in told


def prints(home: Path, when: str, then: str = "") -> str:
    """What ./check shows of a part 1 that prints theta, and the stage that it is at."""
    put(home)
    change(
        home,
        "part1_contacts",
        "namespace bounce {\n",
        "#include <array>\n#include <cstdlib>\n#include <iostream>\nnamespace bounce {\n",
    )
    part1 = home / "src/part1_contacts.cpp"
    text = part1.read_text()
    line = f'  {when} std::cout << "theta = " << q(2);\n  {then}\n'
    part1.write_text(text.replace("  // Eq. (3)", line + "  // Eq. (3)"))
    return first(check(home, "1"))


def test_prints_are_those_of_the_case_that_is_told(home: Path) -> None:
    wrong = "if (q(2) > 1.2) return {Jacobian::Zero(), 0};"
    told = prints(home, "", wrong)
    asked = re.search(r"q = \(.*, (\S+)\)", told)
    assert asked and f"    theta = {asked[1]}\n" in told, told
    assert told.count("theta = ") == 1
    printed = (home / "build/check/printed_1.txt").read_text()
    assert printed.count("theta = ") > 20  # all of them are kept

    silent = prints(home, "if (q(2) < 1.2)", wrong)
    assert "theta = " not in silent and "printed nothing in this case" in silent


def test_what_was_printed_before_a_crash_is_shown(home: Path) -> None:
    told = prints(home, "", "if (q(2) > 1.2) std::abort();")
    asked = re.search(r"q = \(.*, (\S+)\)", told)
    assert asked and f"    theta = {asked[1]}\n" in told and told.count("theta = ") == 1, told


def test_an_index_out_of_range_is_told_with_its_matrix_and_once(home: Path) -> None:
    told = prints(home, "", "if (q(2) > 1.2) return {Jacobian::Zero(), q(3)};")
    assert re.search(
        r"an index of a 3x1 matrix is out of range, at src/part1_contacts.cpp:1\d\n", told
    )
    assert re.search(r"\n +before   \d+ right\n", told), told
    assert "Assertion" not in told and told.count("theta = ") == 1
    beyond = "std::array<double, 2>{}[std::size_t(9 * q(2))]"
    told = prints(home, "", f"if (q(2) > 1.2) return {{Jacobian::Zero(), {beyond}}};")
    assert "an index is beyond the end of a std::vector or std::array, at src/part1_con" in told


LAST = "lcp.p <<"
ERRORS = {  # what stands before the last statement of part 2, and what is said of it
    "a vector times a vector": ("v_free * v;", "a.dot(b) is the scalar product"),
    "a product of other sizes": ("J_hat * lcp.p;", "is a transpose() missing"),
    "two sizes": ("v_free + J_hat;", "rows x columns of both sides"),
    "a matrix for a number": ("double x = J_n.transpose() * J_hat;", "One type stands where"),
    "a const": ("params.mu = 0;", "It is const"),
    "no semicolon": ("int n = 3", "the one before lacks its semicolon"),
    "no such name": ("v_fre(0);", "Is it spelled as where"),
    "no such member": ("params.nu;", "Is it spelled as where"),
    "a column of a const matrix": ("J.col(0) = J_n;", "The left side is const"),
    "a function without parentheses": ("params.M.inverse();", "called with parentheses"),
    "a number plus a vector": ("1 + v_free;", "a number can't be added to a vector"),
    "a power": ("params.l ^ 2;", "^ is no power"),
    "the same name twice": ("Lcp lcp;", "leave out the type"),
    "auto in place of a type": (
        "auto f = params.M() * params.g; f += J_n;",
        "made with auto, which keeps an expression",
    ),
}


@pytest.mark.parametrize(
    "error", ["two sizes", *(pytest.param(e, marks=pytest.mark.long) for e in ERRORS)]
)
def test_an_error_of_the_compiler_is_told_in_words(home: Path, error: str) -> None:
    put(home)
    wrong, said = ERRORS[error]
    change(home, "part2_lcp", LAST, f"{wrong}\n  {LAST}")
    told = first(check(home, "2"))
    assert "  src/part2_lcp.cpp:2" in told and said in " ".join(told.split()), told


@pytest.mark.long
@pytest.mark.parametrize(
    "old, new",
    [
        ("const Vector3& v,", "Vector3& v,"),
        ("Jacobian& J, const Vector3& v,", "Jacobian& J, Vector3 v,"),
        ("namespace bounce {", "using namespace bounce;\nnamespace bouncy {"),
    ],
)
def test_another_function_than_the_declared_one_is_told(home: Path, old: str, new: str) -> None:
    put(home)
    change(home, "part2_lcp", old, new)
    run = check(home, "2")
    told = first(run)
    assert "Compare the function's line with its header" in " ".join(told.split()), told
    assert "Part 2  compiles, but does not link" in run.stdout and "not compile" not in run.stdout
    assert told.startswith("make part2_lcp.cpp link")
    assert "bounce::form_lcp(const Jacobian&, const Vector3&, const Parameters&)" in told


@pytest.mark.long
def test_another_result_than_the_declared_one_is_told(home: Path) -> None:
    put(home)
    change(home, "part2_lcp", "Lcp form_lcp(", "State form_lcp(")
    told = first(check(home, "2"))
    assert "its arguments, and what it returns" in " ".join(told.split()), told


def test_lines_of_any_length_are_read(home: Path) -> None:
    put(home)
    asserted = f'static_assert(false, "{"x" * 100_000}");'
    change(home, "part2_lcp", LAST, f"{asserted}\n  {LAST}")
    told = first(check(home, "2"))
    assert "  src/part2_lcp.cpp:2" in told and "static assertion failed" in told


@pytest.mark.long
def test_prints_of_any_length_are_read(home: Path) -> None:
    put(home)
    long = 'for (int i = 0; i < 50000; ++i) std::fputs("src/", stdout);'
    change(home, "part2_lcp", LAST, f"{long}\n  lcp.V(4, 4) = 0;\n  {LAST}")
    part2 = home / "src/part2_lcp.cpp"
    part2.write_text("#include <cstdio>\n" + part2.read_text())
    assert "is out of range, at src/part2_lcp.cpp:" in first(check(home, "2"))


def test_a_missing_return_comes_before_other_reasons(home: Path) -> None:
    put(home)
    change(home, "part2_lcp", "  return lcp;\n", "")
    told = first(check(home, "2"))
    assert re.search(r"  src/part2_lcp.cpp:\d+: the function can end without return", told), told


@pytest.mark.long
def test_sanitizers_find_what_a_right_answer_hides(home: Path) -> None:
    """The product refers to M, which is gone when it is worked out; its numbers may remain."""
    put(home)
    assert score(check(home, "2", "--sanitize")) == "30 / 30"
    force = "const Vector3 f_e = M * params.g;"
    change(home, "part2_lcp", force, "const auto f_e = params.M() * params.g;")
    told = first(check(home, "2", "--sanitize"))
    assert "src/part2_lcp.cpp:14: `auto` keeps an expression of Eigen" in told
    assert "=====" not in told and "It was asked: " in told and "Hint" not in told
    change(home, "part2_lcp", force, f"{force}\n  const int half = 1 << (33 + int(params.m));")
    part2 = home / "src/part2_lcp.cpp"
    part2.write_text(part2.read_text().replace("lcp.p <<", "lcp.V(3, 3) = 0 * half;\n  lcp.p <<"))
    told = first(check(home, "2", "--sanitize"))
    assert "src/part2_lcp.cpp:15: shift exponent" in told


@pytest.mark.parametrize(
    "folder, place",
    [
        ("part1_index_into_the_next_row", "src/part1_contacts.cpp:13: index 2 out of bounds"),
        ("part2_view_of_the_inverse", "src/part2_lcp.cpp:9: `auto` keeps an expression of Eigen"),
    ],
)
def test_full_points_are_looked_at_with_sanitizers(home: Path, folder: str, place: str) -> None:
    put(home, UNDEFINED / folder)
    run = check(home)
    assert (score(run), run.returncode) == ("100 / 100", 1)
    told = " ".join(run.stdout.partition("\nFirst: undefined behaviour")[2].split())
    assert told.startswith(place)
    assert not re.search("submit the files|known mistake|[Hh]int", run.stdout)
    assert "Looking for undefined behaviour" in run.stdout
    again = check(home)
    assert again.returncode == 1 and told in " ".join(again.stdout.split())
    assert "Looking for undefined behaviour" not in again.stdout


def test_where_there_are_no_sanitizers_it_says_so(home: Path) -> None:
    put(home)
    (home / "src/part1_contacts.cpp").write_text(
        (SOLUTION / "part1_contacts.cpp").read_text()
        + "#ifdef __SANITIZE_ADDRESS__\n#error no sanitizers\n#endif\n"
    )
    run = check(home)
    assert run.returncode == 0 and "submit the files" in run.stdout
    assert "Undefined behaviour was not looked for: the sanitizers of this" in run.stdout
    put(home)


def stage(home: Path) -> tuple[str, str]:
    """The heading and the stage of the hint that --hint opens."""
    said = check(home, "1", "--hint").stdout
    found = re.search(r"^Hint (\S+) .*, stage (\d) of 3", said, re.M)
    assert found, said
    return found[1], found[2]


def test_opens_the_hint_of_what_the_diagnosis_names(home: Path) -> None:
    """And not that of the first check that fails: the arm, 1.2."""
    put(home)
    (home / "build/check/hint").unlink(missing_ok=True)
    change(
        home,
        "part1_contacts",
        "return {J, q(1) + r.y()};",
        "J.row(2) << -r_k(1, 0), r_k(0, 0);\n  return {J, q(1) + r.y()};",
    )
    told = first(check(home, "1"))
    assert "Your J is always that of corner" in told and "Hint 1.3 Any of the four" in told, told
    assert stage(home) == ("1.3", "1")


def test_opens_the_hint_that_a_known_mistake_names(home: Path) -> None:
    """And not the one whose words its sentence has: "your q'", 3.6."""
    put(home, MISTAKES / "part3_no_lift_when_leaving")
    assert "Hint 3.4 A corner that leaves: ./check 3 --hint" in first(check(home, "3"))


def test_another_mistake_starts_at_the_first_stage(home: Path) -> None:
    put(home)
    stub = (SOLUTION.parents[1] / "student/src/part1_contacts.cpp").read_text()
    (home / "src/part1_contacts.cpp").write_text(stub)
    assert [stage(home) for _ in range(2)] == [("1.1", "1"), ("1.1", "2")]
    (home / "src/part1_contacts.cpp").write_text(stub + "// another try, and the same mistake\n")
    assert stage(home) == ("1.1", "3")

    phi = "return {J, q(1) + r.y()};"  # under the same heading, another mistake
    change(home, "part1_contacts", phi, "return {J, r.y()};")
    assert [stage(home) for _ in range(2)] == [("1.1", "1"), ("1.1", "2")]
    change(home, "part1_contacts", phi, "return {J, q(1) - r.y()};")
    assert stage(home) == ("1.1", "1")
    change(home, "part1_contacts", phi, "return {J, r.y()};")
    assert stage(home) == ("1.1", "1")


def test_says_that_no_stage_is_left(home: Path) -> None:
    put(home, MISTAKES / "part1_turned_clockwise")
    (home / "build/check/hint").unlink(missing_ok=True)
    said = [check(home, "1", "--hint").stdout for _ in range(4)]
    assert ["last stage" in text for text in said] == [False, False, True, True]
    assert "there is no further one" in said[3] and "no further" not in said[2]
