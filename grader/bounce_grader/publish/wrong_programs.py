"""Translates the formulas of solution/fixtures/wrong_programs.txt, whose first lines describe them,
into fixtures/public/wrong_programs.txt: the same with numbers in place of names, for ./check
--examples. Each formula is a step, and a program of a part is a list of steps."""

import hashlib
import re

from bounce_grader.grading.examples import SOURCE

RIGHT = "-"
STEPS_OF = {1: (1,), 2: (2,), 3: (1, 2, 3)}  # a step begins with a contact and its LCP
TERM = re.compile(r"([+-]?) ?([\d.]+)? ?((?:[A-Za-z_][\w']* ?)*)")
FORMS = {
    "cos": re.compile(r"cos (\S+)"),
    "sin": re.compile(r"sin (\S+)"),
    "inverse": re.compile(r"1 / (\S+)"),
    "choose": re.compile(r"(\S+) < (\S+) \? (\S+) : (\S+)"),
}

Formulas = dict[str, str]  # by the name of what they give, in order


def table() -> str:
    heads, parts, wrong = _read()
    programs: dict[tuple[int, str], list[tuple[str, str]]] = {}
    for part, needed in STEPS_OF.items():
        before = [item for n in needed[:-1] for item in parts[n].items()]
        programs[part, RIGHT] = [*before, *parts[part].items()]
        for letter, own in wrong.items():
            if letter.startswith(str(part)):
                programs[part, letter] = [*before, *_changed(parts[part], own).items()]
    steps = sorted({step for program in programs.values() for step in program}, key=_shuffled)
    inputs = [head.split()[1] for head in heads if head.startswith("input")]
    names = sorted({*inputs, *(name for name, _ in steps)}, key=_shuffled)
    at = {name: str(index) for index, name in enumerate(names)}
    lines = []
    for kind, *words in map(str.split, heads):
        if kind == "input":
            lines.append(" ".join([kind, at[words[0]], *words]))
        else:
            lines += [f"{kind} {at[name]} {name} 0 -1e300 1e300 {words[0]}" for name in words[1:]]
    lines += [f"step {at[name]} {_numbered(formula, at)}" for name, formula in steps]
    for (part, letter), program in programs.items():
        lines.append(
            " ".join(["program", str(part), letter, *(str(steps.index(s)) for s in program)])
        )
    return "\n".join(lines) + "\n"


def _read() -> tuple[list[str], dict[int, Formulas], dict[str, Formulas]]:
    heads: list[str] = []
    parts: dict[int, Formulas] = {}
    wrong: dict[str, Formulas] = {}
    now: Formulas = {}
    for line in SOURCE.read_text("utf-8").splitlines():
        name, equals, formula = line.partition(" = ")
        words = line.split()
        if not words or line.startswith("#"):
            continue
        if equals:
            now[name.strip()] = formula
        elif words[0] == "part":
            now = parts[int(words[1])] = {}
        elif words[0] == "wrong":
            now = wrong[words[1]] = {}
        else:
            heads.append(line)
    return heads, parts, wrong


def _changed(right: Formulas, own: Formulas) -> Formulas:
    """A wrong program's formulas, in order."""
    new: Formulas = {}
    before: dict[str, Formulas] = {}
    for name, formula in own.items():
        new[name] = formula
        if name in right:
            before[name], new = new, {}
    changed = new
    for name, formula in right.items():
        changed |= before.get(name, {name: formula})
    return changed


def _shuffled(key: object) -> str:
    """An order that tells nothing, the same each time."""
    return hashlib.sha256(str(key).encode()).hexdigest()


def _numbered(formula: str, at: dict[str, str]) -> str:
    for kind, form in FORMS.items():
        if match := form.fullmatch(formula):
            return " ".join([kind, *(at[name] for name in match.groups())])
    terms = []
    for sign, number, factors in filter(any, TERM.findall(formula)):
        indices = [at[name] for name in factors.split()]
        terms += [f"{sign.strip('+')}{number or 1}", str(len(indices)), *indices]
    return " ".join(["sum", *terms])
