"""Kinematics told as in a lecture: places in coordinates, coordinates over time, and then their derivatives.

Components that are asked along and across r are told in polar coordinates (An Introduction to Planar Dynamics, 1.4.3),
all others in Cartesian ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.jets import Jet, direction_angle, magnitude
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Find, Polar, TwoFacts
from planar_cli.records import changing
from planar_cli.solve.curves.by_coordinates import DOTS, ByCoordinates
from planar_cli.solve.curves.kinds_asked import (
    POLAR,
    SIZES,
    Use,
    along_paths,
    asked_in,
    is_whole,
    kinds_of,
    magnitudes_of,
    polar_of,
    wanted_of,
)
from planar_cli.solve.curves.natural_letters import natural_rows
from planar_cli.solve.curves.on_fixed_line import Guided, components, guided
from planar_cli.solve.curves.rolled import rolled
from planar_cli.solve.passages import (
    ALONG,
    PLACES,
    RADIAL,
    RATES,
    ROLLING,
    SECOND_RATES,
    Arm,
    Passage,
    Row,
    sides_of,
    told_function,
)
from planar_cli.solve.regimes.functions import Function, Functions, explained
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.roads import is_curve
from planar_cli.units import LENGTH, PURE, TIME

GIVEN = "Given, and differentiated:"
HEADINGS = (
    "Positions:",
    "Velocities, the derivatives of the positions:",
    "Accelerations, the derivatives of the velocities:",
)


def no_value(_: sp.Expr) -> Decimal | None:
    """Where no instant is asked for."""
    return None


@changing
class Story:
    """Tells the places, velocities and accelerations of one regime on which finds rest.

    `clean`: a formula of the regime as it is printed. `with_rates`: tell the rates of coordinates as well. `value`: of
    such a formula at the instant that is asked for (None: no instant is). `driven`: coordinates over time that stay
    letters. `used`: what has been told so far, in the coordinates.
    """

    regime: Regime
    quantities: Quantities
    functions: Functions
    clean: Callable[[sp.Expr], sp.Expr]
    with_rates: bool = True
    value: Callable[[sp.Expr], Decimal | None] = no_value
    driven: ByCoordinates | None = None
    used: list[sp.Expr] = field(default_factory=list)

    def passages(self, finds: Iterable[Find]) -> tuple[Passage, ...]:
        """Everything on which these finds rest."""
        asked = list(asked_in(finds))
        polar = polar_of(asked)
        around = [
            p
            for (point, origin), level in polar.items()
            for p in self._polar_passages(point, origin, level, magnitudes_of(asked, point))
        ]
        rows: tuple[list[Row], list[Row], list[Row]] = ([], [], [])
        wanted = wanted_of(asked, {point for point, _ in polar})
        for (thing, angular), level in {**self._origins(wanted), **wanted}.items():
            for name, jet in self._jets(thing, angular):
                whole = not angular and any(is_whole(u.quantity, thing) for u in asked)
                for n, row in enumerate(self._derivatives(name, jet, level, angular, whole)):
                    # A particle and the point at which it is are one.
                    if row is not None and row not in rows[n]:
                        rows[n].append(row)
        told = [self._function(f) for f in explained(self.functions.found, self.used)]
        known = {sides_of(r)[0] for r in told}
        first = [*told, *(r for r in rows[0] if sides_of(r)[0] not in known)]
        wheels = tuple(rolled(self.quantities)) if first else ()
        passages = [Passage(GIVEN, tuple(self._given())), *(Passage(w.told(), (), ROLLING) for w in wheels)]
        passages += [Passage(HEADINGS[0], tuple(first), PLACES)]
        if self.with_rates and (around or any(rows[1:])):
            passages.append(Passage("Given:", tuple(self._rates(bool(rows[2])))))
        passages += [Passage(HEADINGS[n], tuple(rows[n]), (RATES, SECOND_RATES)[n - 1]) for n in (1, 2)]
        told_level = max((n for n in (0, 1, 2) if rows[n]), default=2)
        if not any(is_curve(f.found.what) for f in self.quantities.scene.problem.find):
            rims = (w.cycloid({thing for thing, _ in wanted}, told_level) for w in wheels)
            passages += [Passage(rim, (), ROLLING) for rim in rims if rim]
        passages += [p for point, own in along_paths(asked, polar) for p in self._path_passages(point, own)]
        return tuple(p for p in (*passages, *around) if p.rows or p.kind == ROLLING)

    def _origin(self, thing: str) -> str:
        """The point that moves and from which the file measures another; "" where there is none."""
        place = self._measured(thing)
        if place is None or self.driven is not None:
            return ""
        at = self.quantities.place(place.origin)
        return place.origin if any(j.rate not in (None, 0) for j in (at.x, at.y)) else ""

    def _measured(self, thing: str) -> Polar | None:
        """How the file measures a point from another, by distance and angle."""
        place = next((p.place for p in self.quantities.scene.problem.points if p.name == thing), None)
        return place if isinstance(place, Polar) else None

    def _origins(self, wanted: Mapping[tuple[str, bool], int]) -> dict[tuple[str, bool], int]:
        """The origins of what is told, whose places are told before it."""
        found = {(o, False): 0 for thing, angular in wanted if not angular and (o := self._origin(thing))}
        return {**(self._origins(found) if found else {}), **found}

    def _from_origin(self, name: str, closed: sp.Expr) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
        """x_G - r sin φ where the file measures P from G, and r φ - r sin φ, which that is."""
        axis, _, thing = name.partition("_")
        origin = self._origin(thing)
        if not origin or axis not in ("x", "y"):
            return (), ()
        at = self._jet(getattr(self.quantities.place(origin), axis))
        base, rest = self.clean(self.regime.closed(at.value)), self.clean(closed - self.regime.closed(at.value))
        return ((sp.Symbol(f"{axis}_{origin}", real=True), rest), (sp.Add(base, rest),)) if base != 0 else ((), ())

    def _arm(self, name: str) -> Arm | None:
        """r_P/G, before x_P, where the file measures P from G."""
        axis, _, thing = name.partition("_")
        place = self._measured(thing) if axis == "x" and self._origin(thing) else None
        if place is None:
            return None
        scene = self.quantities.scene
        size, angle = scene.value(place.distance), scene.value(place.angle)
        x, y = (sp.Mul(size, wave(angle, evaluate=False), evaluate=False) for wave in (sp.cos, sp.sin))
        parts = self.clean(size * sp.cos(angle)), self.clean(size * sp.sin(angle))
        return Arm(thing, place.origin, (x, y), parts)

    def _on_line(self, name: str) -> tuple[sp.Expr, ...]:
        """x_P = y_P/tan θ or y_P = x_P tan θ, r_P = y_P/sin θ or x_P/cos θ, where the file puts P at a height, or at a
        distance to the side, on a line through the origin at θ.
        """
        axis, _, thing = name.partition("_")
        scene = self.quantities.scene
        place = next((p.place for p in scene.problem.points if p.name == thing), None)
        if not isinstance(place, TwoFacts) or len(place.lines) != 1 or (place.x is None) == (place.y is None):
            return ()
        origin, angle = scene.point(place.lines[0][0]), scene.value(place.lines[0][1])
        kept = "y" if place.x is None else "x"
        if (origin.x, origin.y) != (0, 0) or not angle.free_symbols or axis == kept:
            return ()
        own = sp.Symbol(f"{kept}_{thing}", real=True)
        across = (
            {"r": sp.sin(angle), "x": sp.tan(angle)} if kept == "y" else {"r": sp.cos(angle), "y": 1 / sp.tan(angle)}
        )
        return (own / across[axis],)

    def _function(self, function: Function) -> Row:
        """A coordinate as a function, with its value."""
        row, unit = told_function(function), self.regime.general.instant.scene.ledger.units.get(function.symbol)
        if unit is None:
            return row
        return replace(row, value=self.value(function.expr), dimension=unit.dimension, angle=unit.dimension == PURE)

    def _given(self) -> Iterator[Row]:
        """The coordinates that stay letters, and their rates."""
        units = self.regime.general.instant.scene.ledger.units
        for q, symbol, formula, n in self.driven.rows() if self.driven is not None else ():
            angular = q not in units or units[q].dimension == PURE
            yield self._row(sp.Eq(symbol, formula, evaluate=False), symbol, n, angular)

    def _row(self, sides: Any, expr: sp.Expr, n: int, angular: bool) -> Row:
        """A line with its value: of a length or an angle that was differentiated n times."""
        found = {s: self.value(s) for s in expr.free_symbols} if self.driven is not None else {}
        sizes = {s: number for s, number in found.items() if number is not None}
        return Row("", sides, self.value(expr), (PURE if angular else LENGTH) / TIME**n, angular, sizes)

    def _jet(self, jet: Jet) -> Jet:
        """A place with its derivatives."""
        return jet if self.driven is None else self.driven.jet(jet)

    def _derivatives(self, name: str, jet: Jet, level: int, angular: bool, whole: bool = False) -> Iterator[Row | None]:
        """q, q̇, q̈ as rows; None where there is nothing to say. `whole`: is the vector asked, also where it is zero?"""
        closed = self.regime.closed(jet.value) if self.driven is None else jet.value
        self.used.append(closed)
        stem = closed.name if isinstance(closed, sp.Symbol) and closed in self.regime.rates else name
        before = closed
        for n, expr in enumerate((closed, jet.rate, jet.second)[: level + 1]):
            if expr is None or (n and jet.rate == 0 and not whole):
                return
            formula, symbol = self.clean(expr), sp.Symbol(f"{stem}{DOTS[n]}", real=True)
            way, between = self._from_origin(name, closed) if n == 0 else ((), self._by_chain(before, formula))
            way, arm = (way or (self._on_line(name) if n == 0 else ())), (self._arm(name) if n == 0 else None)
            between = tuple(b for b in between if b != formula)
            line = (symbol, *between, formula) if between else sp.Eq(symbol, formula, evaluate=False)
            yield None if formula == symbol else replace(self._row(line, formula, n, angular), way=way, arm=arm)
            before = formula

    def _by_chain(self, closed: sp.Expr, formula: sp.Expr) -> tuple[sp.Expr, ...]:
        """The derivative of a place or a velocity by the chain rule, before the rates of the coordinates are put in."""
        inside = closed.free_symbols
        once = {q: sp.Symbol(f"{q.name}_dot", real=True) for q in self.regime.rates}
        twice = {rate: sp.Symbol(f"{q.name}_ddot", real=True) for q, rate in once.items()}
        rates = {s: rate for s, rate in {**once, **twice}.items() if s in inside}
        if self.driven is not None or not self.with_rates or any(q in self.functions.found for q in rates):
            return ()
        found = factored(simplified(sp.Add(*(sp.diff(closed, q) * rate for q, rate in rates.items()))))
        return () if found in (formula, 0) else (found,)

    def _jets(self, thing: str, angular: bool) -> Iterator[tuple[str, Jet]]:
        """The angle of a body, or x and y of a point that moves, with the names under which they are told."""
        scene, motion = self.quantities.scene, self.quantities.motion
        if angular and thing in scene.bodies:
            rates = motion.velocities[thing].angular, motion.accelerations[thing].angular
            yield f"theta_{thing}", self._jet(Jet(scene.bodies[thing].theta, *rates))
        elif thing in scene.points or thing in scene.bodies:
            place = self.quantities.place(thing)
            name = thing if thing in scene.points else scene.center_name(thing) or thing
            if any(j.rate is not None and j.rate != 0 for j in (place.x, place.y)):
                jets = [(f"x_{name}", self._jet(place.x)), (f"y_{name}", self._jet(place.y))]
                yield from reversed(jets) if self._on_line(f"x_{name}") else jets

    def _rates(self, twice: bool) -> Iterator[Row]:
        """q̇ = …, of the coordinates that stand in what is told and are no functions of time. `twice`: accelerations are
        told, in which q̈ = 0 matters.
        """
        inside = set().union(*(e.free_symbols for e in self.used)) if self.used else set()
        for symbol, rate in self.regime.rates.items():
            dotted = sp.Symbol(f"{symbol.name}_dot", real=True)
            if symbol not in inside or symbol in self.functions.found or rate == dotted:
                continue
            steady = twice and not rate.free_symbols & {self.regime.time, *self.regime.rates}
            still = f"constant, so that `{symbol.name}_ddot` = 0" if steady else ""
            yield Row("", sp.Eq(dotted, rate, evaluate=False), note=still)

    # --- along the path ----------------------------------------------------------------------------------------------

    def _path_passages(self, point: str, asked: list[Use]) -> Iterator[Passage]:
        """v = √(ẋ² + ẏ²), a_t = (ẋ ẍ + ẏ ÿ)/v, a_n = |ẋ ÿ - ẏ ẍ|/v, ρ = v²/a_n, as far as they are asked."""
        place = self.quantities.place(point)
        known = {
            sp.Symbol(f"{axis}_{point}{dots}", real=True): self.value(self.clean(expr))
            for axis, jet in (("x", self._jet(place.x)), ("y", self._jet(place.y)))
            for dots, expr in zip(DOTS, (jet.value, jet.rate, jet.second), strict=True)
            if expr is not None
        }
        sizes = {s: number for s, number in known.items() if number is not None}
        dx, dy, ddx, ddy = (sp.Symbol(f"{axis}_{point}{d}", real=True) for d in DOTS[1:] for axis in "xy")
        wanted = {kind for use in asked for kind in kinds_of(use)}
        if not sizes:
            parts = place.x.rate, place.y.rate, place.x.second, place.y.second
            pairs = {1: ((dx, parts[0]), (dy, parts[1])), 2: ((ddx, parts[2]), (ddy, parts[3]))}
            kinds = [n for n, kind in ((1, "v"), (2, "a")) if kind in wanted]
            if (natural := wanted - SIZES) and None not in parts:
                rows = natural_rows(point, (Vec(*parts[:2]), Vec(*parts[2:])), {"v", *natural}, self.clean)
                yield Passage("Along the path:", tuple(rows), ALONG)
                kinds = [n for n in kinds if n == 2]
            yield Passage("Magnitudes:", tuple(r for n in kinds for r in self._lettered(n, point, pairs[n])))
        if not sizes.keys() >= {dx, dy} or sizes[dx] == sizes[dy] == 0:
            return
        v, a_t, a_n = (sp.Symbol(f"{name}", real=True) for name in (f"v_{point}", f"a_{point}_t", f"a_{point}_n"))
        lines = {v: sp.sqrt(dx**2 + dy**2)}
        if wanted - {"v"} and sizes.keys() >= {ddx, ddy}:
            lines |= {sp.Symbol(f"a_{point}", real=True): sp.sqrt(ddx**2 + ddy**2)} if "a" in wanted else {}
            lines |= {a_t: (dx * ddx + dy * ddy) / v} if "t" in wanted else {}
            lines |= {a_n: sp.Abs(dx * ddy - dy * ddx) / v} if wanted & {"n", "rho"} else {}
            lines |= {sp.Symbol(f"rho_{point}", real=True): v**2 / a_n} if "rho" in wanted else {}
        told = []
        for symbol, formula in lines.items():
            value = Valuation(sizes).known(formula)
            if value is None:
                return
            dimension = LENGTH if symbol.name.startswith("rho") else LENGTH / TIME ** (1 if symbol == v else 2)
            own = {s: sizes[s] for s in formula.free_symbols}
            told.append(Row("", (symbol, formula), value, dimension, False, own))
            sizes[symbol] = value
        named = ("Along the path:", ALONG) if wanted - {"v", "a"} else ("Magnitudes:", "")
        yield Passage(named[0], tuple(told), named[1])

    def _lettered(self, n: int, point: str, parts: Iterable[tuple[sp.Symbol, sp.Expr | None]]) -> Iterator[Row]:
        """The size of the velocity (1) or the acceleration (2) by both components, in letters or as a number."""
        (x, one), (y, other) = parts
        if one is None or other is None or 0 in (one, other):
            return
        whole = simplified(sp.sqrt(simplified(self.clean(one) ** 2 + self.clean(other) ** 2)))
        sides = (sp.Symbol(f"{' va'[n]}_{point}", real=True), sp.sqrt(x**2 + y**2), whole)
        yield Row("", sides, Valuation({}).known(whole), LENGTH / TIME**n)

    # --- polar coordinates -------------------------------------------------------------------------------------------

    def _polar_passages(self, point: str, origin: str, level: int, whole: set[int]) -> Iterator[Passage]:
        """r and θ with their derivatives; then v_r = ṙ, v_θ = r θ̇, a_r = r̈ - r θ̇², a_θ = r θ̈ + 2 ṙ θ̇. `whole`: of
        the velocity (1), the acceleration (2) the magnitude is asked too.
        """
        reach = self.quantities.place(point)
        if origin:
            reach = reach - self.quantities.place(origin)
        reach = reach if self.driven is None else self.driven.vec(reach)
        size, angle = self._in_time(magnitude(reach)), self._in_time(direction_angle(reach))
        line = self._on_fixed_line(point, reach, size, angle) if level and not whole else None
        if line is not None:
            rows = [row for row in self._polar_rows(point, size, angle, 0) if sides_of(row)[0] == line.letter("r")]
            yield Passage(f"Distance of {point} from {origin or 'the origin'}:", tuple(rows))
            yield from components(line, level, self._on_line(f"r_{point}"))
            return
        rows = [row for n in range(level + 1) for row in self._polar_rows(point, size, angle, n)]
        yield Passage(
            f"Polar coordinates of {point}{f' about {origin}' if origin else ''}, and their rates:", tuple(rows)
        )
        r, dr, ddr, _, dtheta, ddtheta = (sp.Symbol(f"{q}_{point}{d}", real=True) for q in POLAR for d in DOTS)
        told: list[Row] = []
        if level >= 1:
            told += self._components(1, point, (dr, r * dtheta), (size, angle))
        if level == 2:
            parts = (ddr - r * dtheta**2, r * ddtheta + 2 * dr * dtheta)
            told += self._components(2, point, parts, (size, angle))
        parts_told = {row.line[0]: row.line[-1] for row in told if isinstance(row.line, tuple) and row.value is None}
        told += [row for n in sorted(whole) for row in self._magnitude(n, point, told)]
        for n in sorted(whole) if parts_told else ():
            pair = [sp.Symbol(f"{' va'[n]}_{point}_{name}", real=True) for name in POLAR]
            told += self._lettered(n, point, [(s, parts_told.get(s)) for s in pair])
        yield Passage("Components along r and across it:", tuple(told), RADIAL)

    def _on_fixed_line(self, point: str, reach: Vec, size: Jet, angle: Jet) -> Guided | None:
        """A point that keeps x or y at the instant that is asked for; None: it does not."""
        if self.driven is None:
            return None
        own = (self.clean(sp.sympify(angle.rate)), self.clean(sp.sympify(angle.second)))
        turning = next((q for q, rates in self.driven.driven.items() if rates == own), None)
        if turning is None or not self.driven.value.is_zero(angle.value - turning):
            return None
        return guided(point, reach, size, (turning, *own), self.value)

    def _in_time(self, jet: Jet) -> Jet:
        """What is a function of time alone, or of coordinates whose rates are told, is differentiated as that."""
        place, time = self.clean(jet.value), self.regime.time
        if self.driven is None and place.free_symbols & self.regime.rates.keys() and not place.has(sp.Abs, sp.atan2):
            rate = self.clean(self.regime.derivative(place))
            return Jet(place, rate, self.regime.derivative(rate))
        if time not in place.free_symbols or place.free_symbols & {*self.regime.letters} - {time}:
            return jet
        return Jet(place, sp.diff(place, time), sp.diff(place, time, 2))

    def _magnitude(self, n: int, point: str, told: list[Row]) -> Iterator[Row]:
        """The magnitude by both components, which are told."""
        r, theta = (sp.Symbol(f"{' va'[n]}_{point}_{name}", real=True) for name in POLAR)
        values = {row.line[0]: row.value for row in told if isinstance(row.line, tuple) and row.value is not None}
        if r in values and theta in values:
            size = (values[r] ** 2 + values[theta] ** 2).sqrt()
            sides = (sp.Symbol(f"{' va'[n]}_{point}", real=True), sp.sqrt(r**2 + theta**2))
            yield Row("", sides, size, LENGTH / TIME**n, False, {r: values[r], theta: values[theta]})

    def _polar_rows(self, point: str, size: Jet, angle: Jet, n: int) -> Iterator[Row]:
        for name, jet in zip(POLAR, (size, angle), strict=True):
            expr = (jet.value, jet.rate, jet.second)[n]
            self.used.append(self.regime.closed(jet.value))
            if expr is not None:
                symbol, formula = sp.Symbol(f"{name}_{point}{DOTS[n]}", real=True), self.clean(expr)
                row = self._row(sp.Eq(symbol, formula, evaluate=False), formula, n, name == "theta")
                way = self._on_line(f"r_{point}") if name == "r" and n == 0 else ()
                yield row if formula == symbol else replace(row, way=way)

    def _components(self, n: int, point: str, parts: tuple[sp.Expr, sp.Expr], jets: tuple[Jet, Jet]) -> Iterator[Row]:
        """component = formula in polar coordinates = value, of the velocity (n = 1) or the acceleration (n = 2)."""
        inside = {
            sp.Symbol(f"{name}_{point}{dots}", real=True): expr
            for name, jet in zip(POLAR, jets, strict=True)
            for dots, expr in zip(DOTS, (jet.value, jet.rate, jet.second), strict=True)
        }
        for name, part in zip(POLAR, parts, strict=True):
            symbol, formula = sp.Symbol(f"{' va'[n]}_{point}_{name}", real=True), self.clean(part.xreplace(inside))
            row = self._row((symbol, part, formula), formula, n, False)
            # The numbers of r and θ stand above: the formula in t says no more.
            sizes = {s: self.value(self.clean(e)) for s, e in inside.items() if s in part.free_symbols}
            known = {s: v for s, v in sizes.items() if v is not None}
            yield row if row.value is None else replace(row, line=(symbol, part), sizes=known)
