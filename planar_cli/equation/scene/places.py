"""Where the points are, as coordinates with their time derivatives."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from typing import Any, Protocol

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.jets import Jet, constant, magnitude
from planar_cli.equation.values.parts_of_accelerations import CORIOLIS, NORMAL, TANGENTIAL, in_letters, with_mark
from planar_cli.errors import NoValue
from planar_cli.problem.language.expression import Name, Number, Scaled, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.located import length_in
from planar_cli.records import record
from planar_cli.units import parse_unit

HALF = sp.Rational(1, 2)
MOST = 2
"""So many terms, each a length with a factor, are shorter than a name for them."""


def is_plain(value: sp.Expr) -> bool:
    """Is it r + √2 l/2 or -√3 l/2: lengths of the file with numbers for factors, which cancel against others?"""
    terms = [t.as_independent(*t.free_symbols, as_Add=False) for t in sp.Add.make_args(value)]
    return len(terms) <= MOST and all(length.is_Symbol for _, length in terms)


def is_along_one_line(value: sp.Expr) -> bool:
    """Is it e cos β + R sin β or (R + r) sin β: lengths of the file along one slope and across it? What is resolved
    along the slope gets its lengths back: x cos β - y sin β = e.
    """
    turns = value.atoms(sp.cos, sp.sin)
    angles = {f.args[0] for f in turns}
    if len(angles) != 1 or angles.pop().is_number:
        return False
    # As a sum over cos β and sin β, with lengths alone before them.
    before = [sp.factor_terms(value.coeff(f)) for f in turns]
    whole = sp.Add(*(value.coeff(f) * f for f in turns))
    lettered = all(t.free_symbols and not t.has(sp.cos, sp.sin) for b in before for t in sp.Add.make_args(b))
    return lettered and all(not longer(b, 1) for b in before) and sp.expand(value - whole) == 0


def heading(angle: Jet) -> Vec:
    """The unit vector in a direction."""
    return Vec(angle.through(sp.cos), angle.through(sp.sin))


def polar_jets(distance: Jet, angle: Jet) -> Vec:
    """A distance in a direction. What goes round and out has the parts of its acceleration, as arms have them."""
    out = heading(angle)
    plain: Vec = out * distance
    r, (rate, second), (turn, bend) = distance.value, (distance.rate, distance.second), (angle.rate, angle.second)
    if not in_letters() or rate is None or second is None or turn is None or bend is None:
        return plain
    along = second - with_mark(sp.sympify(r * turn**2), NORMAL)
    across = with_mark(sp.sympify(r * bend), TANGENTIAL) + with_mark(sp.sympify(2 * rate * turn), CORIOLIS)
    e = Vec(out.x.value, out.y.value)
    found = e * along + e.turned() * across
    return Vec(replace(plain.x, second=found.x), replace(plain.y, second=found.y))


@record
class Jets:
    """Places as Vecs of jets (problem/scene/located.py)."""

    evaluator: Evaluator
    point: Callable[[str], Vec]
    """The jets of other points."""
    decide: Callable[[], Valuation]
    """Numbers to choose between two places."""

    def value(self, side: Side) -> Jet:
        return self.evaluator.jet(side)

    def number(self, value: int) -> Jet:
        return constant(value)

    def unit_vector(self, angle: Jet) -> Vec:
        return heading(angle)

    def polar(self, distance: Jet, angle: Jet) -> Vec:
        return polar_jets(distance, angle)

    def length(self, v: Vec) -> Jet:
        return magnitude(v)

    def root(self, square: Jet) -> Jet:
        return square.power(HALF)

    def is_nothing(self, value: Jet) -> bool:
        return bool(value.value == 0)

    def apart(self, v: Vec) -> tuple[float, float] | None:
        """A difference of two places; None: a root of it is not real."""
        valuation = self.decide()
        parts = (v.x.value, v.y.value)
        try:
            same = all(valuation.is_zero(p) for p in parts)
            return (0.0, 0.0) if same else (float(valuation(parts[0])), float(valuation(parts[1])))
        except NoValue:
            return None

    def plain(self, value: Jet) -> float | None:
        """A length in m; None where letters have their part in it."""
        ledger = self.evaluator.ledger
        if value.value.free_symbols & set(ledger.letters):
            return None
        try:
            return float(self.decide()(value.value))
        except NoValue:
            return None

    def shown(self, size: float, side: Side) -> str:
        """A length in the unit in which a side is written."""
        ledger = self.evaluator.ledger
        symbols = [ledger.symbols.get(n.name) for n in walk(side) if isinstance(n, Name)]
        units = [ledger.units[s] for s in symbols if s in ledger.units]
        units += [parse_unit(n.unit) for n in walk(side) if isinstance(n, Number | Scaled) and n.unit is not None]
        return length_in(size, units, ledger.us)


class Placed(Protocol):
    """A scene whose places are expressions."""

    @property
    def bodies(self) -> Mapping[str, BodyModel]: ...
    @property
    def owners(self) -> Mapping[str, Collection[str]]: ...

    def point(self, name: str) -> Vec: ...
    def as_drawn(self, expr: Any) -> Any: ...
    def value(self, side: Side) -> sp.Expr: ...


@record
class AsDrawn:
    """A scene where the file draws it (problem/scene/relaxed.py)."""

    scene: Placed

    def place_drawn(self, name: str) -> Vec:
        place = self.scene.point(name)
        return Vec(self.scene.as_drawn(place.x), self.scene.as_drawn(place.y))

    def angle_drawn(self, body: str) -> sp.Expr:
        found: sp.Expr = self.scene.as_drawn(self.scene.bodies[body].theta)
        return found

    def value_at(self, side: Side) -> sp.Expr:
        return self.scene.value(side)

    def heading_of(self, angle: sp.Expr) -> Vec:
        return Vec(sp.cos(angle), sp.sin(angle))

    def owners_of(self, point: str) -> tuple[str, ...]:
        return tuple(self.scene.owners.get(point, ()))
