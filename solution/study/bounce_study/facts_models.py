"""Works out the facts of the page on the least model from its tables."""

import math
from statistics import median_high
from typing import Any

from bounce_study.chart_models import MODELS
from bounce_study.chart_style import FINE
from bounce_study.tables import number, numbers, Row, Tables

NOTEWORTHY = 1.2  # times as long: less is no gain that anyone would choose a model for
TIME = "ns_per_simulated_second"


def facts(tables: Tables) -> dict[str, Any]:
    least, chosen = tables["least_model"], tables["chosen_model"]
    ladder = [_ladder(least.where(scene=scene)) for scene in least.distinct("scene")]
    smaller = [error for rungs in ladder for error in rungs["smaller"]]
    larger = [row for row in least.rows if number(row, "error_m") <= FINE and row["least"] == "0"]
    endless = [row for row in least.rows if not math.isfinite(number(row, "error_m"))]
    steps = list(map(float, chosen.distinct("dt_s")))
    runs = [
        _chosen(chosen.where(scene=scene, dt_s=dt))
        for scene in chosen.distinct("scene")
        for dt in chosen.distinct("dt_s")
    ]
    return {
        "random": _random(tables),
        "ladder": ladder,
        "ladder_expected": sum(rungs["expected"] for rungs in ladder),
        "ladder_smaller_least": min(smaller),
        "ladder_larger_change": max(numbers(larger, "error_m")),
        "ladder_noteworthy": [rungs for rungs in ladder if rungs["gain"] >= NOTEWORTHY],
        "ladder_other_gains": [rungs["gain"] for rungs in ladder if rungs["gain"] < NOTEWORTHY],
        "ladder_endless": len(endless),
        "ladder_endless_time": min(numbers(endless, TIME)),
        "chosen": runs,
        "chosen_slower": [run for run in runs if run["moreau_jean"] < 1],
        "chosen_steps": steps,
        "chosen_apart": max(numbers(chosen.rows, "distance_to_whole_m")),
        "whole": _gain(chosen.rows, "whole"),
        "moreau_jean": _gain(chosen.rows, "moreau_jean"),
    }


def _random(tables: Tables) -> dict[str, Any]:
    """Counts how often the choice by mechanics is the least model in random scenes."""
    names = {name: label for name, (label, _, _) in MODELS.items()} | {"none": "none"}
    order = list(names)
    rows: list[dict[str, Any]] = [
        {
            "chosen": names[row["chosen"]],
            "least": names[row["least"]],
            "scenes": int(row["scenes"]),
            "wrong": int(row["chosen_wrong"]),
            "error": number(row, "largest_error_m"),
            "excess": order.index(row["chosen"]) - order.index(row["least"]),
        }
        for row in tables["random_models"].rows
    ]
    wrong = sum(row["wrong"] for row in rows)
    same = sum(row["scenes"] for row in rows if row["excess"] == 0)
    scenes = sum(row["scenes"] for row in rows)
    larger = scenes - same - wrong
    return {"rows": rows, "scenes": scenes, "same": same, "wrong": wrong, "larger": larger}


def _ladder(rungs: list[Row]) -> dict[str, Any]:
    """Describes the rungs of one scene; the gain is the whole model's time over the least one's."""
    least = next(i for i, row in enumerate(rungs) if row["least"] == "1")
    time, whole = number(rungs[least], TIME), number(rungs[-1], TIME)
    return {
        "scene": rungs[0]["scene"],
        "model": MODELS[rungs[least]["model"]][0],
        "expected": rungs[least]["expected"] == "1",
        "smaller": numbers(rungs[:least], "error_m"),
        "time": time,
        "whole": whole,
        "gain": whole / time,
    }


def _chosen(rows: list[Row]) -> dict[str, Any]:
    """Describes a run, which has one row for each model."""
    used = [row for row in rows if number(row, "steps") > 0]
    return {
        "scene": rows[0]["scene"],
        "dt": number(rows[0], "dt_s"),
        "models": [(MODELS[row["model"]][0], number(row, "seconds")) for row in used],
        "apart": number(rows[0], "distance_to_whole_m"),
        "whole": number(rows[0], "times_as_fast_as_whole"),
        "moreau_jean": number(rows[0], "times_as_fast_as_moreau_jean"),
    }


def _gain(rows: list[Row], baseline: str) -> dict[str, float]:
    times = numbers(rows, f"times_as_fast_as_{baseline}")
    return {"least": min(times), "most": max(times), "median": median_high(times)}
