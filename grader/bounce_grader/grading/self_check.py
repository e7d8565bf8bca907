"""A first step that can fail: a judge that finds no mistake gives the solution full points, too. So
once after each build, a wrong program is graded that must lose what a person wrote down."""

from contextlib import suppress

from bounce_grader.common.errors import KitError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.known_mistakes import expected, GALLERY

WRONG = GALLERY / "part3_friction_sign"
BUILT, CHECKED = BUILD / "built-kit", BUILD / "self-checked"


def problem_of_judge(boxes: tuple[str, ...]) -> str | None:
    """How the grading of the wrong program differs from what it must be; None if it doesn't."""
    try:
        record = grade(WRONG, Options(boxes, sanitize=False))
    except KitError as error:
        return f"a known wrong program can't be graded: {error}"
    part = record["parts"][2]
    lost = sorted(check["id"] for check in part["checks"] if not check["passed"])
    named = part["mistakes"]
    if lost == sorted(expected(WRONG)["lost"]) and named == [WRONG.name]:
        return None
    points = f"{part['score']:g} of {part['max_score']:g} points"
    got = f"got {points}, for {', '.join(named) or 'no known mistake'}"
    why = f"a known wrong program, {WRONG.name}, {got}, and lost {', '.join(lost) or 'nothing'}"
    return f"{why}: trust no score of this build, and report this with what ./kit doctor prints"


def require_sound_judge(boxes: tuple[str, ...]) -> None:
    """Raises KitError if this build grades a wrong program otherwise than it must."""
    built = str(BUILT.stat().st_mtime_ns) if BUILT.exists() else ""
    if CHECKED.exists() and CHECKED.read_text() == built:
        return
    if problem := problem_of_judge(boxes):
        raise KitError(problem)
    with suppress(OSError):  # a kit that can't be written is checked each time
        write_whole(CHECKED, built)
