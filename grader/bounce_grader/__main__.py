import sys

from bounce_grader.cli import main

sys.exit(main(sys.argv[1:]))
