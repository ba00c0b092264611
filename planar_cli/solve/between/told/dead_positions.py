"""Dead positions of a mechanism by right triangles: the line of crank and rod is inclined at an acute angle φ, and from
one to the next the crank turns through an angle that is known, which at a constant rate gives the time.

sin φ_1 = e/(l - r),   θ_1 = π - φ_1,   sin φ_2 = e/(l + r),   θ_2 = 2 π - φ_2,   x = √((l ± r)² - e²)
Δθ = θ_2 - θ_1 = π + φ_1 - φ_2,   t_2 - t_1 = Δθ/ω
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.ledger import NAMED
from planar_cli.solve.between.told.links_in_line import turns_of, waves_of
from planar_cli.solve.between.trace.trace import DeadPosition, LinksInLine, MotionTrace, Request, Result, RouteStep
from planar_cli.units import parse_unit

Clock = Mapping[sp.Symbol, tuple[sp.Symbol, sp.Expr]]


def by_triangles(motion: MotionTrace) -> MotionTrace | None:
    """A motion told so; None: something else rests on the angles or the times of such positions."""
    steps = [s for s in motion.route.steps if s.in_line is not None]
    if not steps or motion.symbolic or motion.passing or motion.spans or motion.oscillations:
        return None
    clock = _clock(motion, [s.in_line.first for s in steps if s.in_line is not None])
    positions = _positions(motion, steps) if len(clock) == len(steps) and _one_rate(clock) else []
    if len(positions) < len(steps):
        return None
    origin = sp.Dummy(real=True)
    put = {**_times(positions, clock, origin), **_angles(positions)}
    requests = tuple(replace(r, parts=tuple(_told(p, put) for p in r.parts)) for r in motion.requests)
    gone = {s for own in positions for s in (own.first, own.other)} | {*clock, origin}
    kept = [s for s in motion.route.steps if s.in_line is None and not set(s.unknowns) <= set(clock)]
    rests = {x for s in kept for x in (*s.needs, *(y for e in s.relations for y in e.residual.free_symbols))}
    asked = {x for r in requests for e in (*r.parts, *(f for _, f in r.beside)) for x in e.free_symbols}
    return None if gone & (rests | asked) else _made(motion, positions, requests, asked, set(clock))


def _made(
    motion: MotionTrace,
    positions: Sequence[LinksInLine],
    requests: tuple[Request, ...],
    asked: set[sp.Symbol],
    times: set[sp.Symbol],
) -> MotionTrace:
    told = {own.first: own.dead for own in positions if own.dead is not None}
    made = {}
    for first, dead in told.items():
        place = dead.place if dead.place is not None and dead.place.unknown in asked else None
        made[first] = replace(dead, place=place)
        for r, unit in ((dead.acute, "deg"), (dead.direction, "deg"), (place, "m"), (dead.turned, "deg")):
            if r is not None:
                motion.ledger.adopt(r.unknown, parse_unit(unit), NAMED)
    results = [r for dead in made.values() for r in _results(dead) if r is not None]
    steps = tuple(
        s if s.in_line is None else replace(s, in_line=replace(s.in_line, dead=made[s.in_line.first]))
        for s in motion.route.steps
        if not set(s.unknowns) <= times
    )
    settled = motion.route.settled | {r.unknown for r in results}
    value = motion.value.extended({r.unknown: r.value for r in results})
    return replace(motion, value=value, route=replace(motion.route, steps=steps, settled=settled), requests=requests)


def _results(dead: DeadPosition) -> tuple[Result | None, ...]:
    return dead.acute, dead.direction, dead.place, dead.turned


# --- times -----------------------------------------------------------------------------------------------------------


def _clock(motion: MotionTrace, angles: Sequence[sp.Symbol]) -> Clock:
    """By the time of such a position the angle of its crank and the constant rate, t = (θ - θ_0)/ω."""
    found: dict[sp.Symbol, tuple[sp.Symbol, sp.Expr]] = {}
    offsets: set[sp.Expr] = set()
    for step in motion.route.steps:
        formula = step.results[0].formula if len(step.results) == 1 else None
        angle = None if formula is None else next((a for a in angles if a in formula.free_symbols), None)
        if formula is not None and angle is not None:
            slope = simplified(sp.diff(formula, angle))
            offsets.add(simplified(formula - slope * angle))
            if slope != 0 and not slope.free_symbols & {*motion.general, *motion.varying}:
                found[step.results[0].unknown] = (angle, simplified(1 / slope))
    return found if len(offsets) == 1 else {}


def _one_rate(clock: Clock) -> bool:
    return len({rate for _, rate in clock.values()}) == 1


def _times(positions: Sequence[LinksInLine], clock: Clock, origin: sp.Symbol) -> dict[sp.Symbol, sp.Expr]:
    """Every time by the first one, here the letter `origin`, and the angles turned since."""
    of = {angle: (t, rate) for t, (angle, rate) in clock.items()}
    since: sp.Expr = origin
    found = {}
    for own in positions:
        t, rate = of[own.first]
        if own.dead is not None and own.dead.turned is not None:
            since += own.dead.turned.unknown / rate
        found[t] = since
    return found


# --- positions -------------------------------------------------------------------------------------------------------


def _positions(motion: MotionTrace, steps: Sequence[RouteStep]) -> list[LinksInLine]:
    """The positions with their triangles, in the order of time; fewer: a letter is taken, or an angle is not acute."""
    made: list[LinksInLine] = []
    for step in sorted(steps, key=lambda s: motion.states.index(s.relations[0].stop)):
        own = step.in_line
        assert own is not None
        dead = _again(own, made) or _first(motion, step, own)
        if dead is None:
            break
        turned = _turned(motion, dead, made, step.relations[0].stop)
        if made and turned is None:
            break
        since = motion.states[0] if not made else _state(steps, made[-1])
        made.append(replace(own, dead=replace(dead, turned=turned, since=since)))
    return made


def _state(steps: Sequence[RouteStep], own: LinksInLine) -> str:
    return next(s.relations[0].stop for s in steps if s.in_line is not None and s.in_line.first == own.first)


def _again(own: LinksInLine, made: Sequence[LinksInLine]) -> DeadPosition | None:
    """The same position some turns after an earlier one."""
    for earlier in made:
        turns = simplified((own.formula - earlier.formula) / (2 * sp.pi))
        if turns.is_Integer and own.folded == earlier.folded and earlier.dead is not None:
            return replace(earlier.dead, angle=earlier.dead.angle + 2 * turns * sp.pi, direction=None, again=True)
    return None


def _first(motion: MotionTrace, step: RouteStep, own: LinksInLine) -> DeadPosition | None:
    state, loop = step.relations[0].stop, step.relations[1].residual
    names = (f"phi__{state}", f"x__{state}")
    (asin,) = (f for f in own.formula.atoms(sp.asin) if not f.is_number)
    told = turns_of(own.formula, asin)
    assert told is not None
    turns, slope = told
    sine = asin.args[0]
    if motion.value(asin) < 0:
        # The inverse sine of an opposite comes back as a product.
        sine, slope = -sine, -slope
        asin = sp.asin(sine)
    if {*names, "phi", "x"} & {*motion.ledger.symbols, *motion.ledger.reserved} - {"x"}:
        return None
    phi, x = (sp.Symbol(name, positive=True) for name in names)
    along = sp.expand(sp.diff(loop, own.first) + sp.diff(loop, own.other))
    along = along if motion.value(along) > 0 else -along
    root = simplified(along.xreplace(waves_of(own, motion.value)))
    offset, length = sp.fraction(sp.together(sine))
    if motion.value(length) < 0:
        offset, length = -offset, -length
    acute = Result(phi, asin, motion.value(asin))
    place = Result(x, root, motion.value(along))
    angle = turns * sp.pi + slope * phi
    return DeadPosition(acute, (length, offset), place, along, angle, _direction(motion, state, angle, acute))


def _direction(motion: MotionTrace, state: str, angle: sp.Expr, acute: Result) -> Result | None:
    """θ_1 = π - φ_1: where the first link points."""
    name = f"theta__{state}"
    if {name, "theta"} & {*motion.ledger.symbols, *motion.ledger.reserved}:
        return None
    return Result(sp.Symbol(name, real=True), angle, motion.value.extended({acute.unknown: acute.value})(angle))


def _turned(motion: MotionTrace, dead: DeadPosition, made: Sequence[LinksInLine], state: str) -> Result | None:
    """Through what the crank turns since the position before; the rest of a turn where that leads back."""
    before = made[-1].dead if made else None
    if before is None:
        return None
    angle = sp.expand(dead.angle - before.angle)
    letter = sp.Symbol(f"Delta_theta__{state}", positive=True)
    known = {d.acute.unknown: d.acute.value for own in made if (d := own.dead) is not None}
    number = motion.value.extended({**known, dead.acute.unknown: dead.acute.value})(angle)
    if letter.name in motion.ledger.symbols or number <= 0:
        return None
    formula = angle
    if (last := before.turned) is not None and (rest := sp.expand(sp.sympify(last.formula) + angle)).is_number:
        formula = rest - last.unknown
    return Result(letter, formula, number)


# --- what is asked ---------------------------------------------------------------------------------------------------


def _angles(positions: Sequence[LinksInLine]) -> dict[sp.Expr, sp.Expr]:
    """The cosine of every rod by the place on the line: of x = r cos θ + l cos ψ."""
    found: dict[sp.Expr, sp.Expr] = {}
    for own in positions:
        dead = own.dead
        if dead is not None and dead.place is not None:
            cos = sp.cos(own.other)
            slope = dead.along.coeff(cos)
            if slope != 0:
                found[cos] = (dead.place.unknown - (dead.along - slope * cos)) / slope
    return found


def _told(part: sp.Expr, put: Mapping[sp.Expr, sp.Expr]) -> sp.Expr:
    found = part.xreplace(dict(put))
    return part if found == part else simplified(found)
