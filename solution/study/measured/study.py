"""The whole of the measured part: from two files to its tables and one JSON object."""

import csv
import io
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from bounce_grader.common.errors import UsageError
from measured import body as bodies
from measured import drops, ellipses, flights, impacts, ladder, laws, rows, sorting, unexplained
from measured.body import Body, Impacts, PUBLISHED
from measured.drops import Drops
from measured.impacts import Air, Event
from measured.ladder import Grids, Group, Rung, Verdict
from measured.rows import Array, Ellipses, Trial
from measured.sorting import Sorted
from measured.unexplained import Finding


REPLICATES, QUICK = 400, 100
ONE, TWO, ALL, OVAL, BOTH = (
    "squares, one corner",
    "squares, two corners",
    "squares",
    "ellipses",
    "both shapes, one corner",
)
FORECASTS = ("newton", "routh_stronge", "compliant")
TABLES = tuple(
    f"measured_{name}"
    for name in ("extraction", "ladder", "bodies", "drops", "findings", "impacts")
)
Table = tuple[tuple[str, ...], list[tuple[Any, ...]]]


@dataclass(frozen=True)
class Study:
    trials: int
    rows: int
    flights: int
    air: Air
    body: Body
    events: int
    sorted: Sorted
    signs: ellipses.Signs
    flagged: int
    verdicts: list[Verdict]
    bodies: list[Verdict]
    drops: Drops
    findings: list[Finding]


def run(squares: Path, oval: Path, quick: bool = False) -> Study:
    trials, read = rows.trials(squares), rows.ellipses(oval)
    if len(trials) < 4:
        raise UsageError(f"{squares} has {len(trials)} trials; it takes four to fit and to judge")
    flight = flights.measure(trials)
    linear = next(drag for drag in flights.drags(flight) if drag.name == "linear")
    air = Air(linear.g, max(linear.drag, 0.0), flight.noise)
    found = impacts.find(trials, air)
    body = bodies.fit_geometry(_fitted(found.events))
    ordered = sorting.sort(found, body)
    replicates = QUICK if quick else REPLICATES
    grids = Grids()
    groups = _groups(ordered, read)
    verdicts = [ladder.judge(group, replicates, grids) for group in groups]
    judged_bodies, in_metric = _by_body(found, body, ordered, replicates)
    return Study(
        len(trials),
        sum(len(trial.k) for trial in trials),
        len(flight.velocity),
        air,
        body,
        len(found.events) + found.crowded,
        ordered,
        ellipses.signs(read),
        read.flagged,
        verdicts,
        judged_bodies,
        _drops(trials, body, air, verdicts),
        [
            *unexplained.findings(trials, found.events, body, air, read),
            *in_metric,
            *_approaches(groups),
        ],
    )


def _fitted(events: list[Event]) -> list[Event]:
    half = ladder.halves(np.array([event.trial for event in events]))
    return [event for event, mine in zip(events, half.fit) if mine]


def _groups(ordered: Sorted, read: Ellipses) -> list[Group]:
    one, two = ordered.one, ordered.two
    oval = ellipses.impacts(read, ellipses.GYRATION)
    floor_one, floor_oval = bodies.floor(one), bodies.floor(oval)
    floor_two = bodies.floor_of_side(two)
    return [
        Group(ONE, (one,), (floor_one,), laws.ONE_CORNER),
        Group(TWO, (two,), (floor_two,), laws.LADDER),
        Group(ALL, (one, two), (floor_one, floor_two), laws.LADDER),
        Group(OVAL, (oval,), (floor_oval,), laws.ONE_CORNER),
        Group(BOTH, (one, oval), (floor_one, floor_oval), laws.ONE_CORNER),
    ]


def _approaches(groups: list[Group]) -> list[Finding]:
    """How fast the corner approaches the ground, in the median, in each class of its own."""
    found = []
    for group in groups:
        if len(group.shapes) == 1:
            half, speed = ladder.halves(group.shapes[0].trial), -group.shapes[0].approach()
            medians = tuple(float(np.median(speed[own])) for own in (half.fit, half.judge))
            found.append(Finding("approach", group.name, "v_n before, m/s", medians))
    return found


def _by_body(
    found: impacts.Found, body: Body, ordered: Sorted, replicates: int
) -> tuple[list[Verdict], list[Finding]]:
    """The same impacts of one corner, by what the body is taken to be; and Newton's error with each
    in one metric, that of the fitted body."""
    keys = {
        (trial, round(pose, 9)) for trial, pose in zip(ordered.one.trial, ordered.one.pose[:, 2])
    }
    same = [e for e in found.events if (e.trial, round(e.pose[2] + body.turn, 9)) in keys]
    inertia = bodies.inertia(bodies.impacts(_fitted(same), PUBLISHED))
    variants = {
        "as published": PUBLISHED,
        "as published, inertia fitted": replace(PUBLISHED, gyration_squared=inertia),
        "fitted": body,
        "fitted, inertia side²/6": replace(body, gyration_squared=body.side**2 / 6),
    }
    judged, in_metric = [], []
    for name, variant in variants.items():
        hits = bodies.impacts(same, variant)
        group = Group(name, (hits,), (bodies.floor(hits),), laws.ONE_CORNER[:-1])
        judged.append(ladder.judge(group, replicates, Grids()))
        in_metric.append(_in_metric(hits, judged[-1], body.gyration_squared))
    return judged, in_metric


def _in_metric(hits: Impacts, verdict: Verdict, gyration_squared: float) -> Finding:
    """The median error of Newton's law in the metric of another body, for both halves."""
    rung = next(rung for rung in verdict.rungs if rung.law.name == "newton")
    wrong = laws.after(rung.law, hits, rung.setting) - hits.after
    error = np.sqrt((wrong[:, :2] ** 2).sum(axis=1) + gyration_squared * wrong[:, 2] ** 2)
    half = ladder.halves(hits.trial)
    medians = tuple(float(np.median(error[own])) for own in (half.fit, half.judge))
    return Finding("metric", verdict.group, "Newton's error, m/s", medians)


def _drops(trials: list[Trial], body: Body, air: Air, verdicts: list[Verdict]) -> Drops:
    """Forecasts the drops of the half that is judged, with the fits of impacts of one corner."""
    one = next(verdict for verdict in verdicts if verdict.group == ONE)
    settings = {rung.law.name: rung.setting for rung in one.rungs}
    models = [("assignment", settings["newton"])]
    models += [(name, settings[name]) for name in FORECASTS]
    models.append(("two_newton", settings["newton"]))
    half = ladder.halves(np.array([trial.name for trial in trials]))
    judged = [trial for trial, mine in zip(trials, half.judge) if mine]
    return drops.forecast(judged, body, air, models, FORECASTS[1])


# --- as tables ---


def tables(study: Study) -> dict[str, bytes]:
    made = (
        _extraction(study),
        _ladder(study.verdicts),
        _ladder(study.bodies),
        _drop_table(study.drops),
        _finding_table(study.findings),
        _impact_table(study.sorted.one),
    )
    return {f"{name}.csv": _csv(table) for name, table in zip(TABLES, made)}


def _csv(table: Table) -> bytes:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(table[0])
    writer.writerows([[_short(value) for value in row] for row in table[1]])
    return out.getvalue().encode()


def _short(value: Any) -> str:
    return f"{value:.5g}" if isinstance(value, float) else str(value)


def _extraction(study: Study) -> Table:
    body, noise = study.body, study.air.noise
    return ("quantity", "value"), [
        ("trials", study.trials),
        ("rows", study.rows),
        ("windows of flight", study.flights),
        ("g, m/s^2", study.air.g),
        ("drag, 1/s", study.air.drag),
        ("noise of x, m", float(noise[0])),
        ("noise of y, m", float(noise[1])),
        ("noise of theta, rad", float(noise[2])),
        ("noise of a change of velocity, m/s", study.sorted.noise),
        ("side, m", body.side),
        ("turn of theta, rad", body.turn),
        ("centre_x, m", body.centre_x),
        ("centre_y, m", body.centre_y),
        ("ground at x = 0, m", body.ground),
        ("ground's slope", body.slope),
        ("depth over speed, s", body.tau),
        ("r_g^2, m^2", body.gyration_squared),
        ("events", study.events),
        ("impacts of one corner", len(study.sorted.one)),
        ("impacts of two corners", len(study.sorted.two)),
        *((f"left out: {reason}", count) for reason, count in study.sorted.left_out.items()),
        ("ellipses left out: flagged", study.flagged),
        ("ellipses, d as published: imbalance, rad/s", study.signs.as_published),
        ("ellipses, v_x turned: imbalance, rad/s", study.signs.turned),
    ]


RUNG = tuple(
    "group law corners parameters mu mu_low mu_high epsilon epsilon_low epsilon_high kappa "
    "kappa_low kappa_high impacts_fitted impacts_judged median_m_s median_low median_high "
    "lower_quartile upper_quartile behind_low behind_high best least floor_m_s floor_low "
    "floor_high".split()
)


def _ladder(verdicts: list[Verdict]) -> Table:
    return RUNG, [_rung_row(verdict, rung) for verdict in verdicts for rung in verdict.rungs]


def _rung_row(verdict: Verdict, rung: Rung) -> tuple[Any, ...]:
    values = [float(v) for trio in zip(rung.setting, rung.low, rung.high) for v in trio]
    return (
        verdict.group,
        rung.law.name,
        rung.law.corners,
        len(rung.law.parameters),
        *values,
        verdict.fitted,
        verdict.judged,
        rung.median,
        *rung.interval,
        *rung.quartiles,
        *rung.behind,
        int(rung.law.name == verdict.best),
        int(rung.law.name == verdict.least),
        verdict.floor,
        *verdict.floor_interval,
    )


DROP = tuple(
    "model t_s median_m lower_quartile upper_quartile horizon_s drops first_impact_s "
    "spread_m".split()
)


def _drop_table(made: Drops) -> Table:
    return DROP, [
        (
            one.model,
            round((i + 1) * rows.INTERVAL, 3),
            *(float(part[i]) for part in (one.median, one.lower, one.upper)),
            one.horizon,
            made.count,
            made.first_impact,
            float(made.spread[i]),
        )
        for one in made.forecasts
        for i in range(drops.SAMPLES)
    ]


def _finding_table(found: list[Finding]) -> Table:
    columns = ("about", "hypothesis", "quantity", "first_half", "second_half")
    return columns, [(f.about, f.hypothesis, f.quantity, *f.values) for f in found]


IMPACT = tuple(
    "trial r_x_m r_y_m v_x_m_s v_y_m_s omega_rad_s v_x_after_m_s v_y_after_m_s "
    "omega_after_rad_s".split()
)


def _impact_table(one: Impacts) -> Table:
    """The impacts of one corner that are judged."""
    hits = one.only(ladder.halves(one.trial).judge)
    numbers = np.concatenate([hits.corner, hits.before, hits.after], axis=1)
    return IMPACT, [
        (int(trial), *map(float, row)) for trial, row in zip(hits.trial, numbers.tolist())
    ]


# --- as JSON ---


def as_json(study: Study) -> dict[str, Any]:
    """What the page is made of."""
    return {
        "shapes": {verdict.group: _verdict(verdict) for verdict in study.verdicts},
        "bodies": {verdict.group: _verdict(verdict) for verdict in study.bodies},
        "extraction": {name: _number(value) for name, value in _extraction(study)[1]},
        "drops": {
            "count": study.drops.count,
            "first_impact_s": _number(study.drops.first_impact),
            "horizon_s": {f.model: _number(f.horizon) for f in study.drops.forecasts},
        },
        "findings": [
            {
                "about": f.about,
                "hypothesis": f.hypothesis,
                "quantity": f.quantity,
                "halves": [_number(v) for v in f.values],
            }
            for f in study.findings
        ],
    }


def _verdict(verdict: Verdict) -> dict[str, Any]:
    return {
        "impacts_fitted": verdict.fitted,
        "impacts_judged": verdict.judged,
        "trials_fitted": verdict.fitted_trials,
        "trials_judged": verdict.judged_trials,
        "floor": {
            "median_error": _number(verdict.floor),
            "interval": [_number(v) for v in verdict.floor_interval],
        },
        "best": verdict.best,
        "least_model": verdict.least,
        "laws": {rung.law.name: _rung(rung) for rung in verdict.rungs},
    }


def _rung(rung: Rung) -> dict[str, Any]:
    places = {name: i for i, name in enumerate(laws.UNUSED)}
    used = rung.law.parameters
    return {
        "parameters": {name: _number(rung.setting[places[name]]) for name in used},
        "parameter_intervals": {
            name: [_number(rung.low[places[name]]), _number(rung.high[places[name]])]
            for name in used
        },
        "median_error": _number(rung.median),
        "interval": [_number(v) for v in rung.interval],
        "quartiles": [_number(v) for v in rung.quartiles],
        "behind_best": [_number(v) for v in rung.behind],
    }


def _number(value: Any) -> Any:
    return float(f"{value:.5g}") if isinstance(value, (float, np.floating)) else value
