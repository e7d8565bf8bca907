import signal
import sys

from bounce_grader.cli import main

signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that no file is left half-written
sys.exit(main(sys.argv[1:]))
