"""The tables of docs/studies/peers.md, as text."""

from bounce_study.peers_data import lead, least_time, Data, Point
from bounce_study.peers_words import metres, short, time
from bounce_study.tables import number, Row
from bounce_study.words import scene, table, times

FINE, FINEST = 1e-3, 1e-6  # m
DIFFERS = 3.0  # times: what a setting has to change to be worth a row


def settings(data: Data) -> str:
    header = ["engine", "version", "numbers", "planar by", "ε", "μ", "contact", "Euler, with"]
    names = ("title", "version", "numbers", "planar", "restitution", "friction", "contact", "order")
    return table(header, [[row[name] for name in names] for row in data.settings])


def steps(data: Data) -> str:
    header = ["", "flight", "times", "quartiles", "error", "contact", "times", "quartiles", "error"]
    flight = {row["engine"]: row for row in data.steps if row["kind"] == "flight"}
    contact = [row for row in data.steps if row["kind"] == "contact"]
    contact.sort(key=lambda row: number(row, "ns_per_step"))
    rows = [
        [data.title(row["engine"]), *_step(flight[row["engine"]]), *_step(row)] for row in contact
    ]
    return table(header, rows)


def _step(row: Row) -> list[str]:
    spread = f"{times(number(row, 'ratio_lower'))} to {times(number(row, 'ratio_upper'))}"
    return [
        time(number(row, "ns_per_step")),
        times(number(row, "ratio")),
        spread,
        metres(number(row, "error_m")),
    ]


def leads(data: Data) -> str:
    header = ["scene"]
    for tolerance in (FINE, FINEST):
        header += [f"ours, {metres(tolerance)}", "engines"]
    header += ["times at the same error", "quartiles", "closest"]
    return table(header, [_lead(data, name) for name in data.scenes])


def _lead(data: Data, name: str) -> list[str]:
    engines = [p for p in data.peers if p.method != "numpy"]
    cells = [scene(name)]
    for tolerance in (FINE, FINEST):
        cells.append(_who(data, least_time(data.ours, name, tolerance)))
        cells.append(_who(data, least_time(engines, name, tolerance)))
    closest = lead(data, name)
    spread = f"{times(closest.lower)} to {times(closest.upper)}"
    return [*cells, times(closest.times), spread, data.title(closest.engine)]


def _who(data: Data, point: Point | None) -> str:
    return f"{time(point.ns)}, {data.title(point.method)}" if point else "never"


def errors(data: Data) -> str:
    engines = data.engines()
    least = {
        (name, engine): min(p.error for p in data.peers if p.scene == name and p.method == engine)
        for name in data.scenes
        for engine in engines
    }
    rows = [[scene(s), *(metres(least[s, e]) for e in engines)] for s in data.scenes]
    for tolerance in (FINE, FINEST):
        reached = [sum(least[s, e] <= tolerance for s in data.scenes) for e in engines]
        rows.append([f"scenes within {metres(tolerance)}", *(str(n) for n in reached)])
    return table(["scene", *(data.title(engine) for engine in engines)], rows)


def variants(data: Data) -> str:
    rows = []
    for name in data.scenes:
        for engine in data.variants_of_engines():
            error = data.variant_errors(name, engine)[-1]
            best = data.variant_errors(name, engine.partition("_")[0])[-1]
            if error > DIFFERS * best and error > FINE:
                rows.append([data.title(engine), scene(name), metres(error), metres(best)])
    return table(["settings", "scene", "error", "with those of the sweep"], sorted(rows))


def lcp(data: Data) -> str:
    header = ["solver", "one LCP", "times", "residual, m/s", "refused", "wrong"]
    return table(header, [_solver(row) for row in data.lcp])


def _solver(row: Row) -> list[str]:
    return [
        row["solver"],
        time(number(row, "ns_per_lcp")),
        times(number(row, "ratio")),
        short(number(row, "residual_m_per_s")),
        row["refused"],
        row["wrong"],
    ]
