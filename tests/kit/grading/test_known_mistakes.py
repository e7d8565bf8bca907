"""Known mistakes: what students are told of them, and that each is taken for itself."""

import json
import re
from typing import Any

import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import BUILD, FIXTURES
from bounce_grader.grading import known_mistakes
from bounce_grader.grading.known_mistakes import gallery, KNOWN, Mistake, say_the_same
from bounce_grader.sandbox import processes

ALL = gallery()
# The numbers don't tell how the code is written: a cause is said as one, after "Often:". And in a
# pair, what is right of the one may be wrong by the other.
ABOUT_CODE = re.compile(
    r"\b(loops?|static|global|variables?|typed|written down|hard-coded|appears? nowhere|<<)\b"
)
SAYS_RIGHT = re.compile(r"\b(is|are) right\b(?! one)")


@pytest.mark.parametrize("m", ALL, ids=lambda m: m.name)
def test_a_mistakes_words_are_true_short_and_no_instructors(m: Mistake) -> None:
    assert len(m.title) <= 60 and m.title[-1] not in ".:" and m.title[0] != " "
    assert m.sentence[-1] in ".?" and len(m.sentence) <= 240
    assert not ABOUT_CODE.search(f"{m.title}. {m.sentence}".partition("Often:")[0])
    assert not SAYS_RIGHT.search(m.sentence)
    assert m.hint.startswith(m.name[4])  # its part's
    told = (KNOWN / f"{m.part.stem}.json").read_text()
    assert m.instructor not in told
    assert m.recognised_as != m.name or m.sentence in told


@pytest.mark.parametrize(
    "recognised_as, answer, says",
    [
        ("part1_b", 1.0, "part1_a and part1_b answer the same to every public case"),
        ("part1_a", 2.0, "part1_b is recognised_as part1_a, but answers otherwise"),
        ("part1_c", 1.0, "recognised_as part1_c, which isn't by itself"),
    ],
)
def test_twins_have_to_be_written_down(recognised_as: str, answer: float, says: str) -> None:
    one = ALL[0]._replace(name="part1_a", recognised_as="part1_a")
    two = ALL[0]._replace(name="part1_b", recognised_as=recognised_as)
    with pytest.raises(KitError, match=says):
        known_mistakes._check_twins([one, two], {"part1_a": [[1.0]], "part1_b": [[answer]]})


def test_numbers_say_the_same_but_for_rounding() -> None:
    assert say_the_same({"a": [1.0, None, "x"]}, {"a": [1.0 + 1e-13, None, "x"]})
    assert say_the_same(1e6, 1e6 + 1e-7)
    for other in ({"a": [1.0, None, "y"]}, {"a": [1.0001, None, "x"]}, {"a": [1.0, None]}, {}):
        assert not say_the_same({"a": [1.0, None, "x"]}, other)


def test_every_mistake_is_taken_for_itself_by_its_stored_answers() -> None:
    asked: list[dict[str, Any]] = []
    names: list[str] = []
    for part in parts():
        text = (KNOWN / f"{part.stem}.json").read_text()
        stored = json.loads(text, parse_constant=lambda word: pytest.fail(word))
        for entry in [{"name": "", "answers": {}}, *stored["mistakes"]]:
            got: list[Any] = [list(answer) for answer in stored["right"]]
            for question, what in entry["answers"].items():
                if isinstance(what, str):
                    got[int(question)] = what  # of an exception
                    continue
                for place, x in what.items():
                    got[int(question)][int(place)] = x
            asked.append({"part": part.number, "answers": got})
            names.append(entry["name"])
    command = [str(BUILD / "recogniser"), str(FIXTURES / "public")]
    lines = "\n".join(map(json.dumps, asked)).encode()
    result = processes.run(command, known_mistakes.LIMITS, stdin=lines)
    assert result.ok, result.err
    found = [json.loads(line)["mistakes"] for line in result.out.splitlines()]
    assert found == [[name] if name else [] for name in names]
