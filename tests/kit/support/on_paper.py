"""Whether the smallest case of a part can be worked out by hand, and what is right there is right:
asked of the oracle, which shares nothing with the grader."""

from collections.abc import Sequence
from typing import Any

import oracle

USUAL: dict[str, Any] = {
    "l": 0.2, "m": 0.3, "mu": 0.3, "epsilon": 0.5,
    "g": [0, -9.81, 0], "dt": 0.01, "delta": 0.001, "T": 150,
}  # fmt: skip
J_IN_THE_SIMPLEST_CASE: Any = [[1, 0], [0, 1], [0, 0]]


def lost_by_numbers(part: dict[str, Any]) -> bool:
    return any(check.get("shown", {}).get("quantities") for check in part["checks"])


def numbers_to_think_of(smallest: dict[str, Any]) -> int:
    """Those that are neither 0 nor the assignment's; T, which counts columns, apart."""
    asked = dict(smallest["input"])
    usual = USUAL | asked["params"]
    pairs = [(usual[name], USUAL[name]) for name in USUAL if name != "T"]
    pairs += [
        (asked[name], J_IN_THE_SIMPLEST_CASE if name == "J" else [0, 0, 0])
        for name in asked
        if name != "params"
    ]
    return sum(x != y for pair in pairs for x, y in zip(*map(_flat, pair), strict=True))


def is_right(part: int, smallest: dict[str, Any]) -> bool:
    """Whether the oracle gives what is called right, or another that is as right."""
    asked, quantity = smallest["input"], smallest["quantity"]
    params = oracle.Parameters.read(USUAL | asked["params"])
    answers = _answers(part, asked, params, quantity)
    expected = _flat(smallest["expected"])
    return any(_agrees(expected, _flat(answer)) for answer in answers)


def _answers(part: int, asked: dict[str, Any], params: Any, quantity: str) -> list[Any]:
    if part == 1:
        contact = oracle.get_contacts(oracle.vector(asked["q"]), params)
        both = [contact.J, contact.second_J] if contact.gap < oracle.ROUNDING else [contact.J]
        return [_of_contact(J, contact.phi, quantity) for J in both]
    if part == 2:
        J_t, J_n = map(oracle.vector, zip(*asked["J"], strict=True))
        return [_of_lcp(*oracle.form_lcp((J_t, J_n), oracle.vector(asked["v"]), params), quantity)]
    if part == 3:
        q, v = oracle.step(oracle.vector(asked["q"]), oracle.vector(asked["v"]), params)
        return [{"q after the step": q, "v after the step": v}[quantity]]
    name, _, column = quantity.partition(" in column ")
    start = oracle.vector(asked["q_0"]), oracle.vector(asked["v_0"])
    return [oracle.simulate(*start, params, int(column))[int(column)]["qv".index(name)]]


def _of_contact(J: Any, phi: Any, quantity: str) -> Any:
    return {
        "phi": phi,
        "J_t (column 0 of J)": J[0],
        "J_n (column 1 of J)": J[1],
        "J = [J_t J_n]": list(zip(*J)),
    }[quantity]


def _of_lcp(V: Any, p: Any, quantity: str) -> Any:
    return {
        "the upper left 3x3 of V": [row[:3] for row in V[:3]],
        "the last column of V": [row[3] for row in V],
        "the last row of V": V[3],
        "p(0)": p[0],
        "(p(1), p(2), p(3))": p[1:],
        "(p(1), p(2))": p[1:3],
        "p": p,
    }[quantity]


def _agrees(expected: Sequence[Any], exact: Sequence[Any]) -> bool:
    pairs = zip(expected, exact, strict=True)
    return all(abs(oracle.exact(x) - y) <= oracle.CONFIRMED * max(1, abs(y)) for x, y in pairs)


def _flat(x: Any) -> list[Any]:
    return [leaf for each in x for leaf in _flat(each)] if isinstance(x, (list, tuple)) else [x]
