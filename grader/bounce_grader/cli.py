"""The commands of ./kit."""

import argparse
import os
import sys
from functools import partial
from importlib import import_module
from typing import Any, NoReturn

from bounce_grader import __version__, formats
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_text, terminal
from bounce_grader.common.paths import given_path, ROOT


class Parser(argparse.ArgumentParser):
    """Says in one sentence what is wrong."""

    def error(self, message: str) -> NoReturn:
        raise UsageError(f"{message} ({self.prog} --help)")


def main(arguments: list[str]) -> int:
    """The exit status of a command, or of the error that ended it, which is printed."""
    try:
        try:
            options = _parser().parse_args(arguments)
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
        if isinstance(error, OSError):  # a full standard output, which is flushed again
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 3


def _plain(message: str) -> str:
    """Escapes an error's message, which may hold names of files and output of programs."""
    return "\n".join(map(terminal, printable_text(message).split("\n")))


def _parser() -> argparse.ArgumentParser:
    parser = Parser(prog="kit", description="Grades the bouncing assignment.")
    parser.add_argument("--version", action="version", version=f"kit {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    def command(name: str, module: str, help: str) -> Any:
        """A command that the function `run` of a module carries out; the grader's begin with a dot."""
        made = commands.add_parser(name, help=help)
        made.set_defaults(command=lambda given: import_module(module, "bounce_grader").run(given))
        return made

    _add_grade(command("grade", ".grade_command", "grade a submission: a folder or an archive"))
    _add_class(command("class", ".classroom.run", "grade a whole class"))

    gradescope = command("gradescope", ".publish.gradescope", "pack an autograder for Gradescope")
    gradescope.add_argument("--out", type=given_path, required=True, metavar="FILE.zip")

    fixtures = command("fixtures", ".publish.fixtures", "write the fixtures from the solution")
    fixtures.add_argument("--check", action="store_true", help="only compare the committed ones")

    command("doctor", ".doctor", "test whether the sandbox holds here")

    handout = command("handout", ".publish.handout", "write what students receive, as a zip")
    handout.add_argument("--out", type=given_path, required=True, metavar="FILE.zip")

    # The study and what tests the kit are beside the grader.
    sys.path += [str(ROOT / folder) for folder in ("solution/study", "tests")]
    study = "measure the methods: tables, charts and pages"
    _add_study(command("study", "bounce_study.command", study))

    bench = command("bench", "bench", "measure the grader's speed")
    bench.add_argument("--submissions", type=int, default=100, metavar="N", help="of a class")

    tests = command("test", "run_all", "run every test of the kit")
    test = tests.add_mutually_exclusive_group()
    accept = "write what golden tests expect anew, for you to read in the diff"
    test.add_argument("--accept", action="store_true", help=accept)
    is_long = "also with sanitizers, and a million inputs for each reader"
    test.add_argument("--long", action="store_true", help=is_long)
    return parser


def _add_grade(parser: argparse.ArgumentParser) -> None:
    option = parser.add_argument
    option("submission", type=given_path)
    option("--json", metavar="FILE", help="write the score record ('-': to standard output)")
    names = f"in place of the report: {', '.join(formats.NAMES)}"
    option("--format", choices=formats.NAMES, metavar="NAME", help=names)
    option("--min-score", type=float, metavar="S", help="exit with 1 below this score")
    option("--speed", action="store_true", help="chart speed against accuracy")
    public = "on the public cases alone: the record has the parts that ./check --json writes"
    option("--public", action="store_true", help=public)
    option("--reveal", action="store_true", help="also show the expected answers of hidden cases")
    remarks = "skip warnings about undefined behaviour"
    option("--no-sanitize", action="store_true", help=remarks)
    box = parser.add_mutually_exclusive_group().add_argument
    box("--require-box", choices=["full"], help="refuse to grade without this sandbox")
    box("--trust-submission", action="store_true", help="grade without a sandbox if need be")


def _add_class(parser: argparse.ArgumentParser) -> None:
    option = parser.add_argument
    services = "Canvas, Moodle, Blackboard or Brightspace"
    handed_in = f"a download from {services}, a folder of folders or zips, or of repositories"
    option("submissions", type=given_path, nargs="?", help=handed_in)
    option("--out", type=given_path, required=True, metavar="DIR", help="the folder to write")
    option("--gradebook", type=given_path, metavar="CSV", help=f"the grades from {services}")
    option("--column", default="", metavar="TITLE", help="its column, as in 'HW3 (98765)'")
    download = "download the submissions by Canvas's API, with CANVAS_URL and CANVAS_TOKEN from"
    canvas = f"{download} the environment; shows what --upload would change there"
    option("--canvas", default="", metavar="COURSE/ASSIGNMENT", help=canvas)
    corpus = "other years' submissions, to find similar ones there as well"
    option("--corpus", type=given_path, nargs="+", default=[], metavar="FOLDER", help=corpus)
    option("--jobs", type=int, metavar="N", help="gradings at the same time")
    option("--dask", default="", metavar="ADDRESS", help="grade on the workers of this scheduler")
    flag = partial(option, action="store_true")
    flag("--upload", help="post the points and pages that were shown to Canvas")
    flag("--overwrite", help="replace points that somebody else entered in the column")
    flag("--apply", help="use this kit version's results instead of another's")
    flag("--speed", help="chart speed against accuracy; takes twice as long")
    sanitize = "warn about undefined behaviour in parts with full marks; takes half as long again"
    flag("--sanitize", help=sanitize)
    reveal = "put the expected answers of hidden cases into the feedback; may be added later"
    flag("--reveal", help=reveal)
    flag("--trust-submission", help="grade without a sandbox if need be")


def _add_study(parser: argparse.ArgumentParser) -> None:
    option = parser.add_argument
    motion = "its motion within a tolerance, the simplest sufficient model, the cheapest method"
    asked = f"tables to measure; all unless named. Or: simulate SCENE.json, {motion}. Or: scene, a template. Or: bench ADAPTER"
    option("questions", nargs="*", metavar="QUESTION", help=asked)
    option("--tolerance", metavar="METRES", help="of simulate: the largest error (default: 0.001)")
    file = partial(option, type=given_path)
    file("--json", metavar="FILE", help="of simulate: the motion, and all else")
    file("--picture", metavar="FILE.svg", help="of simulate: the same, drawn")
    written = "what is written (default: docs/studies, build/kit/quick-study with --quick)"
    file("--out", metavar="FOLDER", help=written)
    file("--squares", metavar="FILE", help="of the question `measured`: drops of squares")
    file("--ellipses", metavar="FILE", help="of the question `measured`: impacts of ellipses")
    option("--quick", action="store_true", help="fewer rounds and random scenes")
    option("--peers", action="store_true", help="also off-the-shelf engines; installs them")
