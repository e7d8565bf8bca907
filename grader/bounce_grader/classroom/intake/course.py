"""Reads OUT/course.toml: the assignment's title, and what lateness costs."""

from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from bounce_grader.common.errors import KitError, UsageError

NAME = "course.toml"
KNOWN = {"title": str, "date": str, "late": dict}
LATE = ("percent_per_day", "at_most_percent")


@dataclass(frozen=True)
class Course:
    """The course's title and its policy on lateness, from course.toml."""

    title: str = ""
    date: str = ""
    percent_per_day: float = 0.0  # of the assignment's points, for each day begun
    at_most_percent: float = 100.0


def read(out: Path) -> Course:
    """The course's policy; the default, under which lateness costs nothing, if there is no such
    file. Raises UsageError."""
    path = out / NAME
    if not path.exists():
        return Course()
    toml = _reader()
    try:
        data = toml.loads(path.read_text("utf-8"))
    except (OSError, ValueError) as error:
        raise UsageError(f"{path} can't be read as TOML: {error}") from error
    data = {key: str(value) if key == "date" else value for key, value in data.items()}
    for key, value in data.items():
        if key not in KNOWN or not isinstance(value, KNOWN[key]):
            raise UsageError(f"{path} holds {key!r}, which should be one of {', '.join(KNOWN)}")
    late = data.pop("late", {})
    for key, value in late.items():
        if key not in LATE or type(value) not in (int, float) or not 0 <= value <= 100:
            raise UsageError(
                f"{path} holds {key} = {value} under [late]; it takes {' and '.join(LATE)}, each a "
                "number from 0 to 100"
            )
    return Course(**data, **late)


def _reader() -> Any:
    """Python's own reader of TOML, from 3.11 on, or the one it was made from."""
    for name in ("tomllib", "tomli"):
        try:
            return import_module(name)
        except ModuleNotFoundError:
            continue
    raise KitError(f"{NAME} can't be read here: apt-get install python3-tomli")
