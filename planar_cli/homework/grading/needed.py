"""Of own earlier values that were put in together, those that matter."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

ROUNDED = 1e-3
"""Relative: what was typed is rounded, so that a value that follows from another differs a little from it."""


def needed(
    names: tuple[str, ...],
    due: tuple[float, ...],
    carried: Callable[[Mapping[str, tuple[float, ...]]], tuple[tuple[float, ...], tuple[str, ...]] | None],
    own: Mapping[str, tuple[float, ...]],
) -> tuple[str, ...]:
    """The own values without which the find comes to something else: where a later one of them is put in, an earlier
    one may change nothing any more.
    """
    left = list(names)
    for name in names:
        rest = [n for n in left if n != name]
        found = carried({n: own[n] for n in rest}) if rest else None
        if found is not None and all(math.isclose(a, b, rel_tol=ROUNDED) for a, b in zip(found[0], due, strict=True)):
            left = rest
    return tuple(left)
