"""The charts, and the tables that each is drawn from."""

from collections.abc import Callable
from dataclasses import dataclass

from bounce_study import chart_maps, chart_measured, chart_models, chart_peers, chart_speed
from bounce_study import chart_stability
from bounce_study.tables import Tables


@dataclass(frozen=True)
class Chart:
    name: str
    needs: tuple[str, ...]
    draw: Callable[[Tables], bytes]


CHARTS = (
    Chart("speed_accuracy.svg", ("speed_accuracy",), chart_speed.panels),
    Chart("speed_accuracy_one.svg", ("speed_accuracy",), chart_speed.one),
    Chart("order.svg", ("order",), chart_speed.order),
    Chart("profile.svg", ("speed_accuracy",), chart_speed.profile),
    Chart("peers_steps.svg", ("peers_steps", "peers_settings"), chart_peers.steps),
    Chart("energy_gain.svg", ("energy_gain",), chart_maps.energy_gain),
    Chart("solution_count.svg", ("solution_count",), chart_maps.solution_count),
    Chart("gauss_seidel.svg", ("gauss_seidel",), chart_stability.gauss_seidel),
    Chart("depth.svg", ("depth",), chart_stability.depth),
    Chart("almost_flat.svg", ("almost_flat",), chart_stability.almost_flat),
    Chart("flat_landing.svg", ("flat_landing",), chart_stability.flat_landing),
    Chart("rest_and_drift.svg", ("rest_and_drift",), chart_stability.rest_and_drift),
    Chart("scaling.svg", ("scaling",), chart_stability.scaling),
    Chart("least_model.svg", ("least_model",), chart_models.ladder),
    Chart("chosen_model.svg", ("chosen_model",), chart_models.chosen),
    Chart("measured_ladder.svg", ("measured_ladder",), chart_measured.ladder),
    Chart("measured_drops.svg", ("measured_drops",), chart_measured.drops),
)


def draw(tables: Tables) -> dict[str, bytes]:
    """Draws the charts whose tables are all there."""
    return {
        chart.name: chart.draw(tables)
        for chart in CHARTS
        if all(name in tables for name in chart.needs)
    }
