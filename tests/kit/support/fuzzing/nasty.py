"""Pieces of C++ that attack.

A piece stands at the top of a file (`head`), in a function that each answer calls (`attack`), or in
both. Which one is drawn, and what is in it, depends on the random numbers alone.
"""

from collections.abc import Callable

from fuzzing.mutation import Random
from fuzzing.nasty_builds import assembling, burning, linking, saying
from fuzzing.nasty_runs import (
    asking,
    calling,
    crashing,
    early,
    including,
    napping,
    printing,
    stealing,
)
from fuzzing.nasty_words import Piece

Kinds = list[tuple[Callable[[Random, list[str]], Piece], int]]  # with how often each is drawn
KINDS: Kinds = [
    (saying, 14),
    (assembling, 10),
    (linking, 6),
    (stealing, 10),
    (including, 4),
    (crashing, 6),
    (printing, 8),
    (calling, 5),
    (asking, 4),
    (early, 5),
    (burning, 2),
    (napping, 1),
]
# They only say something while they are compiled, and change nothing that is linked or runs.
OF_TEXT: Kinds = [(saying, 3), (burning, 1)]
CONDITIONS = ["__SANITIZE_ADDRESS__", "__clang__", "NDEBUG", "__OPTIMIZE__", "__GNUC__"]


def some_piece(rng: Random, places: list[str], kinds: Kinds) -> Piece:
    piece = rng.choices([make for make, _ in kinds], [often for _, often in kinds])[0](rng, places)
    if rng.random() < 0.75:
        return piece
    # In one build alone; what crashes is built with sanitizers, too.
    test = f"#{rng.choice(('ifdef', 'ifdef', 'ifndef'))} {rng.choice(CONDITIONS)}\n"
    head, attack = (f"\n{test}{text}\n#endif\n" if text else "" for text in piece)
    return Piece(head, attack + rng.choice(("", "__builtin_trap();\n", "std::abort();\n")))
