"""The report, from records written by hand: no process is started."""

import io
from typing import Any

from bounce_grader.build.compiler import compile_problem
from bounce_grader.build.linking import link_problem
from bounce_grader.formats import terminal
from bounce_grader.sandbox.processes import Result


def check(passed: bool, message: str = "") -> dict[str, Any]:
    return {
        "id": "part1.GivesTheNormalColumn",
        "title": "the second column of J is J_n",
        "score": 6 if passed else 0,
        "max_score": 6,
        "passed": passed,
        "message": message,
        "mistake": None,
    }


def record(part: dict[str, Any], **changes: Any) -> dict[str, Any]:
    usual = {
        "part": 1,
        "title": "Contact distance and Jacobian",
        "score": 0,
        "max_score": 6,
        "status": "graded",
        "message": "1 of 1 checks failed",
        "graded_with": "own",
        "mistakes": [],
        "patterns": [],
        "checks": [check(False, "got phi = 1")],
    }
    whole = {"score": 0, "max_score": 6, "ignored": [], "box": "full"}
    return {**whole, "parts": [{**usual, **part}], **changes}


def shown(of: dict[str, Any]) -> str:
    stream = io.StringIO()
    terminal.show(of, stream)
    return stream.getvalue()


def test_begins_with_the_score_and_ends_a_failed_check_with_its_hint() -> None:
    text = shown(record({}))
    assert text.startswith("Score 0 / 6\n")
    assert "✗ the second column of J is J_n" in text
    assert "got phi = 1\n      hint 1.2" in text


def test_a_right_part_shows_its_checks_and_no_message() -> None:
    part = {"score": 6, "checks": [check(True)], "message": "everything right"}
    text = shown(record(part, score=6))
    assert "✓ the second column of J is J_n" in text and "hint" not in text


MISTAKE = {
    "name": "part1_columns_swapped",
    "title": "The columns of J are exchanged",
    "sentence": "Both columns of J are right.",
    "equations": [5, 6],
    "hint": "1.2 The moment arm r",
}


def test_a_known_mistake_is_said_once_with_where_to_read() -> None:
    checks = [check(False, "got phi = 1"), check(False, "got phi = 2")]
    text = shown(record({"checks": checks, "mistakes": [MISTAKE]}))
    assert text.count("looks like: The columns of J are exchanged\n") == 1
    assert "Both columns of J are right.\n    eqs. (5), (6) and hint 1.2 The moment arm r\n" in text


def test_what_the_numbers_say_stands_above_the_checks() -> None:
    text = shown(record({"patterns": ["Every wrong number is -1 times the right one."]}))
    assert text.index("-1 times the right one") < text.index("✗")


def test_half_points_are_written_without_zeros() -> None:
    assert "Score 87.5 / 100\n" in shown(record({}, score=87.5, max_score=100.0))


def test_control_characters_and_markup_are_only_text() -> None:
    wild = "\x1b[2J\x07 [bold red]not markup[/] \u202e \x9b31m"
    text = shown(record({"checks": [check(False, wild)], "message": wild, "status": "crashed"}))
    assert "[bold red]not markup[/]" in text
    assert not any(c in text for c in "\x1b\x07\u202e\x9b")


def test_files_that_were_not_used_are_named_but_not_all() -> None:
    names = [f"old{i}.o" for i in range(9)]
    assert "Not used: old0.o, old1.o, old2.o, old3.o, old4.o and 4 more" in shown(
        record({}, ignored=names)
    )


def test_what_the_kit_hands_out_is_not_worth_a_word() -> None:
    assert "Not used" not in shown(record({}, ignored=["README.md", "given/render.cpp"]))


def test_speed_is_said_beside_the_solutions() -> None:
    speed = {"submission_ns": 400.0, "solution_ns": 200.0, "ratio": 2.0, "largest_error": 3e-13}
    text = shown(record({}, speed=speed))
    assert "400 ns a step, the solution 200 ns: 2.00 times its time; largest error 3.0e-13" in text


def test_grading_without_a_box_is_said() -> None:
    assert "without a box" in shown(record({}, box="none"))


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
    assert told == "invalid matrix product, asked for at part2_lcp.cpp:11 (Product.h:1:2)"


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
