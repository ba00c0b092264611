"""A state at rest in an equilibrium stays there; whether a small push would drive it away is said with how fast.

Small deviations follow δ' = A δ, hence δ ~ exp(λ t): unstable where λ > 0, with the e-folding time 1/λ.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.motion.trajectory.automaton import Automaton, Regime

STEP = 1e-6
"""By this part of its scale each number of the state is moved."""
GROWS = 1e-3
"""A growth over the scene's time scale below this is rounding, or a force that does not push back."""
DEPENDENT = 1e-3
"""Directions in which deviations go by less than this part of a step are none: the joints forbid them."""

Vector = list[float]


def growth(automaton: Automaton, regime: Regime, t: float, y: Sequence[float]) -> float:
    """The largest rate at which a small deviation that the joints allow grows [1/s]; 0 where none does."""
    # It takes as long to import as many a motion takes to follow, and few end in an equilibrium.
    import numpy as np

    # Beside a place where the joints end, a deviation may have no value.
    found = [(p, r) for p, r in _deviations(automaton.scale, regime, t, y) if all(map(math.isfinite, (*p, *r)))]
    if not found:
        return 0.0
    places, rates = (np.array(rows).T for rows in zip(*found, strict=True))
    basis, sizes, shares = np.linalg.svd(places)
    count = int(np.sum(sizes > DEPENDENT))
    matrix = basis[:, :count].T @ rates @ shares[:count].T / sizes[:count]
    rate = float(max(np.linalg.eigvals(matrix).real, default=0.0))
    return rate if rate * automaton.time_scale > GROWS else 0.0


def _deviations(
    scale: Sequence[float], regime: Regime, t: float, y: Sequence[float]
) -> Iterator[tuple[Vector, Vector]]:
    """Small deviations that the joints allow, one for each number of the state, and their rates, in parts of the
    scales.
    """
    for i, s in enumerate(scale):
        shifted = []
        for sign in (1, -1):
            moved = [*y]
            moved[i] += sign * STEP * s
            moved = regime.project(t, moved)
            shifted.append((moved, regime.rates(t, moved)))
        (a, f), (b, g) = shifted
        yield (
            [(p - q) / (STEP * r) for p, q, r in zip(a, b, scale, strict=True)],
            [(p - q) / (STEP * r) for p, q, r in zip(f, g, scale, strict=True)],
        )


def growth_note(automaton: Automaton, regime: Regime, t: float, y: Sequence[float]) -> str:
    """What is said of an equilibrium that is kept: "" where it is not unstable."""
    rate = growth(automaton, regime, t, y)
    if not rate:
        return ""
    return (
        f"at t = {t:.9g} s it is at rest in an unstable equilibrium and stays there; "
        f"a small deviation grows by the factor e in {1 / rate:.6g} s"
    )
