"""Reads course.toml, which an instructor writes into the output folder: the assignment's title, and
what lateness costs."""

import difflib
import json
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.classroom.intake.table import rows_of
from bounce_grader.common.errors import KitError, UsageError

COURSE = "course.toml"
SLIP_DAYS = "slip_days.csv"  # in the output folder: the free days that each student has used


class Course(NamedTuple):
    """The assignment's title and its policy on lateness."""

    title: str = ""
    percent_per_day: float = 0.0  # of the assignment's points, for each day begun
    at_most_percent: float = 100.0
    grace_minutes: int = 0  # by which the deadline is later than the service says
    slip_days: int = 0  # days late in the term that cost a student nothing
    earlier: tuple[str, ...] = ()  # the output folders of earlier assignments
    attempt: str = "last"  # or "best"


PERCENT = (r"0(\.0)?|100(\.0)?|[1-9]\d?(\.\d+)?", "a percentage, 0 or from 1 to 100")
WHOLE = (r"\d{1,4}", "a whole number")
TAKES = {  # a pattern of the value as JSON, its words, and the key without which it changes nothing
    "title": (r'".*"', "a text in quotation marks", ""),
    "percent_per_day": (*PERCENT, ""),
    "at_most_percent": (*PERCENT, "percent_per_day"),
    "grace_minutes": (*WHOLE, "percent_per_day"),
    "slip_days": (*WHOLE, "percent_per_day"),
    "earlier": (r'\[("[^"]*"(, )?)*\]', 'folders, as ["../hw1", "../hw2"]', "slip_days"),
    "attempt": (r'"(last|best)"', '"last" or "best"', ""),
}
Keys = dict[tuple[str, ...], Any]  # the values by the tables and the name


def course(out: Path) -> Course:
    """The course's policy; without such a file, lateness costs nothing. Raises UsageError with a
    sentence for each mistake."""
    path = out / COURSE
    if not path.exists():
        return Course()
    try:  # Python has a reader of TOML from 3.11 on, which was made from tomli
        parse = import_module("tomllib" if sys.version_info >= (3, 11) else "tomli").loads
        text = path.read_text("utf-8-sig")
        data = parse(text)
    except ModuleNotFoundError as error:
        raise KitError(f"{COURSE} can't be read here: apt-get install python3-tomli") from error
    except UnicodeDecodeError as error:
        where = f"{path}, line {1 + error.object.count(10, 0, error.start)}"
        raise UsageError(f"{where}: this is no UTF-8: save the file as UTF-8") from error
    except (OSError, ValueError) as error:
        raise UsageError(f"{path} can't be read as TOML: {error}") from error
    keys: Keys = {(key,): value for key, value in data.items()}
    if isinstance(data.get("late"), dict):
        keys |= {("late", key): value for key, value in keys.pop(("late",)).items()}
    mistakes = [(_line(parse, text, key), why) for key in keys for why in _mistakes(out, key, keys)]
    if mistakes:
        raise UsageError("\n".join(f"{path}, line {line}: {why}" for line, why in sorted(mistakes)))
    return Course(**{key[-1]: value for key, value in keys.items()})


def _mistakes(out: Path, key: tuple[str, ...], keys: Keys) -> Iterator[str]:
    """What is wrong with a key."""
    name, there = key[-1], json.dumps(keys[key], default=str)
    pattern, takes, needed = TAKES.get(name, ("", "", ""))
    if name == "late":
        yield f"late is a table, and no {there}: write [late], and below it percent_per_day"
    elif not takes or (name == "title") != (len(key) == 1):
        near = difflib.get_close_matches(name, TAKES, 1, 0.0)[0]
        unknown = "" if near == name else f"there is no key {name}; the nearest is "
        where = f"{near}{', which' * bool(unknown)} belongs"
        yield f"{unknown}{where} {'above' if near == 'title' else 'below'} [late]"
    elif not re.fullmatch(pattern, there):
        fraction = takes == PERCENT[1] and re.match(r"0\.\d+$", there)
        meant = f": for {100 * keys[key]:g} %, write {100 * keys[key]:g}" if fraction else ""
        yield f"{name} should be {takes}, and is {there}{meant}"
    elif needed and ("late", needed) not in keys:
        yield f"{name} changes nothing without {needed}"
    elif name == "earlier":
        for folder in keys[key]:
            if not (out / folder / SLIP_DAYS).is_file():
                yield f"{folder} has no {SLIP_DAYS}: grade it before, with slip_days"


def _line(parse: Callable[[str], Any], text: str, key: tuple[str, ...]) -> int:
    """The line in which a key's value ends: the shortest file that has it ends there."""
    lines = text.splitlines()
    for number in range(len(lines)):
        with suppress(ValueError, LookupError, TypeError):
            value = parse("\n".join(lines[:number]))
            for name in key:
                value = value[name]
            return number
    return len(lines)


def used_before(out: Path, course: Course) -> dict[str, int]:
    """The free days that each student has used in earlier assignments. Raises UsageError."""
    used: dict[str, int] = {}
    for path in (out / folder / SLIP_DAYS for folder in course.earlier):
        for line, row in rows_of(path, ("student", "days"), ()):
            if not re.fullmatch(r"\d{1,4}", days := row["days"]):
                what = f"days should be a whole number, and is {days!r}"
                raise UsageError(f"{path}, line {line}: {what}")
            used[row["student"]] = used.get(row["student"], 0) + int(days)
    return used
