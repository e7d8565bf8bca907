"""./kit study simulate: the motion of a scene within a tolerance, and what model and which method
the scene needs for it."""

import json
import math
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD
from bounce_grader.sandbox import processes
from bounce_study.numbers import metres, short, time
from bounce_study.style import label, MODELS

PROGRAM = BUILD / "bounce_study"
REFUSED = 1
NEEDED = {
    "asleep": "nothing moves",
    "ballistic": "nothing touches the ground",
    "one_normal": "neither friction nor a second corner is needed",
    "one_friction": "friction is needed, a second corner isn't",
    "two_normals": "a second corner is needed, friction isn't",
    "two_frictions": "friction and a second corner are needed",
}
TEMPLATE = """{
  "l": 0.2, "mu": 0.3, "epsilon": 0.5, "g": [0, -9.81, 0],
  "q": [0, 0.5, 0.3], "v": [2, -1, 0],
  "until": 0.4
}"""
Answer = dict[str, Any]  # what solution/study/simulate.hpp writes


def simulate(scene: Path, tolerance: str, out: Path | None, picture: Path | None) -> int:
    """Writes the motion to `out`, draws it into `picture`, and says how it was had and what it
    needs. Returns 1, with the reason and the horizon on standard error, if it can't be had within
    the tolerance."""
    if picture is not None and picture.suffix != ".svg":
        raise UsageError(f"the picture is an SVG; write --picture {picture.with_suffix('.svg')}")
    command = [str(PROGRAM), "simulate", os.path.abspath(scene), tolerance]
    done = processes.run(command)
    if not done.ok:
        message = done.err.strip().removeprefix("bounce_study: ") or f"status {done.code}"
        if done.code == REFUSED:
            print(f"kit: {message}", file=sys.stderr)
            return REFUSED
        raise (UsageError if done.code == 2 else KitError)(message)
    answer = json.loads(done.out)
    made: list[tuple[Path, str | bytes]] = [(out, done.out)] if out is not None else []
    if picture is not None:
        from bounce_study.chart_scene import draw

        side = _side(scene)
        made.append((picture, draw(answer, side, float(tolerance))))
    for file, data in made:
        try:
            write_whole(file, data)
        except OSError as error:
            raise UsageError(f"{file} can't be written: {error.strerror}") from error
    for doubt in answer["doubts"]:
        print(f"kit: {doubt}", file=sys.stderr)
    print(_in_short(answer), *_motion(answer), sep="\n")
    print(*_models(answer, tolerance), *_methods(answer, tolerance), sep="\n")
    return 0


def _side(scene: Path) -> float:
    read = json.loads(scene.read_text("utf-8-sig"))
    return float(read.get("params", read)["l"])


def _in_short(answer: Answer) -> str:
    """What to take, in one sentence."""
    if len(answer["times"]) == 1:
        return "T is 1, so the scene asks for its start alone."
    least = next(model["model"] for model in answer["models"] if model["least"])
    runs = cheapest(answer)
    steps = [run for run in runs if "step" in run]
    words = [label(run["method"]) for run in runs[:1] if "step" not in run]
    words += [f"{label(run['method'])} at a step of {short(run['step'])} s" for run in steps[:1]]
    return f"{', or '.join(words) or 'No method'}; {NEEDED[least]}."


def cheapest(answer: Answer) -> list[Any]:
    """Each method's cheapest run within the tolerance, cheapest first."""
    runs = sorted((run for run in answer["methods"] if run["within"]), key=lambda run: run["ns"])
    return list({run["method"]: run for run in reversed(runs)}.values())[::-1]


def _motion(answer: Answer) -> Iterator[str]:
    yield (
        f"{answer['method']}: within {short(answer['bound'])} m up to {answer['horizon']:g} s, "
        f"in {time(1e9 * answer['seconds'])}"
    )


def _models(answer: Answer, tolerance: str) -> Iterator[str]:
    models = answer["models"]
    place = next(i for i, model in enumerate(models) if model["least"])
    yield f"the least model within {metres(float(tolerance))}: {MODELS[models[place]['model']]}"
    for model in models[:place]:
        error = model["error"]
        off = f"off by {metres(error)}" if error else "its impacts go on without an end"
        yield f"  {MODELS[model['model']]:30}{off}"


def _methods(answer: Answer, tolerance: str) -> Iterator[str]:
    if len(answer["times"]) == 1:
        return
    within = cheapest(answer)
    first = label(within[0]["method"]) if within else "none of these"
    yield f"the cheapest method within {metres(float(tolerance))}: {first}"
    for run in within:
        setting = (
            f"step {short(run['step'])} s" if "step" in run else f"tolerance {run['tolerance']:g}"
        )
        yield f"  {label(run['method']):30}{time(run['ns'])}, {setting}"
    errors: dict[str, list[float]] = {}
    for run in answer["methods"]:
        errors.setdefault(run["method"], []).append(run["error"] or math.inf)
    for method in [name for name in errors if name not in {run["method"] for run in within}]:
        off = metres(max(errors[method][-2:]))  # of one alone it may be luck
        yield f"  {label(method):30}off by {off} at the finest of its settings"
    if not any("step" in run for run in answer["methods"]):
        yield "  methods with a step weren't run: they take at most 250,000 steps, one from each time"
    yield "  (CPU time of the whole motion, measured just now on this machine)"
