"""A place below that from which something was thrown upward: it is passed only on the way down."""

from __future__ import annotations

import sympy as sp

from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.solve.between.trace.trace import MotionTrace

HEIGHT = "y_"


def only_on_the_way_back(found: MotionTrace, speed: sp.Symbol) -> Line:
    """`h/2 < h is passed only on the way down`, of the speed of a state before which it was upward at a higher place;
    nothing of other speeds, where the letters do not tell which place is lower, and of what may rise again, as on a
    spring.
    """
    stop = found.ledger.roles[speed].at
    before = found.states[: found.states.index(stop)] if stop in found.states else ()
    same = [s for s, g in found.general.items() if g == found.general[speed] and found.ledger.roles[s].at in before]
    upward = [s for s in same if (v := found.value.known(s)) is not None and v > 0]
    if not upward or found.value(speed) >= 0 or not _falls_back(found):
        return ()
    earlier = upward[-1]
    now, then = (_height(found, s) for s in (speed, earlier))
    if now is None or then is None or not found.value(then[0] - now[0]) > 0:
        return ()
    if found.symbolic and not sp.simplify(then[0] - now[0]).is_positive:
        return ()
    # A number other than 0 would hide its unit.
    below, above = (letter if height.is_number and height != 0 else height for height, letter in (now, then))
    return line(Math(below), " < ", Math(above), " is passed only on the way down")


def _falls_back(found: MotionTrace) -> bool:
    """Are all accelerations the same all the time, in a vertical plane?"""
    if len(found.regimes) > 1 or found.problem.plane == "horizontal":
        return False
    return all(rate.free_symbols.isdisjoint(found.varying) for r in found.regimes for _, rate in r.laws)


def _height(found: MotionTrace, speed: sp.Symbol) -> tuple[sp.Expr, sp.Symbol] | None:
    """How high what has a speed is in the state of that speed, by what the file says of it, and the letter of it."""
    state = found.ledger.roles[speed].at
    for regime in found.regimes:
        displacement = regime.solution.instant.scene.displacement
        coordinates = displacement.coordinates if displacement is not None else ()
        own = next((c.symbol for c in coordinates if c.speed == found.general[speed]), None)
        if own is None or not own.name.startswith(HEIGHT):
            continue
        here = (s for s, general in found.general.items() if general == own and found.ledger.roles[s].at == state)
        letter = next(here, None)
        if letter is None:
            return None
        told = found.route.plain.get(letter, found.route.formulas.get(letter, letter))
        return told if told.is_number or not told.free_symbols & set(found.general) else letter, letter
    return None
