"""Works out the facts of the page on simulating within a tolerance from its table."""

from typing import Any

from bounce_study.tables import number, numbers, Tables


def facts(tables: Tables) -> dict[str, Any]:
    rows = tables["tolerance"].rows
    scenes = [number(row, "scenes") for row in rows]
    return {
        "tolerances": [
            {
                "tolerance": number(row, "tolerance_m"),
                **{
                    name: number(row, name) / number(row, "scenes")
                    for name in ("free_flight", "event_driven", "stepped", "refused")
                },
                "bound": number(row, "bound_over_error"),
                "bound_most": number(row, "bound_over_error_90"),
                "time": number(row, "ns"),
                "over_best": number(row, "time_over_best"),
                "over_best_most": number(row, "time_over_best_90"),
            }
            for row in rows
        ],
        "tolerance_answered": int(sum(scenes) - sum(numbers(rows, "refused"))),
        "tolerance_asked": int(sum(scenes)),
        "tolerance_violated": int(sum(numbers(rows, "violated"))),
        "tolerance_bound": max(numbers(rows, "bound_over_error")),
        "tolerance_over_best": max(numbers(rows, "time_over_best")),
    }
