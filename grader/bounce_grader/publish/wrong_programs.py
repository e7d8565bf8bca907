"""Translates the formulas of solution/fixtures/wrong_programs.txt, whose first lines describe them,
into fixtures/public/wrong_programs.txt: the same with numbers in place of names, for ./check
--examples. Each formula is a step, and a program of a part is a list of steps."""

import hashlib
import re
from configparser import ConfigParser

from bounce_grader.grading.examples import SOURCE
from bounce_grader.publish.handout_page import filled_in

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
    source = ConfigParser(delimiters="=", interpolation=None)
    source.optionxform = str  # type: ignore[assignment]  # which keeps capitals
    source.read_string(filled_in(SOURCE.read_text("utf-8")))
    programs: dict[tuple[int, str], list[tuple[str, str]]] = {}
    for part, needed in STEPS_OF.items():
        before = [item for n in needed[:-1] for item in source[f"part {n}"].items()]
        right = dict(source[f"part {part}"])
        programs[part, RIGHT] = [*before, *right.items()]
        for title in source.sections():
            if title.startswith(f"wrong {part}"):
                own = _changed(right, dict(source[title]))
                programs[part, title.split()[1]] = [*before, *own.items()]
    steps = sorted({step for program in programs.values() for step in program}, key=_shuffled)
    names = sorted({*source["inputs"], *(name for name, _ in steps)}, key=_shuffled)
    at = {name: str(index) for index, name in enumerate(names)}
    lines = []
    for name, words in source["inputs"].items():
        lines.append(" ".join(["input", at[name], name, *words.split()]))
    for part_number, words in source["outputs"].items():
        for name in words.split():
            lines.append(f"output {at[name]} {name} 0 -1e300 1e300 {part_number}")
    lines += [f"step {at[name]} {_numbered(formula, at)}" for name, formula in steps]
    for (part, letter), program in programs.items():
        numbers = (str(steps.index(step)) for step in program)
        lines.append(" ".join(["program", str(part), letter, *numbers]))
    return "\n".join(lines) + "\n"


def _changed(right: Formulas, own: Formulas) -> Formulas:
    """A buggy program's formulas, in order."""
    changed: Formulas = {}
    before: dict[str, Formulas] = {}
    for name, formula in own.items():
        changed[name] = formula
        if name in right:
            before[name], changed = changed, {}
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
