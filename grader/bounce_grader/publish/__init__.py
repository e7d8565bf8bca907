"""Writes what is published: fixtures, the handout, and bundles for services.

Imports: common, grading.
"""
