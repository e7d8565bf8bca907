"""What the page on the least model says, from its tables."""

import math

from bounce_study import words
from bounce_study.chart_models import MODELS
from bounce_study.tables import number, Row, Tables

NOTEWORTHY = 1.2  # times as long: less is no gain that anyone would choose a model for


def facts(tables: Tables) -> dict[str, str]:
    least, chosen = tables["least_model"], tables["chosen_model"]
    scenes = least.distinct("scene")
    sufficient = [row for row in least.rows if row["least"] == "1"]
    smaller = _smaller(least.rows)
    larger = [row for row in least.rows if number(row, "error_m") <= 1e-3 and row["least"] == "0"]
    return {
        "ladder_scenes": str(len(scenes)),
        "ladder_table": _ladder_table(tables),
        "ladder_expected": str(sum(row["expected"] == "1" for row in sufficient)),
        "ladder_smaller_least": words.metres(min(smaller)),
        "ladder_larger_change": words.metres(max(number(row, "error_m") for row in larger)),
        "ladder_saving": _saving(tables),
        "ladder_capped": str(sum(not math.isfinite(number(r, "error_m")) for r in least.rows)),
        "ladder_capped_time": words.time(
            min(
                number(r, "ns_per_simulated_second")
                for r in least.rows
                if not math.isfinite(number(r, "error_m"))
            )
        ),
        "chosen_apart": words.metres(max(number(r, "distance_to_whole_m") for r in chosen.rows)),
        **_gain(chosen.rows, "whole"),
        **_gain(chosen.rows, "moreau_jean"),
        "chosen_slower": _slower(chosen.rows),
        "chosen_steps": words.listed(words.plain(float(dt)) for dt in chosen.distinct("dt_s")),
        "chosen_table": _chosen_table(tables),
    }


def _smaller(rows: list[Row]) -> list[float]:
    """The errors of the models below the least sufficient one."""
    errors, done = [], False
    for row in rows:
        if row["model"] == "asleep":
            done = False
        done = done or row["least"] == "1"
        if not done:
            errors.append(number(row, "error_m"))
    return errors


def _gain(rows: list[Row], baseline: str) -> dict[str, str]:
    times = [number(row, f"times_as_fast_as_{baseline}") for row in rows]
    return {
        f"{baseline}_least": words.short(min(times)),
        f"{baseline}_most": words.short(max(times)),
        f"{baseline}_median": words.short(words.median(times)),
    }


def _slower(rows: list[Row]) -> str:
    """Where choosing costs more than it saves, against the scheme as it is."""
    times = {
        (row["scene"], float(row["dt_s"])): number(row, "times_as_fast_as_moreau_jean")
        for row in rows
    }
    where = [
        f"{words.scene(scene)} with {words.plain(dt)} s ({words.short(gain)})"
        for (scene, dt), gain in times.items()
        if gain < 1
    ]
    if not where:
        return "It is slower than that in no scene and with no step."
    return f"It is slower than that in {len(where)} of {len(times)} runs: {words.listed(where)}."


def _saving(tables: Tables) -> str:
    """What the least model saves of the whole one's time, event-driven, where both are right."""
    least = tables["least_model"]
    gains = {}
    for scene in least.distinct("scene"):
        own = least.where(scene=scene)
        time = next(number(r, "ns_per_simulated_second") for r in own if r["least"] == "1")
        gains[scene] = number(own[-1], "ns_per_simulated_second") / time
    saved = {scene: gain for scene, gain in gains.items() if gain >= NOTEWORTHY}
    rest = [gain for scene, gain in gains.items() if scene not in saved]
    texts = [f"in {words.scene(s)} {words.short(gain)} times as long" for s, gain in saved.items()]
    if rest:
        other = "the other " if saved else ""
        spread = f"{words.short(min(rest))} to {words.short(max(rest))} times as long"
        texts.append(f"in {other}{len(rest)} scenes {spread}")
    return f"The whole model takes {words.listed(texts)}."


def _ladder_table(tables: Tables) -> str:
    def line(scene: str) -> list[str]:
        own = tables["least_model"].where(scene=scene)
        least = next(i for i, row in enumerate(own) if row["least"] == "1")
        below = [number(row, "error_m") for row in own[:least]]
        whole = number(own[-1], "ns_per_simulated_second")
        time = number(own[least], "ns_per_simulated_second")
        return [
            words.scene(scene),
            MODELS[own[least]["model"]][0],
            "as expected" if own[least]["expected"] == "1" else "not as expected",
            words.metres(min(below)) if below else "there is none",
            words.time(time),
            words.time(whole),
        ]

    header = ["scene", "least model", "", "least error of a smaller one", "its time", "whole model"]
    return words.table(header, map(line, tables["least_model"].distinct("scene")))


def _chosen_table(tables: Tables) -> str:
    chosen = tables["chosen_model"]
    step = chosen.distinct("dt_s")[1]

    def line(scene: str) -> list[str]:
        own = chosen.where(scene=scene, dt_s=step)
        used = [
            f"{MODELS[row['model']][0]} {words.plain(number(row, 'seconds'))} s"
            for row in own
            if number(row, "steps") > 0
        ]
        times = [
            words.short(number(own[0], f"times_as_fast_as_{baseline}"))
            for baseline in ("whole", "moreau_jean")
        ]
        apart = words.metres(number(own[0], "distance_to_whole_m"))
        return [words.scene(scene), ", ".join(used), apart, *times]

    header = ["scene", "models, for how long", "distance to the whole model"]
    header += ["times as fast as the whole model", "as Moreau–Jean as it is"]
    return words.table(header, map(line, chosen.distinct("scene")))
