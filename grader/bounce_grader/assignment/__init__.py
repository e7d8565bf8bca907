"""What is specific to this assignment: its hints and the picture of the square.

May import: common.
"""
