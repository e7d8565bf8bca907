"""Mutation testing of the checks: every small change of the solution must lose points.

changes.py makes the changes, trial.py grades them, table.py counts, and equivalent.json says of
each change that may lose nothing why it can't be told from the solution.
"""
