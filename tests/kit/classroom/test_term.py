"""A term, week by week: first hand-ins, late ones, corrections by hand, a copy, a group, new
weights, appeals, and in the end the answers. At each stage the grade book is the right one, worked
out here without the class."""

import csv
import io
import json
import zipfile
from pathlib import Path

import stand_in
from bounce_grader.common.manifest import parts
from bounce_grader.submission import submission
from classes import COLUMN, grade_class
from conftest import write

OUT = "out"
PEOPLE = {
    "501": "Łukasz, Zoë",
    "502": "O'Neil, D'Arcy",
    "503": "Doe, Jane",
    "504": "Prince",
    "505": "de la Cruz y García, José María",
    "506": "Roe, Max",
    "507": "Absent, Ann",
}
GROUP = {"505": "team7", "506": "team7"}  # one hands in for both


def canvas_name(user: str) -> str:
    name = GROUP.get(user, PEOPLE[user])
    return "".join(c for c in name.lower() if c.isalnum())


class Term:
    def __init__(self, folder: Path) -> None:
        self.folder, self.out = folder, folder / OUT
        self.entries: dict[str, bytes] = {}
        self.texts: dict[str, dict[str, bytes]] = {}
        self.cells = dict.fromkeys(PEOPLE, "")

    def hand_in(self, user: str, text: bytes, number: int, late: bool = False) -> None:
        mark = "LATE_" if late else ""
        again = f"-{number}" if number else ""
        name = f"{canvas_name(user)}_{mark}{user}_{user}{number}_part2_lcp{again}.cpp"
        self.entries = {n: t for n, t in self.entries.items() if f"_{user}_" not in n}
        self.entries[name] = text
        self.texts[user] = {"part2_lcp.cpp": text}

    def score(self, user: str) -> float:
        folder = write(self.folder / "alone" / user, self.texts[user])
        return float(stand_in.record_of(submission.read(folder))["score"])

    def run(self, **more: object) -> dict[str, str]:
        """Canvas's export has what was imported last; its import is what a run has filled in."""
        export = io.StringIO()
        writer = csv.writer(export)
        writer.writerow(["Student", "ID", "SIS Login ID", "Section", COLUMN])
        writer.writerow(["    Points Possible", "", "", "", "100"])
        for id, name in PEOPLE.items():
            writer.writerow([name, id, f"l{id}", "S", self.cells[id]])
        (self.folder / "export.csv").write_text(export.getvalue())
        source = self.folder / "submissions.zip"
        with zipfile.ZipFile(source, "w") as archive:
            for name, text in self.entries.items():
                archive.writestr(name, text)
        book = {"gradebook": self.folder / "export.csv", "columns": {0: COLUMN}}
        assert grade_class(source, self.out, **{**book, **more}) == 0
        filled = csv.reader(io.StringIO((self.out / "gradebook.csv").read_text()))
        self.cells = {row[1]: row[4] for row in filled if row[1] in PEOPLE}
        return self.cells

    def own(self, name: str, text: str) -> None:
        write(self.out, {name: text.encode()})

    def page(self, user: str) -> str:
        (page,) = (self.out / "feedback").glob(f"*_{user}_*.html")
        return page.read_text()


def grades(**points: float | str) -> dict[str, str]:
    given = {id.removeprefix("u"): value for id, value in points.items()}
    return {id: v if isinstance(v, str) else f"{v:.2f}" for id, v in given.items()}


def test_a_term(tmp_path: Path) -> None:
    term = Term(tmp_path)
    hand_ins = {"501": b"// one", "502": b"// two", "503": b"// three", "505": b"// five"}
    for user, text in hand_ins.items():
        term.hand_in(user, text, 0)
    term.own("roster.csv", "submission,id\nteam7,505\nteam7,506\n")

    # The first week: everybody who has handed in, and both members of the group.
    score = {user: term.score(user) for user in hand_ins}
    week1 = grades(
        u501=score["501"],
        u502=score["502"],
        u503=score["503"],
        u504="",
        u505=score["505"],
        u506=score["505"],
        u507="",
    )
    assert term.run() == week1
    assert not (term.out / "feedback-new.zip").exists()

    # One corrects a cell in Canvas; one is late; one hands in again.
    term.cells["502"] = "77"
    term.own("course.toml", "[late]\npercent_per_day = 10\n")
    term.hand_in("504", b"// four", 0, late=True)
    term.hand_in("501", b"// one, better", 1)
    late = max(0.0, term.score("504") - 10)
    week2 = {**week1, **grades(u501=term.score("501"), u502="77", u504=late)}
    assert term.run() == week2
    assert "Since last time: " in term.page("501") and "Since last time" not in term.page("503")
    assert "1 day late, 10 %" in term.page("504")
    with zipfile.ZipFile(term.out / "feedback-new.zip") as archive:
        assert sorted(name.partition("_")[0] for name in archive.namelist()) == [
            "prince",
            "łukaszzoë",
        ]

    # A copy is found by hand, and a member of the group did less.
    header = "student,points,percent,late_days,cap,drop,reason,comment\n"
    rows = ["503,,,,0,,a copy,See me.", '"Roe, Max",-5,,,,,did less,', "504,,,0,,,ill,"]
    term.own("adjustments.csv", header + "\n".join(rows) + "\n")
    adjusted = grades(u503=0.0, u504=term.score("504"), u506=max(0.0, score["505"] - 5))
    assert term.run() == {**week2, **adjusted}
    assert "a copy. See me." in term.page("503") and "Roe, Max" in term.page("505")

    # Two appeals: a check is dropped for all, and one gets a point.
    check = parts()[0].checks[0]
    rows += [f"*,,,,,{check.id},two readings,", "501,1,,,,,appeal,"]
    term.own("adjustments.csv", header + "\n".join(rows) + "\n")

    def lost(user: str) -> float:
        folder = write(term.folder / "alone" / user, term.texts[user])
        record = stand_in.record_of(submission.read(folder))
        return float(check.points - record["parts"][0]["checks"][0]["score"])

    final = {
        **week2,
        **grades(
            u501=term.score("501") + lost("501") + 1,
            u503=0.0,
            u504=term.score("504") + lost("504"),
            u505=score["505"] + lost("505"),
            u506=max(0.0, score["505"] + lost("505") - 5),
        ),
    }
    assert term.run() == final

    # New weights: shown first, then applied; then the answers. The points stay those of the rules.
    halve(term.out, check.id)
    before = dict(term.cells)
    term.run(regrade="all")
    assert term.cells == before
    assert term.run(apply=True) == final
    assert term.run(reveal=True) == final
    assert "expected phi = 0.8128" in term.page("501")
    assert len(list((term.out / "results").glob("*.json"))) > len(PEOPLE) - 2


def halve(out: Path, check: str) -> None:
    """Makes the stored results those of other weights, as before an update of the kit."""
    for file in (out / "results").glob("*.json"):
        result = json.loads(file.read_bytes())
        for part in (result.get("record") or {}).get("parts", []):
            for one in part["checks"]:
                if one["id"] == check and one["passed"]:
                    result["record"]["score"] -= one["score"] / 2
                    part["score"] -= one["score"] / 2
                    one["score"] /= 2
        file.write_text(json.dumps(result))
