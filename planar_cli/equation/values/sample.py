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
APART = 17
"""Seeds that are taken one after the other are so far apart."""


_WIDE = ContextVar("wide", default=False)
NEAR, WIDE, FURTHER = 6, 18, 48
"""So many draws of letters of like size are looked at, and so many of all sizes, where something more is asked; and so
many again of like size.
"""


@contextmanager
def seeded(seed: int, wide: bool = False) -> Iterator[None]:
    """All draws come from another seed for a while. `wide`: letters are not of like size, but from some decades."""
    tokens = _SEED.set(seed), _WIDE.set(wide)
    try:
        yield
    finally:
        _SEED.reset(tokens[0])
        _WIDE.reset(tokens[1])


def widely() -> bool:
    """Are letters drawn from some decades?"""
    return _WIDE.get()


def other_draws() -> tuple[tuple[int, bool], ...]:
    """The present seed and whether it draws widely, and others for draws of which something more is asked."""
    own = _SEED.get()
    near = [(own + APART * k, False) for k in range(1, NEAR)]
    return ((own, _WIDE.get()), *near, *((own + APART * k, True) for k in range(NEAR, NEAR + WIDE)))


def further_draws() -> tuple[tuple[int, bool], ...]:
    """More draws of letters of like size, where looking at one costs little: of a window that few of them meet."""
    begun = NEAR + WIDE
    return tuple((_SEED.get() + APART * k, False) for k in range(begun, begun + FURTHER))


def generator(stream: int = 0) -> random.Random:
    """Random numbers of the present seed. `stream`: those of one purpose, apart from the others."""
    return random.Random(_SEED.get() + 1000 * stream)


def fraction(draw: random.Random) -> Decimal:
    """A number from 0.1 to 1 with `FIGURES` digits, so that nothing vanishes at it by chance."""
    return Decimal(draw.randrange(10 ** (FIGURES - 1), 10**FIGURES)) / Decimal(10**FIGURES)


def anywhere(index: int = 0) -> Decimal:
    """A number of no meaning from 0.3 to 0.8, another one for every index."""
    return Decimal("0.25") + fraction(generator(100 + index)) * Decimal("0.55")
