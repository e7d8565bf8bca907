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


def worked_blocks() -> list[Any]:
    blocks = [(name, block) for name, text in worked_sections() for block in fenced(text)]
    return [pytest.param(block, id=f"{name}-{i}") for i, (name, block) in enumerate(blocks)]


def defaults() -> dict[str, Any]:
    """The default parameters, read from the contract."""
    header = (ROOT / "student/include/bounce/types.hpp").read_text("utf-8")
    scalars = re.findall(rf"^  (?:double|int) (\w+) = ({NUMBER});", header, re.M)
    (g,) = re.findall(r"^  Vector3 g\{(.*?)\};", header, re.M)
    numbers = {name: float(number) for name, number in scalars}
    return {**numbers, "T": int(numbers["T"]), "g": [float(x) for x in g.split(",")]}


def givens(block: str) -> dict[str, Any]:
    """The inputs that a block names; a vector as a list."""
    found = {}
    for name, value in re.findall(r"^given (\w+) = (\(.*?\)|\S+)", block, re.M):
        numbers = [float(x) for x in re.findall(NUMBER, value)]
        found[name] = numbers if value.startswith("(") else numbers[0]
    return found


def scene(block: str) -> dict[str, Any]:
    (handout,) = sections(README.read_text("utf-8"), "One contact by numbers")
    inputs = {**defaults(), **givens(fenced(handout)[0]), **givens(block)}
    return {**inputs, "T": int(inputs["T"])}


def corners(q: oracle.Vector, l: Any) -> dict[str, Any]:
    """c_1 to c_4, counter-clockwise from the top right one at theta = 0 (eq. 3)."""
    cos, sin, signs = mp.cos(q[2]), mp.sin(q[2]), ((1, 1), (-1, 1), (-1, -1), (1, -1))
    arms = [(l / 2 * i, l / 2 * j) for i, j in signs]
    turned = [(cos * x - sin * y, sin * x + cos * y) for x, y in arms]
    return {f"c_{k}": (q[0] + x, q[1] + y) for k, (x, y) in enumerate(turned, 1)}


def input_facts(inputs: dict[str, Any]) -> dict[str, Any]:
    q, v, g = (oracle.vector(inputs[name]) for name in "qvg")
    found = {name: oracle.exact(x) for name, x in inputs.items() if name not in "qvg"}
    found |= {"q": q, "x": q[0], "y": q[1], "theta": q[2]}
    found |= {"v": v, "v_x": v[0], "v_y": v[1], "omega": v[2]}
    return found | {"g": g, "g_x": g[0], "g_y": g[1]}


def contact_facts(q: oracle.Vector, v: oracle.Vector, params: oracle.Parameters) -> dict[str, Any]:
    contact = oracle.get_contacts(q, params)
    J_t, J_n = contact.J
    found = {"phi": contact.phi, "J_t": J_t, "J_n": J_n, "J": list(zip(J_t, J_n))}
    found |= {"J_hat": list(zip(J_n, (-x for x in J_t), J_t))}
    found |= {"r": (J_n[2], -J_t[2]), "r_x": J_n[2], "r_y": -J_t[2]}
    for name, column in {"t": J_t, "n": J_n}.items():
        found |= {f"J_{name}^T v": oracle.dot(column, v), f"v_{name}": oracle.dot(column, v)}
        found |= {f"J_{name}^T M^-1 f_e": oracle.dot(column, params.g)}
    return found | corners(q, params.l)


def lcp_facts(q: oracle.Vector, v: oracle.Vector, params: oracle.Parameters) -> dict[str, Any]:
    J = oracle.get_contacts(q, params).J
    V, p = oracle.form_lcp(J, v, params)
    f_n, f_t = next(oracle.contact_forces(J, v, params))
    # lambda is the speed at which the corner still slides after the step.
    slides = abs(oracle.dot(J[0], oracle.contact_velocity(J, v, params)))
    z = [f_n, max(-f_t, mpf(0)), max(f_t, mpf(0)), slides]
    w = [sum((a * b for a, b in zip(row, z)), p[i]) for i, row in enumerate(V)]
    assert all(x >= -EXACT and y >= -EXACT and abs(x * y) <= EXACT for x, y in zip(z, w)), (z, w)
    found = {"V": V, "p": p, "z": z, "V z + p": w, "f_n": z[0], "f_t1": z[1], "f_t2": z[2]}
    found |= {"lambda": slides, "v + dt M^-1 f_e": oracle.plus(v, params.dt, params.g)}
    found |= {"f_e": tuple(g / w for g, w in zip(params.g, params.inverse_inertia()))}
    return found | {"J_hat^T M^-1 J_hat dt": [row[:3] for row in V[:3]]}


def step_facts(q: oracle.Vector, v: oracle.Vector, params: oracle.Parameters) -> dict[str, Any]:
    J_t, J_n = oracle.get_contacts(q, params).J
    columns = oracle.simulate(q, v, params, last=3)
    found = {f"q_{t}": q_t for t, (q_t, _) in enumerate(columns)}
    found |= {f"v_{t}": v_t for t, (_, v_t) in enumerate(columns)}
    q_next, v_next = columns[1]
    found |= {"q'": q_next, "v'": v_next, "phi'": oracle.get_contacts(q_next, params).phi}
    return found | {"J_t^T v'": oracle.dot(J_t, v_next), "J_n^T v'": oracle.dot(J_n, v_next)}


def facts(inputs: dict[str, Any]) -> dict[str, Any]:
    """Everything that the equations say of one state, by the names that the texts use."""
    params = oracle.Parameters.read({k: x for k, x in inputs.items() if k not in "qv"})
    state = oracle.vector(inputs["q"]), oracle.vector(inputs["v"]), params
    return input_facts(inputs) | contact_facts(*state) | lcp_facts(*state) | step_facts(*state)


def entry(matrix: Any, at: tuple[int, ...]) -> Any:
    return entry(matrix[at[0]], at[1:]) if at else matrix


def python(formula: str) -> str:
    return formula.replace("^", "**").replace("'", "_next")


def worked_out(formula: str, known: dict[str, Any]) -> Any:
    """The value of a name, or of a formula in numbers and names; p(0) is an entry of p."""
    if formula in known:
        return known[formula]
    names = {"cos": mp.cos, "sin": mp.sin, "pi": mp.pi}
    for name, x in known.items():
        names[python(name)] = (lambda *at, x=x: entry(x, at)) if isinstance(x, (list, tuple)) else x
    return eval(python(formula), {"__builtins__": {}}, names)


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


@pytest.mark.parametrize("block", worked_blocks())
def test_worked_numbers_follow_from_the_equations(block: str) -> None:
    known = facts(scene(block))
    checked = 0
    for formulas, printed in statements(block):
        for formula in formulas:
            exact = list(oracle.leaves(worked_out(formula, known)).values())
            wrong = [(a, mp.nstr(b, 12)) for a, b in zip(printed, exact) if not agrees(a, b)]
            assert len(printed) == len(exact), f"{formula} has {len(exact)} numbers"
            assert not wrong, f"{formula}: printed and exact {wrong}"
        checked += len(printed)
    assert checked > 0 or givens(block)


def test_prose_beside_worked_numbers_repeats_them() -> None:
    known = set(re.findall(NUMBER, json.dumps(defaults())))
    for name, text in worked_sections():
        blocks = fenced(text)
        assert blocks, f"{name} has a worked section without a number"
        printed = known | {x.lstrip("-") for x in re.findall(NUMBER, " ".join(blocks))}
        prose = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
        new = set(re.findall(r"\d+\.\d+", prose)) - printed
        assert not new, f"{name}: nothing checks {sorted(new)}"


def mentions(text: str) -> Iterator[int]:
    for listed in re.findall(r"\beqs?\.[ \n/*#]*(\(?\d+\)?(?:(?:,| and| to|-) ?\(?\d+\)?)*)", text):
        yield from map(int, re.findall(r"\d+", listed))


@pytest.mark.parametrize("pages", ["student/**/*", "solution/src/*", "docs/notation.md"])
def test_equations_that_are_mentioned_exist(pages: str) -> None:
    files = [f for f in ROOT.glob(pages) if f.suffix in {".md", ".hpp", ".cpp"}]
    found = [(f, n) for f in files for n in mentions(f.read_text("utf-8"))]
    assert found, "no equation is mentioned"
    assert not [(str(f), n) for f, n in found if not 1 <= n <= 15]


def block_of(blocks: list[str], start: str) -> list[str]:
    """The rows of the one matrix whose block starts so, without their bars."""
    (block,) = [b for b in blocks if re.search(start, b)]
    rows = [row.strip() for row in re.findall(r"\|(.*)\|", block)]
    assert len(rows) == 4
    return rows


def test_V_and_p_as_printed_are_those_of_eqs_9_and_10() -> None:
    """Of a question where no entry is zero or equal to another by chance."""
    params = oracle.Parameters.read({**defaults(), "g": [1.5, -9.0, 0.0], "mu": 0.7})
    J_t, J_n = oracle.vector([0.9, -0.4, 0.3]), oracle.vector([0.2, 1.1, -0.6])
    v = oracle.vector([0.5, -0.8, 1.7])
    known = {"mu": params.mu}
    for a, column in {"t": J_t, "n": J_n}.items():
        weighed = oracle.product(params.inverse_inertia(), column)
        for b, other in {"t": J_t, "n": J_n}.items():
            known[f"J_{b}^T M^-1 J_{a} dt"] = oracle.dot(weighed, other) * params.dt
        free = oracle.dot(column, oracle.plus(v, params.dt, params.g))
        known[f"J_{a}^T (v + dt M^-1 f_e)"] = free
        bounced = free + params.epsilon * oracle.dot(column, v)
        known[f"J_{a}^T ((1 + epsilon) v + dt M^-1 f_e)"] = bounced
    known |= {f"-{name}": -value for name, value in known.items()}

    V, p = oracle.form_lcp((J_t, J_n), v, params)
    hint = (ROOT / "student/hints/part2_lcp.md").read_text("utf-8")
    assert "J_n^T M^-1 J_n dt" not in README.read_text("utf-8")  # it is an exercise
    printed_V = block_of(re.findall(r"(?:^    .*\n)+", hint, re.M), r"M\^-1 J_n dt")
    printed_p = block_of(fenced(README.read_text("utf-8")), r"\np = \| -J_t")
    for row, expected in zip(printed_V + printed_p, [*V, *([x] for x in p)]):
        values = [known[e] if e in known else mpf(e) for e in re.split(" {2,}", row)]
        assert all(abs(a - b) < EXACT for a, b in zip(values, expected, strict=True)), row


def test_parameter_table_has_the_defaults_of_the_contract() -> None:
    rows = re.findall(r"^\| `(\w+)` \|.*\| ([^|]+) \|[^|]*\|$", README.read_text("utf-8"), re.M)
    table = {name: [float(x) for x in re.findall(NUMBER, value)] for name, value in rows}
    expected = {k: x if isinstance(x, list) else [x] for k, x in defaults().items()}
    assert {name: table.get(name) for name in expected} == expected


def test_parts_are_those_of_the_manifest() -> None:
    row = r"^\| (\d) \| `(\w+)` .*`src/(\w+)\.cpp` \| \d+ \|$"
    manifest = [(str(p["part"]), p["function"], p["stem"]) for p in MANIFEST]
    assert re.findall(row, README.read_text("utf-8"), re.M) == manifest


def test_each_check_and_diagnosis_has_a_staged_hint() -> None:
    sources = "\n".join(f.read_text("utf-8") for f in (ROOT / "tests/parts").glob("*.cpp"))
    helped = []
    for part in MANIFEST:
        text = (ROOT / f"student/hints/{part['stem']}.md").read_text("utf-8")
        headings = re.findall(r"^## (\S+) .*\n\nChecks: (.*)$", text, re.M)
        assert len(headings) == len(re.findall(r"^## ", text, re.M))
        assert [n for n, _ in headings] == [f"{part['part']}.{k + 1}" for k in range(len(headings))]
        assert re.findall(r"^### (.*)$", text, re.M) == STAGES * len(headings)
        helped += [(part["part"], id_) for _, line in headings for id_ in line.split(", ")]
        for line in re.findall(r"^Diagnoses: (.*)$", text, re.M):  # a number or input is filled in
            pieces = re.split(r"; |\d|\bl\b", line)
            assert all(piece.strip() in sources for piece in pieces), line
    assert sorted(helped) == sorted((p["part"], c["id"]) for p in MANIFEST for c in p["checks"])


def test_links_of_the_handout_stay_inside_it() -> None:
    for page in [README, *HINTS]:
        for target in re.findall(r"\]\((?!https?:)([^)#]+)", page.read_text("utf-8")):
            path = (page.parent / target).resolve()
            assert path.exists() and path.is_relative_to(ROOT / "student"), f"{page.name}: {target}"
