"""What is particular to this assignment: its hints and the picture of the square.

Imports: common.
"""
