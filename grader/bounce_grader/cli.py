"""The commands of ./kit."""

import argparse
import os
import sys
from importlib import import_module
from typing import Any, NoReturn

from bounce_grader import __version__, formats
from bounce_grader.classroom import cli as class_cli
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_text, terminal
from bounce_grader.common.paths import given_path
from bounce_grader.develop import study


class Parser(argparse.ArgumentParser):
    """Says in one sentence what is wrong."""

    def error(self, message: str) -> NoReturn:
        raise UsageError(f"{message} ({self.prog} --help)")


def main(arguments: list[str]) -> int:
    """The exit status of a command: what it returns if that is a number, 0 if it isn't; or that of
    the error that ended it, which is printed."""
    try:
        try:
            options = _parser().parse_args(arguments)
            returned = options.command(options)
            return returned if isinstance(returned, int) else 0
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


def _plain(message: str) -> str:
    """Escapes an error's message, which may hold names of files and output of programs."""
    return "\n".join(map(terminal, printable_text(message).split("\n")))


def _parser() -> argparse.ArgumentParser:
    parser = Parser(prog="kit", description="Grades the bouncing assignment.")
    parser.add_argument("--version", action="version", version=f"kit {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    def command(name: str, module: str, help: str) -> Any:
        """A command that the function `run` of a module carries out."""
        made = commands.add_parser(name, help=help)
        made.set_defaults(command=lambda given: import_module(f"bounce_grader.{module}").run(given))
        return made

    grade = command("grade", "grade_command", "grade a submission: a folder or an archive")
    grade.add_argument("submission", type=given_path)
    option = grade.add_argument
    option("--json", metavar="FILE", help="write the score record ('-': to standard output)")
    names = f"in place of the report: {', '.join(formats.NAMES)}"
    option("--format", choices=formats.NAMES, metavar="NAME", help=names)
    option("--min-score", type=float, metavar="S", help="exit with 1 below this score")
    option("--speed", action="store_true", help="chart speed against accuracy")
    option("--reveal", action="store_true", help="show the expected answers of hidden cases, too")
    remarks = "leave out remarks about undefined behaviour, which take longer than all else"
    option("--no-sanitize", action="store_true", help=remarks)
    box = grade.add_mutually_exclusive_group().add_argument
    box("--require-box", choices=["full"], help="refuse to grade where this box can't be had")
    box("--trust-submission", action="store_true", help="grade without a box where none can be had")

    class_cli.add(command("class", "classroom.cli", "grade a whole class"))

    gradescope = command("gradescope", "publish.gradescope", "pack an autograder for Gradescope")
    gradescope.add_argument("--out", type=given_path, required=True, metavar="FILE.zip")

    fixtures = command("fixtures", "publish.fixtures", "write the fixtures from the solution")
    fixtures.add_argument("--check", action="store_true", help="only compare the committed ones")

    command("doctor", "develop.doctor", "try out whether the boxes hold here")

    handout = command("handout", "publish.handout", "write what students receive, as a zip")
    handout.add_argument("--out", type=given_path, required=True, metavar="FILE.zip")

    study.add(command("study", "develop.study", "measure the methods: tables, charts and pages"))

    bench = command("bench", "develop.bench", "measure the grader's speed")
    bench.add_argument("--submissions", type=int, default=100, metavar="N", help="of a class")

    tests = command("test", "develop.selftest", "run every test of the kit")
    test = tests.add_mutually_exclusive_group()
    accept = "write what golden tests expect anew, for you to read in the diff"
    test.add_argument("--accept", action="store_true", help=accept)
    is_long = "with sanitizers, and a million inputs for each reader, too"
    test.add_argument("--long", action="store_true", help=is_long)
    return parser
