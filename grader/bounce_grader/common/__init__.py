"""What every room uses: errors, paths, files, escaping, a parallel map.

Imports: nothing of ours.
"""
