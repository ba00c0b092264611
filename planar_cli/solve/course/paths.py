"""Curves: the path of a point, also as seen from a moving point or body, and the hodograph of its velocity.

The place of the point is written with one parameter (time, or the only coordinate that varies), and the parameter is
eliminated. (An Introduction to Planar Dynamics, 1.1, 1.4.1.)
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import sympy as sp

from planar_cli.calculus.curve_words import CIRCLE, POINT, Curve
from planar_cli.calculus.curves import curve_of
from planar_cli.equation.evaluate import refuse
from planar_cli.equation.exact import Valuation
from planar_cli.equation.plain import simplified
from planar_cli.problem.expression import Quantity
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND, Find, Rod
from planar_cli.solve.course.functions import Functions, explained
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.passages import Passage, Row, told_function
from planar_cli.solve.solution import Found
from planar_cli.units import parse_unit

CURVES = ("path", "hodograph")
PATH = (("x", "y"), ("r", "theta"))
HODOGRAPH = (("v_x", "v_y"), ("v", "phi"))
PLAIN_NAMES = {"v_x": "vx", "v_y": "vy"}


def is_curve(what: object) -> bool:
    """Does a find ask for a curve?"""
    return isinstance(what, Quantity) and what.word in CURVES


@dataclass(slots=True)
class CurveReader:
    """Reads the curves that are asked of one regime whose rates are worked out. `starts`: values of t, coordinates and
    free speeds at one instant, as far as they are known.
    """

    regime: Regime
    starts: Mapping[sp.Symbol, sp.Expr]

    def answer(self, find: Find) -> tuple[Found, Passage]:
        """The curve, and how its equation was found."""
        q = find.found.what
        assert isinstance(q, Quantity)
        place = self.place(q)
        parameter, functions, exprs = self._single(find, q, place)
        axes, polar = HODOGRAPH if q.word == "hodograph" else PATH
        scene = self.regime.general.instant.scene
        varying = set(self.regime.letters)
        letters = frozenset(s for s in scene.ledger.letters if s not in varying or s != parameter)
        value = scene.valuations[0]
        curve = curve_of(exprs.x, exprs.y, parameter, value, axes, polar, letters)
        words = self._words(q, curve, value)
        heading = self._heading(q) + self._meaning(parameter, exprs)
        passage = Passage(heading, self._rows(place, functions, exprs, curve, axes))
        return self._found(find, curve, words), passage

    def _found(self, find: Find, curve: Curve, words: str) -> Found:
        equations: tuple[sp.Expr, ...] | None = None
        if curve.equation is not None:
            plain = {s: sp.Symbol(PLAIN_NAMES[s.name], real=True) for s in curve.equation.free_symbols
                     if s.name in PLAIN_NAMES}  # fmt: skip
            equations = (curve.equation.xreplace(plain),)
        named = replace(curve, kind=words, centre=None) if curve.centre is not None else curve
        return Found(find.name, "curve", parse_unit("1"), None, equations, "", find, curve=named)

    # --- places in frames --------------------------------------------------------------------------------------------

    def place(self, q: Quantity) -> Vec:
        """The point in its frame, in coordinates and t."""
        at = self._seen(self._point(q.things[0]), q)
        return Vec(simplified(at.x), simplified(at.y))

    def _point(self, name: str) -> Vec:
        scene = self.regime.general.instant.scene
        at = scene.point(name)
        return Vec(self.regime.closed(at.x), self.regime.closed(at.y))

    def frame(self, q: Quantity) -> str | None:
        """The body from which it is seen; None: it does not turn."""
        scene = self.regime.general.instant.scene
        second = q.things[1] if len(q.things) == 2 else None
        return second if second in scene.bodies and second not in scene.points else None

    def _seen(self, at: Vec, q: Quantity) -> Vec:
        """A place as the frame of a quantity sees it."""
        if len(q.things) < 2 or q.things[1] == GROUND:
            return at
        body = self.frame(q)
        if body is None:
            found: Vec = at - self._point(q.things[1])
            return found
        scene = self.regime.general.instant.scene
        shape = scene.bodies[body].shape
        reach = at - self._point(shape.start if isinstance(shape, Rod) else body)
        theta = self.regime.closed(scene.bodies[body].theta)
        c, s = sp.cos(theta), sp.sin(theta)
        return Vec(simplified(c * reach.x + s * reach.y), simplified(c * reach.y - s * reach.x))

    # --- one parameter -----------------------------------------------------------------------------------------------

    def _varying(self, at: Vec) -> list[sp.Symbol]:
        """The coordinates and t in a place, but for those that rest."""
        inside = at.x.free_symbols | at.y.free_symbols
        return [s for s in self.regime.letters if s in inside and self.regime.rates.get(s, sp.S.One) != 0]

    def _single(self, find: Find, q: Quantity, place: Vec) -> tuple[sp.Symbol, Functions, Vec]:
        """The curve in one parameter: the only coordinate; else one on which the others depend; else time."""
        hodograph = q.word == "hodograph"
        none = Functions(self.regime, self.starts)
        plain = self._velocity(place) if hodograph else place
        varying = self._varying(plain)
        if len(varying) <= 1:
            return (varying or [self.regime.time])[0], none, plain
        for kept in varying:
            if kept not in self.regime.rates:
                continue
            linked = Functions(self.regime, {}, frozenset({kept}), timed=False)
            linked.find()
            found = Vec(linked.put_in(plain.x), linked.put_in(plain.y))
            if self._varying(found) == [kept]:
                return kept, linked, Vec(simplified(found.x), simplified(found.y))
        timed = Functions(self.regime, self.starts)
        timed.find()
        found = Vec(simplified(timed.put_in(place.x)), simplified(timed.put_in(place.y)))
        if self._varying(found) in ([], [self.regime.time]):
            if hodograph:
                found = Vec(simplified(sp.diff(found.x, self.regime.time)), simplified(sp.diff(found.y, self.regime.time)))
            return self.regime.time, timed, found
        raise self._several(find, q, self._varying(found))

    def _velocity(self, place: Vec) -> Vec:
        return Vec(self.regime.derivative(place.x), self.regime.derivative(place.y))

    def _several(self, find: Find, q: Quantity, varying: list[sp.Symbol]) -> Exception:
        names = [s.name for s in varying]
        listed = f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else names[0]
        what = "velocity" if q.word == "hodograph" else "place"
        text = f"{find.name}: the {what} of {q.things[0]} depends on {listed}"
        if len(names) > 1:
            text += ", which the file lets vary independently of each other: that is no single curve"
        else:
            text += ", and the file does not tell how that varies in time"
        hint = "say in `motion` how they move, or give the start of the motion in `states`"
        if q.word == "path":
            hint += "; or ask for the path as seen from a point or body, `path(B/A)`"
        return refuse(find.mark, "PL650", text, hint)

    # --- words -------------------------------------------------------------------------------------------------------

    def _words(self, q: Quantity, curve: Curve, value: Valuation) -> str:
        """The name of the curve; a circle about a point of the file, or one at rest there, says which."""
        if curve.kind not in (CIRCLE, POINT) or curve.centre is None:
            return curve.kind
        if q.word == "hodograph" and curve.kind == CIRCLE:
            return "circle about the origin" if all(value.is_zero(c) for c in curve.centre) else curve.words
        if curve.kind == POINT:
            rests = "the velocity does not change" if q.word == "hodograph" else "it does not move in this frame"
            return f"point, {rests}"
        name = self._named_centre(q, curve.centre, value)
        if not name and all(value.is_zero(c) for c in curve.centre):
            name = "the origin"
        return f"circle about {name}" if name else curve.words

    def _named_centre(self, q: Quantity, centre: tuple[sp.Expr, sp.Expr], value: Valuation) -> str:
        scene = self.regime.general.instant.scene
        for name in scene.points:
            at = self._seen(self._point(name), q)
            if (simplified(at.x).free_symbols | simplified(at.y).free_symbols) & set(self.regime.letters):
                continue
            if value.is_zero(at.x - centre[0]) and value.is_zero(at.y - centre[1]):
                return name
        return ""

    def _heading(self, q: Quantity) -> str:
        point = q.things[0]
        if q.word == "hodograph":
            return f"Hodograph of {point}, the curve of the tip of its velocity drawn from one point"
        if len(q.things) < 2 or q.things[1] == GROUND:
            return f"Path of {point}"
        other = q.things[1]
        body = self.frame(q)
        if body is None:
            return f"Path of {point} seen from a frame that moves with {other} and does not turn, {other} its origin"
        shape = self.regime.general.instant.scene.bodies[body].shape
        if isinstance(shape, Rod):
            return f"Path of {point} seen from {other}, its origin at {shape.start} and its x axis along {other}"
        return f"Path of {point} seen from {other}, its origin at the centre and its axes turning with {other}"

    def _meaning(self, parameter: sp.Symbol, exprs: Vec) -> str:
        """What a coordinate is that the file does not name."""
        scene = self.regime.general.instant.scene
        own = next((c for c in self.regime.coordinates if c.symbol == parameter), None)
        if own is None or parameter in scene.ledger.coordinates:
            return ":"
        if parameter not in exprs.x.free_symbols | exprs.y.free_symbols:
            return ":"
        since = " from where it is drawn" if own.drawn == 0 and own.words.startswith("way") else ""
        return f", {parameter.name} the {own.words}{since}:"

    def _rows(
        self, place: Vec, functions: Functions, exprs: Vec, curve: Curve, axes: tuple[str, str]
    ) -> tuple[Row, ...]:
        """The place, the functions put in, and the elimination."""
        told = explained(functions.found, (place.x, place.y))
        rows = [told_function(f) for f in told if f.symbol not in (place.x, place.y)]
        shown = [sp.Eq(sp.Symbol(a, real=True), e, evaluate=False) for a, e in zip(axes, (exprs.x, exprs.y), strict=True)]
        if curve.kind == POINT:
            return (*rows, *(Row("", e) for e in shown))
        steps = [Row(w, e) for w, e in curve.steps if not any(_same(e, s) for s in shown)]
        if curve.equation is not None and not steps:
            return (*rows, *(Row("", e) for e in shown))
        return (*rows, *(Row("", e) for e in shown), *steps)


def _same(step: object, shown: sp.Eq) -> bool:
    """Is a step a line that is shown already?"""
    return isinstance(step, sp.Eq) and step.lhs == shown.lhs and sp.expand(step.rhs - shown.rhs) == 0
