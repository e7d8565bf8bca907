"""Boxes, processes, and what they may use.

Imports: common.
"""
