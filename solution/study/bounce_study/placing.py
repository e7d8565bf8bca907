"""Short texts beside points, where neither other texts nor points are in the way."""

from typing import Any

POINTS_PER_LETTER = 0.62  # of the size of the font
PLACES = (  # from the point, in its text's widths and heights
    (0.75, 0.0),
    (-0.75, 0.0),
    (0.0, 1.0),
    (0.0, -1.0),
    (0.75, 0.9),
    (-0.75, 0.9),
    (0.75, -0.9),
    (-0.75, -0.9),
)
Box = tuple[float, float, float, float]


class Places:
    """The room of one panel, in points; `axes` must have its limits and its place."""

    def __init__(self, axes: Any) -> None:
        self._axes = axes
        self._taken: list[Box] = []

    def keep(self, x: float, y: float, size: float) -> None:
        """What no text may hide: a mark."""
        at_x, at_y = self._spot(x, y)
        self._taken.append((at_x - size / 2, at_y - size / 2, at_x + size / 2, at_y + size / 2))

    def put(self, text: str, x: float, y: float, size: float, gap: float, **font: Any) -> bool:
        """Writes the text `gap` points beside a mark, if there is room within the panel."""
        width, height = POINTS_PER_LETTER * size * len(text), size
        at_x, at_y = self._spot(x, y)
        for to_x, to_y in PLACES:
            dx = to_x * width + (gap if to_x > 0 else -gap if to_x < 0 else 0)
            dy = to_y * height + (gap if to_y > 0 else -gap if to_y < 0 else 0) * (to_x == 0)
            box = (
                at_x + dx - width / 2,
                at_y + dy - height / 2,
                at_x + dx + width / 2,
                at_y + dy + height / 2,
            )
            if self._inside(box) and not any(_meet(box, other) for other in self._taken):
                self._taken.append(box)
                place = {"textcoords": "offset points", "ha": "center", "va": "center"}
                self._axes.annotate(text, (x, y), (dx, dy), fontsize=size, **place, **font)
                return True
        return False

    def _spot(self, x: float, y: float) -> tuple[float, float]:
        at_x, at_y = self._axes.transData.transform((x, y))
        scale = 72 / self._axes.figure.dpi
        return at_x * scale, at_y * scale

    def _inside(self, box: Box) -> bool:
        scale = 72 / self._axes.figure.dpi
        whole = self._axes.bbox
        return (
            box[0] > whole.x0 * scale
            and box[1] > whole.y0 * scale
            and box[2] < whole.x1 * scale
            and box[3] < whole.y1 * scale
        )


def _meet(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
