"""Reads a folder or a zip into the files of a submission.

Imports: common, sandbox.
"""
