"""python -m mutation [FILE...]: tries every change of these files of the solution or of another
style (part3_step.cpp, corner_in_closed_form/part1_contacts.cpp), and prints what each costs.
Without FILE, of all of them; then it writes the tables into docs/mutation.md."""

import sys

from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import ROOT

from mutation.table import described, tables
from mutation.trial import changes_of, files_of_styles, outcomes

DOCS = ROOT / "docs" / "mutation.md"
BEGIN, END = "<!-- python -m mutation -->\n\n", "<!-- end -->\n"


def main() -> None:
    found = []
    for file in sys.argv[1:] or [*(part.file for part in parts()), *files_of_styles()]:
        of_file = outcomes(changes_of(file))
        print(*map(described, of_file), sep="\n", flush=True)
        found += of_file
    if not sys.argv[1:]:
        text = DOCS.read_text(encoding="utf-8")
        before, _, rest = text.partition(BEGIN)
        after = rest.partition(END)[2]
        DOCS.write_text(before + BEGIN + tables(found) + END + after, encoding="utf-8")


if __name__ == "__main__":
    main()
