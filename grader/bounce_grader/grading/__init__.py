"""Grades a submission into its score record, with known mistakes and speed.

Imports: assignment, build, common, sandbox, submission.
"""
