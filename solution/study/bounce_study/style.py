"""Colours, marks and labels of the charts. The colours are Okabe and Ito's, which the colour-blind
can tell apart; each line has a marker and a dash of its own, so that grey is enough. The same
numbers give the same bytes."""

import io
from typing import Any

BLACK, GREY, INK = "#000000", "#8a8a8a", "#333333"
SKY, GREEN, BLUE = "#56B4E9", "#009E73", "#0072B2"
VERMILION, PURPLE = "#D55E00", "#CC79A7"
WIDTH = 10.0  # inches
SETTINGS = {
    "svg.hashsalt": "bounce",
    "savefig.dpi": 192,  # of the maps, which are pictures within the drawing
    "font.size": 8.0,
    "axes.titlesize": 9.0,
    "legend.fontsize": 8.0,
    "legend.frameon": False,
    "axes.linewidth": 0.6,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.5,
    "axes.axisbelow": True,
    "lines.linewidth": 1.3,
    "lines.markersize": 4.5,
}
# Label, colour, marker, dash.
METHODS: dict[str, tuple[str, str, str, Any]] = {
    "assignment": ("assignment, fixed δ", BLACK, "o", (0, (4, 2))),
    "assignment_delta_dt": ("assignment, δ ∝ Δt", VERMILION, "D", (0, (6, 1, 1, 1))),
    "assignment_delta_0": ("assignment, δ = 0", GREY, "*", (0, (1, 1))),
    "moreau_jean_1": ("Moreau–Jean, one corner", SKY, "^", (0, (2, 1))),
    "moreau_jean_2": ("Moreau–Jean, two corners", BLUE, "v", "-"),
    "penalty": ("penalty", PURPLE, "P", (0, (1, 1.5))),
    "event_driven": ("event-driven", GREEN, "X", "-"),
}
# Grey, with a letter as the mark, so that every point names its line.
ENGINES: dict[str, tuple[str, str, str, Any]] = {
    "chipmunk": ("Chipmunk", GREY, "$C$", "-"),
    "box2d": ("Box2D", GREY, "$B$", "-"),
    "mujoco": ("MuJoCo", GREY, "$M$", "-"),
    "siconos": ("Siconos", GREY, "$S$", "-"),
}

MODELS = {
    "asleep": "nothing at all",
    "ballistic": "free flight",
    "one_normal": "one corner without friction",
    "one_friction": "one corner with friction",
    "two_normals": "two corners without friction",
    "two_frictions": "two corners with friction",
}


def label(method: str) -> str:
    return (METHODS | ENGINES)[method][0]


def line(method: str) -> dict[str, Any]:
    name, color, marker, dash = (METHODS | ENGINES)[method]
    return {"label": name, "color": color, "marker": marker, "linestyle": dash}


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
