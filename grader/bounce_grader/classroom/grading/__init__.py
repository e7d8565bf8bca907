"""Grades each submission of a class once, on any engine, and finds near-copies.

May import: classroom.intake, common, grading, sandbox, submission.
"""
