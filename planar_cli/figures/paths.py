"""The way of a mass centre from one state of a motion to the next, where the motion tells it: by the one coordinate on
which it rests, by rates that are the same all the time or rest on the time alone, or as the motion was followed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.errors import PlanarError
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.shapes import moved
from planar_cli.figures.smooth import smooth
from planar_cli.motion.regime.regime import Regime
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.document.marks import Spot
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace

if TYPE_CHECKING:
    from planar_cli.equation.scene.scene import Scene
    from planar_cli.simulate.measures import Several
    from planar_cli.simulate.run import Run
    from planar_cli.solve.law import Law

Axis = Callable[[float], float | None]

STEPS = 32
CLOSE = 1e-6
"""A way ends where the body is drawn, in parts of how far it is from the pole."""
AROUND = math.radians(60)
"""A curve that rests on an angle is drawn so far on either side."""


def path_of(motion: MotionTrace, run: Run | None, body: str, since: str, until: str) -> tuple[Spot, ...]:
    """Places along the way, m; none: nothing tells it."""
    for regime in motion.regimes:
        if (since, until) in regime.stretches:
            found = _by_coordinate(motion, regime, body, since, until)
            return found or _by_rates(motion, regime, body, since, until) or followed_path(run, body, since, until)
    return ()


def curve_of(drawn: Drawn, name: str) -> tuple[Spot, ...]:
    """The curve on which a particle is by a formula of one angle of the file, on both sides of where it is drawn; none:
    it is on none.
    """
    scene, center = drawn.scene, _place(drawn.scene, name)
    known = scene.ledger.values
    place = Vec(*(e.xreplace({s: known[s] for s in e.free_symbols & known.keys()}) for e in (center.x, center.y)))
    own = {c.name for c in scene.problem.coordinates}
    angles = {s for e in (place.x, place.y) for s in e.free_symbols if s.name in own and scene.ledger.units[s].angle}
    middle = drawn.number(angle) if len(angles) == 1 and (angle := angles.pop()) else None
    if middle is None:
        return ()

    def there(share: float) -> Spot | None:
        way = middle + AROUND * (2 * share - 1)
        return Drawn(scene, drawn.value, {angle: sp.Rational(f"{way:.9g}")}).spot(place)

    return smooth(there, STEPS)


def course_of(drawn: Drawn, name: str) -> tuple[Spot, ...]:
    """The way of a point whose coordinates, or distance from another one and direction, are formulas of the time, from
    t = 0 to the instant that is drawn; none: the file has no such formulas.
    """
    scene, laws = drawn.scene, _laws_of_place(drawn, name)
    clock, now = scene.ledger.symbols.get("t"), drawn.spot(_place(scene, name))
    end = drawn.number(clock) if clock is not None else None
    for (pole, polar), sides in laws.items():
        center = drawn.spot(scene.points[pole]) if pole in scene.points else None if pole else (0.0, 0.0)
        if len(sides) < 2 or center is None or now is None or not end or clock is None:
            continue
        told = Vec(*(scene.value(side) for _, side in sorted(sides.items())))
        found = smooth(_Formulas(drawn, clock, end, told, center, polar), STEPS)
        if found and math.dist(found[-1], now) < CLOSE * max(math.dist(center, now), CLOSE):
            return found
    return ()


@record
class _Formulas:
    """Places by formulas of the time: coordinates, or (`polar`) the direction from the centre and the distance."""

    drawn: Drawn
    clock: sp.Symbol
    end: float
    told: Vec
    center: Spot
    polar: bool

    def __call__(self, share: float) -> Spot | None:
        here = {self.clock: sp.Rational(f"{self.end * share:.9g}")}
        one, other = (self.drawn.number(e.xreplace(here)) for e in (self.told.x, self.told.y))
        if one is None or other is None:
            return None
        return moved(self.center, one, other) if self.polar else (self.center[0] + one, self.center[1] + other)


def pole_of(drawn: Drawn, name: str) -> Spot | None:
    """The point from which the file tells the distance and the direction of another one by formulas; None: it does
    not.
    """
    poles = [pole for (pole, polar), sides in _laws_of_place(drawn, name).items() if polar and len(sides) > 1]
    return next((drawn.spot(drawn.scene.points[p]) if p in drawn.scene.points else (0.0, 0.0) for p in poles), None)


def _laws_of_place(drawn: Drawn, name: str) -> dict[tuple[str, bool], dict[str, Side]]:
    """The formulas of where a point is, seen from another one (""; from the origin), by their parts; True: polar."""
    found: dict[tuple[str, bool], dict[str, Side]] = {}
    for law in drawn.scene.problem.motion:
        told = law.statement
        left = told.left if isinstance(told, Relation) and told.operator == "=" else None
        if not isinstance(told, Relation) or not isinstance(left, Quantity) or left.things[:1] != (name,):
            continue
        part = left.word if left.word in ("x", "y") else left.parts[0].kind if left.word == "r" and left.parts else ""
        if part in ("x", "y", "mag", "angle"):
            pole = left.things[1] if len(left.things) > 1 else ""
            found.setdefault((pole, part in ("mag", "angle")), {})[part] = told.right
    return found


def _place(scene: Scene, name: str) -> Vec:
    return scene.bodies[name].center if name in scene.bodies else scene.points[name]


def _at(motion: MotionTrace, general: sp.Symbol, state: str) -> sp.Symbol | None:
    return next((x for x, g in motion.general.items() if g == general and motion.ledger.roles[x].at == state), None)


def value_in(motion: MotionTrace, general: sp.Symbol, state: str) -> float | None:
    """What a coordinate or speed is in a state."""
    own = _at(motion, general, state)
    found = motion.value.known(own) if own is not None else None
    return None if found is None else float(found)


def _time(motion: MotionTrace) -> sp.Symbol | None:
    return next((g for g in motion.general.values() if g.name == "t"), None)


def _by_coordinate(motion: MotionTrace, regime: RegimeTrace, body: str, since: str, until: str) -> tuple[Spot, ...]:
    scene = regime.solution.instant.scene
    center = _place(scene, body)
    moving = (sp.sympify(center.x).free_symbols | sp.sympify(center.y).free_symbols) & set(motion.general.values())
    if len(moving) != 1:
        return ()
    (q,) = moving
    first, last = value_in(motion, q, since), value_in(motion, q, until)
    if first is None or last is None:
        return ()

    def there(share: float) -> Spot | None:
        way = first + (last - first) * share
        return Drawn(scene, motion.value, {q: sp.Rational(f"{way:.9g}")}).spot(center)

    return smooth(there, STEPS)


def _by_rates(motion: MotionTrace, regime: RegimeTrace, body: str, since: str, until: str) -> tuple[Spot, ...]:
    laws = {law.coordinate.symbol: law for a, b, told in motion.stretches if (a, b) == (since, until) for law in told}
    center = _place(regime.solution.instant.scene, body)
    x, y = (_axis(motion, laws, sp.sympify(place), since, until) for place in (center.x, center.y))
    return () if x is None or y is None else smooth(lambda share: _both(x(share), y(share)), STEPS)


def _both(x: float | None, y: float | None) -> Spot | None:
    return None if x is None or y is None else (x, y)


def _axis(motion: MotionTrace, laws: dict[sp.Symbol, Law], place: sp.Expr, since: str, until: str) -> Axis | None:
    """One coordinate of a mass centre at each share of the time."""
    if not place.free_symbols & set(motion.general.values()):
        fixed = motion.value.known(place)
        return None if fixed is None else lambda _: float(fixed)
    clock = _time(motion)
    if place not in laws or clock is None:
        return None
    times, ends = ([value_in(motion, s, state) for state in (since, until)] for s in (clock, place))
    if None in times or None in ends:
        return None
    (begin, end), (first, last) = ([v for v in pair if v is not None] for pair in (times, ends))
    law = laws[place]
    rests = _rests(motion, law, since, until)
    rate = sp.S.Zero if law.order == 1 else motion.value.known(law.f)
    if not rests and rate is not None:
        bend = float(rate) * (end - begin) ** 2 / 2
        return lambda s: first + (last - first) * s + bend * (s * s - s)
    if law.order == 1 and rests == {clock}:
        return _Summed(motion, law, clock, (begin, end), {0.0: first})
    return None


def _rests(motion: MotionTrace, law: Law, since: str, until: str) -> set[sp.Basic]:
    """What varies between two states, of what a rate is a formula of."""
    found = law.f.free_symbols & (motion.varying | set(motion.general.values()) | {law.v})
    same = {s for s in found if s.name != "t" and value_in(motion, s, since) == value_in(motion, s, until) is not None}
    return set(found - same) if law.order == 1 else set(found)


@record
class _Summed:
    """A coordinate whose rate rests on the time alone, by Simpson's rule. `known`: what it is at some shares, its begin
    among them.
    """

    motion: MotionTrace
    law: Law
    clock: sp.Symbol
    span: tuple[float, float]
    known: dict[float, float | None]

    def __call__(self, share: float) -> float | None:
        since = max(s for s in self.known if s <= share)
        at = self.known[since]
        pieces = math.ceil((share - since) * STEPS - CLOSE)
        for i in range(pieces):
            one, other = (since + (share - since) * k / pieces for k in (i, i + 1))
            rates = [self._rate(one), self._rate((one + other) / 2), self._rate(other)]
            a, b, c = (math.nan if r is None else r for r in rates)
            at = None if at is None or None in rates else at + (other - one) * self._length * (a + 4 * b + c) / 6
        self.known[share] = at
        return at

    @property
    def _length(self) -> float:
        return self.span[1] - self.span[0]

    def _rate(self, share: float) -> float | None:
        now = sp.Rational(f"{self.span[0] + self._length * share:.12g}")
        found = self.motion.value.known(self.law.f.subs(self.clock, now))
        return None if found is None else float(found)


def followed_path(run: Run | None, body: str, since: str, until: str) -> tuple[Spot, ...]:
    """As the motion was followed in numbers."""
    if run is None:
        return ()
    course, states = run.trajectory, [s.name for s in run.problem.states]
    begin, end = (
        course.t0 if name == states[0] else e.t if (e := course.event(name)) else None for name in (since, until)
    )
    if begin is None or end is None or not course.segments:
        return ()
    place = Quantity("r", (body,), None, (), None, run.problem.states[0].mark)
    told: dict[int, Several] = {}

    def there(share: float) -> Spot | None:
        t = begin + (end - begin) * share
        k, segment = next(((k, s) for k, s in enumerate(course.segments) if s.t0 <= t <= s.t1), (0, None))
        if segment is None or not isinstance(segment.regime, Regime):
            return None
        told[k] = told.get(k) or run.measures.several((place,), segment.regime)
        # What is wound up on a drum rests on all that has been before.
        run.measures.wind(t)
        ((x, y),) = told[k](t, segment.at(t))
        return x, y

    try:
        return smooth(there, STEPS) if all(isinstance(s.regime, Regime) for s in course.segments) else ()
    except (PlanarError, ArithmeticError):
        return ()
