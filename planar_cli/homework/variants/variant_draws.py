"""Which values the given names have in each variant: drawn by a seed, all different, the same in every run."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Sequence

from planar_cli.problem.sections.variations import Variation
from planar_cli.records import record

ALL_AT_ONCE = 20_000
"""So many combinations are shuffled; of more, some are drawn."""


@record
class Draw:
    """One combination: names with their values, as a file writes them."""

    values: tuple[tuple[str, str], ...]


def draws(variations: Sequence[Variation], seed: str) -> Iterator[Draw]:
    """All combinations in an order that the seed tells; of very many, ones that are drawn, each once."""
    rng = random.Random(seed)
    sizes = [max(len(v.values), 1) for v in variations]
    total = math.prod(sizes)
    if total <= ALL_AT_ONCE:
        order = list(range(total))
        rng.shuffle(order)
        for number in order:
            yield _drawn(variations, sizes, number)
        return
    seen: set[int] = set()
    while len(seen) < ALL_AT_ONCE:
        number = rng.randrange(total)
        if number not in seen:
            seen.add(number)
            yield _drawn(variations, sizes, number)


def _drawn(variations: Sequence[Variation], sizes: Sequence[int], number: int) -> Draw:
    values = []
    for variation, size in zip(variations, sizes, strict=True):
        number, place = divmod(number, size)
        if variation.values:
            values.append((variation.name, variation.values[place]))
    return Draw(tuple(values))
