"""Finds each student's submission in Moodle's download, packed or unpacked."""

from collections.abc import Mapping
from pathlib import Path, PurePosixPath

from bounce_grader.classroom.intake import moodle
from bounce_grader.classroom.intake.archive import is_folder, opened, zip_alone
from bounce_grader.classroom.intake.canvas import Upload
from bounce_grader.classroom.intake.student import Class, set_duplicates_aside, Student, Unmatched
from bounce_grader.classroom.intake.uploads import not_named, take, typed_elsewhere


def read(path: Path, _people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Moodle download", service="moodle")
    files: dict[tuple[str, str], list[Upload]] = {}
    for number, name in enumerate(archive.names()):
        parsed = moodle.parse(name)
        if not parsed:
            intake.unmatched.append(Unmatched(name, not_named("Moodle", name)))
        elif parsed.kind == "onlinetext":
            page = moodle.feedback_name(parsed.name, parsed.participant)
            typed_elsewhere(intake, name, "Moodle", parsed.participant, page)
        elif not _is_inside(parsed.file):
            intake.unmatched.append(Unmatched(name, "points outside of the submission"))
        else:
            who = (parsed.participant, parsed.name)
            upload = Upload(name, parsed.name, parsed.participant, False, number, parsed.file, True)
            files.setdefault(who, []).append(upload)
    for (participant, name), uploads in files.items():
        page = moodle.feedback_name(name, participant)
        take(intake, archive, participant, name, uploads, page)
    return intake


def read_folders(children: list[Path]) -> Class:
    """Moodle's download, unpacked."""
    intake = Class("a Moodle download", service="moodle")
    for child in children:
        parsed = moodle.parse_folder(child.name) if is_folder(child) else None
        if not parsed:
            intake.unmatched.append(Unmatched(child.name, not_named("Moodle", child.name)))
            continue
        page = moodle.feedback_name(parsed.name, parsed.participant)
        if parsed.kind == "onlinetext":
            typed_elsewhere(intake, child.name, "Moodle", parsed.participant, page)
        else:
            there = zip_alone(child) or child
            intake.students.append(Student(parsed.participant, parsed.name, there, feedback=page))
    set_duplicates_aside(intake)
    return intake


def _is_inside(file: str) -> bool:
    parts_of = PurePosixPath(file).parts
    return not file.startswith("/") and ".." not in parts_of and "\\" not in file
