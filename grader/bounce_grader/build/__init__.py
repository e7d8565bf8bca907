"""Compiles and links a submission, and caches its object files.

May import: common, sandbox, submission.
"""
