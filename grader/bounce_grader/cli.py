"""The commands of ./kit."""

import argparse
import json
import os
import sys
from pathlib import Path

from bounce_grader import __version__
from bounce_grader.errors import KitError, UsageError


def main(arguments: list[str]) -> int:
    options = _parser().parse_args(arguments)
    try:
        return int(options.command(options))
    except UsageError as error:
        print(f"kit: {error}", file=sys.stderr)
        return 2
    except KitError as error:
        print(f"kit: the kit itself failed: {error}", file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        print("kit: stopped", file=sys.stderr)
        return 130
    except BrokenPipeError:  # whoever read the report has seen enough, as with `| head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    except OSError as error:
        print(f"kit: the kit itself failed: {error}", file=sys.stderr)
        return 3


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="kit", description="Grades the bouncing assignment.")
    parser.add_argument("--version", action="version", version=f"kit {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    grade = commands.add_parser("grade", help="grade a submission: a folder or a zip")
    grade.add_argument("submission", type=Path)
    grade.add_argument(
        "--json", metavar="FILE", help="write the score record ('-': to standard output)"
    )
    grade.add_argument("--min-score", type=float, metavar="S", help="exit with 1 below this score")
    grade.add_argument("--speed", action="store_true", help="time a step beside the solution's")
    grade.add_argument(
        "--trust-submission", action="store_true", help="grade without a box where none can be had"
    )
    grade.set_defaults(command=_grade)

    fixtures = commands.add_parser("fixtures", help="write the fixtures from the solution")
    fixtures.add_argument("--check", action="store_true", help="only compare the committed ones")
    fixtures.set_defaults(command=_fixtures)

    handout = commands.add_parser("handout", help="write what students receive, as a zip")
    handout.add_argument("--out", type=Path, required=True, metavar="FILE.zip")
    handout.set_defaults(command=_handout)

    bench = commands.add_parser("bench", help="measure the grader's speed")
    bench.set_defaults(command=_bench)

    test = commands.add_parser("test", help="run every test of the kit")
    extent = test.add_mutually_exclusive_group()
    extent.add_argument("--quick", action="store_true", help="what can be said in a minute")
    extent.add_argument("--long", action="store_true", help="with sanitizers, too")
    test.set_defaults(command=_test)
    return parser


def _grade(options: argparse.Namespace) -> int:
    from bounce_grader import report
    from bounce_grader.grade import Options, grade

    record = grade(options.submission, Options(options.trust_submission, options.speed))
    text = json.dumps(record, indent=1, ensure_ascii=False)
    if options.json == "-":
        print(text)
    else:
        report.show(record)
    if options.json not in (None, "-"):
        _write(Path(options.json), text + "\n")
    return int(options.min_score is not None and record["score"] < options.min_score)


def _write(path: Path, text: str) -> None:
    """Whole or not at all."""
    temporary = path.with_name(path.name + ".part")
    try:
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(path)
    except OSError as error:
        raise UsageError(f"{path} can't be written: {error.strerror}") from error


def _fixtures(options: argparse.Namespace) -> int:
    from bounce_grader import fixtures

    if not options.check:
        fixtures.write_all()
        return 0
    differing = fixtures.differing()
    for name in differing:
        print(f"fixtures/public/{name} isn't what the solution writes: run ./kit fixtures")
    return int(bool(differing))


def _handout(options: argparse.Namespace) -> int:
    from bounce_grader import handout

    print(f"{options.out} holds {handout.write(options.out)} files")
    return 0


def _bench(options: argparse.Namespace) -> int:
    from bounce_grader import bench

    return bench.run()


def _test(options: argparse.Namespace) -> int:
    from bounce_grader import selftest

    return selftest.run("quick" if options.quick else "long" if options.long else "usual")
