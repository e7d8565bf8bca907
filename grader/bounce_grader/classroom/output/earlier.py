"""Compares with earlier submissions. A service hands out the last attempt alone, and a student who
corrects one file may hand in that one alone: points would be lost in silence."""

from collections.abc import Sequence
from pathlib import Path

from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.output.points import note, WRITTEN
from bounce_grader.common.files import read_object
from bounce_grader.common.manifest import named_together
from bounce_grader.common.numbers import short

BEST = "best submissions"  # in written.json, by the student's id


def note_fewer(out: Path, tasks: Sequence[Task], summaries: Sequence[Summary]) -> None:
    """Notes who has fewer parts or points than with the best of their submissions in any run."""
    written = read_object(out / WRITTEN)
    best = written.setdefault(BEST, {})
    for task, summary in zip(tasks, summaries):
        there = [part["part"] for part in summary.parts if part["status"] != "not_submitted"]
        now = {"submission": task.submission, "score": summary.score, "parts": there}
        if summary.score is None:
            continue
        before = best.setdefault(summary.student.id, now)
        is_as_good = summary.score >= before["score"] and set(there) >= set(before["parts"])
        if is_as_good or before["submission"] == task.submission:
            best[summary.student.id] = now
        else:
            had = f"{short(before['score'])} points, with {named_together(before['parts'])}"
            summary.notes.append(f"an earlier submission had {had}: ask which one counts")
    note(out, written)
