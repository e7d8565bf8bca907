"""A page for a student: self-contained, and legible on paper and in grey."""

from bounce_grader.formats import words
from bounce_grader.formats._escaping import to_html
from bounce_grader.record import Record

STYLE = """
body{font:16px/1.5 system-ui,sans-serif;max-width:46rem;margin:2rem auto;padding:0 1rem;color:#111;
background:#fff}
h1{font-size:1.6rem;margin:0 0 .2rem}h2{font-size:1.15rem;margin:2rem 0 .3rem;
border-bottom:2px solid #111;display:flex;justify-content:space-between;gap:1rem}
.of{white-space:nowrap}ul{list-style:none;padding:0}li{padding:.3rem 0;border-bottom:1px solid #ccc}
.line{display:flex;gap:.6rem}.line .title{flex:1}.mark{font-weight:bold;width:1.2em}
.lost .title{font-weight:600}pre{background:#f2f2f2;padding:.6rem;overflow-x:auto;font-size:.85rem;
border-left:3px solid #555;margin:.3rem 0 .3rem 1.8rem}.hint{margin:.2rem 0 .2rem 1.8rem}
.mistake{margin:.3rem 0;padding:.1rem .6rem;border-left:3px solid #111}
.hint,.small{color:#444;font-size:.9rem}.bar{height:.6rem;border:1px solid #111;margin:.4rem 0 1rem}
.bar div{height:100%;background:#333}
"""


def render(record: Record, name: str = "", unused: tuple[str, ...] = ()) -> str:
    share = 100 * record["score"] / record["max_score"]
    parts = "".join(_part(part) for part in record["parts"])
    body = (
        f"<h1>{words.of_points(record)} points</h1>"
        + (f"<p>{to_html(name)}</p>" if name else "")
        + f'<div class="bar"><div style="width:{share:.1f}%"></div></div>'
        + parts
        + _speed(record.get("speed"))
        + _unused([*unused, *(f"{file} wasn't used" for file in record["ignored"][:20])])
        + f'<p class="small">Graded by kit {to_html(record["kit"])}; submission '
        f"{record['submission_sha256'][:12]}.</p>"
    )
    return page("Bouncing: your points", body)


def refused(sentence: str) -> str:
    """For a submission that can't be read."""
    body = f"<h1>Not graded</h1><p>{to_html(sentence)}</p>"
    return page("Bouncing: not graded", body)


def page(title: str, body: str) -> str:
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f"<style>{STYLE}</style></head>\n<body>{body}</body></html>\n"
    )


def _part(part: Record) -> str:
    score = f"{words.points(part['score'])} / {words.points(part['max_score'])}"
    heading = f"<h2><span>Part {part['part']}: {to_html(part['title'])}</span>"
    ran = any(check["passed"] or check["message"] for check in part["checks"])
    checks = "".join(_check(check) for check in part["checks"]) if ran else ""
    given = part["graded_with"] == "given" and part["score"] < part["max_score"]
    return (
        f'{heading}<span class="of">{score}</span></h2><p>{to_html(words.part_words(part))}</p>'
        + "".join(map(_mistake, part["mistakes"]))
        + "".join(f'<p class="mistake">{to_html(said)}</p>' for said in part["patterns"])
        + (f"<ul>{checks}</ul>" if checks else "")
        + ('<p class="small">Judged with the earlier parts given.</p>' if given else "")
    )


def _mistake(mistake: Record) -> str:
    return (
        f'<p class="mistake">Looks like: <b>{to_html(mistake["title"])}.</b> '
        f'{to_html(mistake["sentence"])} See {to_html(words.where_to_read(mistake))}.</p>'
    )


def _check(check: Record) -> str:
    mark, kind = ("✓", "passed") if check["passed"] else ("✗", "lost")
    score = f"{words.points(check['score'])} / {words.points(check['max_score'])}"
    out = (
        f'<li class="{kind}"><div class="line"><span class="mark">{mark}</span>'
        f'<span class="title">{to_html(check["title"])}</span><span class="of">{score}</span></div>'
    )
    if check["message"]:
        out += f"<pre>{to_html(check['message'])}</pre>"
    if not check["passed"] and words.hint(check):
        out += f'<p class="hint">Hint {to_html(words.hint(check))}</p>'
    return out + "</li>"


def _speed(speed: Record | None) -> str:
    if not speed or "ratio" not in speed:
        return ""
    error = speed["largest_error"]
    accuracy = "not finite" if error is None else f"{error:.1e}"
    return (
        f'<p class="small">A step took {speed["submission_ns"]:.0f} ns, {speed["ratio"]:.2f} times '
        f"the solution's; largest error {accuracy}. This gives and costs no points.</p>"
    )


def _unused(sentences: list[str]) -> str:
    items = "".join(f"<li>{to_html(sentence)}</li>" for sentence in sentences)
    return f'<p class="small">Not used:</p><ul class="small">{items}</ul>' if items else ""
