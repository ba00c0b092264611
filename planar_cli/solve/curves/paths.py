"""Curves: the path of a point, also as seen from a moving point or body, and the hodograph of its velocity.

The place of the point is written with one parameter (time, or the only coordinate that varies), and the parameter is
eliminated. (An Introduction to Planar Dynamics, 1.1, 1.4.1.)
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.calculus.curve_words import CIRCLE, LINE, POINT, Curve
from planar_cli.calculus.curves import curve_of
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.errors import refuse
from planar_cli.problem.checks.shared_points import carried_together
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Find, Rod, with_article
from planar_cli.records import changing, record
from planar_cli.solve.curves.one_freedom import driver_of, followed_curve, loops_of
from planar_cli.solve.passages import CURVE, Passage, Row, sides_of, squared_radius, told_function
from planar_cli.solve.regimes.functions import Functions, explained
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.solution import Found
from planar_cli.units import parse_unit

PATH = (("x", "y"), ("r", "theta"))
HODOGRAPH = (("v_x", "v_y"), ("v", "phi"))
PLAIN_NAMES = {"v_x": "vx", "v_y": "vy"}
MANY, SHORT = 2, 12
"""A place in so many coordinates that vary is told beside one in a frame that makes them fewer, where it is that short.
"""
LONGEST = 200
"""A line of more operations is left out of a page."""


@record
class Single:
    """A place in one parameter."""

    parameter: sp.Symbol
    functions: Functions
    """How the other coordinates depend on it."""
    place: Vec
    coordinate: sp.Symbol | None = None
    """For which the parameter stands, where the file calls that like an axis."""


@changing
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
        axes, polar = HODOGRAPH if q.word == "hodograph" else PATH
        scene = self.regime.general.instant.scene
        single = _apart(self._single(q, place), axes, self.regime.general.instant.scene.ledger)
        if isinstance(single, Single):
            letters = frozenset(s for s in scene.ledger.letters if s != single.parameter)
            at, value = single.place, scene.valuations[0]
            axes = _free_axes(axes, at.x.free_symbols | at.y.free_symbols, q.things[0])
            curve = curve_of(at.x, at.y, single.parameter, value, axes, polar, letters)
            curve = replace(curve, course=(at.x, at.y), parameter=single.parameter)
            heading = self._heading(q) + self._meaning(single)
            every = self._rows(place, single, curve, axes)
            short = tuple(r for r in every if not _too_long(r))
            if len(short) < len(every):
                heading = heading.removesuffix(":") + " (lines too long for a page are left out):"
            if (others := tuple(self._from_other_frames(q))) and short and not short[0].words:
                short = (*others, replace(short[0], words="in this frame"), *short[1:])
            passage = Passage(heading, short, CURVE)
            return self._found(find, self._named(q, curve, value)), passage
        loops = loops_of(self.regime)
        driver = driver_of(self.regime, loops, single)
        if driver is None:
            raise self._several(find, q, single)
        at = self._velocity(place) if q.word == "hodograph" else place
        curve = followed_curve(self.regime, loops, driver, at, axes)
        rows = [
            Row("", sp.Eq(sp.Symbol(a, real=True), e, evaluate=False)) for a, e in zip(axes, (at.x, at.y), strict=True)
        ]
        rows += [Row(c.title, sp.Eq(c.residual, 0, evaluate=False)) for c in loops.constraints]
        if curve.equation is not None:
            rows.append(Row(f"places computed along the loop all lie on one {curve.kind}", curve.equation))
        return self._found(find, self._named(q, curve, scene.valuations[0])), Passage(
            self._heading(q) + ":", tuple(rows), CURVE
        )

    def _found(self, find: Find, curve: Curve) -> Found:
        equations: tuple[sp.Expr, ...] | None = None
        if curve.equation is not None:
            plain = {s: sp.Symbol(PLAIN_NAMES[s.name], real=True) for s in curve.equation.free_symbols
                     if s.name in PLAIN_NAMES}  # fmt: skip
            equations = (curve.equation.xreplace(plain),)
        return Found(find.name, "curve", parse_unit("1"), None, equations, "", find, curve=curve)

    # --- places in frames --------------------------------------------------------------------------------------------

    def place(self, q: Quantity) -> Vec:
        """The point in its frame, in coordinates and t; as a point of that of its bodies which makes it shortest."""
        seen = [self._seen(at, q) for at in self._places(q.things[0])]
        plain = [Vec(simplified(at.x), simplified(at.y)) for at in seen]
        return min(plain, key=lambda at: len(self._varying(at)))

    def _from_other_frames(self, q: Quantity) -> Iterator[Row]:
        """Of a path in a moving frame, the place over the ground, and in a frame that does not turn, as long as more
        than one coordinate varies in it: why that frame was chosen.
        """
        if q.word != "path" or len(q.things) != 2:
            return
        name, at = q.things[0], self._point(q.things[0])
        frame = self.frame(q)
        shape = self.regime.general.instant.scene.bodies[frame].shape if frame is not None else None
        views = [(name, "over the ground", at)]
        if isinstance(shape, Rod):
            where = f"from {shape.start}, without turning"
            views.append((f"{name}/{shape.start}", where, at - self._point(shape.start)))
        for index, where, place in views:
            varying = [s.name for s in self._varying(place)]
            if len(varying) < MANY or longer(place.x, SHORT) or longer(place.y, SHORT):
                return
            note = f"{listed([f'`{s}`' for s in varying], 'and')} vary"
            yield Row(where, (sp.Symbol(f"x_{index}", real=True), simplified(place.x)), note=note)
            yield Row("", (sp.Symbol(f"y_{index}", real=True), simplified(place.y)))

    def _places(self, name: str) -> list[Vec]:
        """A point as each of the bodies carries it to which it belongs."""
        general = self.regime.general
        at = self._point(name)
        drawn = {c.symbol: c.drawn for c in general.coordinates if c.drawn is not None}
        scene = general.instant.scene
        owners = scene.owners.get(name, [])
        inside = at.x.free_symbols | at.y.free_symbols
        if name in general.displacement.spots or any(
            c.symbol in inside for c in general.coordinates if c.drawn is None
        ):
            return [at]
        start = Vec(at.x.subs(drawn), at.y.subs(drawn))
        together = carried_together(name, owners, scene.problem.joints) if owners else []
        poses = [general.displacement.poses[o] for o in together[1:] if o not in general.displacement.formula]
        return [at, *(p.point(start) for p in poses)]

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

    def _single(self, q: Quantity, place: Vec) -> Single | list[sp.Symbol]:
        """The curve in one parameter: the only coordinate; else one on which the others depend; else time. Where
        there is none, what it depends on.
        """
        hodograph = q.word == "hodograph"
        plain = self._velocity(place) if hodograph else place
        varying = self._varying(plain)
        if len(varying) <= 1:
            return Single((varying or [self.regime.time])[0], Functions(self.regime, self.starts), plain)
        for kept in varying:
            if kept not in self.regime.rates:
                continue
            linked = Functions(self.regime, {}, frozenset({kept}), timed=False)
            linked.find()
            found = Vec(linked.put_in(plain.x), linked.put_in(plain.y))
            if self._varying(found) == [kept]:
                return Single(kept, linked, Vec(simplified(found.x), simplified(found.y)))
        timed = Functions(self.regime, self.starts)
        timed.find()
        found = Vec(simplified(timed.put_in(place.x)), simplified(timed.put_in(place.y)))
        left = self._varying(found)
        if left not in ([], [self.regime.time]):
            return [s for s in varying if s != self.regime.time] if not hodograph else varying
        if hodograph:
            found = Vec(*(simplified(sp.diff(e, self.regime.time)) for e in (found.x, found.y)))
        return Single(self.regime.time, timed, found)

    def _velocity(self, place: Vec) -> Vec:
        return Vec(self.regime.derivative(place.x), self.regime.derivative(place.y))

    def _several(self, find: Find, q: Quantity, varying: list[sp.Symbol]) -> Exception:
        names = [s.name for s in varying]
        listed = f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else names[0]
        what = "velocity" if q.word == "hodograph" else "place"
        text = f"{find.name}: the {what} of {q.things[0]} depends on {listed}"
        told = {c.symbol for c in self.regime.coordinates} | {*self.regime.free}
        if told and told <= self.starts.keys():
            text += ", and no formula was found that solves their equations of motion"
            hint = "ask for places at `states`, or follow it step by step: `planar simulate`"
            return refuse(find.mark, "PL650", text, hint)
        text += ", and nothing in the file ties them to each other or to the time: that is no single curve"
        hint = "say in `motion` how they move, or give the start of the motion in `states`"
        if q.word == "path":
            hint += "; or ask for the path as seen from a point or body, `path(B/A)`"
        return refuse(find.mark, "PL650", text, hint)

    # --- words -------------------------------------------------------------------------------------------------------

    def _named(self, q: Quantity, curve: Curve, value: Valuation) -> Curve:
        """A circle about a point of the file, or about the origin, is called so; a point at rest says what rests."""
        if curve.kind == POINT:
            rests = "the velocity does not change" if q.word == "hodograph" else "it does not move in this frame"
            return replace(curve, kind=f"point: {rests}", centre=None)
        if curve.kind == LINE and (along := self._along_axis(q, curve)):
            return replace(curve, kind=f"{LINE} {along}")
        if curve.kind != CIRCLE or curve.centre is None:
            return curve
        name = self._named_centre(q, curve.centre) if q.word == "path" else ""
        if not name and all(value.is_zero(c) for c in curve.centre):
            name = "the origin"
        return replace(curve, kind=f"circle about {name}", centre=None) if name else curve

    def _along_axis(self, q: Quantity, curve: Curve) -> str:
        """How a line lies that is parallel to an axis of its frame."""
        x, y = (sp.Symbol(a, real=True) for a in PATH[0])
        body = self.frame(q)
        if curve.equation is None or curve.equation.lhs not in (x, y) or curve.equation.rhs.has(x, y):
            return ""
        shape = self.regime.general.instant.scene.bodies[body].shape if body is not None else None
        if isinstance(shape, Rod) and curve.equation.lhs == y:
            called = with_article(q.things[1])
            return f"through {shape.start} along {called}" if curve.equation.rhs == 0 else f"parallel to {called}"
        return "" if body is not None else f"parallel to the {'x' if curve.equation.lhs == y else 'y'} axis"

    def _named_centre(self, q: Quantity, centre: tuple[sp.Expr, sp.Expr]) -> str:
        """A point that stays at the centre, wherever the others are."""
        scene = self.regime.general.instant.scene
        for name in scene.points:
            at = self._seen(self._point(name), q)
            if all(v.is_zero(at.x - centre[0]) and v.is_zero(at.y - centre[1]) for v in scene.valuations):
                return name
        return ""

    def _heading(self, q: Quantity) -> str:
        point = q.things[0]
        if q.word == "hodograph":
            return f"Hodograph of {point}, the curve of the tip of its velocity drawn from one point"
        if len(q.things) < 2 or q.things[1] == GROUND:
            return f"Path of {point}{' over the ground' if self._several_frames() else ''}"
        other = q.things[1]
        body = self.frame(q)
        if body is None:
            return (
                f"Path of {point} seen from a frame that moves with {other} and does not turn, with {other} as origin"
            )
        shape, called = self.regime.general.instant.scene.bodies[body].shape, with_article(other)
        if isinstance(shape, Rod):
            return f"Path of {point} seen from {called}, origin at {shape.start}, x axis along {called}"
        return f"Path of {point} seen from {called}, origin at the centre, axes turning with {called}"

    def _several_frames(self) -> bool:
        """Is some path asked as a moving point or body sees it?"""
        asked = (f.found.what for f in self.regime.general.instant.scene.problem.find)
        return any(isinstance(q, Quantity) and q.word == "path" and len(q.things) > 1 for q in asked)

    def _meaning(self, single: Single) -> str:
        """What a coordinate is that the file does not name."""
        parameter, exprs = single.parameter, single.place
        scene = self.regime.general.instant.scene
        if single.coordinate is not None:
            return f", `{parameter.name}` the coordinate {single.coordinate.name}:"
        own = next((c for c in self.regime.coordinates if c.symbol == parameter), None)
        inside = exprs.x.free_symbols | exprs.y.free_symbols
        if own is None or own.words[:5] in ("x of ", "y of ") or parameter not in inside:
            return ":"
        if parameter in scene.ledger.coordinates:
            constant = sorted(f"`{s.name}`" for s in inside & set(scene.ledger.letters) - {parameter})
            rest = f", {' and '.join(constant)} {'are' if len(constant) > 1 else 'is'} constant" if constant else ""
            return f" (`{parameter.name}` varies{rest}):"
        since = " from where it is drawn" if own.drawn == 0 and own.words.startswith("way") else ""
        return f", `{parameter.name}` the {own.words}{since}:"

    def _rows(self, place: Vec, single: Single, curve: Curve, axes: tuple[str, str]) -> tuple[Row, ...]:
        """The place, the functions put in, and the elimination."""
        functions, exprs = single.functions, single.place
        told = explained(functions.found, (place.x, place.y))
        rows = [told_function(f) for f in told if f.symbol not in (place.x, place.y)]
        shown = []
        for axis, own, expr in zip(axes, (place.x, place.y), (exprs.x, exprs.y), strict=True):
            known = functions.found.get(own) if isinstance(own, sp.Symbol) else None
            words = known.words if known is not None and known.expr == expr else ""
            line = expanded(expr) if expr.is_polynomial(self.regime.time) else expr
            shown.append(Row(words, sp.Eq(sp.Symbol(axis, real=True), line, evaluate=False)))
        steps = [Row(w, e) for w, e in curve.steps if not any(_same(e, s.line) for s in shown)]
        steps = [
            replace(s, line=squared_radius(s.line, curve.radius)) if s.line == curve.equation else s for s in steps
        ]
        return (*rows, *shown) if curve.kind == POINT else (*rows, *shown, *steps)


def _free_axes(axes: tuple[str, str], used: Collection[sp.Symbol], point: str) -> tuple[str, str]:
    """Axes called after the point where the file has a length of the same name: y_P beside y."""
    names = {s.name for s in used}
    if not names & set(axes):
        return axes
    across, up = (f"{axis}_{point}" for axis in axes)
    while names & {across, up}:
        across, up = across + "′", up + "′"
    return across, up


def _apart(single: Single | list[sp.Symbol], axes: tuple[str, str], ledger: Ledger) -> Single | list[sp.Symbol]:
    """The parameter under another name where the file calls a coordinate like an axis, and it is not that axis."""
    if not isinstance(single, Single) or single.parameter.name not in axes:
        return single
    p, at = single.parameter, single.place
    if (at.x, at.y)[axes.index(p.name)] == p:
        return single
    other = ledger.once(f"{p.name}_0", ledger.units[p].text, p)
    return Single(other, single.functions, Vec(at.x.xreplace({p: other}), at.y.xreplace({p: other})), p)


def without_told_places(q: Quantity, curve: Passage, told: Iterable[Passage]) -> Passage:
    """A curve without x(t) and y(t) of its point, or their rates, where these stand above."""
    if len(q.things) > 1:
        return curve
    known = {sides_of(r)[0].name: sides_of(r)[-1] for p in told for r in p.rows if len(sides_of(r)) > 1}
    dots, axes = ("_dot", HODOGRAPH[0]) if q.word == "hodograph" else ("", PATH[0])
    letters = dict(zip(axes, (f"{axis}_{q.things[0]}{dots}" for axis in PATH[0]), strict=True))
    above = {
        str(sides_of(row)[0]): row
        for row in curve.rows
        if (letter := letters.get(str(sides_of(row)[0]))) in known and _equal(known[letter], sides_of(row)[-1])
    }
    left = tuple(row for row in curve.rows if row not in above.values())
    if not left or above.keys() != letters.keys():
        return curve
    names = " and ".join(f"{axis} = {letter}" for axis, letter in letters.items()) if dots else ""
    return replace(curve, heading=f"{curve.heading.removesuffix(':')}{', ' if names else ''}{names}:", rows=left)


def _equal(one: sp.Expr, other: sp.Expr) -> bool:
    return bool(expanded(sp.sympify(one - other)) == 0)


def _too_long(row: Row) -> bool:
    """Would it fill most of a page?"""
    return any(longer(side, LONGEST) for side in sides_of(row) if isinstance(side, sp.Expr))


def _same(step: object, shown: sp.Eq) -> bool:
    """Is a step a line that is shown already?"""
    return isinstance(step, sp.Eq) and step.lhs == shown.lhs and _equal(step.rhs, shown.rhs)
