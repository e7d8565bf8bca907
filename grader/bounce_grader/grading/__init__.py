"""Grades a submission into its score record, with known mistakes and speed.

May import: assignment, build, common, sandbox, submission.
"""
