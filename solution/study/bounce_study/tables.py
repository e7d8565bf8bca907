"""Reads the tables that bounce_study writes: CSV below comments that say where they are from."""

import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from bounce_grader.common.errors import UsageError

Tables = dict[str, Any]  # pandas.DataFrame by name; attrs: machine, compiler, flags, times, date
FINE, FINEST = 1e-3, 1e-6  # m: the tolerances that pages speak of
TIME = "ns_per_simulated_second"


def read(file: Path) -> Any:
    """Reads a table; raises UsageError, naming the file, where it isn't one."""
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
        table = pd.read_csv(io.StringIO("\n".join(x for x in lines if not x.startswith("# "))))
    except (OSError, ValueError) as error:
        message = str(error).strip().replace("\n", " ")
        raise UsageError(f"{file} can't be read: {message}; measure it again") from error
    comments = [line[2:].partition(": ") for line in lines if line.startswith("# ")]
    table.attrs = {name: value for name, _, value in comments}
    return table


TIE = 2.0  # on another machine times that differ by less may be in another order


def fastest(runs: Any, within: float) -> Any:
    """Each method's fastest run in a scene with an error of at most `within`, fastest first."""
    reached = runs[runs["error_m"] <= within].sort_values(TIME, kind="stable")
    return reached.drop_duplicates(["scene", "method"])


def leaders(runs: Any, within: float) -> Any:
    """The fastest method in each scene; "tie" where the next one takes hardly longer, and "alone"
    where no other gets there."""
    ranked = fastest(runs, within).groupby("scene")
    first = ranked.nth(0).reset_index().set_index("scene")
    counts, second = ranked.size(), ranked.nth(1).reset_index().set_index("scene")[TIME]
    tied = second.reindex(first.index) < TIE * first[TIME]
    return first["method"].mask(tied, "tie").where(counts > 1, "alone")


def origins(tables: Tables, names: Sequence[str]) -> str:
    """Where and when tables were measured; each is named if that isn't the same for all."""
    together: dict[str, list[str]] = {}
    for name in names:
        origin = tables[name].attrs
        if "machine" in origin:
            what = "{machine}; {compiler}, {flags}; {date}. {times}.".format_map(
                {"times": ""} | origin
            )
            together.setdefault(what.removesuffix(" ."), []).append(name)
    if len(together) == 1:
        return next(iter(together))
    return "\n".join(f"- {', '.join(own)}: {what}" for what, own in together.items())
