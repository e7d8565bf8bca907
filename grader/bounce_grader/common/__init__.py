"""Shared by all packages: errors, paths, files, escaping, numbers, drawings, a parallel map.

May import: nothing of this package.
"""
