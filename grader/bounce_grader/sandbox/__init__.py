"""Boxes, processes, and limits on their resources.

May import: common.
"""
