"""./kit grade: grades a submission, and reports on it."""

import argparse
from pathlib import Path

from bounce_grader import formats
from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import require_folder, write_asked
from bounce_grader.common.manifest import full_points
from bounce_grader.common.numbers import short
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.report import report
from bounce_grader.grading.self_check import require_sound_judge
from bounce_grader.sandbox.box import kinds


def run(options: argparse.Namespace) -> int:
    if options.format and options.json == "-":
        raise UsageError("--format and --json - both write to standard output: give one")
    if not 0 <= (options.min_score or 0) <= full_points():
        most = f"takes points from 0 to {short(full_points())}, not {short(options.min_score)}"
        raise UsageError(f"--min-score {most}")
    require_folder(Path(options.json or ""))
    acceptable = (options.require_box,) if options.require_box else kinds(options.trust_submission)
    require_sound_judge(acceptable)
    wanted = Options(acceptable, options.speed, not options.no_sanitize, options.public)
    try:
        record = report(grade(options.submission, wanted), options.reveal)
    except UsageError as error:
        if refused := formats.refused(options.format, str(error)):
            print(refused)
        raise
    shown = "json" if options.json == "-" else options.format or "terminal"
    print(formats.render(shown, record))
    if options.json not in (None, "-"):
        write_asked(Path(options.json), formats.render("json", record) + "\n")
    return int(options.min_score is not None and record["score"] < options.min_score)
