"""Reads a folder or an archive into the files of a submission.

May import: common, sandbox.
"""
