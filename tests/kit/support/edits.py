"""Changes to a JSON document, written as a line."""

import copy
import json
from functools import reduce
from operator import getitem
from typing import Any


def edited(document: Any, edit: str) -> Any:
    """The document after "parts 0 points = 7"; after "parts 0 points" alone, without that."""
    path, _, value = edit.partition(" = ")
    *above, last = [int(word) if word.isdigit() else word for word in path.split()]
    changed = copy.deepcopy(document)
    holder = reduce(getitem, above, changed)
    if value:
        holder[last] = json.loads(value)
    else:
        del holder[last]
    return changed
