"""Compiles and links a submission, and keeps its objects.

Imports: common, sandbox, submission.
"""
