"""python -m slips: writes the tables into docs/grading.md, and prints what is falsely said."""

from bounce_grader.common.paths import ROOT
from slips.table import said, table

DOCS = ROOT / "docs" / "grading.md"
BEGIN, END = "<!-- python -m slips -->\n\n", "<!-- end -->\n"


def main() -> None:
    rows = said()
    text = DOCS.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    DOCS.write_text(before + BEGIN + table(rows) + END + rest.partition(END)[2], encoding="utf-8")
    for row in rows:
        if row.false:
            print(row.part, row.style, " and ".join(row.slips), "is taken for", *row.false)


if __name__ == "__main__":
    main()
