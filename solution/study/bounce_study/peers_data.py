"""What was measured of the engines beside our methods: the tables of docs/studies/peers.md."""

from dataclasses import dataclass
from pathlib import Path

from bounce_study import tables
from bounce_study.tables import number, Row

RATIO = ("times", "lower_quartile", "upper_quartile")
OURS = {
    "assignment": "the assignment's scheme, plain",
    "assignment_fast": "the assignment's scheme, fastest",
    "assignment_delta_dt": "the assignment's scheme, δ per Δt",
    "moreau_jean_1": "Moreau–Jean, one corner",
    "moreau_jean_2": "Moreau–Jean, two corners",
    "penalty": "springs and dampers",
    "event_driven": "event-driven",
}


@dataclass(frozen=True)
class Point:
    scene: str
    method: str
    dt: float
    ns: float  # per simulated second
    error: float  # m


@dataclass(frozen=True)
class Data:
    origin: dict[str, str]
    settings: list[Row]
    steps: list[Row]
    variants: list[Row]
    lcp: list[Row]  # none where Siconos was not installed
    notes: list[Row]
    ratios: list[Row]
    peers: list[Point]
    ours: list[Point]

    @property
    def scenes(self) -> list[str]:
        return list(dict.fromkeys(point.scene for point in self.ours))

    def engines(self) -> list[str]:
        """Those of the sweep, without numpy: it is the assignment's scheme."""
        return [row["engine"] for row in self.settings if row["swept"] == "1" and not is_own(row)]

    def variants_of_engines(self) -> list[str]:
        return list(dict.fromkeys(row["engine"] for row in self.variants if row["swept"] == "0"))

    def variant_errors(self, scene: str, engine: str) -> list[float]:
        """From the largest step to the smallest."""
        own = [row for row in self.variants if row["scene"] == scene and row["engine"] == engine]
        own.sort(key=lambda row: -number(row, "dt_s"))
        return [number(row, "error_m") for row in own]

    def title(self, engine: str) -> str:
        titles = {row["engine"]: row["title"] for row in self.settings}
        return titles.get(engine) or OURS.get(engine) or engine

    def name(self, engine: str) -> str:
        """The title within a sentence, where a comma would be taken for the sentence's."""
        title, _, settings = self.title(engine).partition(", ")
        return f"{title} ({settings})" if settings else title


def read(folder: Path) -> Data:
    peers = tables.read(folder / "peers.csv")
    lcp = folder / "peers_lcp.csv"
    return Data(
        origin=peers.origin,
        settings=_rows(folder, "peers_settings"),
        steps=_rows(folder, "peers_steps"),
        variants=_rows(folder, "peers_variants"),
        lcp=tables.read(lcp).rows if lcp.exists() else [],
        notes=[row for row in peers.rows if row["note"]],
        ratios=_rows(folder, "peers_ratios"),
        peers=[_point(row) for row in peers.rows],
        ours=[_point(row) for row in _rows(folder, "peers_beside")],
    )


def _rows(folder: Path, name: str) -> list[Row]:
    return tables.read(folder / f"{name}.csv").rows


def _point(row: Row) -> Point:
    return Point(
        row["scene"],
        row["method"],
        number(row, "setting"),
        number(row, "ns_per_simulated_second"),
        number(row, "error_m"),
    )


def is_own(row: Row) -> bool:
    return row["engine"] in ("numpy", "assignment", "assignment_fast")


def least_time(points: list[Point], scene: str, error: float) -> Point | None:
    """The fastest that is no worse than `error`."""
    good = [p for p in points if p.scene == scene and p.error <= error]
    return min(good, key=lambda p: p.ns) if good else None


@dataclass(frozen=True)
class Lead:
    """How many times as long an engine takes as ours at the same error or less."""

    times: float  # 0 where none of ours is as good
    lower: float
    upper: float
    engine: str


def lead(data: Data, scene: str) -> Lead:
    """That of the closest engine."""
    rows = [r for r in data.ratios if r["scene"] == scene and r["within"] == "peer's own"]
    leads = [_lead(row) for row in rows if row["engine"] != "numpy"]
    return min(leads, key=lambda each: each.times)


def _lead(row: Row) -> Lead:
    times, lower, upper = (float(row[name] or 0) for name in RATIO)
    return Lead(times, lower, upper, row["engine"])
