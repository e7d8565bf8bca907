"""Makes the distribution's Python packages importable; ./kit starts Python without them, as it
explains."""

import sys


def find_installed() -> None:
    """Makes them importable from here on."""
    if sys.flags.no_site:
        import site

        site.main()
