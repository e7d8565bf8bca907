"""Shared by all packages: errors, paths, files, escaping, numbers, drawings, a parallel map.

Imports: nothing of ours.
"""
