"""Impulse and momentum between two states.

    m v_G1 + ∫F dt = m v_G2        H_O1 + ∫M_O dt = H_O2

for every body and connected group, along x and y and about every fixed point O, and about a point C of one body that
stays where it is to the mass centre (C need not be fixed: v_C and v_G are equal then, and the extra term v_C × m v_G
vanishes). Such an equation is put on paper where no unknown reaction enters it and the impulses are functions of place
and time; where they vanish, momentum is conserved. (An Introduction to Planar Dynamics, 3.4, 4.6, equations 4.68 -
4.76.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from planar_cli.equation.plain import longer, simplified
from planar_cli.problem.facts import Wrench
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND
from planar_cli.solve.course.equations import NO_MASS, Equation
from planar_cli.solve.course.general import General
from planar_cli.solve.course.potential import potential
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.course.regime_sequence import RegimeSequence
from planar_cli.solve.course.timeline import Stop

LONGEST, MOST_BODIES = 300, 6
ARROWS = {"x": "→ ", "y": "↑ "}


@dataclass(frozen=True, slots=True)
class Candidate:
    """A momentum of a group and the rate at which it changes, in the unknowns of the general position. `about`: the
    point of an angular momentum, "" of a linear one along `axis`.
    """

    bodies: tuple[str, ...]
    about: str
    axis: str
    momentum: sp.Expr
    rate: sp.Expr


@dataclass(frozen=True, slots=True)
class Integrated:
    """The same closed: the momentum, and a function of place and time of which its rate is the derivative."""

    candidate: Candidate
    momentum: sp.Expr
    function: sp.Expr


@dataclass(frozen=True, slots=True)
class Momentum:
    """One equation between two states, in their letters."""

    since: Stop
    stop: Stop
    bodies: tuple[str, ...]
    about: str
    arrow: str
    before: sp.Expr
    after: sp.Expr
    impulse: sp.Expr


def candidates_of(general: General) -> list[Candidate]:
    """All that no unknown reaction enters."""
    scene, system = general.instant.scene, general.trial.system
    if system.reactions is None or any(p.kind == "drive" for p in system.pushes):
        return []
    if any(b.varies(general.time) for b in scene.bodies.values()):
        return []
    followers = {law.push for law in system.laws}
    loose = {system.symbols[p.name] for p in system.pushes if p.name not in followers}
    acting = [w for w in system.reactions.acting("all") if w.body != GROUND]
    fixed = {n: p for n, p in scene.points.items() if not (scene.owners.get(n) or ()) or _still(p)}
    found: list[Candidate] = []
    for group in _groups(general):
        if all(scene.bodies[b].mass == 0 for b in group):
            continue
        outer = [w for w in acting if w.body in group]
        for axis, d in (("x", Vec(sp.S.One, sp.S.Zero)), ("y", Vec(sp.S.Zero, sp.S.One))):
            rate = sp.expand(sp.Add(*(w.force.dot(d) for w in outer if w.force is not None)))
            if not rate.free_symbols & loose:
                found.append(Candidate(group, "", axis, _linear(general, group, d), rate))
        centres = {**fixed, **(_own_points(general, group[0]) if len(group) == 1 else {})}
        for name, center in centres.items():
            rate = simplified(sp.expand(sp.Add(*(_moment(w, center) for w in outer))))
            if not rate.free_symbols & loose:
                found.append(Candidate(group, name, "", _angular(general, group, center), rate))
    return [c for c in found if c.momentum != 0]


def _still(place: Vec) -> bool:
    return not (place.x.free_symbols | place.y.free_symbols)


def _groups(general: General) -> list[tuple[str, ...]]:
    """Every body alone, and all together."""
    bodies = tuple(general.instant.scene.bodies)
    single: list[tuple[str, ...]] = [(b,) for b in bodies[:MOST_BODIES]]
    return [*single, bodies] if len(bodies) > 1 else single


def _own_points(general: General, body: str) -> dict[str, Vec]:
    """Points that keep their place beside the mass centre of a body that may turn."""
    scene = general.instant.scene
    center = scene.center(body)
    letters = {c.symbol for c in general.coordinates}
    found = {}
    for name, place in scene.points.items():
        arm = place - center
        if not (simplified(arm.x).free_symbols | simplified(arm.y).free_symbols) & letters:
            found[name] = place
    return found


def _moment(w: Wrench, center: Vec) -> sp.Expr:
    turning = (w.point - center).cross(w.force) if w.force is not None else sp.S.Zero
    return turning + w.couple


def _linear(general: General, group: tuple[str, ...], d: Vec) -> sp.Expr:
    scene, motion = general.instant.scene, general.quantities.motion
    return sp.Add(*(scene.bodies[b].mass * motion.velocity(scene.center(b), b).dot(d) for b in group))


def _angular(general: General, group: tuple[str, ...], center: Vec) -> sp.Expr:
    scene, motion = general.instant.scene, general.quantities.motion
    parts = []
    for b in group:
        body = scene.bodies[b]
        arm, v = body.center - center, motion.velocity(body.center, b)
        parts.append(body.mass * arm.cross(v) + body.inertia * motion.velocities[b].angular)
    return sp.Add(*parts)


def integrated(regime: Regime, candidates: Sequence[Candidate]) -> list[Integrated]:
    """Those whose rates are derivatives of functions of place and time, without repetition."""
    found: list[Integrated] = []
    seen: list[sp.Expr] = []
    for c in candidates:
        momentum = simplified(regime.closed(c.momentum))
        if momentum == 0 or longer(momentum, LONGEST) or not regime.told(momentum):
            continue
        rate = regime.closed(c.rate)
        function = potential(rate, regime) if regime.told(rate) else None
        if function is None or function.has(sp.Integral) or longer(function, LONGEST):
            continue
        law = sp.expand(momentum - function)
        if any(not (law / other).free_symbols & set(regime.letters) for other in seen if not longer(law, 60)):
            continue
        seen.append(law)
        found.append(Integrated(c, momentum, function))
    return found


def momentum_equations(course: RegimeSequence, found: Sequence[Sequence[Integrated]], k: int) -> Iterator[Equation]:
    """The equations that end at state k: from the state before it, and from where its regime began."""
    if k < 1 or course.is_impulsive(k - 1):
        return
    begins = k - 1
    while begins > 0 and not course.is_impulsive(begins - 1) and course.regimes[begins - 1] is course.regimes[k - 1]:
        begins -= 1
    for since in dict.fromkeys((k - 1, begins)):
        a, b = (course.stops[course.states[i].name] for i in (since, k))
        for item in found[k - 1]:
            c = item.candidate
            impulse = simplified(b.at(item.function) - a.at(item.function))
            told = Momentum(
                a, b, c.bodies, c.about, ARROWS.get(c.axis, ""), a.at(item.momentum), b.at(item.momentum), impulse
            )
            residual = sp.expand(told.after - told.before - impulse)
            if residual.free_symbols & set(b.letters.values()):
                words = "impulse and momentum"
                extra = NO_MASS if any(x.any_mass for x in course.problem.bodies) else 0.0
                yield Equation(residual, "momentum", words, b.name, a.name, source=told, surcharge=extra)
