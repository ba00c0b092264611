"""Kinematics told as in a lecture: places in coordinates, coordinates over time, and then their derivatives.

Components that are asked along and across r are told in polar coordinates (An Introduction to Planar Dynamics, 1.4.3),
all others in Cartesian ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import field

import sympy as sp

from planar_cli.equation.jets import Jet, magnitude
from planar_cli.equation.quantities import Quantities, direction_angle
from planar_cli.problem.expression import Quantity
from planar_cli.problem.scene import GROUND, Find
from planar_cli.problem.walk import walk
from planar_cli.records import changing, record
from planar_cli.solve.passages import Passage, Row, told_function
from planar_cli.solve.regimes.functions import Functions, explained
from planar_cli.solve.regimes.regime import Regime

LEVELS = {"r": 0, "x": 0, "y": 0, "v": 1, "IC": 1, "coriolis": 1, "KE": 1, "momentum": 1, "H": 1, "a": 2, "rho": 2}
ANGLES = {"theta": 0, "omega": 1, "alpha": 2}
WITHOUT_POINT = ("KE", "momentum", "H")
POLAR = ("r", "theta")
HEADINGS = (
    "Places:",
    "Velocities, the derivatives of the places:",
    "Accelerations, the derivatives of the velocities:",
)
DOTS = ("", "_dot", "_ddot")


@changing
class Story:
    """Tells the places, velocities and accelerations of one regime on which finds rest.

    `clean`: a formula of the regime as it is printed. `with_rates`: tell the rates of coordinates as well. `used`: what
    has been told so far, in the coordinates.
    """

    regime: Regime
    quantities: Quantities
    functions: Functions
    clean: Callable[[sp.Expr], sp.Expr]
    with_rates: bool = True
    used: list[sp.Expr] = field(default_factory=list)

    def passages(self, finds: Iterable[Find]) -> tuple[Passage, ...]:
        """Everything on which these finds rest."""
        asked = list(_asked(finds))
        polar = _polar(asked)
        around = [p for (point, origin), level in polar.items() for p in self._polar_passages(point, origin, level)]
        rows: tuple[list[Row], list[Row], list[Row]] = ([], [], [])
        for (thing, angular), level in _wanted(asked, {point for point, _ in polar}).items():
            for name, jet in self._jets(thing, angular):
                for n, row in enumerate(self._derivatives(name, jet, level)):
                    if row is not None:
                        rows[n].append(row)
        told = [told_function(f) for f in explained(self.functions.found, self.used)]
        known = {r.line.lhs for r in told}
        first = [*told, *(r for r in rows[0] if r.line.lhs not in known)]
        passages = [Passage(HEADINGS[0], tuple(first))]
        if self.with_rates and (around or any(rows[1:])):
            passages.append(Passage("Rates of the coordinates:", tuple(self._rates())))
        passages += [Passage(HEADINGS[n], tuple(rows[n])) for n in (1, 2)]
        return tuple(p for p in (*passages, *around) if p.rows)

    def _derivatives(self, name: str, jet: Jet, level: int) -> Iterator[Row | None]:
        """q, q̇, q̈ as rows; None where there is nothing to say."""
        closed = self.regime.closed(jet.value)
        self.used.append(closed)
        stem = closed.name if isinstance(closed, sp.Symbol) and closed in self.regime.rates else name
        for n, expr in enumerate((closed, jet.rate, jet.second)[: level + 1]):
            if expr is None or (n and jet.rate == 0):
                return
            formula, symbol = self.clean(expr), sp.Symbol(f"{stem}{DOTS[n]}", real=True)
            yield None if formula == symbol else Row("", sp.Eq(symbol, formula, evaluate=False))

    def _jets(self, thing: str, angular: bool) -> Iterator[tuple[str, Jet]]:
        """The angle of a body, or x and y of a point that moves, with the names under which they are told."""
        scene, motion = self.quantities.scene, self.quantities.motion
        if angular and thing in scene.bodies:
            rates = motion.velocities[thing].angular, motion.accelerations[thing].angular
            yield f"theta_{thing}", Jet(scene.bodies[thing].theta, *rates)
        elif thing in scene.points or thing in scene.bodies:
            place = self.quantities.place(thing)
            name = thing if thing in scene.points else scene.center_name(thing) or thing
            if any(j.rate is not None and j.rate != 0 for j in (place.x, place.y)):
                yield f"x_{name}", place.x
                yield f"y_{name}", place.y

    def _rates(self) -> Iterator[Row]:
        """q̇ = …, of the coordinates that stand in what is told and are no functions of time."""
        inside = set().union(*(e.free_symbols for e in self.used)) if self.used else set()
        for symbol, rate in self.regime.rates.items():
            dotted = sp.Symbol(f"{symbol.name}_dot", real=True)
            if symbol in inside and symbol not in self.functions.found and rate != dotted:
                yield Row("", sp.Eq(dotted, rate, evaluate=False))

    # --- polar coordinates -------------------------------------------------------------------------------------------

    def _polar_passages(self, point: str, origin: str, level: int) -> Iterator[Passage]:
        """r and θ with their derivatives; then v_r = ṙ, v_θ = r θ̇, a_r = r̈ - r θ̇², a_θ = r θ̈ + 2 ṙ θ̇."""
        reach = self.quantities.place(point)
        if origin:
            reach = reach - self.quantities.place(origin)
        size, angle = magnitude(reach), direction_angle(reach)
        rows = [row for n in range(level + 1) for row in self._polar_rows(point, size, angle, n)]
        yield Passage(
            f"Polar coordinates of {point}{f' about {origin}' if origin else ''}, and their rates:", tuple(rows)
        )
        r, dr, ddr, _, dtheta, ddtheta = (sp.Symbol(f"{q}_{point}{d}", real=True) for q in POLAR for d in DOTS)
        told: list[Row] = []
        if level >= 1:
            told += self._components("v", point, (dr, r * dtheta), (size, angle))
        if level == 2:
            parts = (ddr - r * dtheta**2, r * ddtheta + 2 * dr * dtheta)
            told += self._components("a", point, parts, (size, angle))
        yield Passage("Components along r and across it:", tuple(told))

    def _polar_rows(self, point: str, size: Jet, angle: Jet, n: int) -> Iterator[Row]:
        for name, jet in zip(POLAR, (size, angle), strict=True):
            expr = (jet.value, jet.rate, jet.second)[n]
            self.used.append(self.regime.closed(jet.value))
            if expr is not None:
                yield Row("", sp.Eq(sp.Symbol(f"{name}_{point}{DOTS[n]}", real=True), self.clean(expr), evaluate=False))

    def _components(
        self, letter: str, point: str, parts: tuple[sp.Expr, sp.Expr], jets: tuple[Jet, Jet]
    ) -> Iterator[Row]:
        """component = formula in polar coordinates = value."""
        inside = {
            sp.Symbol(f"{name}_{point}{dots}", real=True): expr
            for name, jet in zip(POLAR, jets, strict=True)
            for dots, expr in zip(DOTS, (jet.value, jet.rate, jet.second), strict=True)
        }
        for name, part in zip(POLAR, parts, strict=True):
            symbol = sp.Symbol(f"{letter}_{point}_{name}", real=True)
            yield Row("", (symbol, part, self.clean(part.xreplace(inside))))


@record
class Use:
    """One quantity of a find, and how often what it is about is differentiated."""

    quantity: Quantity
    level: int


def _asked(finds: Iterable[Find]) -> Iterator[Use]:
    for find in finds:
        dots = 0
        for q in (n for n in walk(find.found.what) if isinstance(n, Quantity)):
            if q.word in ("dot", "ddot"):
                dots += 1 if q.word == "dot" else 2
            elif q.word in ANGLES or q.word in LEVELS:
                yield Use(q, min({**LEVELS, **ANGLES}[q.word] + dots, 2))


def _polar(asked: list[Use]) -> dict[tuple[str, str], int]:
    """Points of which components along and across r are asked, each with the origin of r ("": that of the file)."""
    found: dict[tuple[str, str], int] = {}
    for use in asked:
        if use.quantity.parts and use.quantity.parts[0].kind in POLAR:
            things = use.quantity.things
            key = (things[0], "" if len(things) < 2 or things[1] == GROUND else things[1])
            found[key] = max(found.get(key, 0), use.level)
    return found


def _wanted(asked: list[Use], polar: set[str]) -> dict[tuple[str, bool], int]:
    """Which points (False) and angles of bodies (True) are told, differentiated how often. Of a point that is told in
    polar coordinates magnitudes need nothing more.
    """
    found: dict[tuple[str, bool], int] = {}
    for use in asked:
        q = use.quantity
        kinds = {p.kind for p in q.parts}
        if q.word not in ANGLES and q.things[0] in polar and kinds and kinds <= {*POLAR, "mag"}:
            continue
        for thing in q.things[:1] if q.word in WITHOUT_POINT else q.things:
            key = (thing, q.word in ANGLES)
            found[key] = max(found.get(key, 0), use.level)
    return found
