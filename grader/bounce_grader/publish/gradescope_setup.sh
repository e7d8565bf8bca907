#!/usr/bin/env bash
# Gradescope runs this once, as root, in a container of Ubuntu 22.04: it installs what the kit needs
# and builds it. The solution has to get all points here, and a known wrong program, which ./kit grades
# after each build, has to lose its own.
set -euo pipefail
cd /autograder/source
chmod +x kit run_autograder
./kit grade solution --speed --min-score 100
