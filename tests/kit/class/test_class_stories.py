"""Stories of a class: NAME.toml has what is handed in and the commands that are given week by week,
NAME.txt beside it what has to come out.

A story has rounds. Each prepares files (`write`, `pack` archives, a command for the `shell`,
`edit`), changes what is on Canvas (`canvas`, `token`, `largest` download), and gives the words
after ./kit class: its own `command`, or the story's and `more`. With `apart`, each round
begins anew, with the files of the story. `show` names what is written down of a round, if it has
changed since the last one. Gradings are a stand-in's: the text of a part, as "fails: 2", says its
points; another `kit` grades `later`, or has other `points` for checks."""

import csv
import html
import io
import re
import shlex
import subprocess
import zipfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import golden
import pytest
import stand_in
from bounce_grader import cli
from bounce_grader.classroom.grading import grading, near_copies, results
from bounce_grader.classroom.intake import canvas_api
from canvas_server import running, State, TOKEN
from conftest import Patch, Printed, write
from corpus import Member, UTF8, zip_of
from handed_in import packed_tar

STORIES = Path(__file__).parent / "stories"
COLUMNS = "id student late state score final adjustments".split() + ["needs a look", "not used"]
SHOWN = ("gradebook.csv", "gradebook.xls", "grades.csv", "pages.txt")
Outputs = dict[str, str]


def packed(name: str, entries: dict[str, Any]) -> bytes:
    """A zip, or a tar by its name; an entry with entries of its own is an archive, too."""
    files = {n: packed(n, e) if isinstance(e, dict) else e.encode() for n, e in entries.items()}
    if ".t" in name:
        return packed_tar(files, "xz" if name.endswith("xz") else "gz")
    return zip_of(Member(n.encode(), text, method=0, flags=UTF8) for n, text in files.items())


def encoding_of(name: str) -> str:
    """Blackboard writes its .xls in UTF-16."""
    known = {".xls": "utf-16", "utf-16": "utf-16", "latin-1": "latin-1", "windows": "cp1252"}
    return next((known[part] for part in known if part in name), "utf-8")


def decoded(path: Path) -> str:
    return path.read_bytes().decode(encoding_of(path.name), "backslashreplace")


def prepare(folder: Path, round: dict[str, Any]) -> None:
    for name, text in round.get("write", {}).items():
        write(folder, {name: text.removeprefix("\n").encode(encoding_of(name))})
    for name, entries in round.get("pack", {}).items():
        write(folder, {name: packed(name, entries)})
    subprocess.run(["sh", "-ec", round.get("shell", "")], cwd=folder, check=True)
    for name, changes in round.get("edit", {}).items():
        text = decoded(folder / name)
        for old, new in changes:
            assert old in text, f"{old!r} isn't in {name}"
            text = text.replace(old, new)
        write(folder, {name: text.encode(encoding_of(name))})


def set_stage(kit: dict[str, Any], patch: Patch) -> None:
    """Gradings by the stand-in in this process, perhaps of another version of the kit."""
    version = kit.get("version", repr(kit))
    grade = partial(stand_in.grade, **{name: kit[name] for name in kit.keys() - {"version"}})

    def run(tasks: Any, jobs: int, _: Any = None) -> Iterator[Any]:
        yield from ((task, results.grade_one(task, grade)) for task in tasks)

    patch.setattr(grading, "in_processes", run)
    patch.setattr(results, "__version__", version)
    patch.setattr(results, "depends_on", lambda: ([], []))
    patch.setattr(near_copies, "find", lambda *_: near_copies.Similar((), 0))


def text_of(page: str) -> str:
    """The words of a piece of HTML, a line for each block."""
    page = re.sub(r"\s*\n\s*", " ", page)
    page = re.sub(r"</(p|h\d|li|tr|summary|div)>", "\n", page)
    page = re.sub(r"</t[dh]>", " | ", page)
    lines = html.unescape(re.sub(r"<[^>]*>", "", page)).splitlines()
    return "".join(f"{line.strip(' |')}\n" for line in lines if line.strip(" |"))


def between(page: str, start: str, end: str) -> str:
    return page.partition(start)[2].partition(end)[0]


def class_page(page: str) -> str:
    """The figures, who needs a look, and how many curves there are."""
    figures, looks, *_ = page.partition("<body>")[2].split("<section>")
    curves = page.count('<path class="curve ')
    return text_of(figures) + text_of(looks) + f"Curves: {curves}\n"


def feedback_page(page: str) -> str:
    """A page without what is said of each part."""
    head = between(page, "<body>", '<div class="bar">')
    head += between(page, "<h2>Comments", "<h2><span>")
    unused = between(page, "Not used:", "</ul>")
    answers = "The expected answers are shown.\n" if "0.8128" in page else ""
    return text_of(head) + answers + (f"Not used:\n{text_of(unused)}" if unused else "")


def pages(out: Path) -> Outputs:
    """By name; and which pages are in the zips."""
    files = {file.relative_to(out / "feedback"): file for file in out.glob("feedback/**/*.html")}
    found = {f"page {name}": feedback_page(decoded(file)) for name, file in files.items()}
    for path in out.glob("feedback-*.zip"):
        with zipfile.ZipFile(path) as archive:
            found[f"page {path.name}"] = "".join(f"{n}\n" for n in sorted(archive.namelist()))
            assert {page.date_time[0] for page in archive.infolist()} <= {1980}
    return found


def changed(now: Outputs, last: Outputs) -> Outputs:
    """The changed outputs, and all changed pages in one."""
    new = {name: text for name, text in now.items() if last.get(name) != text}
    of_pages = {name[5:]: new.pop(name) for name in sorted(new) if name.startswith("page ")}
    texts = [f"{n}\n{re.sub('^(?=.)', '  ', text, flags=re.M)}" for n, text in of_pages.items()]
    gone = [f"{name[5:]} is gone\n" for name in sorted(last.keys() - now.keys())]
    return new | ({"pages.txt": "".join(texts + gone)} if texts or gone else {})


def grades(table: str) -> str:
    """The columns that are told of here."""
    rows = csv.DictReader(io.StringIO(table.removeprefix("\ufeff"), newline=""))
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerows([COLUMNS, *([row[column] for column in COLUMNS] for row in rows)])
    return text.getvalue()


def outputs(out: Path) -> Outputs:
    if not (out / "class.html").exists():
        return {}
    assert "0.8128" not in decoded(out / "class.html") + decoded(out / "grades.csv")
    return {
        **{book.name: decoded(book) for book in out.glob("gradebook.*")},
        "grades.csv": grades(decoded(out / "grades.csv")),
        "class.txt": class_page(decoded(out / "class.html")),
        **pages(out),
    }


def plain(text: str, folder: Path) -> str:
    """What is printed, without what differs each time."""
    text = re.sub(r"kit: .* left\n", "", text)
    text = re.sub(r"\d+ a minute", "N a minute", text.replace(f"{folder}/", ""))
    return re.sub(r"http://127.0.0.1:\d\d+", "http://canvas", text)


def give(command: str, here: Path, round: dict[str, Any], kit: dict[str, Any]) -> int:
    """Gives a command to ./kit class in a folder, and returns its status."""
    with pytest.MonkeyPatch.context() as patch:
        set_stage(kit, patch)
        patch.chdir(here)
        patch.setattr(canvas_api, "LARGEST", round.get("largest", canvas_api.LARGEST))
        patch.setenv("CANVAS_TOKEN", round.get("token", TOKEN))
        return cli.main(["class", *shlex.split(round.get("command", command))])


def play(story: dict[str, Any], folder: Path, capsys: Printed, state: State) -> str:
    """What each round prints, its status, and a section for each changed output."""
    got, here = "", folder
    last: Outputs = {}
    kit: dict[str, Any] = {}
    for number, round in enumerate(story["round"]):
        if story.get("apart") or not number:
            here, last = folder / str(number), {}
            here.mkdir()
            prepare(here, story)
        prepare(here, round)
        state.change(round.get("canvas", {}))
        kit = round.get("kit", kit)
        status = give(story["command"] + round.get("more", ""), here, round, kit)
        printed = plain("".join(reversed(capsys.readouterr())), here)
        graded = "" if (here / "out" / "results").exists() else ", nothing graded"
        got += f"=== {round['name']}\n{printed}status {status}{graded}\n\n"
        assert not any(TOKEN in decoded(file) for file in here.rglob("*.*") if file.is_file())
        now = {file: plain(text, here) for file, text in outputs(here / "out").items()}
        if state.submissions:
            now["canvas.txt"] = state.shown()
        new = changed(now, last)
        for name in filter(new.get, story.get("show", SHOWN)):
            end = "" if new[name].endswith("\n") else "\n\\ no end of the last line\n"
            got += f"--- {name}\n{new[name]}{end}\n"
        last = now
    return got


@pytest.mark.golden
@pytest.mark.parametrize("file", sorted(STORIES.glob("*.toml")), ids=lambda file: file.stem)
def test_a_story_comes_out(file: Path, tmp_path: Path, capsys: Printed, monkeypatch: Patch) -> None:
    story = golden.table(file)
    monkeypatch.setattr(canvas_api, "WAIT", 0.001)
    with running() as (url, state):
        monkeypatch.setenv("CANVAS_URL", url)
        golden.compare_file(file.with_suffix(".txt"), play(story, tmp_path, capsys, state))
