"""Grades submissions of the bouncing assignment."""

__version__ = "0.1.0"
