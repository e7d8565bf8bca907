"""The command ./kit: grades submissions of the bouncing assignment. Each package in here does one
job, and its docstring says what it may import; docs/architecture.md describes them."""

import os
import sys

__version__ = "0.1.0"

# Bytecode goes to the build folder, also from the processes that the kit starts.
sys.pycache_prefix = os.path.abspath(f"{__file__}/../../../build/kit/python")
