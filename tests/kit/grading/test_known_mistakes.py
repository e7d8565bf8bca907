"""Known mistakes: reading the gallery, the content of the files, and the report of a mistake."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import BUILD, FIXTURES
from bounce_grader.grading import fixtures, known_mistakes
from bounce_grader.grading.known_mistakes import (
    GALLERY,
    KNOWN,
    gallery,
    known,
    say_the_same,
    Mistake,
)
from bounce_grader.sandbox import processes
from conftest import ROOT, Grade, solution_files

MISTAKE = """# A title

A sentence.

- Equations: 4, 5
- Hint: 1.2 The moment arm r
- For the instructor: one line
"""
ALL = gallery()


def folder(tmp_path: Path, words: str | None = MISTAKE, name: str = "part1_new") -> Path:
    made = tmp_path / name
    made.mkdir()
    (made / "expected.json").write_text('{"lost": ["part1.X"]}')
    if words is not None:
        (made / "mistake.md").write_text(words)
    return made


def test_a_mistake_is_read_from_its_folder(tmp_path: Path) -> None:
    assert known_mistakes.read(folder(tmp_path)) == Mistake(
        "part1_new",
        "A title",
        "A sentence.",
        (4, 5),
        "1.2 The moment arm r",
        "one line",
        ("part1.X",),
        "part1_new",
    )


@pytest.mark.parametrize(
    "words, says",
    [
        (None, "part1_new lacks mistake.md: write its title"),
        ("# A title\n", "isn't laid out as"),
        (MISTAKE.replace("1.2 The moment arm r", "9.9 Nothing"), "names a hint that isn't"),
        (MISTAKE.replace("4, 5", "4, 99"), "names an equation that"),
        (MISTAKE.replace("- For the instructor: one line\n", ""), "isn't laid out as"),
    ],
)
def test_what_a_folder_lacks_is_said(tmp_path: Path, words: str | None, says: str) -> None:
    with pytest.raises(KitError, match=re.escape(says)):
        known_mistakes.read(folder(tmp_path, words))


def test_a_name_without_its_part_is_refused(tmp_path: Path) -> None:
    with pytest.raises(KitError, match="must begin with its part"):
        known_mistakes.read(folder(tmp_path, name="wrong_sign"))


def fake(name: str, recognised_as: str = "") -> Mistake:
    return Mistake(name, "", "", (1,), "", "", (), recognised_as or name)


@pytest.mark.parametrize(
    "second, answers, says",
    [
        (fake("part1_b"), [[1.0]], "part1_a and part1_b answer the same to every public case"),
        (fake("part1_b", "part1_a"), [[2.0]], "part1_b is recognised_as part1_a, but answers oth"),
        (fake("part1_b", "part1_c"), [[1.0]], "recognised_as part1_c, which isn't by itself"),
    ],
)
def test_twins_have_to_be_written_down(second: Mistake, answers: Any, says: str) -> None:
    got = {"part1_a": [[1.0]], "part1_b": answers}
    with pytest.raises(KitError, match=says):
        known_mistakes._check_twins([fake("part1_a"), second], got)


def test_numbers_say_the_same_but_for_rounding() -> None:
    assert say_the_same({"a": [1.0, None, "x"]}, {"a": [1.0 + 1e-13, None, "x"]})
    assert say_the_same(1e6, 1e6 + 1e-7)
    for other in ({"a": [1.0, None, "y"]}, {"a": [1.0001, None, "x"]}, {"a": [1.0, None]}, {}):
        assert not say_the_same({"a": [1.0, None, "x"]}, other)


def test_files_are_kept_where_only_rounding_differs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    texts = {"part1_contacts.json": '{"right": [[0.25, 1]]}'}
    monkeypatch.setattr(known_mistakes, "texts", lambda: texts)
    file = tmp_path / "part1_contacts.json"
    file.write_text('{"right": [[0.2500000000001, 1]]}')
    known_mistakes.write(tmp_path)
    assert "0.2500000000001" in file.read_text() and known_mistakes.differing(tmp_path) == []
    file.write_text('{"right": [[0.250001, 1]]}')
    (tmp_path / "part5.json").write_text("{}")
    assert known_mistakes.differing(tmp_path) == ["part1_contacts.json", "part5.json"]
    known_mistakes.write(tmp_path)
    assert file.read_text() == texts["part1_contacts.json"]
    assert sorted(f.name for f in tmp_path.iterdir()) == ["part1_contacts.json", "part5.json"]


def test_every_title_and_sentence_is_one_of_its_kind() -> None:
    for m in ALL:
        assert len(m.title) <= 60 and m.title[-1] not in ".:" and m.title[0] != " ", m.name
        assert m.sentence[-1] in ".?" and len(m.sentence) <= 240, m.name
    # The same title twice is for the same mistake in two parts, or for twins.
    by_part = [(m.part, m.title) for m in ALL if m.recognised_as == m.name]
    assert len(by_part) == len(set(by_part))


# The numbers don't tell how the code is written. A cause is said as one, after "Often:".
ABOUT_CODE = re.compile(
    r"\b(loops?|static|global|variables?|typed|written down|hard-coded|appears? nowhere|<<)\b"
)


def test_no_sentence_says_how_the_code_is_written() -> None:
    told = {m.name: f"{m.title}. {m.sentence}".partition("Often:")[0] for m in ALL}
    assert not [name for name, words in told.items() if ABOUT_CODE.search(words)]


# In a pair, what is right of the one may be wrong by the other.
def test_no_sentence_says_what_is_right() -> None:
    right = re.compile(r"\b(is|are) right\b(?! one)")
    assert not [m.name for m in ALL if right.search(m.sentence)]


def test_a_mistakes_hint_belongs_to_its_part() -> None:
    assert not [m.name for m in ALL if not m.hint.startswith(m.name[4])]


def test_what_students_get_holds_no_line_for_the_instructor() -> None:
    told = "".join(file.read_text() for file in KNOWN.glob("*.json"))
    for m in ALL:
        assert m.instructor not in told, m.name
        assert m.sentence in told or m.recognised_as != m.name


def test_the_answers_are_small_and_finite() -> None:
    files = list(KNOWN.glob("*.json"))
    assert {f.stem for f in files} == {part.stem for part in parts()}
    assert sum(file.stat().st_size for file in files) < 800_000
    for file in files:
        json.loads(file.read_text(), parse_constant=lambda word: pytest.fail(word))


def test_every_mistake_is_taken_for_itself_by_its_stored_answers() -> None:
    asked = []
    for part in parts():
        stored = json.loads((KNOWN / f"{part.stem}.json").read_text())
        for entry in stored["mistakes"]:
            asked.append((part, _answers(stored["right"], entry["answers"]), entry["name"]))
        asked.append((part, stored["right"], ""))
    lines = [json.dumps({"part": part.number, "answers": got}) for part, got, _ in asked]
    command = [str(BUILD / "recogniser"), str(FIXTURES / "public")]
    result = processes.run(command, known_mistakes.LIMITS, stdin="\n".join(lines).encode())
    assert result.ok, result.err
    for (_, _, name), line in zip(asked, result.out.splitlines()):
        assert json.loads(line)["mistakes"] == ([name] if name else [])


def _answers(right: list[Any], differences: dict[str, Any]) -> list[Any]:
    answers: list[Any] = [list(answer) for answer in right]
    for question, what in differences.items():
        if isinstance(what, str):
            answers[int(question)] = what
            continue
        for entry, x in what.items():
            answers[int(question)][int(entry)] = x
    return answers


# --- in the record ---


def changed(stem: str, *changes: tuple[str, str]) -> dict[str, bytes | None]:
    text = solution_files()[f"{stem}.cpp"].decode()
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    return {f"{stem}.cpp": text.encode()}


def test_a_mistake_stands_in_its_part_and_in_each_check_that_it_costs(grade: Grade) -> None:
    part = grade(changed("part1_contacts", ("J << J_t, J_n;", "J << J_n, J_t;")))["parts"][0]
    told = known()["part1_columns_swapped"]
    mistake = {key: told[key] for key in ("name", "title", "sentence", "equations", "hint")}
    assert part["mistakes"] == [mistake] and part["patterns"] == []
    assert [c["mistake"] for c in part["checks"]] == [None, *[mistake] * 5]


def test_two_mistakes_are_told_apart_by_their_checks(grade: Grade) -> None:
    wrong = changed(
        "part2_lcp",
        ("v_free + params.epsilon * v", "v_free - v + params.epsilon * v"),
        ("<< params.mu, -1", "<< 2 * params.mu, -1"),
    )
    part = grade(wrong)["parts"][1]
    names = ["part2_epsilon_without_one", "part2_friction_bound_doubled"]
    assert [m["name"] for m in part["mistakes"]] == names
    costs = {c["id"]: c["mistake"]["name"] for c in part["checks"] if not c["passed"]}
    assert costs["part2.GivesTheNormalRowOfP"] == names[0]
    assert costs["part2.BordersItWithTheFrictionCone"] == names[1]


def test_an_unknown_mistake_is_described_by_its_numbers(grade: Grade) -> None:
    part = grade(changed("part1_contacts", ("q(1) + r.y()}", "0.7 * (q(1) + r.y())}")))["parts"][0]
    assert part["mistakes"] == []
    assert part["patterns"] == [
        "Right in every public question: J_t and J_n; wrong: phi.",
        "Every wrong number is 0.7 times the right one.",
    ]


def test_a_number_written_down_is_told_by_what_makes_no_difference(grade: Grade) -> None:
    part = grade(changed("part1_contacts", ("(params.l / 2)", "(0.4 / 2)")))["parts"][0]
    words = "Where only l is changed, J_t, J_n and phi stay the same in your answers"
    assert part["mistakes"] == [] and any(words in text for text in part["patterns"])


def test_what_is_wrong_in_a_hidden_case_alone_is_neither_named_nor_described(grade: Grade) -> None:
    hidden = json.loads((fixtures.hidden_folder() / "part1_contacts.json").read_text())
    theta = hidden["checks"]["part1.TurnsHoweverFar"][0]["input"]["q"][2]
    there = f"J << J_t, J_n;\n  if (q(2) == {theta}) J.setZero();"
    part = grade(changed("part1_contacts", ("J << J_t, J_n;", there)))["parts"][0]
    assert "a hidden case" in part["checks"][4]["message"]
    assert part["patterns"] == [] and part["mistakes"] == []


def test_part_3_is_recognised_whatever_parts_1_and_2_do(grade: Grade) -> None:
    wrong = changed(
        "part3_step", ("q_p.y() = params.delta;", "q_p.y() = params.dt * params.delta;")
    )
    wrong |= changed("part1_contacts", ("q(1) + r.y()}", "r.y()}"))
    record = grade(wrong)
    named = [[m["name"] for m in part["mistakes"]] for part in record["parts"]]
    assert named == [["part1_phi_without_the_centre"], [], ["part3_lift_times_dt"], []]


def test_a_part_that_ends_is_given_no_mistake(grade: Grade) -> None:
    crash = "J << J_n, J_t;\n  if (params.l > 10) __builtin_trap();"
    part = grade(changed("part1_contacts", ("J << J_t, J_n;", crash)))["parts"][0]
    assert part["status"] == "crashed"
    assert part["mistakes"] == [] and part["patterns"] == []


def test_the_readme_of_the_gallery_names_every_field() -> None:
    words = (ROOT / "tests" / "submissions" / "README.md").read_text()
    fields = {field for f in GALLERY.rglob("expected.json") for field in json.loads(f.read_text())}
    assert all(f"`{field}`" in words for field in fields)
