"""Whose submissions these are, in a download of Canvas or a folder.

Imports: common, submission.
"""
