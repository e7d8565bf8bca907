"""What ends a command: each is one sentence for the user, and an exit status."""


class UsageError(Exception):
    """Wrong usage, or a submission that can't be read: exit status 2."""


class KitError(Exception):
    """The kit itself failed; it is never a verdict about a submission: exit status 3."""
