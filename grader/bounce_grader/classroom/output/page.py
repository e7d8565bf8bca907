"""class.html: the class at a glance, for the teacher. It needs nothing but itself."""

import statistics
from collections import Counter
from collections.abc import Collection, Iterable, Sequence

from bounce_grader.classroom.intake.students import Class
from bounce_grader.classroom.output import charts
from bounce_grader.classroom.output.charts import Bar, Dot, Way
from bounce_grader.classroom.work.near_copies import MOST as MOST_PAIRS, Similar
from bounce_grader.classroom.work.summary import Summary
from bounce_grader.common import escaping
from bounce_grader.common.manifest import parts
from bounce_grader.grading import speed
from bounce_grader.grading.known_mistakes import for_the_instructor

MOST_UNUSED = 10  # files named of a submission; grades.csv has some more
RIGHT = 1e-9  # the tolerance of every comparison
STYLE = """
body{font:16px/1.5 system-ui,sans-serif;color:#111;background:#fff;max-width:60rem;margin:0 auto;
padding:1rem}h1{font-size:1.7rem;margin:.5rem 0}h2{font-size:1.2rem;margin:2.2rem 0 .4rem;
border-bottom:2px solid #111}svg{width:100%;height:auto;display:block}
svg text{font:14px system-ui,sans-serif;fill:#111}table{border-collapse:collapse;width:100%}
.drawing,.table{overflow-x:auto}.drawing svg{min-width:34rem}
th,td{text-align:left;padding:.25rem .6rem .25rem 0;border-bottom:1px solid #bbb;
vertical-align:top}td.n,th.n{text-align:right;white-space:nowrap}th{border-bottom:2px solid #111}
.figures{display:flex;flex-wrap:wrap;gap:.5rem 2rem;padding:0;list-style:none}
.figures b{display:block;font-size:1.4rem}.small{color:#444;font-size:.9rem}
summary{cursor:pointer}td{overflow-wrap:anywhere}
@media print{details{display:block}body{max-width:none}}
"""


def render(found: Class, summaries: Sequence[Summary], near: Similar, said: Sequence[str]) -> str:
    names = {s.student.id: _who(s) for s in summaries}
    sections = [
        _figures(found, summaries),
        _section("Points", _histogram(summaries)),
        _section("Parts and checks", _success(summaries)),
        _section("Most frequent mistakes", _mistakes(summaries)),
        _section("Speed against accuracy", _speed(summaries)),
        _section("Needs a look", _looks(summaries)),
        _section("Near-copies", _near(near, names)),
        _section("Not graded, not matched", _unmatched(found, said)),
        _section("All submissions", _all(summaries)),
    ]
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>The class</title>'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f"<style>{STYLE}</style></head>\n<body><h1>The class</h1>{''.join(sections)}</body></html>\n"
    )


def _section(title: str, body: str) -> str:
    return f"<section><h2>{title}</h2>{body}</section>\n"


def _who(summary: Summary) -> str:
    student = summary.student
    return student.name if student.name == student.id else f"{student.name} ({student.id})"


def _scores(summaries: Iterable[Summary]) -> list[float]:
    return [s.score for s in summaries if s.score is not None]


def _figures(found: Class, summaries: Sequence[Summary]) -> str:
    scores = _scores(summaries)
    full = sum(part.points for part in parts())
    whole = max(found.handed_in, len(summaries))
    figures = [("submissions", str(whole)), ("graded", str(len(scores)))]
    if scores:
        figures += [
            ("median", f"{statistics.median(scores):g}"),
            ("mean", f"{statistics.mean(scores):.1f}"),
            ("with all points", str(sum(score >= full for score in scores))),
        ]
    late = sum(s.student.late for s in summaries)
    figures += [("late", str(late))] if late else []
    items = "".join(f"<li><b>{value}</b>{name}</li>" for name, value in figures)
    return f'<ul class="figures">{items}</ul>'


def _histogram(summaries: Sequence[Summary]) -> str:
    most = sum(part.points for part in parts())
    return _drawing(charts.histogram(_scores(summaries), most))


def _drawing(svg: str) -> str:
    return f'<div class="drawing">{svg}</div>'


def _success(summaries: Sequence[Summary]) -> str:
    graded = [s for s in summaries if s.score is not None]
    if not graded:
        return "<p>Nothing is graded yet.</p>"
    rows = []
    for part in parts():
        mean = statistics.mean(s.parts[part.number] for s in graded)
        heading = f"Part {part.number}: {part.title}"
        rows.append(Bar(heading, mean / part.points, f"{mean:.1f} of {part.points:g}", True))
        for check in part.checks:
            passed = sum(s.checks[check.id] > 0 for s in graded)
            share = passed / len(graded)
            rows.append(Bar(check.title, share, f"{100 * share:.0f} %"))
    said = "<p>Of a part, the mean of its points; of a check, how many passed it.</p>"
    return said + _drawing(charts.bars(rows, "Success by part and by check"))


def _mistakes(summaries: Sequence[Summary]) -> str:
    graded = [s for s in summaries if s.score is not None]
    counts = Counter(name for s in graded for name in s.mistakes)
    titles = {name: title for s in graded for name, title in s.mistakes.items()}
    if not counts:
        return "<p>No known mistake was recognised.</p>" + _failed(graded)
    most = counts.most_common(15)
    bars = [Bar(titles[name], count / len(graded), _n(count)) for name, count in most]
    rows = [
        [name[4], escaping.html(titles[name]), _n(count), escaping.html(for_the_instructor(name))]
        for name, count in most
    ]
    said = "<p>How many submissions make which known mistake, as far as their answers tell.</p>"
    drawing = _drawing(charts.bars(bars, "Submissions by mistake"))
    return said + drawing + _table(["part", "mistake", "submissions", "what it is"], rows, {2})


def _failed(graded: Sequence[Summary]) -> str:
    failed = Counter(id for s in graded for id, points in s.checks.items() if not points)
    titles = {check.id: (part, check) for part in parts() for check in part.checks}
    rows = [
        [f"part {titles[id][0].number}", escaping.html(titles[id][1].title), _n(count)]
        for id, count in failed.most_common(10)
    ]
    said = "<p>These checks failed most often.</p>"
    return said + _table(["part", "check", "failed in"], rows, {2}) if rows else ""


def _n(number: float) -> str:
    return f"{number:g}"


def _speed(summaries: Sequence[Summary]) -> str:
    if all(s.ratio is None for s in summaries):
        return (
            "<p>Nothing was timed: the same command with <code>--speed</code> adds the charts.</p>"
        )
    full = sum(part.points for part in parts())
    dots = [
        Dot(s.ratio, _error(s, full), _kind(s.score, full), f"{_who(s)}: {s.score:g} points")
        for s in summaries
        if s.score is not None
    ]
    said = (
        "<p>Each mark is a submission: a disc has all points, a ring some, a cross none. Times are "
        "measured in the same run as the solution's; the largest error is over all public cases. What "
        "doesn't run as a whole isn't timed; where an answer is missing, there is no error to show."
        "</p>"
    )
    return said + (_drawing(charts.scatter(dots, RIGHT)) if dots else "") + _ways(summaries, full)


def _error(summary: Summary, full: float) -> float | None:
    """Where points are lost though every answer that came is near, one is missing."""
    if summary.error is None or summary.score is None:
        return None
    return summary.error if summary.score >= full or summary.error > RIGHT else None


def _ways(summaries: Sequence[Summary], full: float) -> str:
    """All submissions' curves in one chart. Each has its own run's solution as its unit of time."""
    curves = [
        Way(places, _kind(s.score, full), f"{_who(s)}: {s.score:g} points")
        for s in summaries
        if s.score is not None and (places := _over_solution(s, "submission"))
    ]
    if not curves:
        return ""
    usual = [_median(summaries, whose) for whose in ("solution", "least")]
    said = (
        "<p>Each line is a submission on its way to smaller time steps, over the scenes that the "
        "assignment's model can do; the error is that of the worst scene, against the exact "
        "motion. Right programs differ in their time alone: their marks stand level. Squares: the "
        "solution; triangles: no more model than each step needs; dotted: 1 mm.</p>"
    )
    return said + _drawing(charts.ways([*curves, *filter(None, usual)], speed.FINE))


def _over_solution(summary: Summary, whose: str) -> tuple[tuple[float, float | None], ...]:
    unit = [point.ns for point in summary.curves.get("solution", ()) if point.dt >= speed.STEP]
    return tuple((p.ns / unit[-1], p.error) for p in summary.curves.get(whose, ()) if unit)


def _median(summaries: Sequence[Summary], whose: str) -> Way | None:
    """The usual curve of the class's runs."""
    runs = [(s, _over_solution(s, whose)) for s in summaries]
    runs = [(s, places) for s, places in runs if places]
    if not runs:
        return None
    first, places = runs[0]
    usual = [
        statistics.median(run[k][0] for _, run in runs)
        for k in range(min(len(run) for _, run in runs))
    ]
    marks = tuple((x, error) for x, (_, error) in zip(usual, places))
    dts = tuple(f"{1000 * p.dt:g} ms" for p in first.curves[whose])
    names = {"solution": "the solution", "least": "no more model than each step needs"}
    return Way(marks, whose, names[whose], dts if whose == "solution" else ())


def _kind(score: float, full: float) -> str:
    return "full" if score >= full else "some" if score else "none"


def _looks(summaries: Sequence[Summary]) -> str:
    rows = [
        [escaping.html(_who(s)), escaping.html("; ".join(s.needs_a_look))]
        for s in summaries
        if s.needs_a_look
    ]
    return _table(["who", "why"], rows) if rows else "<p>Nobody.</p>"


def _near(near: Similar, names: dict[str, str]) -> str:
    if near.problem:
        return f"<p>Not looked for: {escaping.html(near.problem)}</p>"
    said = (
        "<p>The share of one submission's structure that is in the other too, whatever the names "
        "and the layout; lines of the handout don't count. Right answers to a short task look "
        f"alike: half of the submissions have {near.usual} % or more in common with their closest "
        "relative. The pairs that stand out from that are a reason to look, and no more.</p>"
    )
    rows = [
        [escaping.html(names[p.first]), escaping.html(names[p.second]), f"{p.share} %"]
        for p in near.pairs
    ]
    if near.left_out:
        left_out = escaping.first_few([names[id] for id in near.left_out])
        said += f"<p>Left out: {escaping.html(left_out)}. Needs a look, above, says why.</p>"
    if not rows:
        return said + "<p>None.</p>"
    table = _table(["one", "the other", "in common"], rows, {2})
    return said + _groups(near, names) + table + _cut(near)


def _groups(near: Similar, names: dict[str, str]) -> str:
    """Of many alike, each is compared with its closest relatives only: these belong together."""
    items = [
        f"<li>{len(group)} alike: {escaping.html(', '.join(names[id] for id in group))}</li>"
        for group in _together(near)
        if len(group) > 2
    ]
    said = "<p>Linked by the pairs below; within a group, others may be as near.</p>"
    return f"{said}<ul>{''.join(items)}</ul>" if items else ""


def _together(near: Similar) -> list[list[str]]:
    """The largest group first."""
    groups: dict[str, list[str]] = {}
    for pair in near.pairs:
        one = groups.setdefault(pair.first, [pair.first])
        other = groups.setdefault(pair.second, [pair.second])
        if one is not other:
            one += other
            groups |= {id: one for id in other}
    whole = {id(group): group for group in groups.values()}
    return sorted(whole.values(), key=lambda group: -len(group))


def _cut(near: Similar) -> str:
    cut = len(near.pairs) >= MOST_PAIRS
    return f"<p>These are the {MOST_PAIRS} pairs with most in common.</p>" if cut else ""


def _unmatched(found: Class, said: Sequence[str]) -> str:
    rows = [
        [escaping.html(escaping.printable_name(unmatched.name)), escaping.html(unmatched.reason)]
        for unmatched in found.unmatched
    ]
    out = _table(["file", "why it isn't graded"], rows) if rows else "<p>Everything is matched.</p>"
    if said:
        items = "".join(f"<li>{escaping.html(sentence)}</li>" for sentence in said)
        out += f"<p>The grade book:</p><ul>{items}</ul>"
    return out


def _all(summaries: Sequence[Summary]) -> str:
    head = ["who", "points", *(f"part {part.number}" for part in parts()), "late", "not used"]
    rows = []
    for s in summaries:
        points = [_points(s.score), *(_points(s.parts.get(part.number)) for part in parts())]
        unused = escaping.html(escaping.first_few(s.unused, MOST_UNUSED, "; ", s.ignored_more))
        rows.append([escaping.html(_who(s)), *points, "late" if s.student.late else "", unused])
    table = _table(head, rows, set(range(1, 2 + len(parts()))))
    return f"<details><summary>{len(rows)} submissions</summary>{table}</details>"


def _points(points: float | None) -> str:
    return "" if points is None else _n(points)


def _table(head: list[str], rows: list[list[str]], numbers: Collection[int] = ()) -> str:
    def cells(tag: str, row: list[str]) -> str:
        mark = [' class="n"' if i in numbers else "" for i in range(len(row))]
        return "".join(f"<{tag}{m}>{cell}</{tag}>" for m, cell in zip(mark, row))

    body = "".join(f"<tr>{cells('td', row)}</tr>" for row in rows)
    return f'<div class="table"><table><tr>{cells("th", head)}</tr>{body}</table></div>'
