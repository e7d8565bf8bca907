"""Speed against accuracy: a panel for each scene, the order of convergence, and the performance
profile."""

import math
import textwrap
from typing import Any

from bounce_grader.study import look, runs
from bounce_grader.study.runs import Run
from bounce_grader.study.tables import Tables, number

LEFT, RIGHT = 1e-8, 30.0  # m: what is more exact lies in a strip at the left edge
README_SCENE = "oblique_bounce"


def panels(tables: Tables) -> bytes:
    all_runs = runs.runs(tables)
    scenes = runs.scenes(all_runs)
    plt = look.pyplot()
    rows = math.ceil((len(scenes) + 1) / 3)
    figure, grid = plt.subplots(rows, 3, figsize=(look.WIDTH, 3.1 * rows), sharex=True, sharey=True)
    letters = _letters(all_runs)
    for axes, scene in zip(grid.flat, scenes):
        _panel(axes, all_runs, scene, letters)
    for axes in grid.flat[len(scenes) :]:
        axes.axis("off")
    _label(grid)
    _legend(grid.flat[len(scenes)], all_runs)
    _foot(figure, letters, 180)
    return look.svg(figure)


def one(tables: Tables) -> bytes:
    """A single panel, for the README."""
    all_runs = [run for run in runs.runs(tables) if run.scene == README_SCENE]
    plt = look.pyplot()
    ratios = {"width_ratios": [2.2, 1]}
    figure, (axes, key) = plt.subplots(1, 2, figsize=(8.4, 4.6), gridspec_kw=ratios)
    letters = _letters(all_runs)
    _panel(axes, all_runs, README_SCENE, letters)
    axes.set_xlabel("error, m")
    axes.set_ylabel("CPU time per simulated second, ns")
    key.axis("off")
    _legend(key, all_runs)
    _foot(figure, letters, 125)
    return look.svg(figure)


def _panel(axes: Any, all_runs: list[Run], scene: str, letters: dict[str, str]) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(LEFT / 3, RIGHT)
    axes.axvspan(LEFT / 3, LEFT * 3, color="#eeeeee", zorder=0)
    axes.axvline(look.FINE, color="black", linewidth=0.8, linestyle=(0, (1, 2)))
    axes.set_title(scene.replace("_", " "))
    placed: list[tuple[float, float]] = []
    for method in runs.methods(all_runs)[::-1]:
        own = [r for r in all_runs if r.scene == scene and r.method == method]
        own = [r for r in own if math.isfinite(r.error)]
        if own:
            _line(axes, own, look.style(method, runs.peers(all_runs)), letters, placed)


def _line(
    axes: Any,
    own: list[Run],
    style: look.Style,
    letters: dict[str, str],
    placed: list[tuple[float, float]],
) -> None:
    own = sorted(own, key=lambda run: -run.setting)
    x, y = [max(run.error, LEFT) for run in own], [run.ns for run in own]
    axes.plot(x, y, **style.line(), zorder=2 if own[0].peer else 3)
    if min(run.error for run in own) > look.FINE:
        marker = "o" if style.marker in look.PEER_MARKERS else style.marker
        axes.plot(x[-1:], y[-1:], marker, mfc="white", mec=style.color, ms=8, zorder=4)
        axes.annotate(
            letters[runs.reason(own)],
            (x[-1], y[-1]),
            (7, -3),
            textcoords="offset points",
            fontsize=8,
            fontweight="bold",
        )
    if own[0].peer:
        _name(axes, style, (x[-1], y[-1]), placed)
        return
    for run, spot in zip(own, zip(x, y)):
        _setting(axes, run, spot, style, placed)


def _name(
    axes: Any, style: look.Style, spot: tuple[float, float], placed: list[tuple[float, float]]
) -> None:
    """Of another engine, at the end of its line, where there is room."""
    if _has_room(spot, placed):
        place = {"textcoords": "offset points", "ha": "center", "va": "bottom"}
        axes.annotate(style.label, spot, (0, 5), fontsize=6, color="#555555", zorder=5, **place)


def _has_room(spot: tuple[float, float], placed: list[tuple[float, float]]) -> bool:
    """Whether no text stands there yet; takes the place."""
    here = (math.log10(spot[0]) / 1.25, math.log10(spot[1]) / 0.4)
    if any(abs(here[0] - x) < 1 and abs(here[1] - y) < 1 for x, y in placed):
        return False
    placed.append(here)
    return True


def _setting(
    axes: Any,
    run: Run,
    spot: tuple[float, float],
    style: look.Style,
    placed: list[tuple[float, float]],
) -> None:
    """The step or the tolerance at a point, in powers of ten, where there is room."""
    power = math.log10(run.setting)
    if abs(power - round(power)) > 1e-4 or not _has_room(spot, placed):
        return
    inside = spot[0] <= LEFT  # in the strip there is room on the right only
    axes.annotate(
        f"1e{round(power)}",
        spot,
        (5 if inside else -4, 0),
        textcoords="offset points",
        fontsize=6,
        color=style.color if style.color != look.ORANGE else "#9a6a00",
        ha="left" if inside else "right",
        va="center",
        zorder=5,
    )


def _letters(all_runs: list[Run]) -> dict[str, str]:
    """A letter for each reason for which a method stays above the line."""
    reasons: list[str] = []
    for scene in runs.scenes(all_runs):
        for method in runs.methods(all_runs):
            own = [r for r in all_runs if r.scene == scene and r.method == method]
            if own and min(r.error for r in own) > look.FINE:
                reasons.append(runs.reason(own))
    return {text: look.letter(i) for i, text in enumerate(sorted(set(reasons)))}


def _label(grid: Any) -> None:
    for axes in grid[-1]:
        axes.set_xlabel("error, m")
    last = [axes for axes in grid.flat if axes.axison][-3:]
    for axes in last:
        axes.tick_params(labelbottom=True)
        axes.set_xlabel("error, m")
    for axes in grid[:, 0]:
        axes.set_ylabel("CPU time per simulated second, ns")


def _legend(axes: Any, all_runs: list[Run]) -> None:
    others = runs.peers(all_runs)
    plt = look.pyplot()
    shown = [look.style(method, others) for method in runs.methods(all_runs)]
    handles = [plt.Line2D([], [], label=style.label, **style.line()) for style in shown]
    handles.append(plt.Line2D([], [], color="black", linewidth=0.8, ls=(0, (1, 2)), label="1 mm"))
    axes.legend(handles=handles, loc="upper left", handlelength=3.2, labelspacing=0.35)


def _foot(figure: Any, letters: dict[str, str], width: int) -> None:
    """What the marks mean, below the panels."""
    words = "At points: Δt in s; event-driven: the tolerance. Grey strip: 1e-8 m or less."
    if letters:
        words += " An open mark ends a line that is never within 1 mm, because "
        words += "; ".join(f"({letters[text]}) {text}" for text in letters) + "."
    lines = textwrap.wrap(words, width)
    room = (len(lines) + 0.5) * 0.155 / figure.get_figheight()
    figure.text(0.02, 0.1 / figure.get_figheight(), "\n".join(lines), va="bottom", fontsize=7.5)
    figure.tight_layout(rect=(0, room, 1, 1))


def order(tables: Tables) -> bytes:
    """error / dt over dt: level where the order is one, rising to the left where there is a floor."""
    table = tables["order"]
    scenes = table.distinct("scene")
    plt = look.pyplot()
    rows = math.ceil((len(scenes) + 1) / 3)
    figure, grid = plt.subplots(rows, 3, figsize=(look.WIDTH, 2.6 * rows), sharex=True)
    for axes, scene in zip(grid.flat, scenes):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(scene.replace("_", " "))
        for method in table.distinct("method"):
            own = [row for row in table.where(scene=scene, method=method)]
            x = [number(row, "dt_s") for row in own]
            y = [number(row, "error_m") / step for row, step in zip(own, x)]
            kept = [(a, b) for a, b in zip(x, y) if math.isfinite(b) and b > 1e-7]
            if kept:
                line = look.style(method, []).line()
                axes.plot(
                    *zip(*kept),
                    **{**line, "linewidth": 1.0, "markersize": 0.8 * line["markersize"]},
                )
        if not axes.lines:
            look.note(axes, "every method is exact here")
    for axes in grid.flat[len(scenes) :]:
        axes.axis("off")
    for axes in [a for a in grid.flat if a.axison][-3:]:
        axes.tick_params(labelbottom=True)
        axes.set_xlabel("Δt, s")
    for axes in grid[:, 0]:
        axes.set_ylabel("error / Δt, m/s")
    styles = [look.style(method, []) for method in table.distinct("method")]
    handles = [plt.Line2D([], [], label=style.label, **style.line()) for style in styles]
    grid.flat[len(scenes)].legend(handles=handles, loc="center left", handlelength=3.2)
    figure.tight_layout()
    return look.svg(figure)


def profile(tables: Tables) -> bytes:
    """Dolan and More: the share of problems that a method solves within a factor of the fastest."""
    all_runs = runs.runs(tables)
    shares = profiles(all_runs)
    plt = look.pyplot()
    figure, axes = plt.subplots(figsize=(look.WIDTH * 0.8, 4.2))
    axes.set_xscale("log")
    for method, ratios in shares.items():
        style = look.style(method, runs.peers(all_runs))
        solved = sorted(ratio for ratio in ratios if math.isfinite(ratio))
        x = [1.0, *solved, 1e5]
        y = [sum(r <= t for r in ratios) / len(ratios) for t in x]
        line = {**style.line(), "markevery": max(1, len(x) // 8)}
        axes.step(x, y, where="post", label=style.label, **line)
    axes.set_xlim(0.9, 1e5)
    axes.set_ylim(0, 1.02)
    axes.set_xlabel("times the time of the fastest method of the problem")
    axes.set_ylabel("share of the problems")
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), handlelength=3.2)
    figure.tight_layout()
    return look.svg(figure)


def profiles(all_runs: list[Run]) -> dict[str, list[float]]:
    """By method, its time over that of the fastest, for each scene and tolerance."""
    ratios: dict[str, list[float]] = {method: [] for method in runs.methods(all_runs)}
    for scene in runs.scenes(all_runs):
        for tolerance in runs.TOLERANCES:
            times = {m: runs.least_time(all_runs, scene, m, tolerance) for m in ratios}
            best = min(times.values())
            for method, time in times.items():
                ratios[method].append(time / best if math.isfinite(time) else math.inf)
    return ratios
