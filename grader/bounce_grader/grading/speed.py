"""Measures a submission's speed and accuracy by the stopwatch, and puts the results into words."""

import json
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.common.errors import KitError
from bounce_grader.common.escaping import printable_text
from bounce_grader.common.numbers import metres, seconds
from bounce_grader.common.paths import REFERENCE_RUNNER, SCENES, STOPWATCH
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import LARGEST_FILE, Box

WAIT = processes.Limits(cpu_seconds=30, wall_seconds=120, memory=4 << 30, file_size=LARGEST_FILE)
CURVES = ("submission", "solution", "least")
LEAST_RATIO = 0.05
STEP = 1e-3  # s: the dt at which the time of a step is reported
FINE = 1e-3  # m: errors up to this are near enough
WRONG = "built for speed, a column of a trajectory is wrong, so it isn't timed"
LARGEST = 1e100  # m: a larger error counts as one that isn't finite
Measured = dict[str, Any]


class Point(NamedTuple):
    """Time and error at one dt, over one or all scenes."""

    dt: float  # s
    ns: float  # CPU time for a simulated second
    error: float | None  # m, the largest; None if it isn't finite, or above LARGEST


def measure(timed: Path, box: Box) -> Measured | None:
    """Measures the curves of a submission, of the solution and of the least model. If an answer is
    wrong, the result says so and has no curves. None if the stopwatch fails."""
    asked = {"scenes": str(SCENES), "timed": box.to_run(timed)}
    asked["solution"] = box.to_run(REFERENCE_RUNNER)
    result = box.run([str(STOPWATCH), json.dumps(asked)], WAIT)
    return read(result.out) if result.ok else None


def read(out: bytes) -> Measured:
    """Reads the stopwatch's answer, which grader/judge/stopwatch.cpp describes, and adds the time
    of a step. Raises KitError. Of a submission's are only the texts in it."""
    try:
        answer = json.loads(out)
        if "wrong" in answer:
            return {"otherwise": f"{WRONG}: {printable_text(answer['wrong'])}"}
        scenes = list(map(_scene, answer["scenes"]))
        cut = answer["cut"] and answer["cut"] | {"dt": float(answer["cut"]["dt"])}
        measured = {"cut": cut, "dt": answer["dt"], "scenes": scenes}
        return {**_step(measured), **measured}
    except (ValueError, TypeError, LookupError) as error:
        raise KitError("the stopwatch's answer can't be read") from error


def _scene(scene: Any) -> Measured:
    def rounded(point: Any) -> Any:
        error = point["error"]
        is_finite = error is not None and error <= LARGEST
        return point | {"error": float(f"{error:.3e}") if is_finite else None}

    return scene | {curve: list(map(rounded, scene[curve])) for curve in CURVES}


def _step(measured: Measured) -> Measured:
    """Nanoseconds per step over all scenes, and the ratio to the solution's. Empty if a scene
    wasn't timed. Empty also if the ratio is too small to be true: such a program may have replaced
    the functions that hand over its answers."""
    mine, solution = curve(measured, "submission"), curve(measured, "solution")
    both = [pair for pair in zip(mine, solution) if pair[0].dt >= STEP]
    if not both:
        return {}
    own, solutions = (round(point.ns * point.dt, 1) for point in both[-1])
    if not own > LEAST_RATIO * solutions > 0:
        return {}
    return {"submission_ns": own, "solution_ns": solutions, "ratio": own / solutions}


def curve(measured: Measured, whose: str) -> list[Point]:
    """One curve over all scenes, with a point for each dt at which every scene was timed."""
    scenes, points = measured.get("scenes", []), []
    whole = sum(scene["seconds"] for scene in scenes)
    for dt, *at in zip(measured.get("dt", []), *(scene[whose] for scene in scenes)):
        ns = sum(scene["seconds"] * p["ns"] for scene, p in zip(scenes, at)) / whole
        errors = [p["error"] for p in at]
        points.append(Point(dt, ns, None if None in errors else max(errors)))
    return points


def sentences(measured: Measured) -> list[str]:
    """Sentences that say what the curves mean, or why there are none."""
    if "otherwise" in measured:
        return [f"{measured['otherwise'][0].upper()}{measured['otherwise'][1:]}."]
    mine, solution = curve(measured, "submission"), curve(measured, "solution")
    least = curve(measured, "least")
    out = [_reached(mine, solution, least)] if mine and solution and least else []
    return out + ([f"It was cut {measured['cut']}."] if measured.get("cut") else [])


def _reached(mine: list[Point], solution: list[Point], least: list[Point]) -> str:
    first, quick = (
        next((p for p in curve if p.error is not None and p.error <= FINE), None)
        for curve in (mine, least)
    )
    if first is None:
        last = mine[-1]
        far = "somewhere not finite" if last.error is None else f"off by {metres(last.error)}"
        return f"Your program doesn't get within 1 mm: at {step(last)} it is still {far}."
    out = f"Your program is within 1 mm of the exact motion from {step(first)} on, "
    out += f"and then takes {seconds(first.ns)} for a second of motion"
    out += "".join(f"; the solution {seconds(p.ns)}" for p in solution if p.dt == first.dt)
    if quick:
        out += f"; no more model than each step needs does that in {seconds(quick.ns)}"
    return out + "."


def step(point: Point) -> str:
    return f"dt = {seconds(1e9 * point.dt)}"
