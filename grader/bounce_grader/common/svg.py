"""The shapes that drawings are made of. They take the colour of the text around them, so that they
show on paper, in the dark and in grey."""

from collections.abc import Sequence

from bounce_grader.common import escaping

INK = "currentColor"


def svg(shapes: Sequence[str], width: float, height: float, label: str) -> str:
    return (
        f'<svg viewBox="0 0 {width:.0f} {height:.0f}" role="img" aria-label="{escaping.html(label)}">'
        f"{''.join(shapes)}</svg>"
    )


def rect(x: float, y: float, w: float, h: float, fill: str, stroke: str = "none") -> str:
    size = f'width="{max(w, 0):.1f}" height="{max(h, 0):.1f}"'
    return f'<rect x="{x:.1f}" y="{y:.1f}" {size} fill="{fill}" stroke="{stroke}"/>'


def text(x: float, y: float, words: str, anchor: str = "start", weight: str = "normal") -> str:
    bold = ' style="font-weight:bold"' if weight == "bold" else ""
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{bold}>{escaping.html(words)}</text>'
    )


def upward(x: float, y: float, words: str) -> str:
    turned = f'transform="rotate(-90 {x:.1f} {y:.1f})"'
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="middle" {turned}>{escaping.html(words)}</text>'
    )


def line(x1: float, y1: float, x2: float, y2: float, dash: str = "", width: float = 1) -> str:
    return path([(x1, y1), (x2, y2)], dash, width)


def path(points: Sequence[tuple[float, float]], dash: str = "", width: float = 1) -> str:
    dashed = f' stroke-dasharray="{dash}"' if dash else ""
    thick = f' stroke-width="{width:g}"' if width != 1 else ""
    places = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
    return f'<path d="M{places}" fill="none" stroke="{INK}"{dashed}{thick}/>'
