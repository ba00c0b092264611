"""Poses of the bodies as terms: what the position residuals of joints are fed with, for any motion however large."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from planar_cli.motion.scene.carried import Carried
from planar_cli.motion.scene.curves import curve_at, off_curve
from planar_cli.motion.scene.feet import Foot
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.facts import Outline
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Curve
from planar_cli.records import record


@record
class MovingPoses:
    """What is drawn counts as it is in the reference configuration; from there the bodies carry it along."""

    scene: Carried
    feet: Mapping[tuple[str, str], Foot]
    """Where rims are nearest to curves, by surface and body."""

    @property
    def time(self) -> Term:
        """Since the reference configuration, s."""
        return self.scene.time - self.scene.time.value

    def number(self, drawn: Any) -> Term:
        """A constant."""
        graph = self.scene.graph
        return graph.number(graph.of(drawn).value)

    def vector(self, drawn: Vec) -> Vec:
        """A constant vector."""
        return Vec(self.number(drawn.x), self.number(drawn.y))

    def point(self, body: str, drawn: Vec) -> Vec:
        """Where the body's material point is that was drawn there."""
        return self.scene.carried_from(body, self.vector(drawn))

    def direction(self, body: str, drawn: Vec) -> Vec:
        """A direction that turns with the body."""
        return self.scene.turned_with(body, self.vector(drawn))

    def angle(self, body: str) -> Term:
        """The angle by which the body has turned, counterclockwise."""
        return self.scene.turned_by(body)

    def length(self, v: Vec) -> Term:
        """|v|."""
        return self.root(v.dot(v))

    def root(self, square: Any) -> Term:
        """√square."""
        graph = self.scene.graph
        return graph.call("sqrt", graph.of(square))

    def turned(self, v: Vec) -> Term:
        """The angle by which a direction has turned since it was drawn; it goes on over many turns."""
        graph = self.scene.graph
        return graph.turning(graph.of(v.y), graph.of(v.x))

    def positive(self, number: Any) -> bool:
        """Is a number, as drawn, not negative?"""
        return self.scene.sign(number) >= 0

    def off_curve(self, curve: Outline, other: Outline, place: Vec) -> Term:
        """How far a corner has come off a curve, or a rim from its distance as drawn."""
        surface = self.scene.surfaces[curve.curve]
        assert isinstance(surface.shape, Curve)
        foot = self.feet.get((curve.curve, other.body))
        if other.kind == "arc" and foot is not None:
            return self.change(foot.height)
        return self.change(off_curve(self.scene, surface, surface.shape, self.point(other.body, place)))

    def foot(self, curve: Outline, rim: Outline, place: Vec) -> tuple[Term, Term]:
        """The arc travelled on the curve, and how its tangent has turned."""
        foot = self.feet[curve.curve, rim.body]
        return self.change(foot.arc), self.turned(foot.bend.tangent)

    def along_curve(self, curve: Outline, body: str, place: Vec) -> Vec:
        """The tangent of the curve where the body's point is."""
        surface = self.scene.surfaces[curve.curve]
        assert isinstance(surface.shape, Curve)
        return curve_at(self.scene, surface, surface.shape, self.point(body, place)).tangent

    def change(self, number: Any) -> Term:
        """A number less its value as drawn."""
        term = self.scene.graph.of(number)
        return term - term.value
