"""Finds the students' submissions in a download from Canvas or a folder.

Imports: common, submission.
"""
