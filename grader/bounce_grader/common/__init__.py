"""Shared by all packages: errors, paths, files, escaping, numbers, a parallel map.

May import: nothing of this package.
"""
