"""Texts that try to act as markup, formulas or commands."""

import re

from hypothesis import strategies as st

# Characters with a special meaning somewhere, which are drawn often.
SPECIAL = (
    ["\x1b[2J", "\x9b31m", "\x00", "\r", "\r\n", "\n", "\t", "\x07", "\x7f", "\x85", "\ufffe"]
    + ["\u2028", "\u202e", "\u2066", "\ud800", "\udcff", "é", "e\u0301", "界", "\U0001f4a5", " "]
    + ["<script>", "</b>", "&amp;", "&#0;", "]]>", "<!--", '"', "'", "`", "``", "|", "\\", "\\|"]
    + ["=1+1", "+", "-", "@", ";", ",", "＝", "[bold]", "[/]", "::", "##[", "::error::", "%0A"]
    + ["\n::x::", "##[group]"]
    + ["https://x.example", "@user", "#1", "*", "_", "~", "![a](b)", "--"]
)
TEXTS = st.lists(st.sampled_from(SPECIAL) | st.characters() | st.text(max_size=5)).map("".join)


def commands_in(log: str) -> list[str]:
    """The lines that GitHub's runner takes for commands where they are printed: those that begin
    with "::", and those with "##[" anywhere; with a name between, Azure's."""
    lines = re.split("[\r\n]", log)
    return [line for line in lines if line.strip().startswith("::") or re.search(r"##\w*\[", line)]


def runner_commands(log: str) -> list[tuple[str, dict[str, str], str]]:
    """As actions/runner reads them (ActionCommand.TryParseV2): "::name k=v,k=v::data"."""

    def unescaped(escaped: str, *codes: str) -> str:
        for code in (*codes, "%0D", "%0A", "%25"):
            escaped = escaped.replace(code, chr(int(code[1:], 16)))
        return escaped

    found = []
    for line in log.split("\n"):
        match = re.fullmatch(r"::(\w+) ?([^:]*)::(.*)", line)
        assert match, line
        pairs = (pair.split("=", 1) for pair in match[2].split(",") if pair)
        where = {name: unescaped(value, "%3A", "%2C") for name, value in pairs}
        found.append((match[1], where, unescaped(match[3])))
    return found
