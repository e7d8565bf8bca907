import os
import sys

from bounce_grader.cli import main

status = main(sys.argv[1:])
if sys.argv[1:2] == ["grade"]:
    os._exit(status)  # a grading leaves nothing behind; to tidy up all the same takes 20 ms
sys.exit(status)
