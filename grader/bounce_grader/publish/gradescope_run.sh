#!/usr/bin/env bash
# Gradescope runs this for each submission. If the kit fails, it leaves no results.json; Gradescope
# then reports a failure of the autograder, and nobody gets a zero.
set -uo pipefail
cd /autograder/source
results=/autograder/results/results.json
./kit grade /autograder/submission --speed --format gradescope >"$results.part"
status=$?
# 0: graded; 2: the submission can't be read, and the file says so to the student.
if [ "$status" -ne 0 ] && [ "$status" -ne 2 ] || [ ! -s "$results.part" ]; then
  rm -f "$results.part"
  exit "$status"
fi
mv "$results.part" "$results"
