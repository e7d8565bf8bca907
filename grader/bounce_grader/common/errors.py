"""The errors that end a command. Each has one sentence for the user, and an exit status."""

import errno
from collections.abc import Iterator
from contextlib import contextmanager

from bounce_grader.common.escaping import printable_name


class UsageError(Exception):
    """Wrong usage, or a submission that can't be read: exit status 2."""


class KitError(Exception):
    """The kit itself failed, which says nothing about a submission: exit status 3."""


def raise_if_full(error: Exception) -> None:
    """Raises the error again if the disk is full, which is no submission's fault."""
    if isinstance(error, OSError) and error.errno == errno.ENOSPC:
        raise error


@contextmanager
def about_one_submission(failure: str) -> Iterator[None]:
    """Turns an unexpected error in work on one submission into a UsageError, so that the others go
    on; `failure` says what failed. A KitError and a full disk pass through unchanged."""
    try:
        yield
    except (UsageError, KitError):
        raise
    except Exception as error:
        raise_if_full(error)
        why = (isinstance(error, OSError) and error.strerror) or str(error)
        reason = printable_name(": ".join(filter(None, [type(error).__name__, why])))
        raise UsageError(f"{failure} ({reason}): look at its files") from error
