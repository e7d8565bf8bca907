"""A page for a student: self-contained, and legible on paper, in the dark and in grey."""

from bounce_grader.common import escaping
from bounce_grader.formats import case, sentences, speed_chart
from bounce_grader.grading.record import Record

STYLE = """
:root{color-scheme:light dark;--ink:#111;--paper:#fff;--soft:#444;--field:#f2f2f2;--line:#ccc}
@media (prefers-color-scheme:dark){:root{--ink:#eee;--paper:#161616;--soft:#bbb;--field:#262626;
--line:#555}}
@media print{:root{color-scheme:light;--ink:#111;--paper:#fff;--soft:#444;--field:#f2f2f2;--line:#ccc}}
body{font:16px/1.5 system-ui,sans-serif;max-width:52rem;margin:2rem auto;padding:0 1rem;
color:var(--ink);background:var(--paper);overflow-wrap:anywhere}
h1{font-size:1.6rem;margin:0 0 .2rem}h2{font-size:1.15rem;margin:2rem 0 .3rem;
border-bottom:2px solid;display:flex;justify-content:space-between;gap:1rem}
.of{white-space:nowrap}ul{list-style:none;padding:0}
li{padding:.3rem 0;border-bottom:1px solid var(--line)}
.line{display:flex;gap:.6rem}.line .title{flex:1}.mark{font-weight:bold;width:1.2em}
.lost .title{font-weight:600}
pre{background:var(--field);padding:.6rem;overflow-x:auto;font-size:.85rem;border-left:3px solid;
margin:.3rem 0}.lost>pre,.case{margin:.3rem 0 .3rem 1.8rem}
.hint{margin:.2rem 0 .2rem 1.8rem}
.mistake{margin:.3rem 0;padding:.1rem .6rem;border-left:3px solid}
.hint,.small{color:var(--soft);font-size:.9rem}
.bar{height:.6rem;border:1px solid;margin:.4rem 0 1rem}.bar div{height:100%;background:var(--ink)}
.case pre{white-space:pre-wrap}.case p{margin:.3rem 0}.case .name{margin-top:.8rem;font-weight:600}
.pair,.pictures,.charts{display:flex;flex-wrap:wrap;gap:.6rem 1.6rem;overflow-x:auto}
.matrix{border-collapse:separate;border-spacing:.1rem;font-size:.95rem;font-variant-numeric:tabular-nums}
.matrix caption{text-align:left;font-size:.85rem;color:var(--soft);white-space:nowrap}
.matrix td{text-align:right;padding:0 .25rem;white-space:nowrap;border:2px solid transparent}
.matrix td.wrong{border-color:var(--ink);background:var(--field);font-weight:bold}
.matrix td.unit{text-align:left;color:var(--soft);font-size:.85rem}
.unseen{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
figure{margin:.6rem 0}figcaption{font-size:.85rem}
svg{display:block;width:100%;height:auto}svg text{font:14px system-ui,sans-serif;fill:currentColor}
.hollow{fill:var(--paper)}.ground{fill:var(--field)}.pictures figure{width:15.6rem;max-width:100%}
.wide,.chart{max-width:34rem}.charts figure{width:21rem;max-width:100%;margin:0}
summary{cursor:pointer}
@media (max-width:30rem){.lost>pre,.case,.hint{margin-left:0}.matrix{font-size:.78rem}}
"""


MOST_UNUSED = 20  # files named
TITLE = "Bouncing: "  # every page's begins so


def render(record: Record, name: str = "", unused: tuple[str, ...] = ()) -> str:
    share = 100 * record["score"] / record["max_score"]
    parts = "".join(_part(part) for part in record["parts"])
    body = (
        f"<h1>{sentences.of_points(record)} points</h1>"
        + (f"<p>{escaping.html(name)}</p>" if name else "")
        + f'<div class="bar"><div style="width:{share:.1f}%"></div></div>'
        + parts
        + speed_chart.page_section(record.get("speed") or {})
        + _unused(
            [*unused, *(f"{file} wasn't used" for file in record["ignored"])],
            record.get("ignored_more", 0),
        )
        + f'<p class="small">Graded by kit {escaping.html(record["kit"])}; submission '
        f"{record['submission_sha256'][:12]}.</p>"
    )
    return page(f"{TITLE}your points", body)


def refused(sentence: str) -> str:
    """For a submission that can't be read."""
    body = f"<h1>Not graded</h1><p>{escaping.html(sentence)}</p>"
    return page(f"{TITLE}not graded", body)


def page(title: str, body: str) -> str:
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f"<style>{STYLE}</style></head>\n<body>{body}</body></html>\n"
    )


def _part(part: Record) -> str:
    score = f"{sentences.points(part['score'])} / {sentences.points(part['max_score'])}"
    heading = f"<h2><span>Part {part['part']}: {escaping.html(part['title'])}</span>"
    ran = any(check["passed"] or check["message"] for check in part["checks"])
    checks = "".join(_check(check) for check in part["checks"]) if ran else ""
    given = part["graded_with"] == "given" and part["score"] < part["max_score"]
    return (
        f'{heading}<span class="of">{score}</span></h2><p>{escaping.html(sentences.part_words(part))}</p>'
        + "".join(map(_mistake, part["mistakes"]))
        + "".join(f'<p class="mistake">{escaping.html(said)}</p>' for said in part["patterns"])
        + (f"<ul>{checks}</ul>" if checks else "")
        + ('<p class="small">Judged with the earlier parts given.</p>' if given else "")
    )


def _mistake(mistake: Record) -> str:
    return (
        f'<p class="mistake">Looks like: <b>{escaping.html(mistake["title"])}.</b> '
        f'{escaping.html(mistake["sentence"])} See {escaping.html(sentences.where_to_read(mistake))}.</p>'
    )


def _check(check: Record) -> str:
    mark, kind = ("✓", "passed") if check["passed"] else ("✗", "lost")
    score = f"{sentences.points(check['score'])} / {sentences.points(check['max_score'])}"
    out = (
        f'<li class="{kind}"><div class="line"><span class="mark">{mark}</span>'
        f'<span class="title">{escaping.html(check["title"])}</span><span class="of">{score}</span></div>'
    )
    if check.get("shown", {}).get("quantities"):
        out += case.render(check["shown"], check["message"].partition("\n")[0])
    elif check["message"]:
        out += f"<pre>{escaping.html(check['message'])}</pre>"
    if not check["passed"] and sentences.hint(check):
        out += f'<p class="hint">Hint {escaping.html(sentences.hint(check))}</p>'
    return out + "</li>"


def _unused(sentences: list[str], more: int) -> str:
    rest = max(0, len(sentences) - MOST_UNUSED) + more
    shown = [*sentences[:MOST_UNUSED], *([f"and {rest} more"] if rest else [])]
    items = "".join(f"<li>{escaping.html(sentence)}</li>" for sentence in shown)
    return f'<p class="small">Not used:</p><ul class="small">{items}</ul>' if items else ""
