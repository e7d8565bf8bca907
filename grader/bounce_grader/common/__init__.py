"""What every room uses: errors, paths, files, escaping, numbers, drawings, a parallel map.

Imports: nothing of ours.
"""
