"""python -m mutation [FILE...]: tries every change of the solution, or of these files of it, prints
what each of them costs, and then the table."""

import sys

from bounce_grader.common.manifest import parts

from mutation.table import described, table
from mutation.trial import all_changes, outcomes

found = []
for file in sys.argv[1:] or [part.file for part in parts()]:
    of_file = outcomes(change for change in all_changes() if change.file == file)
    print(*map(described, of_file), sep="\n", flush=True)
    found += of_file
print(table(found))
