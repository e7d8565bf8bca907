"""Makes of a Markdown file of the handout an HTML page that needs no other file and no network."""

import re
from html import escape
from pathlib import Path
from typing import Any

from markupsafe import Markup

from bounce_grader.common.manifest import parts
from bounce_grader.formats.html import fill
from bounce_grader.publish import equations

NUMBER = r"\d+(?:\.\d+)?"


def page(file: Path) -> bytes:
    """The page of a Markdown file. The pictures that it shows lie beside it, as SVG."""
    from markdown_it import MarkdownIt

    markdown = MarkdownIt("commonmark", {"html": True}).enable("table")
    markdown.add_render_rule("fence", _fence)
    markdown.add_render_rule("code_block", _code)
    markdown.add_render_rule("text", lambda _, tokens, i, *__: equations.inline(tokens[i].content))
    markdown.add_render_rule("table_open", lambda *_: '<div class="table" tabindex="0"><table>\n')
    markdown.add_render_rule("table_close", lambda *_: "</table></div>\n")
    tokens = markdown.parse(with_points(file.read_text("utf-8")))
    _number_headings(tokens)
    title = next(t.content for t in tokens if t.type == "inline")
    body = markdown.renderer.render(tokens, markdown.options, {})
    body = re.sub(
        r'<p><img src="([\w.]+)" alt="[^"]*"\s*/?></p>',
        lambda found: f"<figure>{_drawing(file.parent / found[1])}</figure>",
        body,
    )
    body = re.sub(r'href="([\w/]+)\.md"', r'href="\1.html"', body)
    if file.parent.name == "hints":  # each stage opens by itself; what ./check reads is left out
        body = re.sub(r"<p>Checks: .*?</p>", "", body, flags=re.DOTALL)
        stage = r"<h3[^>]*>(.*?)</h3>(.*?)(?=<h[23]|$)"
        body = re.sub(stage, r"<details><summary>\1</summary>\2</details>", body, flags=re.DOTALL)
    return fill("publish/handout_page.html.j2", title=title, body=Markup(body)).encode()


def _drawing(file: Path) -> str:
    return re.sub(r"\s+", " ", re.sub(r"<!--.*?-->", "", file.read_text("utf-8"), flags=re.S))


def _number_headings(tokens: list[Any]) -> None:
    """Gives each heading the name that links to it may have."""
    for opening, content in zip(tokens, tokens[1:]):
        if opening.type == "heading_open":
            words = re.findall(r"\w+", content.content.lower())
            opening.attrSet("id", "-".join(words))


def _code(_: Any, tokens: list[Any], index: int, *__: Any) -> str:
    return f'<pre tabindex="0"><code>{escape(tokens[index].content, quote=False)}</code></pre>\n'


def _fence(self: Any, tokens: list[Any], index: int, *_: Any) -> str:
    content = tokens[index].content
    is_equation = not tokens[index].info and re.search(r"[=<]", content)
    return equations.displayed(content) if is_equation else _code(self, tokens, index)


def with_points(text: str) -> str:
    """The text with the points of each part and their sum, wherever the handout or a header says
    them: "Part 2 (30 points)", the table of parts, "worth 100 points", "30, 30, 30 and 10
    points"."""
    points = [f"{part.points:g}" for part in parts()]
    for part in parts():
        own = rf"\g<1>{part.points:g}\g<2>"
        text = re.sub(rf"(\bPart {part.number}\b[^\n(]*\(){NUMBER}( points\))", own, text)
        text = re.sub(rf"(?m)^(\| {part.number} \|.*\| ){NUMBER}( \|)$", own, text)
    total = f"{sum(part.points for part in parts()):g}"
    text = re.sub(rf"(\bworth ){NUMBER}( points)", rf"\g<1>{total}\g<2>", text)
    listed = f"{', '.join(points[:-1])} and {points[-1]}"
    return re.sub(rf"(?:{NUMBER}, )+{NUMBER} and {NUMBER}( points)", rf"{listed}\g<1>", text)
