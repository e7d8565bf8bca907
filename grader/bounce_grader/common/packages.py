"""Python packages of the distribution, which ./kit starts without: see there."""

import sys


def find_installed() -> None:
    """From here on they can be imported."""
    if sys.flags.no_site:
        import site

        site.main()
