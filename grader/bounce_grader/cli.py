"""The commands of ./kit."""

import argparse
import os
import sys
from pathlib import Path

from bounce_grader import __version__, formats
from bounce_grader.classroom import cli as class_cli
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import json_document, printable_text, terminal
from bounce_grader.common.manifest import parts
from bounce_grader.develop import study


def main(arguments: list[str]) -> int:
    options = _parser().parse_args(arguments)
    try:
        try:
            return int(options.command(options))
        finally:
            sys.stdout.flush()
    except UsageError as error:
        print(f"kit: {_plain(str(error))}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("kit: stopped", file=sys.stderr)
        return 130
    except BrokenPipeError:  # the reader closed the pipe, as `| head` does
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    except Exception as error:  # an unforeseen fault of the kit must not end as a low score
        known = isinstance(error, KitError | OSError)
        words = str(error) if known else f"{type(error).__name__}: {error}"
        print(f"kit: the kit itself failed: {_plain(words)}", file=sys.stderr)
        return 3


def check_manifest() -> int:
    """Says what is wrong in parts.json, before anything is built from it. Returns an exit
    status."""
    try:
        parts()
    except UsageError as error:
        print(f"kit: {_plain(str(error))}", file=sys.stderr)
        return 2
    return 0


def _plain(message: str) -> str:
    """Escapes an error's message, which may hold names of files and output of programs."""
    return "\n".join(map(terminal, printable_text(message).split("\n")))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="kit", description="Grades the bouncing assignment.")
    parser.add_argument("--version", action="version", version=f"kit {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    grade = commands.add_parser("grade", help="grade a submission: a folder or an archive")
    grade.add_argument("submission", type=Path)
    grade.add_argument(
        "--json", metavar="FILE", help="write the score record ('-': to standard output)"
    )
    grade.add_argument(
        "--format",
        choices=formats.NAMES,
        metavar="NAME",
        help=f"what is printed, in place of the report: {', '.join(formats.NAMES)}",
    )
    grade.add_argument(
        "--before",
        type=Path,
        metavar="FILE",
        help="say what has changed since this record, or Gradescope's submission_metadata.json",
    )
    grade.add_argument("--min-score", type=float, metavar="S", help="exit with 1 below this score")
    grade.add_argument(
        "--speed", action="store_true", help="chart speed against accuracy, beside the solution's"
    )
    grade.add_argument(
        "--reveal", action="store_true", help="show the expected answers of hidden cases, too"
    )
    grade.add_argument(
        "--no-sanitize",
        action="store_true",
        help="leave out the remarks about undefined behaviour in parts with all points, which take "
        "longer than all else",
    )
    boxes = grade.add_mutually_exclusive_group()
    boxes.add_argument(
        "--require-box", choices=["full"], help="refuse to grade where this box can't be had"
    )
    boxes.add_argument(
        "--trust-submission", action="store_true", help="grade without a box where none can be had"
    )
    grade.set_defaults(command=_grade)

    class_cli.add(commands)

    gradescope = commands.add_parser("gradescope", help="pack an autograder for Gradescope")
    gradescope.add_argument("--out", type=Path, required=True, metavar="FILE.zip")
    gradescope.set_defaults(command=_gradescope)

    fixtures = commands.add_parser("fixtures", help="write the fixtures from the solution")
    fixtures.add_argument("--check", action="store_true", help="only compare the committed ones")
    fixtures.set_defaults(command=_fixtures)

    doctor = commands.add_parser("doctor", help="try out whether the boxes hold here")
    doctor.set_defaults(command=_doctor)

    handout = commands.add_parser("handout", help="write what students receive, as a zip")
    handout.add_argument("--out", type=Path, required=True, metavar="FILE.zip")
    handout.set_defaults(command=_handout)

    study.add(commands)

    bench = commands.add_parser("bench", help="measure the grader's speed")
    bench.add_argument("--submissions", type=int, default=100, metavar="N", help="of a class")
    bench.set_defaults(command=_bench)

    test = commands.add_parser("test", help="run every test of the kit")
    extent = test.add_mutually_exclusive_group()
    extent.add_argument(
        "--accept",
        action="store_true",
        help="write what golden tests expect anew, for you to read in the diff",
    )
    extent.add_argument(
        "--long",
        action="store_true",
        help="with sanitizers, and a million inputs for each reader, too",
    )
    test.set_defaults(command=_test)
    return parser


def _grade(options: argparse.Namespace) -> int:
    from bounce_grader.common.files import write_whole
    from bounce_grader.formats import terminal
    from bounce_grader.grading.grade import grade, Options
    from bounce_grader.grading import previous
    from bounce_grader.grading.record import with_answers
    from bounce_grader.sandbox.box import kinds

    if options.format and options.json == "-":
        raise UsageError("--format and --json - both write to standard output: give one")
    folder = Path(options.json or "").parent
    if not folder.is_dir():
        raise UsageError(f"{options.json} can't be written: there is no folder {folder}")
    earlier = previous.read(options.before) if options.before else None
    acceptable = (options.require_box,) if options.require_box else kinds(options.trust_submission)
    wanted = Options(acceptable, options.speed, not options.no_sanitize, answers=options.reveal)
    try:
        record = previous.compared(grade(options.submission, wanted), earlier)
    except UsageError as error:
        refused = formats.refused(options.format, str(error))
        if refused:
            print(refused)
        raise
    record = with_answers(record) if options.reveal else record
    text = json_document(record, indent=1)
    if options.json == "-":
        print(text)
    elif options.format:
        pass_score = options.min_score or 0.0
        print(formats.render(options.format, record, options.submission, pass_score))
    else:
        terminal.show(record)
    if options.json not in (None, "-"):
        try:
            write_whole(Path(options.json), text + "\n")
        except OSError as error:
            raise UsageError(f"{options.json} can't be written: {error.strerror}") from error
    return int(options.min_score is not None and record["score"] < options.min_score)


def _gradescope(options: argparse.Namespace) -> int:
    from bounce_grader.publish import gradescope

    gradescope.write(options.out)
    return 0


def _fixtures(options: argparse.Namespace) -> int:
    from bounce_grader.publish import fixtures

    if not options.check:
        fixtures.write_all()
        return 0
    return fixtures.check()


def _doctor(options: argparse.Namespace) -> int:
    from bounce_grader.develop import doctor

    return doctor.run()


def _handout(options: argparse.Namespace) -> int:
    from bounce_grader.publish import handout

    print(f"{options.out} holds {handout.write(options.out)} files")
    return 0


def _bench(options: argparse.Namespace) -> int:
    from bounce_grader.develop import bench

    return bench.run(options.submissions)


def _test(options: argparse.Namespace) -> int:
    from bounce_grader.develop import selftest

    return selftest.accept() if options.accept else selftest.run(options.long)
