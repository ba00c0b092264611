"""Poses of the bodies near the drawn configuration, as time jets: what the position residuals of joints are fed with.

A body with centre c turns by a small angle δ: a point drawn at c + r goes to c + r cos δ + k × r sin δ. To the second
order in time cos δ = 1 - δ²/2 and sin δ = δ are exact, and so is atan x = x for the small angle by which a
direction has turned.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from decimal import Decimal
from typing import Any

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.facts import Outline, center_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import changing, record
from planar_cli.solve.multibody.time_jets import ONE, TWO, ZERO, TimeJet, constant

ELAPSED = TimeJet(ZERO, ONE, ZERO, {})


@record
class Place:
    """One body: its centre, its velocity there and ω; the numbers of its coordinates x, y, θ (None: a particle)."""

    center: Vec
    velocity: Vec
    spin: Decimal
    columns: tuple[int, int, int | None]


@changing
class NearPoses:
    """The poses q + q̇ t of all bodies; the ground, and what is not among `places`, stays."""

    value: Valuation
    places: Mapping[str, Place]
    time: TimeJet = ELAPSED
    _centers: dict[str, Vec] = field(default_factory=dict)
    _frames: dict[str, Vec] = field(default_factory=dict)

    def number(self, drawn: Any) -> Any:
        """The Decimal value of an expression of the scene."""
        return self.value(drawn) if not isinstance(drawn, Decimal) else drawn

    def vector(self, drawn: Vec) -> Vec:
        """The same of both parts of a vector."""
        return Vec(self.number(drawn.x), self.number(drawn.y))

    def point(self, body: str, drawn: Vec) -> Vec:
        """The place of the material point drawn there."""
        at = self.vector(drawn)
        place = self.places.get(body)
        if place is None:
            return Vec(constant(at.x), constant(at.y))
        arm = at - place.center
        center = self._center(body, place)
        return center + self._turn(body, place, arm) if arm.x or arm.y else center

    def direction(self, body: str, drawn: Vec) -> Vec:
        """A vector that turns with the body."""
        v = self.vector(drawn)
        place = self.places.get(body)
        if place is None or place.columns[2] is None:
            return Vec(constant(v.x), constant(v.y))
        return self._turn(body, place, v)

    def angle(self, body: str) -> TimeJet:
        """The angle by which the body has turned."""
        place = self.places.get(body)
        if place is None or place.columns[2] is None:
            return constant(0)
        return TimeJet(ZERO, place.spin, ZERO, {place.columns[2]: ONE})

    def length(self, v: Vec) -> Any:
        """|v|."""
        return v.dot(v).sqrt()

    def root(self, square: Any) -> Any:
        """√square, of a Decimal or a jet."""
        return square.sqrt()

    def turned(self, v: Vec) -> TimeJet:
        """The angle from the drawn direction to the present one, by its tangent, which starts at zero."""
        drawn = Vec(v.x.value, v.y.value)
        found: TimeJet = drawn.cross(v) / drawn.dot(v)
        return found

    def positive(self, number: Any) -> bool:
        """Is a number or jet, as drawn, not negative?"""
        return bool((number if isinstance(number, Decimal) else number.value) >= 0)

    def change(self, number: Any) -> Any:
        """The number less its value as drawn."""
        return number - number.value

    def off_curve(self, curve: Outline, other: Outline, place: Vec) -> TimeJet:
        """The curve is taken as its circle of curvature there, which is exact to the second order."""
        own = center_of(other, place)
        now, center = self.point(other.body, place if own is None else own), self._bend_center(curve, place)
        if center is None:
            along = self.direction(curve.body, _tangent(curve))
            found: TimeJet = self.change((now - self.point(curve.body, place)).cross(along))
            return found
        away: TimeJet = self.change(self.length(now - self.point(curve.body, center)))
        return away

    def foot(self, curve: Outline, rim: Outline, place: Vec) -> tuple[TimeJet, TimeJet]:
        """On the circle of curvature, which is exact to the second order."""
        own, bend = center_of(rim, place) or place, self._bend_center(curve, place)
        now = self.point(rim.body, own)
        if bend is None:
            reach = now - self.point(curve.body, place)
            return self.change(reach.dot(self.direction(curve.body, _tangent(curve)))), self.angle(curve.body)
        turn = self.turned(now - self.point(curve.body, bend))
        return (turn - self.angle(curve.body)) / self.number(curve.curvature), turn

    def along_curve(self, curve: Outline, body: str, place: Vec) -> Vec:
        """The radius of the circle of curvature; of a straight piece the tangent. It turns a little more, to the second
        order, where the curvature changes on the way.
        """
        center, now, tangent = self._bend_center(curve, place), self.point(body, place), _tangent(curve)
        along = self.direction(curve.body, tangent) if center is None else now - self.point(curve.body, center)
        slid = (now - self.point(curve.body, place)).dot(self.direction(curve.body, tangent))
        turned: Vec = along + along.turned() * (slid * slid * (self.number(curve.sharpening) / 2))
        return turned

    def _bend_center(self, curve: Outline, place: Vec) -> Vec | None:
        """The centre of curvature; None where the curve does not bend."""
        return center_of(curve, place) if self.number(curve.curvature) else None

    def _center(self, body: str, place: Place) -> Vec:
        found = self._centers.get(body)
        if found is None:
            (x, y, _), c, v = place.columns, place.center, place.velocity
            found = Vec(TimeJet(c.x, v.x, ZERO, {x: ONE}), TimeJet(c.y, v.y, ZERO, {y: ONE}))
            self._centers[body] = found
        return found

    def _turn(self, body: str, place: Place, arm: Vec) -> Vec:
        """cos δ · arm + sin δ · k × arm."""
        if place.columns[2] is None:
            return Vec(constant(arm.x), constant(arm.y))
        frame = self._frames.get(body)
        if frame is None:
            sine = self.angle(body)
            frame = self._frames[body] = Vec(ONE - sine * sine / TWO, sine)
        return Vec(frame.x * arm.x - frame.y * arm.y, frame.x * arm.y + frame.y * arm.x)


def _tangent(curve: Outline) -> Vec:
    assert curve.tangent is not None
    return curve.tangent
