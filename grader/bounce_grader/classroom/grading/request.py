"""The options of one run of ./kit class."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from bounce_grader.classroom.grading import unit
from bounce_grader.classroom.grading.unit import Unit


@dataclass(frozen=True)
class Request:
    """The arguments of ./kit class."""

    submissions: Path | None  # None with --canvas
    out: Path
    gradebook: Path | None = None
    columns: Mapping[int, str] = field(default_factory=dict)  # 0: the total; n: part n
    engine: str = "local"
    jobs: int = 0
    scheduler: str = ""
    speed: bool = False
    sanitize: bool = False
    trust: bool = False
    reveal: bool = False
    overwrite: bool = False
    canvas: str = ""  # COURSE/ASSIGNMENT
    upload: bool = False
    corpus: Sequence[Path] = ()
    regrade: str | None = None
    apply: bool = False
    unit: Unit = unit.run
