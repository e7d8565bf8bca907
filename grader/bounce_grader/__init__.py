"""The command ./kit: grades submissions of the bouncing assignment. docs/architecture.md describes
its packages, and says what each may import."""

import os
import sys

__version__ = "0.1.0"

# Bytecode goes to the build folder, also from the processes that the kit starts.
sys.pycache_prefix = os.path.abspath(f"{__file__}/../../../build/kit/python")
