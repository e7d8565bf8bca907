"""docs/studies/peers.md: a template, and facts worked out from the tables beside the page."""

import math
from collections.abc import Iterable
from pathlib import Path

from bounce_study import pages, peers_tables
from bounce_study.peers_data import is_own, lead, read, Data
from bounce_study.peers_tables import FINE, FINEST
from bounce_study.peers_words import count, metres, seconds, short, time
from bounce_study.tables import number, Row
from bounce_study.words import listed, scene, times

TEMPLATE = pages.TEMPLATES / "peers.md"


def page(folder: Path) -> str:
    facts = facts_of(read(folder))
    return pages.NAME.sub(lambda name: facts[name[1]], TEMPLATE.read_text(encoding="utf-8"))


def facts_of(data: Data) -> pages.Facts:
    return {
        **pages.origin(data.origin),
        "scene_count": count(len(data.scenes)),
        "fine": metres(FINE),
        "finest": metres(FINEST),
        "least_dt": seconds(min(p.dt for p in data.peers if p.method != "numpy")),
        "numpy_dt": seconds(
            min([p.dt for p in data.peers if p.method == "numpy"], default=math.inf)
        ),
        "variant_dt": seconds(min(number(row, "dt_s") for row in data.variants)),
        "lcp_contacts": data.lcp[0]["contacts"] if data.lcp else "no",
        **_tables(data),
        **_sentences(data),
        **_contact_step(data),
    }


def _tables(data: Data) -> pages.Facts:
    return {
        "settings_table": peers_tables.settings(data),
        "steps_table": peers_tables.steps(data),
        "lead_table": peers_tables.leads(data),
        "errors_table": peers_tables.errors(data),
        "variants_table": peers_tables.variants(data),
        "lcp_table": peers_tables.lcp(data),
    }


def _sentences(data: Data) -> pages.Facts:
    dantzig = [engine for engine in data.variants_of_engines() if "_dantzig" in engine]
    soft = [e for e in ("mujoco", "mujoco_5") if data.variant_errors("flat_drop", e)]
    return {
        "lead_sentence": _lead_sentence(data),
        "agreement_sentence": _agreement_sentence(data),
        "failures": _failures(data),
        "dantzig_sentence": _sentence_over_steps(data, "oblique_bounce", dantzig),
        "soft_sentence": _sentence_over_steps(data, "flat_drop", soft),
        "lcp_sentence": _lcp_sentence(data),
    }


def _contact_step(data: Data) -> pages.Facts:
    contact = {row["engine"]: row for row in data.steps if row["kind"] == "contact"}
    ours = contact["assignment_fast"]
    engines = [row for row in contact.values() if not is_own(row)]
    fastest = min(engines, key=lambda row: number(row, "ns_per_step"))
    return {
        "dt": seconds(number(ours, "dt_s")),
        "ours_contact": time(number(ours, "ns_per_step")),
        "fastest_contact_name": data.name(fastest["engine"]),
        "fastest_contact_ratio": times(number(fastest, "ratio")),
        "numpy_contact_ratio": (
            times(number(contact["numpy"], "ratio")) if "numpy" in contact else "?"
        ),
        "contact_error_sentence": _contact_error_sentence(data, ours, engines),
    }


def _contact_error_sentence(data: Data, ours: Row, engines: list[Row]) -> str:
    best = min(engines, key=lambda row: number(row, "error_m"))
    return (
        f"after a second of sliding, with the same step of {seconds(number(ours, 'dt_s'))}, it is "
        f"{metres(number(ours, 'error_m'))} off, and {data.name(best['engine'])} "
        f"{metres(number(best, 'error_m'))}."
    )


def _lead_sentence(data: Data) -> str:
    leads = {name: lead(data, name) for name in data.scenes}
    behind = [name for name, each in leads.items() if each.times <= 1]
    least = min(leads, key=lambda name: leads[name].times)
    closest = leads[least]
    if behind:
        return f"in {listed(map(scene, behind))}; in the others some method of ours is faster."
    return (
        "in none. In each of them some method of ours is faster than every engine at the same "
        f"error; the closest is {data.name(closest.engine)} in {scene(least)}, which takes "
        f"{times(closest.times)} times as long."
    )


def _agreement_sentence(data: Data) -> str:
    engines = set(data.engines())
    together = {
        name: len(engines & {p.method for p in data.peers if p.scene == name and p.error <= FINE})
        for name in data.scenes
    }
    least = min(together, key=lambda name: together[name])
    return (
        f"in every scene at least {count(together[least])} of the {count(len(engines))} "
        f"come within {metres(FINE)} of it as their steps shrink, with {scene(least)} "
        "the hardest."
    )


def _failures(data: Data) -> str:
    """By engine: where it has stalled, and where it still converges and needs a smaller step."""
    lines = []
    for engine in data.engines():
        notes = {row["scene"]: row["note"] for row in data.notes if row["method"] == engine}
        said = "; it ".join(_failures_of_one(notes))
        if said:
            lines.append(f"- {data.title(engine)} {said}.")
    return "\n".join(lines) or "- None."


def _failures_of_one(notes: dict[str, str]) -> list[str]:
    stalled = {name: note for name, note in notes.items() if note.startswith("stalls")}
    slow = [f"{scene(name)} ({note})" for name, note in notes.items() if name not in stalled]
    said = []
    if stalled:
        reason = next(iter(stalled.values())).partition(": ")[2]
        said.append(f"stalls in {listed(map(scene, stalled))}: {reason}")
    if slow:
        said.append(f"still converges in {listed(slow)}")
    return said


def _sentence_over_steps(data: Data, name: str, engines: list[str]) -> str:
    """Nothing where none of the engines was installed."""
    if not engines:
        return ""
    dts = [number(row, "dt_s") for row in data.variants]
    swept = f"with steps from {seconds(max(dts))} to {seconds(min(dts))}"
    return f"In the {scene(name)}, {swept}, {listed(_over_steps(data, name, engines))}."


def _over_steps(data: Data, name: str, engines: list[str]) -> Iterable[str]:
    for engine in engines:
        errors = data.variant_errors(name, engine)
        yield (
            f"{data.name(engine)} stays between {metres(min(errors))} and {metres(max(errors))} "
            f"off ({metres(errors[-1])} with the smallest)"
        )


def _lcp_sentence(data: Data) -> str:
    siconos = [row for row in data.lcp if row["solver"].startswith("Siconos")]
    if not siconos:
        return "Siconos was not installed."
    best = min(siconos, key=lambda row: number(row, "ns_per_lcp"))
    apart = max(number(row, "difference_m_per_s") for row in siconos)
    return (
        f"All agree with the closed form to {short(apart)} m/s, and the fastest of Siconos takes "
        f"{times(number(best, 'ratio'))} times as long."
    )
