"""Where a resistance that does not vanish with the speed, such as a drag of a fixed size, brings the scene to rest.

At rest it is none, and just before as large as ever. So either nothing else acts, and all stays as it is; or what else
acts is less than the resistance, which holds what it has stopped; or it is more, and the motion turns round.
"""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.motion.regime.guards import AGAIN
from planar_cli.motion.trajectory.automaton import Automaton, Guard, Regime
from planar_cli.motion.trajectory.trajectory import Outcome

MOVES = "moves"
"""The kind of the guards that look for such a stop."""
ENDS = (MOVES, AGAIN)
"""Guards that fall where a state may be reached in the same instant."""
SLOW = 1e-6
"""Speeds below this part of their scale are zero there: the direction of the resistance is all but lost."""
NOTHING = 1e-9
"""Accelerations below this part of their scale, or parts of them across the others, are zero."""

SOON = 1e-9
"""In parts of the time scale: after so long it is known which way what has turned round moves."""
State = tuple[float, ...]


def stopped(
    automaton: Automaton, regime: Regime, guards: Sequence[Guard], t: float, y: Sequence[float]
) -> State | Outcome | None:
    """The state with which the motion goes on from such a stop; or its end, where the resistance holds it. None: no
    guard that has fallen looks for one, or something else moves or varies, so that more is to be told.
    """
    half = len(y) // 2
    speeds = zip(y[half:], automaton.scale[half:], strict=True)
    if all(g.kind != MOVES for g in guards) or not automaton.autonomous or any(abs(v) > SLOW * s for v, s in speeds):
        return None
    still = (*y[:half], *(0.0 for _ in y[half:]))
    weights = [automaton.time_scale / s for s in automaton.scale[half:]]
    alone = _weighted(regime, weights, t, still)
    size = _product(alone, alone)
    if size <= NOTHING**2:
        return still
    step = SOON * automaton.time_scale
    moved = (*y[:half], *(step * a / w for a, w in zip(alone, weights, strict=True)))
    resisted = _weighted(regime, weights, t + step, moved)
    part = _product(resisted, alone) / size
    if any(abs(r - part * a) > NOTHING + SLOW * abs(a) for r, a in zip(resisted, alone, strict=True)):
        return None
    if part > 0:
        # It begins with the speed of an instant later, so that no time is left out.
        return (*y[:half], *(step * r / w for r, w in zip(resisted, weights, strict=True)))
    who = next(g.joint for g in guards if g.kind == MOVES)
    return Outcome("held", f"from t = {t:.9g} s on nothing moves: {who} resists with more than what acts", t, who)


def _weighted(regime: Regime, weights: Sequence[float], t: float, y: Sequence[float]) -> list[float]:
    """The accelerations in parts of their scales."""
    return [a * w for a, w in zip(regime.rates(t, y)[len(y) // 2 :], weights, strict=True)]


def _product(one: Sequence[float], other: Sequence[float]) -> float:
    return sum(a * b for a, b in zip(one, other, strict=True))
