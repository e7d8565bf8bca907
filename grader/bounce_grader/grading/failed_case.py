"""Reads and validates a failed case in numbers, as the judge writes it
(grader/judge/failed_case.hpp)."""

import sys
from typing import Any

from bounce_grader.common.escaping import printable_text

Shown = dict[str, Any]
ODD = ("nan", "inf", "-inf")
MOST = 2000  # rows, or entries of a row


def read(answer: Any) -> Shown | None:
    """Copies the fields that are documented, and no others. Raises ValueError, TypeError or
    KeyError."""
    if answer is None:
        return None
    out: Shown = {key: _text(answer[key]) for key in ("name", "input", "sentence")}
    out["quantities"] = [_quantity(quantity) for quantity in answer["quantities"]]
    if "contact" in answer:
        out["contact"] = _text(answer["contact"])
    if "scene" in answer:
        out["scene"] = _scene(answer["scene"])
    if "path" in answer:
        out["path"] = _path(answer["path"])
    return out


def read_revealed(answer: Any) -> Shown | None:
    """A hidden case with its expected answers, and the message that shows them."""
    if answer is None:
        return None
    return {"message": _text(answer["message"]), "shown": read(answer["shown"])}


def _text(x: Any) -> str:
    if not isinstance(x, str):
        raise TypeError("no text")
    return printable_text(x)


def _quantity(answer: Any) -> Shown:
    out: Shown = {key: _text(answer[key]) for key in ("name", "unit")}
    out["got"] = _rows(answer["got"], _entry)
    out["right"] = _rows(answer["right"], _bool)
    if "expected" in answer:
        out["expected"] = _rows(answer["expected"], _entry)
    shapes = {tuple(map(len, out[key])) for key in ("got", "right", "expected") if key in out}
    if len(shapes) != 1:
        raise ValueError("matrices of several shapes")
    return out


def _scene(answer: Any) -> Shown:
    numbers = {key: _finite(answer[key]) for key in ("l", "m", "dt", "delta")}
    vectors = {key: _rows([answer[key]], _finite)[0] for key in ("g", "q", "v")}
    if {len(vector) for vector in vectors.values()} != {3}:
        raise ValueError("no configuration")
    return {**numbers, **vectors}


def _path(answer: Any) -> Shown:
    out: Shown = {"first": _whole(answer["first"]), "got": _rows(answer["got"], _entry)}
    if "expected" in answer:
        out["columns"] = [_whole(column) for column in answer["columns"]]
        out["expected"] = _rows(answer["expected"], _finite)
    widths = {len(row) for key in ("got", "expected") for row in out.get(key, [])}
    if widths - {3} or len(out.get("columns", [])) != len(out.get("expected", [])):
        raise ValueError("no configurations")
    return out


def _rows(answer: Any, entry: Any) -> list[list[Any]]:
    if not isinstance(answer, list) or not 0 < len(answer) <= MOST:
        raise TypeError("no matrix")
    rows = [[entry(x) for x in row] for row in answer]
    if {len(row) for row in rows} != {len(rows[0])} or not 0 < len(rows[0]) <= MOST:
        raise ValueError("no matrix")
    return rows


def _entry(x: Any) -> float | str:
    return str(x) if x in ODD else _finite(x)


def _finite(x: Any) -> float:
    if type(x) not in (int, float) or not abs(x) <= sys.float_info.max:
        raise TypeError("no number")
    return float(x)


def _whole(x: Any) -> int:
    if type(x) is not int or not -1 <= x < 10**7:
        raise TypeError("no column")
    return x


def _bool(x: Any) -> bool:
    if type(x) is not bool:
        raise TypeError("neither right nor wrong")
    return x
