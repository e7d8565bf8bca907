"""Finds each student's submission in Blackboard's download, packed or unpacked."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from bounce_grader.classroom.intake import blackboard
from bounce_grader.classroom.intake.archive import opened
from bounce_grader.classroom.intake.canvas import Upload
from bounce_grader.classroom.intake.student import Class, set_duplicates_aside, Unmatched
from bounce_grader.classroom.intake.uploads import not_named, take, typed_elsewhere
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting


def read(path: Path, _people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Blackboard download", service="blackboard")
    parsed = {name: blackboard.parse(name) for name in archive.names() if "/" not in name}
    known = {name: entry for name, entry in parsed.items() if entry}
    title = blackboard.title(entry.head for entry in known.values())
    attempts: dict[str, dict[int, list[Upload]]] = {}
    people: dict[str, blackboard.Person] = {}
    for name, entry in known.items():
        if not entry.file:
            person = blackboard.person_of(entry.head, archive.read(name, 4096))
            if person:
                people[entry.head] = person
        attempts.setdefault(entry.head, {}).setdefault(entry.when, [])
        if entry.file:
            upload = Upload(name, "", entry.head, False, entry.when, entry.file, True)
            attempts[entry.head][entry.when].append(upload)
    for head, by_time in attempts.items():
        person = people.get(head)
        if not person and not title:
            intake.unmatched.append(Unmatched(head, "has no text that says whose it is"))
            continue
        user = person.user if person else head.removeprefix(title)
        name = person.name if person and person.name else user
        newest = [replace(upload, name=name, user=user) for upload in by_time[max(by_time)]]
        page = f"{fitting(printable_name(user))}.html"  # not by the name: it may hold a "/"
        if newest:
            take(intake, archive, user, name, newest, page)
        else:
            typed_elsewhere(intake, f"{head}.txt", "Blackboard", user, page)
    left = [name for name in archive.names() if name not in known]
    intake.unmatched += [Unmatched(name, not_named("Blackboard", name)) for name in left]
    set_duplicates_aside(intake)
    return intake
