"""Writes the points of grader/parts.json into the texts that students read."""

import re

from bounce_grader.common.manifest import parts
from bounce_grader.common.numbers import short

NUMBER = r"\d+(?:\.\d+)?"


def with_points(text: str) -> str:
    """The text with the points of each part and their sum, wherever the handout or a header says
    them: "Part 2 (30 points)", the table of parts, "worth 100 points", "30, 30, 30 and 10
    points"."""
    points = [short(part.points) for part in parts()]
    for part in parts():
        own = rf"\g<1>{short(part.points)}\g<2>"
        text = re.sub(rf"(\bPart {part.number}\b[^\n(]*\(){NUMBER}( points\))", own, text)
        text = re.sub(rf"(?m)^(\| {part.number} \|.*\| ){NUMBER}( \|)$", own, text)
    total = short(sum(part.points for part in parts()))
    text = re.sub(rf"(\bworth ){NUMBER}( points)", rf"\g<1>{total}\g<2>", text)
    listed = f"{', '.join(points[:-1])} and {points[-1]}"
    return re.sub(rf"(?:{NUMBER}, )+{NUMBER} and {NUMBER}( points)", rf"{listed}\g<1>", text)
