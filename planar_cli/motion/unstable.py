"""A state at rest in an equilibrium stays there; whether a small push would drive it away is said with how fast.

Small deviations follow δ' = A δ, hence δ ~ exp(λ t): unstable where λ > 0, with the e-folding time 1/λ.
"""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.motion.automaton import Automaton, Regime

STEP = 1e-6
"""By this part of its scale each number of the state is moved."""
GROWS = 1e-3
"""A growth over the scene's time scale below this is rounding, or a force that does not push back."""


def growth(automaton: Automaton, regime: Regime, t: float, y: Sequence[float]) -> float:
    """The largest rate at which a small deviation that the joints allow grows [1/s]; 0 where none does."""
    import numpy as np

    scale = automaton.scale
    columns = []
    for i, s in enumerate(scale):
        shifted = []
        for sign in (1, -1):
            moved = [*y]
            moved[i] += sign * STEP * s
            moved = regime.project(t, moved)
            shifted.append((moved, regime.rates(t, moved)))
        (a, f), (b, g) = shifted
        columns.append(([p - q for p, q in zip(a, b, strict=True)], [p - q for p, q in zip(f, g, strict=True)]))
    places = np.array([[x / s for x, s in zip(c[0], scale, strict=True)] for c in columns]).T
    rates = np.array([[x / s for x, s in zip(c[1], scale, strict=True)] for c in columns]).T
    # Deviations that the joints allow span the columns of `places`; on them A maps places to rates.
    u, sizes, vt = np.linalg.svd(places)
    rank = int((sizes > 1e-3 * STEP).sum())
    if rank == 0:
        return 0.0
    basis = u[:, :rank]
    inverse = vt[:rank].T / sizes[:rank]
    reduced = basis.T @ rates @ inverse
    rate = float(max(np.linalg.eigvals(reduced).real))
    return rate if rate * automaton.time_scale > GROWS else 0.0


def growth_note(automaton: Automaton, regime: Regime, t: float, y: Sequence[float]) -> str:
    """What is said of an equilibrium that is kept: "" where it is not unstable."""
    rate = growth(automaton, regime, t, y)
    if not rate:
        return ""
    return (
        f"at t = {t:.9g} s it is at rest in an unstable equilibrium and stays there; "
        f"a small deviation grows by the factor e in {1 / rate:.6g} s"
    )
