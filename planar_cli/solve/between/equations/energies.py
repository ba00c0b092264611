"""What the energies of a balance are made of, in letters of its states: speeds, heights and stretches with names.

T = m v_G²/2 + I ω²/2        U = m g (y_1 - y_2)        U = k (s_1² - s_2²)/2
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.system.led import rolls, root_edge
from planar_cli.equation.values.exact import Valuation
from planar_cli.principles.base import EnergyParts, Moving, Storage, Stored
from planar_cli.solve.between.equations.balances import StateBalance
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop

CENTRE = " is the instantaneous centre of "
SEVERAL = 3
"""Of fewer equal bodies the common mass centre is not looked at."""


def energy_parts(course: StatedMotion, b: StateBalance, value: Valuation) -> EnergyParts | None:
    """The parts of a balance of energies; None: of another amount. `value`: numbers of everything."""
    if not b.law.moving:
        return None
    acting = _acting(course, b)
    own = (_with_reason(m, acting[-1], b.stop, value) for m in b.law.moving)
    moving = tuple(_at(m, partial(_place, acting[-1], b, m.body)) for m in own)
    found = []
    for words, brought in b.brought:
        # What ends on the way is no source of the last regime.
        for regime in reversed(acting):
            stored = _stored(course, regime, b, words)
            if stored is not None:
                found += _storage(words, brought, stored, regime, b, value)
                break
    return EnergyParts(moving, tuple(found), tuple(_midway(acting[-1], b.stop, value)))


def _place(regime: Regime, b: StateBalance, body: str, expr: sp.Expr) -> sp.Expr:
    """A quantity of a body at the end of a balance, by what is given where its amount is told so."""
    found, given = b.stop.at(regime.closed(expr)), b.given.get(body)
    return found if given is None else simplified(found.xreplace(dict(given)))


def _midway(regime: Regime, stop: Stop, value: Valuation) -> Iterator[tuple[tuple[str, ...], str]]:
    """Between which points of the file the common mass centre of several equal bodies lies halfway."""
    scene = regime.general.trial.system.scene
    masses = [b.mass for b in scene.bodies.values() if b.rigid]
    for mass in dict.fromkeys(m for m in masses if masses.count(m) >= SEVERAL):
        own = [name for name, b in scene.bodies.items() if b.rigid and b.mass == mass]
        centres = [scene.bodies[name].center for name in own]
        x, y = (2 * sp.Add(*(getattr(c, axis) for c in centres)) / len(own) for axis in ("x", "y"))
        for (one, a), (two, b) in combinations(scene.points.items(), 2):
            apart = [stop.at(regime.closed(e)) for e in (a.x + b.x - x, a.y + b.y - y)]
            if {one, two} <= scene.owners.keys() and all(map(value.vanishes, apart)):
                yield tuple(own), f"midway between {one} and {two}"
                break


def _acting(course: StatedMotion, b: StateBalance) -> tuple[Regime, ...]:
    """The regimes between the states of a balance."""
    names = [s.name for s in course.states]
    return tuple(course.regimes[names.index(b.since.name) : names.index(b.stop.name)])


def _with_reason(m: Moving, regime: Regime, stop: Stop, value: Valuation) -> Moving:
    """With why its mass centre has its velocity; of a point that rests there alone also what velocity it has."""
    why = _why(m, regime, stop, value)
    point, centre, _ = why.partition(CENTRE)
    system = regime.general.trial.system
    if not centre or why == m.why or system.motion is None:
        return replace(m, why=why)
    v = system.motion.velocity(system.scene.point(point), m.body)
    speeds = [e for e in (simplified(regime.closed(v.x)), simplified(regime.closed(v.y))) if e != 0]
    return replace(m, why=why, resting=(point, speeds[0]) if len(speeds) == 1 else None)


def _why(m: Moving, regime: Regime, stop: Stop, value: Valuation) -> str:
    """Why a mass centre has its velocity; of what hangs on a wheel that rolls, its own instantaneous centre first."""
    system = regime.general.trial.system
    edge = root_edge(system, m.body)
    hangs = edge is not None and edge.body != m.body and not rolls(system, m.body)
    return m.why if m.why and not hangs else centre_of(m, regime, stop, value) or m.why


def centre_of(m: Moving, regime: Regime, stop: Stop, value: Valuation) -> str:
    """The point of a turning body that is at rest in the state, in words; "": it has none, or does not turn there."""
    system = regime.general.trial.system
    motion, scene = system.motion, system.scene

    def rests(*speeds: sp.Expr) -> bool:
        return all(value.vanishes(stop.at(regime.closed(e))) for e in speeds)

    if motion is None or m.inertia == 0 or rests(m.omega):
        return ""
    for point, owners in scene.owners.items():
        if m.body in owners and point != m.center:
            v = motion.velocity(scene.point(point), m.body)
            if rests(v.x, v.y):
                return f"{point}{CENTRE}{m.body}"
    return ""


def _stored(course: StatedMotion, regime: Regime, b: StateBalance, words: str) -> Stored | None:
    """What the potential of a source is made of, in one regime of a balance."""
    offered = (o.balance for o in course.between.offered.get(id(regime), []))
    sources = (s for balance in offered if balance.words == b.law.words for s in balance.sources)
    return next((s.stored for s in sources if s.words == words and s.stored is not None), None)


def _at(m: Moving, place: Callable[[sp.Expr], sp.Expr]) -> Moving:
    mass, inertia, vx, vy, omega = (place(e) for e in (m.mass, m.inertia, m.vx, m.vy, m.omega))
    return replace(
        m, mass=mass, inertia=inertia, vx=vx, vy=vy, omega=omega, place=tuple(place(sp.sympify(e)) for e in m.place)
    )


def _storage(
    words: str, brought: sp.Expr, s: Stored, regime: Regime, b: StateBalance, value: Valuation
) -> list[Storage]:
    """Where it gives what was brought; a spring that is free at one end has no stretch there."""
    measure, factor = regime.closed(s.measure), regime.closed(s.factor)
    first, last = b.since.at(measure), b.stop.at(measure)
    for ends in ((first, last), (sp.S.Zero, last), (first, sp.S.Zero)) if s.power == 2 else ((first, last),):
        found = Storage(words, factor, *ends, s.power, s.letter)
        letters = found.brought.free_symbols - brought.free_symbols
        if all(value.known(x) is not None for x in letters) and value.is_zero(brought - found.brought):
            return [found]
    return []


def impulse_integral(course: StatedMotion, b: StateBalance) -> sp.Expr | None:
    """∫ΣF dt or ∫ΣM dt between two states, where what acts varies with time alone."""
    t = course.ledger.symbols["t"]
    rate = sp.Add(*(s.rate for s in b.law.sources))
    letters = set(rate.free_symbols)
    if t not in letters and not b.law.letter:
        # A letter of its own may stand for a law of time: a table.
        letters = {s for r in _acting(course, b) for s in r.closed(rate).free_symbols}
    if b.law.letter or t not in letters or any(s in letters for s in b.stop.letters if s != t):
        return None
    return sp.Integral(rate, (t, b.since.t, b.stop.t))
