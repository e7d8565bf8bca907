"""The commands of ./kit."""

import argparse
import os
import sys
from collections.abc import Callable
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

    def command(
        name: str, run: Callable[[argparse.Namespace], int], help: str
    ) -> argparse.ArgumentParser:
        made: argparse.ArgumentParser = commands.add_parser(name, help=help)
        made.set_defaults(command=run)
        return made

    grade = command("grade", _grade, "grade a submission: a folder or an archive")
    grade.add_argument("submission", type=Path)
    option, names = grade.add_argument, ", ".join(formats.NAMES)
    option("--json", metavar="FILE", help="write the score record ('-': to standard output)")
    option(
        "--format", choices=formats.NAMES, metavar="NAME", help=f"in place of the report: {names}"
    )
    option("--min-score", type=float, metavar="S", help="exit with 1 below this score")
    option("--speed", action="store_true", help="chart speed against accuracy")
    option("--reveal", action="store_true", help="show the expected answers of hidden cases, too")
    remarks = "leave out remarks about undefined behaviour, which take longer than all else"
    option("--no-sanitize", action="store_true", help=remarks)
    box = grade.add_mutually_exclusive_group().add_argument
    box("--require-box", choices=["full"], help="refuse to grade where this box can't be had")
    box("--trust-submission", action="store_true", help="grade without a box where none can be had")

    class_cli.add(commands)

    gradescope = command("gradescope", _gradescope, "pack an autograder for Gradescope")
    gradescope.add_argument("--out", type=Path, required=True, metavar="FILE.zip")

    fixtures = command("fixtures", _fixtures, "write the fixtures from the solution")
    fixtures.add_argument("--check", action="store_true", help="only compare the committed ones")

    command("doctor", _doctor, "try out whether the boxes hold here")

    handout = command("handout", _handout, "write what students receive, as a zip")
    handout.add_argument("--out", type=Path, required=True, metavar="FILE.zip")

    study.add(commands)

    bench = command("bench", _bench, "measure the grader's speed")
    bench.add_argument("--submissions", type=int, default=100, metavar="N", help="of a class")

    test = command("test", _test, "run every test of the kit").add_mutually_exclusive_group()
    accept = "write what golden tests expect anew, for you to read in the diff"
    test.add_argument("--accept", action="store_true", help=accept)
    is_long = "with sanitizers, and a million inputs for each reader, too"
    test.add_argument("--long", action="store_true", help=is_long)
    return parser


def _grade(options: argparse.Namespace) -> int:
    from bounce_grader.common.files import write_whole
    from bounce_grader.formats import terminal
    from bounce_grader.grading.grade import grade, Options
    from bounce_grader.grading.record import with_answers
    from bounce_grader.sandbox.box import kinds

    if options.format and options.json == "-":
        raise UsageError("--format and --json - both write to standard output: give one")
    folder = Path(options.json or "").parent
    if not folder.is_dir():
        raise UsageError(f"{options.json} can't be written: there is no folder {folder}")
    acceptable = (options.require_box,) if options.require_box else kinds(options.trust_submission)
    wanted = Options(acceptable, options.speed, not options.no_sanitize, answers=options.reveal)
    try:
        record = grade(options.submission, wanted)
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
        print(formats.render(options.format, record))
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

    return fixtures.check() if options.check else fixtures.write_all()


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
