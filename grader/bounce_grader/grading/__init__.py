"""Grades a submission into its score record, with known mistakes and speed.

May import: build, common, sandbox, submission.
"""
