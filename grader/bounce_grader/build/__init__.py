"""Compiles and links a submission, and caches its object files.

Imports: common, sandbox, submission.
"""
