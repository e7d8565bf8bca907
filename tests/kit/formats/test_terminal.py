"""The report, from the record written by hand: no process is started."""

import io
import json
import re
from typing import Any

import pytest
from bounce_grader.build.compiler import compile_problem
from bounce_grader.build.linking import link_problem
from bounce_grader.formats import terminal
from bounce_grader.sandbox.processes import Result
from conftest import ROOT

FOLDER = ROOT / "tests" / "kit" / "formats" / "expected"
RECORD = json.loads((FOLDER / "record.json").read_text())
PART = RECORD["parts"][0]


def shown(**changes: Any) -> str:
    stream = io.StringIO()
    terminal.show({**RECORD, **changes}, stream)
    return stream.getvalue()


def test_is_what_a_person_has_read() -> None:
    assert shown() == (FOLDER / "terminal.txt").read_text()


def test_a_right_part_shows_its_checks_and_no_message() -> None:
    checks = [{**check, "passed": True, "message": ""} for check in PART["checks"]]
    right = {"score": 30, "checks": checks, "message": "everything right", "mistakes": []}
    text = shown(parts=[{**PART, **right}])
    assert "✓ the second column of J is J_n" in text
    assert "hint" not in text and "everything right" not in text


def test_half_points_are_written_without_zeros() -> None:
    assert "Score 87.5 / 100\n" in shown(score=87.5, max_score=100.0)


def test_control_characters_and_markup_are_only_text() -> None:
    wild = "\x1b[2J\x07 [bold red]not markup[/] \u202e \x9b31m"
    check = {**PART["checks"][0], "message": wild}
    text = shown(parts=[{**PART, "checks": [check], "message": wild, "status": "crashed"}])
    assert text.count("[bold red]not markup[/]") == 2
    assert not any(c in text for c in "\x1b\x07\u202e\x9b")


def test_files_that_were_not_used_are_named_but_not_all() -> None:
    text = shown(ignored=[f"old{i}.o" for i in range(9)])
    assert "Not used: old0.o, old1.o, old2.o, old3.o, old4.o and 4 more" in text


def test_what_the_kit_hands_out_is_not_worth_a_word() -> None:
    assert "Not used" not in shown(ignored=["README.md", "given/render.cpp"])


def test_speed_is_said_beside_the_solutions() -> None:
    speed = {"submission_ns": 400.0, "solution_ns": 200.0, "ratio": 2.0, "largest_error": 3e-13}
    line = "400 ns a step, the solution 200 ns: 2.00 times its time; largest error 3.0e-13"
    assert line in shown(speed=speed)


def test_grading_without_a_box_is_said() -> None:
    assert "without a box" in shown(box="none")


def failed(err: str, code: int = 1, too_long: bool = False) -> Result:
    return Result(code, 0.0, b"", err, too_long, False)


def test_the_first_error_is_the_one_that_is_told() -> None:
    err = "part2_lcp.cpp:7:3: warning: x\npart2_lcp.cpp:9:1: error: first\na.cpp:1:1: error: second"
    assert compile_problem(failed(err), "part2_lcp.cpp") == "part2_lcp.cpp:9:1: first"


def test_an_error_inside_eigen_names_the_line_that_asked_for_it() -> None:
    err = (
        "/usr/include/eigen3/Eigen/src/Core/Product.h:1:2: error: static_assert failed due to "
        "requirement 'ProductIsValid' \"INVALID_MATRIX_PRODUCT\"\n"
        "part2_lcp.cpp:11:30: note: in instantiation of function template\n"
    )
    told = compile_problem(failed(err), "part2_lcp.cpp")
    assert told == (
        "invalid matrix product, asked for at part2_lcp.cpp:11 (Product.h:1:2). The left one needs "
        "as many columns as the right one has rows: is a transpose() missing?"
    )


@pytest.mark.parametrize(
    "said, meant",
    [
        ("use of undeclared identifier 'mu'", "Is it spelled as where it comes from"),
        ("unknown type name 'Matrix3d'; did you mean 'Eigen::Matrix3d'?", "Is it spelled as"),
        ("expected ';' at end of declaration", "Often this line or the one before lacks"),
        ("reference to non-static member function must be called", "called with parentheses"),
        ("no viable overloaded '+='", "The left side is const"),
        ("cannot assign to variable 'params' with const-qualified type 'x'", "It is const"),
        ("no viable conversion from 'const Product<V, V>' to 'double'", "is a.dot(b)"),
        ("invalid operands to binary expression ('const double' and 'int')", "^ is no power"),
        ("no matching function for call to 'form_lcp'", "Compare the call"),
        ("redefinition of 'lcp'", "leave out the type"),
        ("extraneous closing brace ('}')", "count { and }"),
    ],
)
def test_a_common_error_is_told_with_what_it_means(said: str, meant: str) -> None:
    told = compile_problem(failed(f"part2_lcp.cpp:9:1: error: {said}\n"), "part2_lcp.cpp")
    assert re.match(rf"part2_lcp.cpp:9:1: {re.escape(said)}\.? \w", told) and meant in told


def refused_by_eigen(instantiated: str) -> str:
    err = (
        "/usr/include/eigen3/Eigen/src/Core/Product.h:1:2: error: static_assert failed\n"
        "part2_lcp.cpp:11:30: note: in instantiation of function template specialization "
        f"'Eigen::{instantiated}' requested here\n"
    )
    return compile_problem(failed(err), "part2_lcp.cpp").partition(", asked for")[0]


VECTOR = "Eigen::Matrix<double, 3, 1, 0>"
J = "Eigen::Matrix<double, 3, 2, 0>"


def test_shapes_that_do_not_fit_are_told() -> None:
    product = f"MatrixBase<{J}>::operator*<{VECTOR}>"
    assert refused_by_eigen(product) == "a 3x2 and a 3x1 can't be multiplied"
    column = f"Eigen::Block<const {J}, 3, 1, true>"
    both = f"Eigen::CwiseBinaryOp<Eigen::internal::scalar_sum_op<double>, const {VECTOR}, {column}>"
    total = f"MatrixBase<{both}>::operator+<Eigen::Matrix<double, 4, 1, 0>>"
    assert refused_by_eigen(total) == "a 3x1 and a 4x1 can't be added"
    velocity = f"Eigen::Product<Eigen::Transpose<const {J}>, {VECTOR}, 0>"
    assigned = f"Matrix<double, 3, 1, 0>::Matrix<{velocity}>"
    assert refused_by_eigen(assigned) == "a 2x1 can't be assigned to a 3x1"


@pytest.mark.parametrize(
    "instantiated",
    [
        f"MatrixBase<{VECTOR}>::operator+<{VECTOR}>",
        f"MatrixBase<Eigen::Matrix<double, -1, -1>>::operator*<{VECTOR}>",
        f"MatrixBase<{VECTOR}>::norm",
        "A<" * 4000,
        "",
    ],
)
def test_of_shapes_that_fit_or_are_unknown_none_is_told(instantiated: str) -> None:
    assert refused_by_eigen(instantiated) == "static_assert failed"


def test_a_compiler_that_ran_too_long_is_told_so() -> None:
    assert "more than 15 s" in compile_problem(failed("", too_long=True), "part1_contacts.cpp")
    assert "more than 15 s" in compile_problem(failed("", code=128 + 24), "part1_contacts.cpp")


def test_what_the_linker_misses_is_told_with_its_line() -> None:
    err = (
        "ld.lld: error: undefined symbol: rotation(double)\n"
        ">>> referenced by part3_step.cpp:12 (/tmp/x/part3_step.cpp:12)\n"
    )
    told = link_problem(failed(err))
    assert told == "part3_step.cpp:12 uses rotation(double), which no file that compiles defines"
