"""python -m mutation [FILE...]: tries every change of these files of the solution or of another
style (part3_step.cpp, vectors_and_algorithms/part1_contacts.cpp), and prints what each costs.
Without FILE, of all of them. The last line counts them."""

import sys

from bounce_grader.common.manifest import parts

from mutation.table import described, summary
from mutation.trial import changes_of, files_of_styles, outcomes


def main() -> None:
    found = []
    for file in sys.argv[1:] or [*(part.file for part in parts()), *files_of_styles()]:
        of_file = outcomes(changes_of(file))
        print(*map(described, of_file), sep="\n", flush=True)
        found += of_file
    print(summary("all", found))


if __name__ == "__main__":
    main()
