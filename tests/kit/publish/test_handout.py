"""What the handout and its hints say is right. A worked number stands in a fenced block, one
statement a line, and is worked out here, at 50 digits:

    given v = (3, -1, 2) m/s, m/s, rad/s      an input; the others are those of the handout
    phi = y + r_y = 0.000414330 m   (eq. 4)   a name, formulas in between, and the number
"""

from __future__ import annotations

import json
import re
from decimal import Decimal
from pathlib import Path
from typing import Any, Iterator

import oracle
import pytest
from oracle import mp, mpf

ROOT = Path(__file__).resolve().parents[3]
README = ROOT / "student/README.md"
HINTS = sorted((ROOT / "student/hints").glob("part*.md"))
MANIFEST = json.loads((ROOT / "grader/parts.json").read_text("utf-8"))["parts"]

SIGNIFICANT_DIGITS = 6
EXACT = mpf("1e-15")  # of max(1, |number|): what reading a decimal number as a double may change
STAGES = ["A nudge", "The formula", "A worked number"]
NUMBER = r"-?\d+(?:\.\d+)?"


def fenced(text: str) -> list[str]:
    return re.findall(r"^```\w*\n(.*?)^```$", text, re.M | re.S)


def sections(text: str, title: str) -> list[str]:
    """The text under each matching heading, up to the next heading."""
    return re.findall(rf"^#+ {title}$\n(.*?)(?=^#+ |\Z)", text, re.M | re.S)


def worked_sections() -> list[tuple[str, str]]:
    readme = [("README", s) for s in sections(README.read_text("utf-8"), "One contact by numbers")]
    hints = [(f.stem, s) for f in HINTS for s in sections(f.read_text("utf-8"), STAGES[2])]
    return readme + hints


WORKED = [(name, block) for name, text in worked_sections() for block in fenced(text)]


def defaults() -> dict[str, Any]:
    """The default parameters, read from the contract."""
    header = (ROOT / "student/include/bounce/types.hpp").read_text("utf-8")
    scalars = re.findall(rf"^  (?:double|int) (\w+) = ({NUMBER});", header, re.M)
    (g,) = re.findall(r"^  Vector3 g\{(.*?)\};", header, re.M)
    numbers = {name: float(number) for name, number in scalars}
    return {**numbers, "g": [float(x) for x in g.split(",")]}


def givens(block: str) -> dict[str, Any]:
    """The inputs that a block names; a vector as a list."""
    found = {}
    for name, value in re.findall(r"^given (\w+) = (\(.*?\)|\S+)", block, re.M):
        numbers = [float(x) for x in re.findall(NUMBER, value)]
        found[name] = numbers if value.startswith("(") else numbers[0]
    return found


def facts(inputs: dict[str, Any]) -> dict[str, Any]:
    """Everything that the equations say of one state, by the names that the texts use."""
    inputs["T"] = int(inputs["T"])
    params = oracle.Parameters.read({k: x for k, x in inputs.items() if k not in "qv"})
    q, v, g = (oracle.vector(inputs[name]) for name in "qvg")
    contact = oracle.get_contacts(q, params)
    J = J_t, J_n = contact.J
    V, p = oracle.form_lcp(J, v, params)
    f_n, f_t = next(oracle.contact_forces(J, v, params))
    # lambda is the speed at which the corner still slides after the step.
    slides = abs(oracle.dot(J_t, oracle.contact_velocity(J, v, params)))
    z = [f_n, max(-f_t, mpf(0)), max(f_t, mpf(0)), slides]
    w = [sum((a * b for a, b in zip(row, z)), p[i]) for i, row in enumerate(V)]
    assert all(x >= -EXACT and y >= -EXACT and abs(x * y) <= EXACT for x, y in zip(z, w)), (z, w)
    columns = oracle.simulate(q, v, params, last=3)
    q_next, v_next = columns[1]

    found = {name: oracle.exact(x) for name, x in inputs.items() if name not in "qvg"}
    found |= zip(("x", "y", "theta", "v_x", "v_y", "omega", "g_x", "g_y"), (*q, *v, *g))
    found |= {"phi": contact.phi, "J_t": J_t, "J_n": J_n, "J": list(zip(J_t, J_n))}
    found |= {"J_hat": list(zip(J_n, (-x for x in J_t), J_t))}
    found |= {"r": (J_n[2], -J_t[2]), "r_x": J_n[2], "r_y": -J_t[2]}
    for name, column in {"t": J_t, "n": J_n}.items():
        found |= {f"J_{name}^T v": oracle.dot(column, v), f"v_{name}": oracle.dot(column, v)}
        found |= {f"J_{name}^T v'": oracle.dot(column, v_next)}
        found |= {f"J_{name}^T M^-1 f_e": oracle.dot(column, g)}
        free = oracle.dot(column, oracle.plus(v, params.dt, g))
        found[f"J_{name}^T (v + dt M^-1 f_e)"] = free
        bounced = free + params.epsilon * oracle.dot(column, v)
        found[f"J_{name}^T ((1 + epsilon) v + dt M^-1 f_e)"] = bounced
        weighed = oracle.product(params.inverse_inertia(), column)
        for other, row in {"t": J_t, "n": J_n}.items():
            found[f"J_{other}^T M^-1 J_{name} dt"] = oracle.dot(weighed, row) * params.dt
    found |= {"V": V, "p": p, "J_hat^T M^-1 J_hat dt": [row[:3] for row in V[:3]], "V z + p": w}
    found |= zip(("f_n", "f_t1", "f_t2", "lambda"), z)
    found |= {"f_e": tuple(x / i for x, i in zip(g, params.inverse_inertia()))}
    found |= {"v + dt M^-1 f_e": oracle.plus(v, params.dt, g), "q'": q_next, "v'": v_next}
    found |= {"phi'": oracle.get_contacts(q_next, params).phi}
    for t, (q_t, v_t) in enumerate(columns):
        found |= {f"q_{t}": q_t, f"v_{t}": v_t}
    # c_1 to c_4, counter-clockwise from the top right one at theta = 0 (eq. 3).
    cos, sin, half = mp.cos(q[2]), mp.sin(q[2]), params.l / 2
    for k, (i, j) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1)), 1):
        found[f"c_{k}"] = (q[0] + half * (cos * i - sin * j), q[1] + half * (sin * i + cos * j))
    return found


def worked_out(formula: str, known: dict[str, Any]) -> Any:
    """The value of a name, or of a formula in numbers and names; p(0) is an entry of p."""
    if formula in known:
        return known[formula]
    python = re.sub(r"\b(?!cos|sin)([\w']+)\(([\d,]+)\)", r"\1[\2]", formula)
    python = re.sub(r"\[(\d),(\d)\]", r"[\1][\2]", python).replace("^", "**")
    names = {name.replace("'", "_next"): x for name, x in known.items()}
    names |= {"cos": mp.cos, "sin": mp.sin, "__builtins__": {}}
    return eval(python.replace("'", "_next"), names)


def statements(block: str) -> Iterator[tuple[list[str], list[str]]]:
    """(the names and formulas, the printed numbers) of each statement."""
    joined = re.sub(r"\n *\|", " |", block)  # the rows of a matrix are one statement
    for line in filter(None, map(str.strip, joined.splitlines())):
        if line.startswith("given "):
            continue
        *formulas, printed = re.sub(r" *\(eqs?\. .*?\)", "", line).split(" = ")
        assert formulas, f"neither an input nor a statement: {line}"
        bracketed = re.match(r"\(.*\)|\|.*\|", printed)
        value = bracketed.group() if bracketed else printed.split()[0]
        yield [" ".join(f.split()) for f in formulas], re.findall(NUMBER, value)


def agrees(printed: str, exact: Any) -> bool:
    error = abs(mpf(printed) - exact)
    if error <= EXACT * max(1, abs(exact)):
        return True
    digits, exponent = Decimal(printed).as_tuple()[1:]
    return len(digits) == SIGNIFICANT_DIGITS and error <= mpf(10) ** int(exponent) / 2


@pytest.mark.parametrize("block", [block for _, block in WORKED])
def test_worked_numbers_follow_from_the_equations(block: str) -> None:
    known = facts(defaults() | givens(WORKED[0][1]) | givens(block))
    checked = 0
    for formulas, printed in statements(block):
        for formula in formulas:
            exact = list(oracle.leaves(worked_out(formula, known)).values())
            wrong = [(a, mp.nstr(b, 12)) for a, b in zip(printed, exact) if not agrees(a, b)]
            assert len(printed) == len(exact), f"{formula} has {len(exact)} numbers"
            assert not wrong, f"{formula}: printed and exact {wrong}"
        checked += len(printed)
    assert checked > 0 or givens(block)


def test_V_and_p_as_printed_are_those_of_eqs_9_and_10() -> None:
    """Of a question where no entry is zero or equal to another by chance."""
    state = {"q": [0.1, 0.5, 0.3], "v": [0.5, -1.8, 1.7], "g": [1.5, -9.0, 0.0], "mu": 0.7}
    known = facts(defaults() | state)
    hint = (ROOT / "student/hints/part2_lcp.md").read_text("utf-8")
    assert "J_n^T M^-1 J_n dt" not in README.read_text("utf-8")  # it is an exercise
    [V] = [b for b in re.findall(r"(?:^    .*\n)+", hint, re.M) if "M^-1 J_n dt" in b]
    [p] = [b for b in fenced(README.read_text("utf-8")) if "\np = | -J_t" in b]
    rows = [re.split(" {2,}", row.strip()) for row in re.findall(r"\|(.*)\|", V + p)]
    known |= {f"-{name}": -x for name, x in known.items() if isinstance(x, type(mpf(0)))}
    for row, expected in zip(rows, [*known["V"], *([x] for x in known["p"])], strict=True):
        values = [known[e] if e in known else mpf(e) for e in row]
        assert all(abs(a - b) < EXACT for a, b in zip(values, expected, strict=True)), row


def test_each_check_and_diagnosis_has_a_staged_hint() -> None:
    tables = (ROOT / "grader/diagnosis/tables.txt").read_text("utf-8")
    ids = re.findall(r"^id +(\w+)$", tables, re.M)
    about = [*re.findall(r"\[(\w+)\] ", tables), "l"]  # traits, and an input
    helped = []
    for part in MANIFEST:
        text = (ROOT / f"student/hints/{part['stem']}.md").read_text("utf-8")
        headings = re.findall(r"^## (\S+) .*\n\nChecks: (.*)$", text, re.M)
        assert len(headings) == len(re.findall(r"^## ", text, re.M))
        assert [n for n, _ in headings] == [f"{part['part']}.{k + 1}" for k in range(len(headings))]
        assert re.findall(r"^### (.*)$", text, re.M) == STAGES * len(headings)
        helped += [(part["part"], id_) for _, line in headings for id_ in line.split(", ")]
        for line in re.findall(r"^(?:Diagnoses|Numbers): (.*)$", text, re.M):
            for name in line.split("; "):
                id_, _, thing = name.rstrip(")").partition("(")
                assert id_ in ids and (not thing or thing in about), name
    assert sorted(helped) == sorted((p["part"], c["id"]) for p in MANIFEST for c in p["checks"])
