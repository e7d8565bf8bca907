"""Measured impacts and drops: what is extracted from them, and which laws they obey."""
