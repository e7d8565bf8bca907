"""Speed against accuracy: a panel for each scene, the order of convergence, and the performance
profile."""

import math
import textwrap
from typing import Any

from bounce_study import look, placing, runs
from bounce_study.runs import Run
from bounce_study.tables import number, Tables

COLUMNS = 2
LEFT, RIGHT = 1e-8, 30.0  # m: what is more exact lies in a strip at the left edge
README_SCENE = "oblique_bounce"


def panels(tables: Tables) -> bytes:
    all_runs = runs.runs(tables)
    scenes = runs.scenes(all_runs)
    plt = look.pyplot()
    rows = math.ceil((len(scenes) + 1) / COLUMNS)
    size = (look.WIDTH, 4.2 * rows)
    figure, grid = plt.subplots(rows, COLUMNS, figsize=size, sharex=True, sharey=True)
    letters = _letters(all_runs)
    for axes, scene in zip(grid.flat, scenes):
        _lines(axes, all_runs, scene)
    for axes in grid.flat[len(scenes) :]:
        axes.axis("off")
    _label(grid)
    _legend(grid.flat[len(scenes)], all_runs)
    _foot(figure, letters, 165)
    for axes, scene in zip(grid.flat, scenes):
        _texts(axes, all_runs, scene, letters)
    return look.svg(figure)


def one(tables: Tables) -> bytes:
    """A single panel, for the README."""
    all_runs = [run for run in runs.runs(tables) if run.scene == README_SCENE]
    plt = look.pyplot()
    ratios = {"width_ratios": [2.2, 1]}
    figure, (axes, key) = plt.subplots(1, 2, figsize=(8.4, 5.2), gridspec_kw=ratios)
    letters = _letters(all_runs)
    _lines(axes, all_runs, README_SCENE)
    axes.set_xlabel("error, m")
    axes.set_ylabel("CPU time per simulated second, ns")
    key.axis("off")
    _legend(key, all_runs)
    _foot(figure, letters, 125)
    _texts(axes, all_runs, README_SCENE, letters)
    return look.svg(figure)


def _own(all_runs: list[Run], scene: str, method: str) -> list[Run]:
    """From the largest step to the smallest."""
    own = [r for r in all_runs if r.scene == scene and r.method == method]
    return sorted((r for r in own if math.isfinite(r.error)), key=lambda run: -run.setting)


def _spot(run: Run) -> tuple[float, float]:
    return max(run.error, LEFT), run.ns


def _lines(axes: Any, all_runs: list[Run], scene: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(LEFT / 3, RIGHT)
    axes.axvspan(LEFT / 3, LEFT * 3, color="#eeeeee", zorder=0)
    axes.axvline(look.FINE, color="black", linewidth=0.8, linestyle=(0, (1, 2)))
    axes.set_title(scene.replace("_", " "))
    for method in runs.methods(all_runs)[::-1]:
        own = _own(all_runs, scene, method)
        if own:
            _line(axes, own, look.style(method, runs.peers(all_runs)))


def _line(axes: Any, own: list[Run], style: look.Style) -> None:
    x, y = zip(*map(_spot, own))
    axes.plot(x, y, **style.line(), zorder=2 if own[0].peer else 3)
    if not _fails(own):
        return
    if look.is_letter(style):  # the letter stays, within an open mark
        axes.plot(x[-1:], y[-1:], "o", mfc="none", mec="black", mew=0.8, ms=10, zorder=4)
    else:
        axes.plot(x[-1:], y[-1:], style.marker, mfc="white", mec=style.color, ms=8, zorder=4)


def _fails(own: list[Run]) -> bool:
    return min(run.error for run in own) > look.FINE


def _texts(axes: Any, all_runs: list[Run], scene: str, letters: dict[str, str]) -> None:
    """Reasons first, then settings where there is room."""
    room = placing.Places(axes)
    by_method = {method: _own(all_runs, scene, method) for method in runs.methods(all_runs)}
    lines = {method: own for method, own in by_method.items() if own}
    for own in lines.values():
        for run in own:
            room.keep(*_spot(run), 4)
    for method, own in lines.items():
        if _fails(own):
            letter = letters[runs.reason(own)]
            room.put(letter, *_spot(own[-1]), 8, 5, fontweight="bold", zorder=6)
    for method, own in lines.items():
        if not own[0].peer:
            _settings(room, own, look.style(method, []))


def _settings(room: placing.Places, own: list[Run], style: look.Style) -> None:
    """The steps or the tolerances that are powers of ten."""
    color = style.color if style.color != look.ORANGE else "#9a6a00"
    for run in own:
        power = math.log10(run.setting)
        if abs(power - round(power)) < 1e-4:
            room.put(f"1e{round(power)}", *_spot(run), 6, 3, color=color, zorder=5)


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
    last = [axes for axes in grid.flat if axes.axison][-COLUMNS:]
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
    words = "At points: Δt in s, where there is room; event-driven: the tolerance."
    words += " Grey strip: 1e-8 m or less."
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
                axes.plot(*zip(*kept), **{**line, **_order_look(method, line)})
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
    handles = [
        plt.Line2D(
            [], [], label=style.label, **{**style.line(), **_order_look(method, style.line())}
        )
        for method, style in zip(table.distinct("method"), styles)
    ]
    grid.flat[len(scenes)].legend(handles=handles, loc="center left", handlelength=3.2)
    figure.tight_layout()
    return look.svg(figure)


def _order_look(method: str, line: dict[str, Any]) -> dict[str, Any]:
    """The plain form lies upon the fast one, which is drawn wide and pale below it."""
    if method == "assignment_fast":
        return {"linewidth": 4.0, "markersize": 5.5, "alpha": 0.55, "zorder": 1}
    if method == "assignment":
        return {"linewidth": 0.9, "markersize": 2.5, "zorder": 2.5}
    return {"linewidth": 1.0, "markersize": 0.8 * line["markersize"]}


def profile(tables: Tables) -> bytes:
    """Dolan and Moré: the share of problems that a method solves within a factor of the fastest.
    Ours and the others in a panel each, every line to where it stays level, and named there."""
    all_runs = runs.runs(tables)
    shares = profiles(all_runs)
    peers = runs.peers(all_runs)
    groups = {"our methods": [m for m in shares if m not in peers], "engines and numpy": peers}
    shown = {title: group for title, group in groups.items() if group}
    plt = look.pyplot()
    size = (look.WIDTH, 4.2)
    figure, row = plt.subplots(1, len(shown), figsize=size, squeeze=False)
    for axes, (title, group) in zip(row[0], shown.items()):
        axes.set_title(title)
        _profile_panel(axes, {m: shares[m] for m in group}, peers)
    row[0][0].set_ylabel("share of the problems")
    figure.tight_layout()
    return look.svg(figure)


def _profile_panel(axes: Any, shares: dict[str, list[float]], peers: list[str]) -> None:
    solved = [r for own in shares.values() for r in own if math.isfinite(r)]
    first, last = min(solved, default=1.0), max(solved, default=1.0)
    end = last * (last / first) ** 0.08
    styles = {method: look.style(method, peers) for method in shares}
    for method, ratios in shares.items():
        _profile_line(axes, ratios, styles[method], end)
    top = max(_share(ratios) for ratios in shares.values())
    axes.set_xscale("log")
    axes.set_xlim(first * 0.9, end * (end / first) ** 0.6)
    axes.set_ylim(0, 1.15 * top)
    axes.set_xlabel("times the time of the fastest method of the problem")
    heights = _apart([_share(ratios) for ratios in shares.values()], 0.045 * top)
    for (method, ratios), height in zip(shares.items(), heights):
        beside = {"textcoords": "data", "va": "center", "fontsize": 7.5}
        line = {"arrowprops": {"arrowstyle": "-", "linewidth": 0.5, "color": look.GREY}}
        name = (end * (end / first) ** 0.04, height)
        axes.annotate(styles[method].label, (end, _share(ratios)), name, **beside, **line)


def _share(ratios: list[float]) -> float:
    return sum(map(math.isfinite, ratios)) / len(ratios)


def _apart(heights: list[float], gap: float) -> list[float]:
    """The same heights, moved up where two would be closer than the gap."""
    moved = list(heights)
    below = 0.0
    for i in sorted(range(len(heights)), key=lambda i: heights[i]):
        moved[i] = below = max(heights[i], below + gap)
    return moved


def _profile_line(axes: Any, ratios: list[float], style: look.Style, end: float) -> None:
    solved = sorted(ratio for ratio in ratios if math.isfinite(ratio))
    x = [*solved[:1], *solved, end]
    y = [0.0, *(sum(r <= t for r in ratios) / len(ratios) for t in x[1:])]
    axes.step(x, y, where="post", **{**style.line(), "markevery": max(1, len(x) // 5)})


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
