"""From a submission to its record, with known mistakes and speed.

Imports: assignment, build, common, sandbox, submission.
"""
