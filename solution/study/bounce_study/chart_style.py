"""Colours, marks and labels of the charts. The colours are Okabe and Ito's, which the colour-blind
can tell apart; each line has a marker and a dash of its own, so that grey is enough. The same
numbers give the same bytes."""

import io
from dataclasses import dataclass
from typing import Any

BLACK, GREY, INK = "#000000", "#8a8a8a", "#333333"
ORANGE, SKY, GREEN, BLUE = "#E69F00", "#56B4E9", "#009E73", "#0072B2"
VERMILION, PURPLE = "#D55E00", "#CC79A7"
FINE, FINEST = 1e-3, 1e-6  # m: the tolerances that pages speak of; the first is a line in charts
WIDTH = 10.0  # inches; 96 pixels to each on a screen
SETTINGS = {
    "svg.hashsalt": "bounce",
    "svg.fonttype": "path",
    "savefig.dpi": 192,  # of the maps, which are pictures within the drawing
    "font.family": "DejaVu Sans",
    "font.size": 8.0,
    "axes.titlesize": 9.0,
    "axes.labelsize": 8.0,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "legend.fontsize": 8.0,
    "axes.linewidth": 0.6,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.5,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "hatch.linewidth": 0.6,
}


@dataclass(frozen=True)
class Style:
    label: str
    color: str
    marker: str
    dash: Any = "-"
    size: float = 4.5  # of the marker; those with arms need more to be told from a dot
    width: float = 1.3

    def line(self) -> dict[str, Any]:
        return {
            "color": self.color,
            "marker": self.marker,
            "linestyle": self.dash,
            "markersize": self.size,
            "linewidth": self.width,
            **({"mfc": INK, "mec": INK, "mew": 0.2} if is_letter(self) else {}),
        }


METHODS = {
    "assignment": Style("assignment, plain", BLACK, "o", (0, (4, 2))),
    "assignment_fast": Style("assignment, fast", ORANGE, "s"),
    "assignment_delta_dt": Style("assignment, δ ∝ Δt", VERMILION, "D", (0, (6, 1, 1, 1))),
    "assignment_delta_0": Style("assignment, δ = 0", GREY, "*", (0, (1, 1)), 7.0),
    "moreau_jean_1": Style("Moreau–Jean, one corner", SKY, "^", (0, (2, 1))),
    "moreau_jean_2": Style("Moreau–Jean, two corners", BLUE, "v"),
    "penalty": Style("penalty", PURPLE, "P", (0, (1, 1.5)), 6.5),
    "event_driven": Style("event-driven", GREEN, "X", "-", 6.5),
}
# Engines: grey, with a letter as the mark, so that every point names its line.
PEERS = {
    name: Style(label, GREY, rf"$\mathbf{{{mark}}}$", "-", 6.0, 0.7)
    for name, label, mark in (
        ("chipmunk", "Chipmunk", "C"),
        ("chipmunk_10", "Chipmunk, 10 iterations", "K"),
        ("box2d", "Box2D", "X"),
        ("ode", "ODE", "O"),
        ("bullet", "Bullet", "B"),
        ("mujoco", "MuJoCo", "M"),
        ("dart", "DART", "D"),
        ("siconos", "Siconos", "S"),
        ("simbody", "Simbody", "Y"),
        ("numpy", "numpy", "N"),
    )
}
OTHER_PEERS = "EFGHIJKL"  # marks of engines that aren't listed above


def style(method: str, peers: list[str]) -> Style:
    """Gives the style of one of our methods, or of one of the peers."""
    known = METHODS.get(method) or PEERS.get(method)
    if known:
        return known
    mark = OTHER_PEERS[peers.index(method) % len(OTHER_PEERS)]
    return Style(method, GREY, rf"$\mathbf{{{mark}}}$", "-", 6.0, 0.7)


def is_letter(style: Style) -> bool:
    return style.marker.startswith("$")


def method_label(name: str) -> str:
    return style(name, [name]).label


def scene_label(name: str) -> str:
    return name.replace("_", " ")


def pyplot() -> Any:
    """Sets up matplotlib's pyplot, which is imported only where a chart is drawn."""
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    plt.rcdefaults()
    plt.rcParams.update(SETTINGS)
    return plt


def svg(figure: Any) -> bytes:
    """Writes the figure without a date or a version, and with ids that depend on nothing else."""
    out = io.BytesIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    pyplot().close(figure)
    return out.getvalue()


def note(axes: Any, text: str) -> None:
    """Writes the text in the middle of the panel."""
    axes.text(0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", wrap=True)


def legend_below(figure: Any, axes: Any, panels: tuple[float, ...], **more: Any) -> None:
    """Puts the legend of these axes below the panels, which fill this rectangle of the figure."""
    figure.tight_layout(rect=panels)
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", **more)
