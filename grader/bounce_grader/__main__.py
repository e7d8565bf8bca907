import os
import sys

from bounce_grader.cli import main

status = main(sys.argv[1:])
if sys.argv[1:2] == ["grade"]:
    os._exit(status)  # a grading leaves nothing to clean up, and Python's own clean-up takes 20 ms
sys.exit(status)
