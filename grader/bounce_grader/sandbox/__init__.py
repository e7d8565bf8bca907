"""Boxes, processes, and limits on their resources.

Imports: common.
"""
