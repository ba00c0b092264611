"""What moves along a fixed curve: its acceleration by components along and across the path, and the radius of it.

    a_P = a_t e_t + v²/ρ e_n                       (An Introduction to Planar Dynamics, 1.4)

Of a rigid body only the point that is joined to the curve moves so; its others follow by a_B = a_A + α × r_B/A - …
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.scene.curves import curve_formula
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.facts import Path
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Curve
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Value, line
from planar_cli.report.kinematics.component_sums import along_unit, both_told
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.names import index_of, plain_name
from planar_cli.report.words.swallowed import with_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.units import ACCELERATION, LENGTH, PURE, VELOCITY, Dimension

SHORT = 6
"""y′ and y″ of more operations are told by their values."""
FEW, SMALL, ROUNDING = 4, 20, 1e-9
"""Operations and numbers of a root that is told before its value; so near it must be to that."""
LONGEST = 40
"""A formula of more operations is told by its numbers alone, and where these are longer too by its value."""
SLOPE, BEND = sp.symbols("y′ y″", real=True)
Once = Callable[[str, tuple[Line, ...], Vec, str, Line], Iterator[Block]]
"""Tells the sides of a vector with its components, where its key was not told before."""


class PathTelling:
    """Lines of what moves along a fixed curve."""

    def __init__(self, vectors: VectorTelling, phrases: Phrases, once: Once) -> None:
        self.vectors, self.phrases, self.once = vectors, phrases, once
        self.scene = vectors.system.scene
        self._told: set[str] = set()

    def acceleration(self, body: str, at: Vec, place: str, level: str) -> Iterator[Block]:
        """a = a_t e_t + v²/ρ e_n of the point of a body that moves along the curve; at rest a_t e_t alone."""
        edge, path = self.vectors.edges.get(body), self.curved(body)
        if level == "velocity" or edge is None or path is None or edge.slide is None or edge.slide_rate is None:
            return
        if not self._on_curve(body, at):
            return
        tangent = line(Name("e_t"), " = ", *vector_of(path.tangent, PURE, self.phrases))
        steady = edge.slide_rate in self.vectors.zero
        parts = () if steady else line(self.phrases.math(edge.slide_rate), " ", Name("e_t"))
        radius, note = list[Block](), tangent
        if edge.slide not in self.vectors.zero and self.phrases.value.known(edge.slide) != 0:
            bends = path.tangent.turned()
            normal = bends if self.phrases.value(path.curvature) > 0 else -bends
            note = line(*tangent, ", ", Name("e_n"), " = ", *vector_of(normal, PURE, self.phrases))
            parts = line(*parts, *([" + "] if parts else []), self.phrases.math(edge.slide**2), "/ρ ", Name("e_n"))
            radius = list(self._radius(path, place, body, note))
            if len(radius) > 1:
                yield from (replace(b, note=()) if isinstance(b, Equation) and b.note == note else b for b in radius)
                yield from self._unit_vectors(path.tangent, normal)
                note, radius = (), [radius[-1]]
            else:
                yield from radius
        vector = self.vectors.motion.acceleration(at, body)
        if steady:
            vector = Vec(*(p.xreplace({edge.slide_rate: sp.S.Zero}) for p in (vector.x, vector.y)))
        if self.phrases.symbolic:
            vector = Vec(*(sp.sympify(p).xreplace(self.vectors.letters) for p in (vector.x, vector.y)))
        sides = (line(Name(f"a_{index_of(place)}")), parts, *self._put_in(edge, path, steady))
        yield from self.once(f"acceleration {place}", sides, vector, "acceleration", () if radius else note)

    def _put_in(self, edge: Edge, path: Path, steady: bool) -> list[Line]:
        """Both components of a_t e_t + v²/ρ e_n with their numbers."""
        assert edge.slide is not None
        assert edge.slide_rate is not None
        phrases = self.phrases
        if phrases.symbolic or not phrases.has_numbers(edge.slide + edge.slide_rate + path.curvature):
            return []
        speed = phrases.of_dimension(phrases.certain(edge.slide), VELOCITY).number
        rate = Decimal(0) if steady else phrases.of_dimension(phrases.certain(edge.slide_rate), ACCELERATION).number
        radius = phrases.of_dimension(abs(1 / phrases.value(path.curvature)), LENGTH).number
        towards = ((speed, 2), (radius, -1))
        hollow = path.tangent.turned() * (1 if phrases.value(path.curvature) > 0 else -1)
        components = [
            [*along_unit(phrases.certain(along), ((rate, 1),)), *along_unit(phrases.certain(across), towards)]
            for along, across in ((path.tangent.x, hollow.x), (path.tangent.y, hollow.y))
        ]
        told_both = both_told(components, phrases.figures)
        return [told_both] if told_both else []

    def _unit_vectors(self, tangent: Vec, normal: Vec) -> Iterator[Block]:
        """e_t by the slope y′, and e_n at right angles to it."""
        back = "-" if self.phrases.value(tangent.x) < 0 else ""
        along = line(f"{back}[1, ", Math(SLOPE), "]/", Math(sp.sqrt(1 + SLOPE**2)))
        yield Equation((line(Name("e_t")), along, vector_of(tangent, PURE, self.phrases)))
        words = line("at right angles to ", Name("e_t"), ", to the concave side")
        yield Equation((line(Name("e_n")), vector_of(normal, PURE, self.phrases)), None, (), words)

    def _on_curve(self, body: str, at: Vec) -> bool:
        """Does this point of a body move along the curve, as a particle does and what does not turn?"""
        motion, is_zero = self.vectors.motion, self.phrases.value.is_zero
        if all(
            t[body].angular in self.vectors.zero or is_zero(t[body].angular)
            for t in (motion.velocities, motion.accelerations)
        ):
            return True
        arm = self.scene.arms.between(motion.accelerations[body].point, at)
        return is_zero(arm.x) and is_zero(arm.y)

    def curved(self, body: str) -> Path | None:
        """The fixed curve along which a body moves; None: it is straight there, or there is none."""
        edge = self.vectors.edges.get(body)
        path = edge.joining.path if edge is not None and edge.joining is not None else None
        if edge is None or path is None or path.curvature == 0 or edge.parent != "ground":
            return None
        return None if self.phrases.value.known(path.curvature) is None else path

    def _bends(self, body: str) -> tuple[tuple[sp.Expr, sp.Expr], ...] | None:
        """y′ and y″ of a fixed curve y = f(x) where a body is on it, and as functions of x; None: there is none."""
        joining = self.vectors.edges[body].joining
        joint = next((j for j in self.scene.problem.joints if joining is not None and j.name == joining.joint), None)
        named = (getattr(joint, "along", ""), *getattr(joint, "between", ()))
        surface = next((s for n in named if isinstance(n, str) and (s := self.scene.surfaces.get(n))), None)
        if joining is None or surface is None or surface.body is not None or not isinstance(surface.shape, Curve):
            return None
        if surface.shape.kind != "y":
            return None
        x, formula = curve_formula(self.scene, surface.shape)
        general = [simplified(sp.diff(formula, x, n)) for n in (1, 2)]
        slope, bend = (simplified(e.xreplace({x: joining.point.x})) for e in general)
        plain = not slope.has(sp.Piecewise) and not longer(slope, LONGEST) and not longer(bend, LONGEST)
        return ((slope, general[0]), (bend, general[1])) if plain and bend != 0 else None

    def _of_curve(self, bends: tuple[tuple[sp.Expr, sp.Expr], ...], note: Line) -> Iterator[Block]:
        """y′ and y″ as functions of x with their values, and ρ = (1 + y′²)^(3/2)/|y″|."""
        phrases, ((slope, _), (bend, _)) = self.phrases, bends
        sizes: dict[sp.Symbol, Decimal] = {}
        in_metres = False
        for symbol, (expr, general), dimension in zip((SLOPE, BEND), bends, (PURE, PURE / LENGTH), strict=True):
            sides: list[Any] = [Math(symbol)]
            # Only numbers and x: with lengths in the unit of the page.
            bare = general.free_symbols and not expr.free_symbols and not longer(general, SHORT)
            bare = bool(bare) and not phrases.ledger.us
            sides += [Math(general)] if bare else []
            in_metres |= bare and symbol == SLOPE
            clean = bool(expr.free_symbols) and (
                phrases.symbolic or is_clean(phrases.ledger, expr, dimension=dimension)
            )
            sides += [phrases.math(expr)] if clean else []
            if not (phrases.symbolic and expr.free_symbols):
                value = phrases.of_dimension(phrases.certain(expr), dimension)
                sizes[symbol] = value.number
                per_length = "" if in_metres else value.unit[1:]
                shown = value if dimension == PURE else line(replace(value, unit="1"), per_length)
                sides += [*(phrases.substituted(expr, value) if clean else ()), shown]
            yield Equation(
                tuple(sides), None, (), line("lengths in m" if symbol == SLOPE else "in 1/m") if in_metres else ()
            )
        size = -BEND if phrases.value(bend) < 0 else BEND
        formula, radius = (1 + SLOPE**2) ** sp.Rational(3, 2) / size, (1 + slope**2) ** sp.Rational(3, 2) / abs(bend)
        if len(sizes) < 2:
            yield Equation((line("ρ"), Math(formula), phrases.math(simplified(radius))), None, note=note)
            return
        put = Phrases(phrases.ledger, phrases.value, phrases.figures, False).numbers(formula, sizes, turns=False)
        value = phrases.of_dimension(phrases.value(radius), LENGTH)
        exact = _exact(radius, value)
        yield Equation((line("ρ"), Math(formula), *([] if put is None else [put]), *exact, value), None, note=note)

    def _radius(self, path: Path, place: str, body: str, note: Line = ()) -> Iterator[Block]:
        """ρ of the path of a point, once; nothing where the file gives it by that letter."""
        if place in self._told:
            return
        self._told.add(place)
        sense = 1 if self.phrases.value(path.curvature) > 0 else -1
        radius = abs(1 / path.curvature) if self.phrases.symbolic else sense / path.curvature
        value = () if self.phrases.symbolic else (self.phrases.of_dimension(self.phrases.value(radius), LENGTH),)
        whole = simplified(self._in_full(radius))
        radius = whole if whole.is_Symbol else radius
        if radius.is_Symbol and plain_name(radius.name) == "ρ":
            return
        if bends := self._bends(body):
            yield from self._of_curve(bends, note)
            return
        clean = self.phrases.symbolic or (bool(radius.free_symbols) and is_clean(self.phrases.ledger, radius))
        shown = (self.phrases.math(radius),) if clean and not longer(radius, LONGEST) else ()
        yield Equation((line("ρ"), *shown, *value), None, note=note)

    def _in_full(self, expr: sp.Expr) -> sp.Expr:
        """With what the names of long coordinates stand for, which hide the length of a cord."""
        named = self.phrases.ledger.definitions
        return expr.xreplace({s: named[s] for s in expr.free_symbols if s in named})

    def asked_radius(self, answer: Found, q: Quantity) -> list[Block] | None:
        """The same where it is asked for by that letter; None: it is asked otherwise."""
        if q.word != "rho" or plain_name(answer.name) != "ρ" or answer.unit.text not in ("m", "ft"):
            return None
        body = q.things[0] if q.things[0] in self.scene.bodies else self.scene.owner(q.things[0])
        path, place = self.curved(body), centre_of(self.scene, body)
        if path is None:
            return None
        told = list(self._radius(path, place, body))
        return told if told or place in self._told else None


def _exact(size: sp.Expr, value: Value) -> tuple[Line, ...]:
    """5 √5 m before 11.18 m: a short root of whole numbers, in the base unit; nothing for what is no such root."""
    root = simplified(size)
    if not root.is_number or root.is_Rational or longer(root, FEW) or abs(float(root) - float(value.number)) > ROUNDING:
        return ()
    whole = all((a.is_Integer and abs(int(a)) <= SMALL) or a == sp.Rational(1, 2) for a in root.atoms(sp.Number))
    return (line(Math(root), f" {value.unit}"),) if whole else ()


def vector_of(vector: Vec, dimension: Dimension, phrases: Phrases) -> Line:
    """[x, y] with its unit; in letters where they are short."""
    if not phrases.symbolic:
        return phrases.vector(phrases.certain(vector.x), phrases.certain(vector.y), dimension)
    if longer(vector.x, LONGEST) or longer(vector.y, LONGEST):
        return ()
    plain = [min((factored(p), simplified(p)), key=operations) for p in map(sp.sympify, (vector.x, vector.y))]
    shown: list[Any] = [with_unit(p, dimension, phrases.ledger, phrases.figures) or phrases.math(p) for p in plain]
    return line("[", shown[0], ", ", shown[1], "]")
