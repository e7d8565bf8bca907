"""Writes what is published: fixtures, the handout, and bundles for services.

May import: common, formats, grading.
"""
