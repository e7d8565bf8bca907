"""What leaves the kit: fixtures, the handout, and bundles for services.

Imports: common, grading.
"""
