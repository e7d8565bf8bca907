"""Writes short texts beside points, where neither other texts nor points are in the way."""

from typing import Any

WIDTH = 0.62  # of a letter, in font sizes
DIRECTIONS = (  # from the point, in widths and heights of the text
    (0.75, 0.0),
    (-0.75, 0.0),
    (0.0, 1.0),
    (0.0, -1.0),
    (0.75, 0.9),
    (-0.75, 0.9),
    (0.75, -0.9),
    (-0.75, -0.9),
)
Box = tuple[float, float, float, float]  # left, lower, right and upper edge, in points


class PointLabels:
    """The labels of one panel; `axes` must have its limits and its place in the figure."""

    def __init__(self, axes: Any) -> None:
        self._axes = axes
        self._scale = 72 / axes.figure.dpi
        self._occupied: list[Box] = []

    def occupy(self, x: float, y: float, size: float) -> None:
        """Keeps texts away from a mark."""
        self._occupied.append(_box(*self._position(x, y), size, size))

    def add(self, text: str, x: float, y: float, size: float, gap: float, **font: Any) -> bool:
        """Writes the text `gap` points beside a mark, if there is room within the panel."""
        width, height = WIDTH * size * len(text), size
        center_x, center_y = self._position(x, y)
        for to_x, to_y in DIRECTIONS:
            dx = to_x * width + gap * _sign(to_x)
            dy = to_y * height + gap * _sign(to_y) * (to_x == 0)
            box = _box(center_x + dx, center_y + dy, width, height)
            if self._is_free(box):
                self._occupied.append(box)
                place = {"textcoords": "offset points", "ha": "center", "va": "center"}
                self._axes.annotate(text, (x, y), (dx, dy), fontsize=size, **place, **font)
                return True
        return False

    def _position(self, x: float, y: float) -> tuple[float, float]:
        at_x, at_y = self._axes.transData.transform((x, y))
        return at_x * self._scale, at_y * self._scale

    def _is_free(self, box: Box) -> bool:
        left, lower, right, upper = (edge * self._scale for edge in self._axes.bbox.extents)
        inside = box[0] > left and box[1] > lower and box[2] < right and box[3] < upper
        return inside and not any(_overlap(box, other) for other in self._occupied)


def _box(x: float, y: float, width: float, height: float) -> Box:
    return x - width / 2, y - height / 2, x + width / 2, y + height / 2


def _sign(x: float) -> int:
    return (x > 0) - (x < 0)


def _overlap(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
