"""Makes an HTML page of a Markdown file of the handout: one file, which needs no other and no
network."""

import re
from html import escape
from pathlib import Path
from typing import Any

from bounce_grader.publish import equations
from bounce_grader.publish.points import with_points

STYLE = """
:root { color-scheme: light dark; --ink: #1f2430; --paper: #ffffff; --soft: #f3f4f6;
  --line: #c8ccd2; --link: #1d4f8c; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e9ee; --paper: #14181f; --soft: #1f2530; --line: #3a414c; --link: #8fb8e8; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem 1.2rem 4rem; max-width: 46rem; color: var(--ink);
  background: var(--paper); font: 1rem/1.6 system-ui, sans-serif; overflow-wrap: break-word; }
h1 { line-height: 1.2; }
h2 { margin-top: 2.5rem; border-bottom: 1px solid var(--line); }
a { color: var(--link); }
code, pre { font: 0.9em/1.5 ui-monospace, monospace; background: var(--soft); border-radius: 4px; }
code { padding: 0.1em 0.3em; }
pre { padding: 0.8rem; overflow-x: auto; }
pre code { padding: 0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; }
th, td { padding: 0.3rem 0.7rem 0.3rem 0; border-bottom: 1px solid var(--line); text-align: left;
  vertical-align: top; }
.equation { display: flex; align-items: center; gap: 1rem; margin: 0.8rem 0; }
.equation > div { flex: 1; min-width: 0; overflow: auto hidden; display: flex; flex-wrap: wrap;
  justify-content: safe center; gap: 0.4rem 2.5rem; }
math { font-size: 1.1em; font-family: "STIX Two Math", "Cambria Math", "Latin Modern Math", math; }
svg, img { max-width: 100%; height: auto; }
figure { margin: 1rem 0; }
details { margin: 0.6rem 0; }
summary { cursor: pointer; font-weight: 600; }
@media print {
  :root { --ink: #000000; --paper: #ffffff; --soft: #ffffff; --line: #999999; --link: #000000; }
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  h2, h3 { break-after: avoid; }
  pre, .equation, figure, tr { break-inside: avoid; }
  pre { white-space: pre-wrap; }
}
"""


def page(file: Path) -> bytes:
    """The page of a Markdown file. The pictures that it shows lie beside it, as SVG."""
    from markdown_it import MarkdownIt

    markdown = MarkdownIt("commonmark", {"html": True}).enable("table")
    markdown.add_render_rule("fence", _fence)
    markdown.add_render_rule("text", _text)
    markdown.add_render_rule("table_open", lambda *_: '<div class="wide" tabindex="0"><table>\n')
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
    body = re.sub(r'href="([\w]+)\.md"', r'href="\1.html"', body)
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>{STYLE}</style>\n</head>\n"
        f"<body>\n<main>\n{body}</main>\n</body>\n</html>\n"
    ).encode()


def _drawing(file: Path) -> str:
    return re.sub(r"\s+", " ", re.sub(r"<!--.*?-->", "", file.read_text("utf-8"), flags=re.S))


def _number_headings(tokens: list[Any]) -> None:
    """Gives each heading the name that links to it may have."""
    for opening, content in zip(tokens, tokens[1:]):
        if opening.type == "heading_open":
            words = re.findall(r"\w+", content.content.lower())
            opening.attrSet("id", "-".join(words))


def _text(self: Any, tokens: list[Any], index: int, *_: Any) -> str:
    return equations.inline(tokens[index].content)


def _fence(self: Any, tokens: list[Any], index: int, *_: Any) -> str:
    token = tokens[index]
    is_equation = not token.info and re.search(r"[=<]", token.content)
    if not is_equation:
        return f'<pre tabindex="0"><code>{escape(token.content, quote=False)}</code></pre>\n'
    lines = [
        f'<div class="equation"><div tabindex="0">{"".join(line.mathml)}</div>'
        + (f'<span id="eq{line.number}">({line.number})</span>' if line.number else "")
        + "</div>\n"
        for line in equations.displayed(token.content)
    ]
    return "".join(lines)
