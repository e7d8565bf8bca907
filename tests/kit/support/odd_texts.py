"""Texts that try to act as markup, formulas or commands."""

import re

from hypothesis import strategies as st

# Characters with a special meaning somewhere, which are drawn often.
SPECIAL = (
    ["\x1b[2J", "\x9b31m", "\x00", "\r", "\r\n", "\n", "\t", "\x07", "\x7f", "\x85", "\ufffe"]
    + ["\u2028", "\u202e", "\u2066", "\ud800", "\udcff", "é", "e\u0301", "界", "\U0001f4a5", " "]
    + ["<script>", "</b>", "&amp;", "&#0;", "]]>", "<!--", '"', "'", "`", "``", "|", "\\", "\\|"]
    + [
        "=1+1",
        "+",
        "-",
        "@",
        ";",
        ",",
        "＝",
        "[bold]",
        "[/]",
        "::",
        "##[",
        "::error::",
        "%0A",
        "\n::x::",
        "##[group]",
    ]
    + ["https://x.example", "@user", "#1", "*", "_", "~", "![a](b)", "--"]
)
TEXTS = st.lists(st.sampled_from(SPECIAL) | st.characters() | st.text(max_size=5)).map("".join)


def commands_in(log: str) -> list[str]:
    """The lines that GitHub's runner takes for commands where they are printed: those that begin
    with "::", and those with "##[" anywhere; with a name between, Azure's."""
    lines = re.split("[\r\n]", log)
    return [line for line in lines if line.strip().startswith("::") or re.search(r"##\w*\[", line)]
