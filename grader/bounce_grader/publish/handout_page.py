"""Turns a Markdown file of the handout into an HTML page that needs no other file and no network."""

import os
import re
from collections.abc import Mapping
from functools import partial
from html import escape
from pathlib import Path
from typing import Any

from jinja2 import Environment, StrictUndefined, TemplateError
from markupsafe import Markup

from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CONTRACT, HANDOUT
from bounce_grader.formats.html import fill
from bounce_grader.publish import equations


def sources() -> list[Path]:
    """The Markdown files that become pages, in the order in which they are read."""
    return [HANDOUT / "README.md", *sorted(HANDOUT.glob("hints/*.md")), HANDOUT / "explore.md"]


def page(file: Path) -> bytes:
    """The page of a Markdown file. The pictures that it shows lie beside it, as SVG."""
    from markdown_it import MarkdownIt

    markdown = MarkdownIt("commonmark", {"html": True}).enable("table")
    markdown.add_render_rule("fence", _fence)
    markdown.add_render_rule("code_block", _code)
    markdown.add_render_rule("code_inline", _name)
    markdown.add_render_rule("text", lambda _, tokens, i, *__: equations.inline(tokens[i].content))
    markdown.add_render_rule("table_open", lambda *_: '<div class="table" tabindex="0"><table>\n')
    markdown.add_render_rule("table_close", lambda *_: "</table></div>\n")
    tokens = markdown.parse(filled_in(file.read_text("utf-8")))
    contents = _number_headings(tokens)
    body = markdown.renderer.render(tokens, markdown.options, {})
    drawn = partial(_drawing, file.parent)
    body = re.sub(r'<p><img src="([\w.]+)" alt="[^"]*"\s*/?></p>', drawn, body)
    body = re.sub(r'href="([\w/]+)\.md"', r'href="\1.html"', body)
    if file.parent.name == "hints":  # each stage opens by itself; what ./check reads is left out
        body = re.sub(r"<p>Checks: .*?</p>", "", body, flags=re.DOTALL)
        stage = r"<h3[^>]*>(.*?)</h3>(.*?)(?=<h[23]|$)"
        body = re.sub(stage, r"<details><summary>\1</summary>\2</details>", body, flags=re.DOTALL)
    heading, rest = map(Markup, body.split("</h1>\n", 1))
    around = {"contents": contents, "pages": _neighbours(file), "title": _title(file)}
    return fill("publish/handout_page.html.j2", heading=heading, body=rest, **around).encode()


def _title(file: Path) -> str:
    return file.read_text("utf-8").splitlines()[0].removeprefix("# ")


def _neighbours(file: Path) -> list[tuple[str, str, str]]:
    """The pages before and after this one: the relation, the link and the title."""
    all_pages = sources()
    place = all_pages.index(file)
    near = (("prev", place - 1), ("next", place + 1))
    return [
        (relation, os.path.relpath(other.with_suffix(".html"), file.parent), _title(other))
        for relation, n in near
        if 0 <= n < len(all_pages)
        for other in [all_pages[n]]
    ]


def _drawing(folder: Path, image: re.Match[str]) -> str:
    svg = re.sub(r"(?s)<!--.*?-->", "", (folder / image[1]).read_text("utf-8"))
    return f"<figure>{' '.join(svg.split())}</figure>"


def _number_headings(tokens: list[Any]) -> list[tuple[str, Markup]]:
    """Gives each heading the name that links to it may have. Those of sections, with their texts."""
    contents = []
    for opening, content in zip(tokens, tokens[1:]):
        if opening.type == "heading_open":
            name = "-".join(re.findall(r"\w+", content.content.lower()))
            opening.attrSet("id", name)
            if opening.tag == "h2":
                contents.append((name, Markup(equations.inline(content.content))))
    return contents


def _name(_: Any, tokens: list[Any], index: int, *__: Any) -> str:
    """Code in a sentence. A line may end at its blanks, but not within a name that a line can hold."""
    code = escape(tokens[index].content, quote=False)
    names = re.compile(r"(?<!\S)(?=\S*[-/_])\S{1,32}(?!\S)")
    return f"<code>{names.sub(lambda name: f'<span>{name[0]}</span>', code)}</code>"


def _code(_: Any, tokens: list[Any], index: int, *__: Any) -> str:
    return f'<pre tabindex="0"><code>{escape(tokens[index].content, quote=False)}</code></pre>\n'


def _fence(self: Any, tokens: list[Any], index: int, *_: Any) -> str:
    """A block without a name is an equation."""
    info = tokens[index].info
    return _code(self, tokens, index) if info else equations.displayed(tokens[index].content)


def filled_in(text: str) -> str:
    """Fills in points and titles of parts and default parameters: {{ points[2] }}, {{ titles[2] }},
    {{ all_points }}, {{ default.l }}. Raises UsageError for another placeholder."""
    values = {
        "points": {part.number: f"{part.points:g}" for part in parts()},
        "titles": {part.number: part.title for part in parts()},
        "all_points": f"{sum(part.points for part in parts()):g}",
        "default": defaults(),
    }
    try:
        template = Environment(undefined=StrictUndefined, keep_trailing_newline=True)
        return template.from_string(text).render(values)
    except TemplateError as error:
        raise UsageError(f"a placeholder can't be filled in: {error}") from error


def defaults() -> dict[str, str]:
    """The default parameters by name, as types.hpp sets them, the only place that does."""
    header = (CONTRACT / "bounce" / "types.hpp").read_text("utf-8")
    found = dict(re.findall(r"(?m)^  (?:double|int) (\w+) = ([^;]+);", header))
    [g] = re.findall(r"(?m)^  Vector3 g\{(\S+), (\S+), \S+\};", header)
    return found | {name: f"{float(x):g}" for name, x in zip(("g_x", "g_y"), g)}


def require_placeholders(texts: Mapping[str, str]) -> None:
    """Raises UsageError if a text of the handout says a number itself, as a translated one may. A
    part's points stand in a table, in its heading and in the sentence about the score."""
    needed = {("README.md", f"default.{name}"): 1 for name in defaults()}
    needed["README.md", "all_points"] = 1
    for part in parts():
        needed["README.md", f"points[{part.number}]"] = 3
        needed[f"include/bounce/{part.stem}.hpp", f"points[{part.number}]"] = 1
    for (name, placeholder), times in needed.items():
        if texts[name].count(f"{{{{ {placeholder} }}}}") < times:
            number = f"{{{{ {placeholder} }}}} in place of a number, {times} times"
            raise UsageError(f"student/{name} needs {number}")
