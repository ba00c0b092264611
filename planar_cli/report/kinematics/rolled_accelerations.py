"""Accelerations of the points of a wheel that rolls without slipping on what is fixed, by way of its centre.

a_G = α × r_G/C + v_G²/ρ e_n                   ρ of the path of G; on a straight line without the last part
a_P = a_G + α × r_P/G - ω² r_P/G               (An Introduction to Planar Dynamics, 2.4)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Paragraph, line
from planar_cli.report.kinematics.component_sums import Turned, components_told
from planar_cli.report.kinematics.on_path import Once, vector_of
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.counted import as_vector
from planar_cli.units import ACCELERATION, LENGTH, PURE, Dimension

STRAIGHT = " moves along a straight line"
STILL = Vec(sp.S.Zero, sp.S.Zero)
Velocity = Callable[[str], Iterator[Block]]
"""Tells the velocity of a body's centre, where nothing has told it."""


@record
class Wheel:
    """A body that rolls: the point of contact, its centre, the radius of the path of this (None: a straight line), and
    the direction towards the concave side of that path.
    """

    body: str
    joining: Joining
    centre: Vec
    radius: sp.Expr | None
    normal: Vec


class RolledTelling:
    """Lines of the points of wheels."""

    def __init__(self, vectors: VectorTelling, once: Once, velocity: Velocity) -> None:
        self.vectors, self.phrases, self.once, self.velocity = vectors, vectors.phrases, once, velocity
        self.scene = vectors.system.scene
        self._still: set[str] = set()
        """Wheels of which it was said that their centre has no acceleration."""

    def acceleration(self, body: str, at: Vec, place: str, level: str) -> Iterator[Block]:
        """The acceleration of a point of a wheel with its value, after that of the centre."""
        wheel = self.wheel(body) if level == "acceleration" else None
        if wheel is None:
            return
        name, arm = centre_of(self.scene, body), self.scene.arms.between(wheel.centre, at)
        omega, alpha = self.vectors.motion.velocities[body].angular, self._alpha(body)
        inward: list[Any] = [] if omega == 0 else ["-", self.phrases.math(omega**2), " ", _arm(place, name)]
        if wheel.radius is None and place == wheel.joining.place and inward:
            only = f"{body} rolls without slipping: {place} has an acceleration towards "
            yield Paragraph(line(only, Name(name), " only"))
            told = self._told(STILL, sp.S.Zero, arm, omega)
            yield from self._once(body, at, place, line(*inward), told, self.vectors.arm_told(place, name, arm))
            return
        central = self._is_zero(arm)
        # a_G = R α of a wheel on a straight line says all there is.
        if self.phrases.value.known(alpha) is None or (central and wheel.radius is None):
            return
        yield from self._centre(wheel)
        if central:
            return
        centre = self.vectors.motion.acceleration(wheel.centre, body)
        parts: list[Any] = [] if self._is_zero(centre) else [Name(f"a_{index_of(name)}")]
        turned = self._product(alpha, place, name)
        parts += [" + ", *turned] if parts and turned else turned
        parts += [" - ", *inward[1:]] if parts and inward else inward
        told = self._told(centre, alpha, arm, omega)
        yield from self._once(body, at, place, line(*parts), told, self.vectors.arm_told(place, name, arm))

    def in_letters(self, body: str, at: Vec, place: str) -> Iterator[Block]:
        """The acceleration of a point of a wheel on a straight line, before that of the centre is known."""
        wheel = self.wheel(body)
        if wheel is None or wheel.radius is not None:
            return
        name = centre_of(self.scene, body)
        if place in (wheel.joining.place, name):
            return
        omega, alpha = self.vectors.motion.velocities[body].angular, self._alpha(body)
        parts = self._product(alpha, name, wheel.joining.place)
        if parts:
            yield Equation((line(Name(f"a_{index_of(name)}")), line(*parts)), None, note=line(Name(name), STRAIGHT))
            parts = [Name(f"a_{index_of(name)}"), " + ", *self._product(alpha, place, name)]
        elif not alpha and body not in self._still:
            self._still.add(body)
            yield self._nought(name)
        if omega != 0:
            parts += [" - " if parts else "-", self.phrases.math(omega**2), " ", _arm(place, name)]
        yield Equation((line(Name(f"a_{index_of(place)}")), line(*parts or ["0"])))

    @staticmethod
    def _nought(name: str) -> Equation:
        """The centre of a wheel that rolls steadily on a straight line has no acceleration."""
        why = line(Name(name), STRAIGHT, " at constant speed")
        return Equation((line(Name(f"a_{index_of(name)}")), line("0")), None, note=why)

    def _is_zero(self, vector: Vec) -> bool:
        return all(self.phrases.value.is_zero(p) for p in (vector.x, vector.y))

    def _centre(self, wheel: Wheel) -> Iterator[Block]:
        """The acceleration of the centre, along and across its path."""
        body, j, name = wheel.body, wheel.joining, centre_of(self.scene, wheel.body)
        arm, alpha = self.scene.arms.between(j.point, wheel.centre), self._alpha(body)
        parts, inward = self._product(alpha, name, j.place), STILL
        if wheel.radius is None or self.vectors.motion.velocities[body].angular == 0:
            note = self.vectors.arm_told(name, j.place, arm) if parts else ()
            if parts and wheel.radius is None:
                why = line(Name(name), STRAIGHT)
                note = line(*note, ", ", *why) if note else why
        else:
            yield from self.velocity(body)
            parts += [" + "] if parts else []
            parts += [Name(f"v_{index_of(name)}²"), "/ρ ", Name("e_n")]
            v = self.vectors.motion.velocity(wheel.centre, body)
            inward, note = wheel.normal * ((v.x**2 + v.y**2) / wheel.radius), self._radius(wheel)
        if not parts:
            # Where it stands above, it is not said again.
            yield self._nought(name)
            return
        told = self._told(inward, alpha, arm, sp.S.Zero)
        yield from self._once(body, wheel.centre, name, line(*parts), told, note)

    def _radius(self, wheel: Wheel) -> Line:
        """The radius of the path of the centre, and the direction to the concave side of it."""
        assert wheel.radius is not None
        sides: list[Any] = [self.phrases.math(wheel.radius)] if wheel.radius.free_symbols else []
        if not self.phrases.symbolic:
            sides += [" = "] if sides else []
            sides.append(self.phrases.of_dimension(self.phrases.value(wheel.radius), LENGTH))
        return line("ρ = ", *sides, ", ", Name("e_n"), " = ", *vector_of(wheel.normal, PURE, self.phrases))

    def _once(self, body: str, at: Vec, place: str, formula: Line, told: Line, note: Line) -> Iterator[Block]:
        name, vector = index_of(place), self.vectors.motion.acceleration(at, body)
        sides = (line(Name(f"a_{name}")), formula, *([told] if told else []))
        yield from self.once(f"acceleration {place}", sides, vector, "acceleration", note)

    def _alpha(self, body: str) -> sp.Expr:
        alpha = self.vectors.motion.accelerations[body].angular
        return sp.S.Zero if alpha in self.vectors.zero else alpha

    def _product(self, alpha: sp.Expr, place: str, reference: str) -> list[Any]:
        letter = as_vector(alpha, self.vectors.system)
        return [] if alpha == 0 else [self.phrases.math(letter), " × ", _arm(place, reference)]

    def _told(self, base: Vec, alpha: sp.Expr, arm: Vec, omega: sp.Expr) -> Line:
        """The components with their numbers."""
        if self.phrases.symbolic:
            return ()
        certain = self.phrases.certain

        def pair(vector: Vec, dimension: Dimension) -> tuple[Decimal, Decimal]:
            x, y = (self.phrases.of_dimension(certain(p), dimension).number for p in (vector.x, vector.y))
            return x, y

        turned = Turned(pair(base, ACCELERATION), certain(alpha), pair(arm, LENGTH), certain(omega))
        return components_told(turned, self.phrases.figures)

    def wheel(self, body: str) -> Wheel | None:
        """A round body that rolls on what is fixed; None: it does not, or its centre is no point of the scene."""
        edge = self.vectors.edges.get(body)
        j = edge.joining if edge is not None else None
        if edge is None or j is None or j.rolling is None or edge.backward or {edge.parent, j.base} != {GROUND}:
            return None
        own, base, value = j.rolling.mover, j.rolling.base, self.phrases.value
        if value.is_zero(own) or (j.drift is not None and not value.is_zero(base)):
            return None
        centre = j.point + j.rolling.tangent.turned() / own
        off = centre - self.scene.center(body)
        if not all(value.is_zero(p) for p in (off.x, off.y)):
            return None
        towards = j.rolling.tangent.turned()
        if value.is_zero(base):
            return Wheel(body, j, self.scene.center(body), None, towards)
        bend = simplified(1 / base - 1 / own)
        sense = 1 if value(bend) > 0 else -1
        return Wheel(body, j, self.scene.center(body), simplified(sense * bend), towards * sense)


def _arm(place: str, reference: str) -> Name:
    return Name(f"r_{index_of(place)}/{index_of(reference)}")
