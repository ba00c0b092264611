"""Where "anywhere" lies: the one source of drawn numbers.

What is decided about letters (zero, sign, rank, which root) is decided at places that are drawn. All draws come from
one seed, the same in every run, so that a second seed checks what the first one decided: answers must not change.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from decimal import Decimal

USUAL = 20
_SEED = ContextVar("seed", default=USUAL)
FIGURES = 31


@contextmanager
def seeded(seed: int) -> Iterator[None]:
    """All draws come from another seed for a while."""
    token = _SEED.set(seed)
    try:
        yield
    finally:
        _SEED.reset(token)


def generator(stream: int = 0) -> random.Random:
    """Random numbers of the present seed. `stream`: those of one purpose, apart from the others."""
    return random.Random(_SEED.get() + 1000 * stream)


def fraction(draw: random.Random) -> Decimal:
    """A number from 0.1 to 1 with `FIGURES` digits, so that nothing vanishes at it by chance."""
    return Decimal(draw.randrange(10 ** (FIGURES - 1), 10**FIGURES)) / Decimal(10**FIGURES)


def anywhere(index: int = 0) -> Decimal:
    """A number of no meaning from 0.3 to 0.8, another one for every index."""
    return Decimal("0.25") + fraction(generator(100 + index)) * Decimal("0.55")
