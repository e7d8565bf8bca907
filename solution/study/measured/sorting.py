"""Sorts the events of the measured squares into impacts of one corner, of two, and what is left
out."""

from collections import Counter
from dataclasses import dataclass

import numpy as np

from measured import body as bodies
from measured.body import Body, Impacts
from measured.impacts import Event, Found, RESOLVED

TOGETHER = 0.008  # s: two rows; corners that strike within it are one impact of two corners
SLOWEST = 0.1  # m/s of approach: below it the noise is a tenth of the velocity
CROWDED = "fewer than four rows to the next impact or the end"
LEFT_OUT = (
    CROWDED,
    "slower than 0.1 m/s",
    "not in flight before and after",
    "one corner, but more than one impact in the rows",
)


@dataclass(frozen=True)
class Sorted:
    one: Impacts
    two: Impacts
    left_out: dict[str, int]  # how many events, by reason
    noise: float  # of a change of velocity, m/s: the median in the mass metric


def sort(found: Found, body: Body) -> Sorted:
    hits = bodies.impacts(found.events, body)
    together = bodies.seconds_between(hits) < TOGETHER
    approach = hits.approach()
    reasons = [
        _reason(event, bool(both), float(v_n))
        for event, both, v_n in zip(found.events, together, approach)
    ]
    kept = np.array([reason == "" for reason in reasons])
    counts = Counter(reasons)
    counts[CROWDED] += found.crowded
    return Sorted(
        hits.only(kept & ~together),
        hits.only(kept & together),
        {reason: counts[reason] for reason in LEFT_OUT},
        _noise([event for event, keep in zip(found.events, kept) if keep], body),
    )


def _reason(event: Event, both: bool, approach: float) -> str:
    """Why an event is left out; empty where it is kept."""
    if approach > -SLOWEST:
        return LEFT_OUT[1]
    if event.apart > RESOLVED:
        return LEFT_OUT[2]
    if not both and event.residual > RESOLVED:
        return LEFT_OUT[3]
    return ""


def _noise(events: list[Event], body: Body) -> float:
    metric = np.array([1, 1, body.gyration_squared])
    return float(np.median([np.sqrt((metric * e.deviation**2).sum()) for e in events]))
