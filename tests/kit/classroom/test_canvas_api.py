"""Canvas by its API, against a small server: paging, limits of the rate, a wrong token, a failure
half-way and going on, and nothing posted that wasn't shown."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import canvas_server
import pytest
from bounce_grader.classroom.intake import canvas_api
from bounce_grader.classroom.output import outputs
from bounce_grader.classroom.work.summary import Summary
from bounce_grader.common.errors import KitError, UsageError
from canvas_server import State, TOKEN
from classes import grade_class, points_of, text_of
from conftest import write

USERS = list(range(101, 109))


@pytest.fixture
def server(monkeypatch: pytest.MonkeyPatch) -> Iterator[State]:
    monkeypatch.setattr(canvas_api, "WAIT", 0.001)
    with canvas_server.running() as (url, state):
        monkeypatch.setenv("CANVAS_URL", url)
        for user in USERS:
            state.add(user, f"Doe {user}, Jane", {"part2_lcp.cpp": text_of(user)})
        yield state


def run(
    out: Path,
    monkeypatch: pytest.MonkeyPatch,
    token: str = TOKEN,
    canvas: str = "7/9",
    **more: object,
) -> int:
    monkeypatch.setenv("CANVAS_TOKEN", token)
    return grade_class(out, out, canvas=canvas, **more)


def expected(tmp_path: Path) -> dict[int, float]:
    return {user: float(points_of(user, tmp_path)) for user in USERS}


def test_points_and_pages_are_posted_once_they_were_shown(
    tmp_path: Path,
    server: State,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    out = tmp_path / "out"
    monkeypatch.setattr(canvas_api, "WAIT", -1.0)  # s: to wait raises ValueError
    assert run(out, monkeypatch, upload=True) == 1  # not shown before
    assert not server.comments and "wasn't shown before" in capsys.readouterr().out
    assert run(out, monkeypatch, upload=True) == 0
    scores = {user: s["score"] for user, s in server.submissions.items()}
    assert scores == expected(tmp_path)
    assert {user: len(pages) for user, pages in server.comments.items()} == dict.fromkeys(USERS, 1)
    assert all(b"<!doctype html>" in pages[0] for pages in server.comments.values())
    assert server.tokens_elsewhere == []
    assert "Doe 101, Jane" in (out / "grades.csv").read_text()
    said = capsys.readouterr()
    assert TOKEN not in said.out + said.err
    assert not any(TOKEN in f.read_text(errors="replace") for f in out.rglob("*") if f.is_file())
    assert run(out, monkeypatch) == 0
    again = capsys.readouterr().out
    assert "Students whose points or pages would change on Canvas: 0." in again
    assert "--upload" not in again


def test_who_hands_in_no_file_is_listed_and_gets_a_page(
    tmp_path: Path,
    server: State,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    for user, kind in ((201, "online_text_entry"), (202, "online_url"), (203, "media_recording")):
        server.add(user, f"Roe {user}, Max", {}, submission_type=kind, submitted_at="2026-11-20")
    server.add(204, "Roe 204, Max", {"photo.jpg": b"x"}, submission_type="online_upload")
    server.add(205, "Roe 205, Max", {}, submission_type=None, submitted_at=None)
    out = tmp_path / "out"
    assert [run(out, monkeypatch, upload=True) for _ in range(2)] == [1, 0]
    told = capsys.readouterr().out
    assert "'Roe 201, Max' is text typed into Canvas" in told
    assert "'Roe 202, Max' is an address typed into Canvas" in told
    assert "'Roe 203, Max' has no file" in told and "'Roe 204, Max' holds nothing" in told
    assert "Roe 205" not in told and "8 of 12" in told
    page = (out / "class.html").read_text()
    assert all(f"Roe {user}, Max" in page for user in (201, 202, 203, 204))
    assert all(len(server.comments[user]) == 1 for user in (201, 202, 203, 204))
    assert 205 not in server.comments and server.submissions[201]["score"] is None
    assert run(out, monkeypatch) == 0
    assert "Students whose points or pages would change on Canvas: 0." in capsys.readouterr().out


def test_who_is_called_as_a_group_or_an_id_gives_and_takes_nothing(
    tmp_path: Path, server: State, monkeypatch: pytest.MonkeyPatch
) -> None:
    for user, name in ((301, "team seven"), (302, "101")):
        server.add(user, name, {"part2_lcp.cpp": b"// nothing"})
    for user in (201, 202):
        server.add(user, f"Roe {user}, Max", {}, submission_type=None)
    out = tmp_path / "out"
    roster = b"submission,id\nteam seven,201\nteam seven,202\n101,101\n"
    write(out, {"roster.csv": roster, "adjustments.csv": b"student,points,reason\n101,1,good\n"})
    run(out, monkeypatch)
    run(out, monkeypatch, upload=True)
    scores = {user: submission["score"] for user, submission in server.submissions.items()}
    points = expected(tmp_path)
    assert scores[201] is scores[202] is None and not {201, 202} & set(server.comments)
    assert scores[101] == points[101] + 1 and scores[302] == scores[301] < 100
    assert "good" not in (out / "feedback" / "101_302_3020_feedback.html").read_text()


def test_what_a_person_has_entered_is_kept_and_an_excuse_too(
    tmp_path: Path,
    server: State,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    out = tmp_path / "out"
    for upload in (False, True):
        run(out, monkeypatch, upload=upload)
    server.submissions[101]["score"] = 12.5
    server.submissions[102] |= {"excused": True, "score": None}
    write(out, {"adjustments.csv": b"student,points,reason\n103,-1,late\n104,1,good\n"})
    for upload in (False, True):
        run(out, monkeypatch, upload=upload)
    now = {user: s["score"] for user, s in server.submissions.items()}
    points = expected(tmp_path)
    changed: dict[int, float | None] = {
        101: 12.5,
        102: None,
        103: max(0, points[103] - 1),
        104: points[104] + 1,
    }
    assert now == {**dict[int, float | None](points), **changed}
    assert "keeps 12.5" in capsys.readouterr().out
    assert {len(server.comments[user]) for user in (103, 104)} == {2}
    assert len(server.comments[105]) == 1


def test_a_failure_half_way_is_gone_on_from(
    tmp_path: Path, server: State, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    run(out, monkeypatch)
    server.broken_after = 3
    with pytest.raises(KitError, match="give the same command again later"):
        run(out, monkeypatch, upload=True)
    server.broken_after = -1
    while run(out, monkeypatch, upload=True):
        pass
    assert {u: s["score"] for u, s in server.submissions.items()} == expected(tmp_path)
    assert {len(pages) for pages in server.comments.values()} == {1}


def test_requests_that_come_too_quickly_are_tried_again(
    tmp_path: Path, server: State, monkeypatch: pytest.MonkeyPatch
) -> None:
    server.limited = 4
    assert run(tmp_path / "out", monkeypatch) == 0


def test_lateness_is_counted_in_days(
    tmp_path: Path, server: State, monkeypatch: pytest.MonkeyPatch
) -> None:
    server.submissions[101] |= {"late": True, "seconds_late": 2 * 86400 + 1}
    out = tmp_path / "out"
    write(out, {"course.toml": b"[late]\npercent_per_day = 5\n"})
    run(out, monkeypatch)
    (page,) = (out / "feedback").glob("*_101_*")
    assert "3 days late, 15 %" in page.read_text()


@pytest.mark.parametrize(
    "name", ["../../../evil.cpp", "a/b.cpp", "x" * 300 + ".cpp", ".cpp", "\x00"]
)
@pytest.mark.usual(3)
def test_no_name_of_a_file_leads_out_of_the_folder(
    tmp_path: Path, server: State, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    server.add(200, "../../Eve", {"part2_lcp.cpp": text_of(200), name: b""})
    out = tmp_path / "out"
    assert run(out, monkeypatch) == 0
    assert not list(tmp_path.rglob("evil*")) or all(
        out / "canvas" in path.parents for path in tmp_path.rglob("*evil*")
    )


@pytest.mark.parametrize(
    "mistake",
    [
        "/files/1030/download",  # which leads to itself
        "gone",
        {"id": None},
        {"url": ""},
        {"url": None},
        {"url": "file:///etc/hostname"},
        {"url": "http://[x/"},
        "file:///etc/hostname",
        "ftp://127.0.0.1/x",
        "data:,int",
        "http://[x/",
        "http://127.0.0.1:port/",
    ],
)
@pytest.mark.usual(5)
def test_a_file_that_cannot_be_had_costs_no_other_student_the_grading(
    tmp_path: Path,
    server: State,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    mistake: str | dict[str, str | None],
) -> None:
    if mistake == "gone":
        server.gone.add(1030)
    elif isinstance(mistake, str):
        server.elsewhere[1030] = mistake
    else:
        server.submissions[103]["attachments"][0] |= mistake
    out = tmp_path / "out"
    assert run(out, monkeypatch) == 0
    said = capsys.readouterr().out
    assert "7 of 8 submissions graded" in said
    assert "'Doe 103, Jane' isn't graded: Canvas" in said and "look at it there" in said
    assert len(list((out / "canvas").iterdir())) == 7


def test_one_students_files_fill_no_disk(
    tmp_path: Path,
    server: State,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """What can't count isn't downloaded; of what can, no more than may be handed in."""
    most = 100_000
    monkeypatch.setattr(canvas_api, "LARGEST", most)
    several = {f"{i}.zip": bytes(most // 3) for i in range(40)}
    server.add(201, "Several", {"part2_lcp.cpp": text_of(201), **several})
    server.add(202, "Large", {"part2_lcp.cpp": text_of(202), "large.zip": bytes(most + 1)})
    server.add(203, "Film", {"part2_lcp.cpp": text_of(203), "film.mov": bytes(most * 2)})
    server.add(204, "Many", {f"helper{i}.cpp": b"" for i in range(101)})
    out = tmp_path / "out"
    assert run(out, monkeypatch) == 0
    said = capsys.readouterr().out
    assert "9 of 12 submissions graded" in said
    assert "'Several' isn't graded: all that is handed in" in said
    assert "'Large' isn't graded: large_202_2021_large.zip is too large" in said
    assert "is 101 files; a submission may have 100" in said
    sizes = [path.stat().st_size for path in (out / "canvas").iterdir()]
    assert sum(sizes) < 2 * most and len(sizes) < 20


def test_a_page_that_is_not_there_is_not_posted(
    tmp_path: Path, server: State, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = outputs._page

    def odd(summary: Summary, *more: Any) -> str:
        if summary.student.id == "103":
            raise UnicodeError("surrogates")
        return whole(summary, *more)

    monkeypatch.setattr(outputs, "_page", odd)
    out = tmp_path / "out"
    run(out, monkeypatch)
    assert run(out, monkeypatch, upload=True) == 0
    assert set(server.comments) == set(USERS) - {103}
    assert {user: s["score"] for user, s in server.submissions.items()} == expected(tmp_path)


def test_a_page_that_canvas_refuses_is_said_and_the_others_are_posted(
    tmp_path: Path,
    server: State,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    server.refused.add(103)
    out = tmp_path / "out"
    run(out, monkeypatch)
    assert run(out, monkeypatch, upload=True) == 1
    assert "(103): Canvas refused it (400" in capsys.readouterr().out
    assert set(server.comments) == set(USERS) - {103}


@pytest.mark.parametrize(
    "more, sentence",
    [
        ({"token": "wrong"}, "Canvas doesn't accept the token"),
        ({"token": " "}, "needs CANVAS_TOKEN in the environment"),
        ({"canvas": "7"}, "takes COURSE/ASSIGNMENT, two numbers"),
        ({"canvas": "7/8"}, "Canvas has no assignment 7/8 for you"),
    ],
)
def test_what_cannot_be_is_said_in_a_sentence(
    tmp_path: Path,
    server: State,
    monkeypatch: pytest.MonkeyPatch,
    more: dict[str, str],
    sentence: str,
) -> None:
    with pytest.raises(UsageError) as refused:
        run(tmp_path / "out", monkeypatch, **more)
    assert sentence in str(refused.value) and "\n" not in str(refused.value)
    assert not (tmp_path / "out" / "results").exists()
