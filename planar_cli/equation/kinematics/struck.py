"""The scene in a blow: a collision, an impulse, a joint that takes hold of moving parts.

    momentum before + impulses = momentum after          m v_1 + ΣJ = m v_2,   H_1 + Σ r × J = H_2

(An Introduction to Planar Dynamics, 3.4, 3.7, 4.6.) It takes no time: nothing moves, finite forces have no impulse. The
same machinery as at an instant at rest works it out: impulses stand for forces, velocities just after the blow for
accelerations, and the momenta with which the bodies arrive act like known impulses.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.motion import Twist
from planar_cli.equation.scene.meeting import meeting_of
from planar_cli.equation.scene.nearness import distance, doubtful_corner, doubtful_normal, doubtful_place
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Mark, refuse
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Meeting, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.headings import heading
from planar_cli.problem.scene.impulse_letters import impulse_letters
from planar_cli.problem.scene.scene import GROUND

MADE = re.compile(r"^(mass|moment of inertia) of |mass centre")
"""What is worked out of a body, by its title."""
AXES = (Vec(sp.S.One, sp.S.Zero), Vec(sp.S.Zero, sp.S.One))


class StruckScene(Scene):
    """`before`: the motion of every body just before the blow; `open_names`: unknowns that joints brought in."""

    before: Mapping[str, Twist]
    open_names: dict[str, sp.Symbol]

    def arriving(self, point: Vec, body: str) -> Vec:
        """The velocity of a body's point just before the blow."""
        if body == GROUND:
            return Vec(sp.S.Zero, sp.S.Zero)
        twist = self.before[body]
        found: Vec = twist.linear + (point - twist.point).turned() * twist.angular
        return found

    def constants(self) -> list[sp.Symbol]:
        """The letters of masses, mass centres and moments of inertia that do not change with places."""
        definitions, titles, constant = self.ledger.definitions, self.ledger.titles, []
        for symbol, expr in definitions.items():
            inside = expr.free_symbols
            while inside & definitions.keys():
                inside = set().union(*(definitions.get(s, s).free_symbols for s in inside))
            if MADE.search(titles.get(symbol, "")) and not inside & set(self.ledger.coordinates):
                constant.append(symbol)
        return constant

    def meeting(
        self,
        between: tuple[str, ...],
        normal: Side | None,
        mark: Mark,
        at: str = "",
        during: tuple[str, str] | None = None,
    ) -> Meeting:
        """Where two bodies strike each other. `at`: the point that the file names; `during`: the states between which
        alone they do.
        """
        return meeting_of(self, between, None if normal is None else heading(self, normal), mark, at, during)

    def distance(self, joint: Any, value: Valuation) -> Decimal | None:
        """How far apart the two bodies of an impact are, in m; None where their shapes do not tell."""
        return distance(self, getattr(joint, "between", ()), value, getattr(joint, "at", ""))

    def doubtful(self, joint: Any, value: Valuation, near: Decimal) -> str:
        """What is wrong with the point at which an impact is taken to happen, with these numbers; "" if nothing is."""
        struck = self.meeting(joint.between, joint.normal, joint.mark, joint.at).point
        return doubtful_corner(self, joint.between, struck, value, near, joint.at)

    def demand_as_said(self, joint: Any, value: Valuation, near: Decimal) -> None:
        """FileProblem where an impact says another point or another normal than the shapes have, with these numbers.
        Nothing is said against a particle that is drawn beside what it strikes.
        """
        struck = self.meeting(joint.between, joint.normal, joint.mark, joint.at).point
        words, gap = " and ".join(joint.between), self.distance(joint, value)
        if gap is not None and gap > near:
            return
        if joint.at and doubtful_place(struck, self.point(joint.at), value, near):
            text = f"{words} do not touch at {joint.at}"
            raise refuse(joint.mark, "PL536", text, "leave `at` out, or correct the places")
        if joint.normal is not None:
            turned = doubtful_normal(self, joint.between, struck, heading(self, joint.normal), value, near)
            if turned is not None:
                text = f"the common normal of {words} is at {float(round(turned, 6)):.6g} deg"
                raise refuse(joint.mark, "PL536", text, "leave `normal` out, or correct the places")

    def unknown(self, name: str, unit: str) -> sp.Symbol:
        """A constant of the blow that the file leaves open."""
        if name not in self.open_names:
            self.open_names[name] = self.ledger.letter(name, unit)
        return self.open_names[name]

    def blows(self, setting: Any) -> tuple[Wrench, ...]:
        """The impulses of the file, and the momenta with which the bodies arrive."""
        found: list[Wrench] = []
        for name, body in self.bodies.items():
            v = self.arriving(body.center, name)
            for part, axis in zip((v.x, v.y), AXES, strict=True):
                if body.mass != 0 and part != 0:
                    size = body.mass * part
                    found.append(Wrench("", "momentum", name, body.center, axis * size, 0, size))
            spin = self.before[name].angular
            if body.inertia != 0 and spin != 0:
                size = body.inertia * spin
                found.append(Wrench("", "momentum", name, body.center, None, size, size))
        letters = impulse_letters(self.problem)
        for load in self.problem.loads:
            letter = self.ledger.symbols[letters[load.name][0]] if load.name in letters else None
            found += [_named(w, letter) for w in load.impulses(setting) if w.body != GROUND]
        return tuple(found)


def _named(wrench: Wrench, letter: sp.Symbol | None) -> Wrench:
    """An impulse by its letter."""
    if letter is None or wrench.force is None or wrench.magnitude == 0:
        return wrench
    return replace(wrench, force=wrench.force * (letter / wrench.magnitude), magnitude=letter)
