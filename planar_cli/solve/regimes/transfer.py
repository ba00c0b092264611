"""What one regime takes over from another: letters that it does not have itself, read in its own motion.

A speed of another regime is what the motion makes of it, a place of another regime where the bodies then are; what does
not move here stays as it is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.general import General
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.speed_transfer import edges_of, transferred_speed
from planar_cli.solve.regimes.timeline import Stop

Transfer = Mapping[sp.Symbol, sp.Expr]
"""Letters of other regimes, in the unknowns of one."""


def transfer_of(own: Regime, regimes: Sequence[Regime]) -> dict[sp.Symbol, sp.Expr]:
    """Free speeds and coordinates of all regimes that are not its own, in the motion of one of them."""
    edges = {s: e for r in regimes for s, e in edges_of(r.general.trial.system.tree).items() if s in r.free}
    motion, scene = own.general.quantities.motion, own.general.instant.scene
    speeds = {u: transferred_speed(u, e, motion, scene) for u, e in edges.items() if u not in own.letters}
    found = {u: e for u, e in speeds.items() if e is not None}
    for other in regimes:
        if other is not own:
            found |= _places(own.general, other.general)
    return found


def _places(own: General, other: General) -> dict[sp.Symbol, sp.Expr]:
    """Coordinates of another general position where the bodies are in this one; only those that vary here."""
    mine = {c.symbol for c in own.coordinates}
    found: dict[sp.Symbol, sp.Expr] = {}
    for c in other.coordinates:
        if c.symbol in mine or not c.body:
            continue
        expr = _place(c, own, other, found)
        if expr is not None and expr.free_symbols & mine:
            found[c.symbol] = expr
    return found


def _place(c: Coordinate, own: General, other: General, found: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr | None:
    """One coordinate from the place or the angle of its body, where that grows with it alone at a constant ratio."""
    mine = {x.symbol for x in own.coordinates}
    here, there = own.instant.scene.bodies[c.body], other.instant.scene.bodies[c.body]
    pairs = [(here.theta, there.theta)] if c.unit == "rad" else []
    pairs += [(here.center.x, there.center.x), (here.center.y, there.center.y)]
    for ours, other_side in pairs:
        theirs = other_side.xreplace(dict(found))
        slope = sp.diff(theirs, c.symbol)
        varying = {x.symbol for x in other.coordinates} - mine
        if slope == 0 or slope.free_symbols & (mine | varying) or theirs.free_symbols & (varying - {c.symbol}):
            continue
        return simplified((ours - theirs.subs(c.symbol, 0)) / slope)
    if c.unit != "rad":
        return None
    path = Vec(there.center.x.xreplace(dict(found)), there.center.y.xreplace(dict(found)))
    elsewhere = {x.symbol for x in other.coordinates} - mine - {c.symbol}
    return None if (path.x.free_symbols | path.y.free_symbols) & elsewhere else _round(here.center, path, c.symbol)


def _round(place: Vec, path: Vec, angle: sp.Symbol) -> sp.Expr | None:
    """The angle φ at a place of the circle r(φ): r'' = c - r, with the centre c. None: it is no circle."""
    arm = Vec(-sp.diff(path.x, angle, 2), -sp.diff(path.y, angle, 2))
    center = Vec(simplified(path.x - arm.x), simplified(path.y - arm.y))
    if angle in center.x.free_symbols | center.y.free_symbols:
        return None
    begin = Vec(arm.x.subs(angle, 0), arm.y.subs(angle, 0))
    onward = Vec(sp.diff(path.x, angle).subs(angle, 0), sp.diff(path.y, angle).subs(angle, 0))
    square = simplified(begin.dot(begin))
    if square == 0 or abs(sense := simplified(begin.cross(onward) / square)) != 1:
        return None
    reach = place - center
    found: sp.Expr = sense * sp.atan2(simplified(begin.cross(reach)), simplified(begin.dot(reach)))
    return found


def resting_equations(regime: Regime, since: Stop, stop: Stop, transfer: Transfer) -> Iterator[Equation]:
    """What moves only in other regimes stays where it is, or is told by `transfer`."""
    own = set(regime.letters)
    for letter, end in stop.letters.items():
        if letter in own:
            continue
        if transfer.get(letter, sp.S.Zero) != 0:
            words = "the same motion" if letter in stop.speeds else "the same place"
            yield Equation(end - stop.at(transfer[letter]), "handed", words, stop.name, since.name)
            continue
        # The body may well move along another coordinate: the ball slides on, and only its height stays.
        speed = letter in stop.speeds
        residual = end if speed else end - since.letters[letter]
        words = "it is zero meanwhile" if speed else "it does not change"
        yield Equation(residual, "link", words, stop.name, since.name)


def later_equations(regimes: Sequence[Regime], first: Stop, transfer: Transfer) -> Iterator[Equation]:
    """What moves only in later regimes: as drawn, and at rest; or where the first regime has it, by `transfer`."""
    own = set(regimes[0].letters)
    told: set[sp.Symbol] = set()
    for regime in regimes[1:]:
        moved: set[sp.Symbol] = set()
        for c in regime.coordinates:
            if c.symbol in transfer and c.symbol not in own:
                moved.add(c.speed)
            if c.symbol in own or c.symbol in told or c.drawn is None:
                continue
            told.add(c.symbol)
            residual = first.letters[c.symbol] - first.at(transfer.get(c.symbol, c.drawn))
            kind, words = ("handed", "the same place") if c.speed in moved else ("drawn", "as drawn")
            yield Equation(residual, kind, words, first.name)
        for u in regime.free:
            if u in own or u in told:
                continue
            told.add(u)
            if u in moved and u in transfer:
                yield Equation(first.letters[u] - first.at(transfer[u]), "handed", "the same motion", first.name)
            else:
                yield Equation(first.letters[u], "start", "it rests", first.name)
