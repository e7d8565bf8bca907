"""Grades each submission of a class once, on any engine, and finds near-copies.

Imports: classroom.intake, common, grading, sandbox, submission.
"""
