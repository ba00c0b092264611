"""A state at rest in an equilibrium stays there; whether a small push would drive it away is said with how fast.

Small deviations follow δ' = A δ, hence δ ~ exp(λ t): unstable where λ > 0, with the e-folding time 1/λ.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from operator import mul

from planar_cli.motion.automaton import Automaton, Regime

STEP = 1e-6
"""By this part of its scale each number of the state is moved."""
GROWS = 1e-3
"""A growth over the scene's time scale below this is rounding, or a force that does not push back."""
DEPENDENT = 1e-3
"""What is left of a deviation below this part of a step depends on the others."""
TERMS, SQUARED = 20, 50
"""Of exp(A/|A|) so many terms, and so many times it is squared."""

Vector = list[float]


def growth(automaton: Automaton, regime: Regime, t: float, y: Sequence[float]) -> float:
    """The largest rate at which a small deviation that the joints allow grows [1/s]; 0 where none does."""
    rate = _largest_rate(_on_orthogonal(list(_deviations(automaton.scale, regime, t, y))))
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


def _on_orthogonal(pairs: list[tuple[Vector, Vector]]) -> list[Vector]:
    """The matrix A of q' = A q on what all places span: by Gram and Schmidt, the longest first, rates with them."""
    basis: list[tuple[Vector, Vector]] = []
    while pairs:
        place, rate = pairs.pop(max(range(len(pairs)), key=lambda k: math.hypot(*pairs[k][0])))
        size = math.hypot(*place)
        if size <= DEPENDENT:
            break
        q, f = [x / size for x in place], [x / size for x in rate]
        basis.append((q, f))
        shares = [sum(map(mul, q, place)) for place, _ in pairs]
        pairs = [(_less(p, c, q), _less(r, c, f)) for (p, r), c in zip(pairs, shares, strict=True)]
    return [[sum(map(mul, q, f)) for _, f in basis] for q, _ in basis]


def _less(a: Vector, share: float, b: Vector) -> Vector:
    return [x - share * y for x, y in zip(a, b, strict=True)]


def _largest_rate(matrix: list[Vector]) -> float:
    """The largest real part of an eigenvalue: of exp(A τ), squared again and again, the size grows with it at last."""
    norm = max((math.hypot(*row) for row in matrix), default=0.0) * math.sqrt(len(matrix))
    if norm == 0.0:
        return 0.0
    unit = [[float(i == j) for j in range(len(matrix))] for i in range(len(matrix))]
    power = term = unit
    for k in range(1, TERMS):
        term = [[x / (k * norm) for x in row] for row in _product(term, matrix)]
        power = [[x + y for x, y in zip(a, b, strict=True)] for a, b in zip(power, term, strict=True)]
    logarithm = 0.0
    for k in range(SQUARED):
        power = _product(power, power)
        size = max(math.hypot(*row) for row in power)
        power = [[x / size for x in row] for row in power]
        logarithm += math.log(size) / 2.0 ** (k + 1)
    return logarithm * norm


def _product(a: list[Vector], b: list[Vector]) -> list[Vector]:
    columns = list(zip(*b, strict=True))
    return [[sum(map(mul, row, column)) for column in columns] for row in a]


def growth_note(automaton: Automaton, regime: Regime, t: float, y: Sequence[float]) -> str:
    """What is said of an equilibrium that is kept: "" where it is not unstable."""
    rate = growth(automaton, regime, t, y)
    if not rate:
        return ""
    return (
        f"at t = {t:.9g} s it is at rest in an unstable equilibrium and stays there; "
        f"a small deviation grows by the factor e in {1 / rate:.6g} s"
    )
