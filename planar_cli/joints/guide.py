"""The guide: slot, collar, slider, track."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, ClassVar

from planar_cli.joints._outline_residuals import same_turn, together, touching
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import (
    Facts,
    Joining,
    Law,
    Mode,
    Outline,
    Path,
    Push,
    Row,
    Test,
    center_of,
    opposed,
    relative,
)
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import BodyKey, Choice, DirectionKey, PointKey, SideKey, key
from planar_cli.problem.scene.residuals import Poses, Residual
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import Setting
from planar_cli.problem.scene.sketches import Sketch, Slide


@dataclass(frozen=True, slots=True, kw_only=True)
class Guide(Joint):
    """A point, or a whole body, slides along a line or curve.

    Meaning
        With `point` only that point is held on the track (a pin in a slot); its body may turn. With `body` the body
        slides and cannot turn against its track (a piston, a collar on a rod). `along` is the track: an angle for a
        fixed straight line, the name of a surface, or the name of the body in which the slot is cut. Both sides of
        the track hold. Without a coefficient it is smooth. Where bodies are pinned together at the point, the track
        presses on the particle among them, such as a piston, else on the body that stands first in the file.

    YAML
        title: Slider and crank
        plane: vertical
        points: {O: [0, 0], A: [0, 0.1 m], B: {from: A, distance: 0.3 m, angle: -20 deg}}
        bodies:
          OA: {rod: [O, A], mass: 1 kg}
          AB: {rod: [A, B], mass: 2 kg}
        joints:
          - pin: {at: O, between: [ground, OA]}
          - pin: {at: A, between: [OA, AB]}
          - guide: {point: B, along: 0 deg}
        motion: [omega(OA) = 10 rad/s]
        find: {v: v(B).x, N: N(B)}

    Equations
        The place of the point across the track is constant; in a slot of body b this is r(P/b).across(b) = constant.
        With `body` also θ of the body = θ of the track + constant. One normal reaction, and a moment with `body`;
        friction as at a contact.

    Signs
        `N(j)` is the component of the force on the sliding body along the track's left normal (track direction turned
        90 deg counterclockwise); it may have either sign. `friction(j)` is the friction force on the sliding body. At a
        fixed point both are the forces on the body that slides over it.

    Valid when
        There is no play in the track.

    Reference
        An Introduction to Planar Dynamics, 1.4.3 (slotted arm), 2.4 (motion relative to a rotating body), 4.3.
    """

    kind: ClassVar[str] = "guide"
    guides: ClassVar[bool] = True
    quantities: ClassVar[tuple[str, ...]] = ("N", "friction", "mode")
    choices: ClassVar[tuple[Choice, ...]] = (
        Choice((("point",), ("body",)), "`point: B` when its body may turn, `body: b` when it cannot"),
        Choice(
            ((), ("mu",), ("mu_s", "mu_k"), ("mu_s",), ("mu_k",)),
            "`mu`, or `mu_s` and `mu_k`, or one of the two alone; none when it is smooth",
        ),
    )

    point: str | None = key(PointKey(), "the point that slides; its body may turn", default=None)
    body: str | None = key(BodyKey(), "the body that slides and cannot turn", default=None)
    along: Side | str = key(DirectionKey(), "the track: an angle, a surface, or the body that has the slot")
    mu: Side | None = key(SideKey("1"), "coefficient of friction, static and kinetic", default=None)
    mu_s: Side | None = key(SideKey("1"), "coefficient of static friction", default=None)
    mu_k: Side | None = key(SideKey("1"), "coefficient of kinetic friction", default=None)

    def holder(self) -> str:
        return self.along if isinstance(self.along, str) else GROUND

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        joining, _ = self._joining(scene)
        along = joining.path.tangent if joining.path is not None else Vec(1, 0)
        whole = self.body or (None if joining.mover == GROUND or scene.rigid(joining.mover) else joining.mover)
        drawn = joining.base == GROUND and scene.names_carrier(self._track())
        carrier = None if joining.base == GROUND else joining.base
        grounded, pinned = joining.base == GROUND, joining.mover == GROUND
        return (Slide(joining.point, along, grounded, whole, drawn, carrier, pinned, self._track()),)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        joining, normal = self._joining(scene)
        self._demand_slot_told(scene, joining)
        tangent = joining.path.tangent if joining.path else normal
        n = self._push(f"N_{self.name}", "normal", joining, normal)
        pushes = [n]
        turning = self._turning(scene, joining, scene.track(self.along, joining.point, self.mark).sharpening)
        if self.body is not None and scene.rigid(joining.mover):
            # On a curved track the couple comes with a force along it, so that together they do no work.
            force = -tangent * joining.path.curvature if turning and joining.path else None
            actions = opposed(joining.mover, joining.base, joining.point, force, 1)
            pushes.append(Push(f"M_{self.name}", "couple", self.name, joining.place, actions, "N*m"))
        static, kinetic = self.mu_s or self.mu or self.mu_k, self.mu_k or self.mu or self.mu_s
        if static is None or kinetic is None or scene.is_zero(scene.value(static)):
            return (Mode("slip", "", Facts((joining,), turning, tuple(pushes))),)
        pushes.append(self._push(f"F_{self.name}", "friction", joining, tangent))
        return self._rough(scene, joining, turning, tuple(pushes), scene.value(static), scene.value(kinetic))

    def _track(self) -> str:
        """The name of the surface or body along which it runs; "": a direction is given."""
        return self.along if isinstance(self.along, str) else getattr(self.along, "name", "")

    def _joining(self, scene: Setting) -> tuple[Joining, Vec]:
        along = self._track()
        base = scene.carrier(along) if scene.names_carrier(along) else "ground"
        if self.body is not None:
            mover, point, place = self.body, scene.center(self.body), scene.center_name(self.body)
        else:
            place = self.point or ""
            mover, point = scene.owner(place, base), scene.point(place)
            if mover == GROUND and (base == GROUND or scene.owner(place) != GROUND):
                raise scene.refuse(
                    self.mark,
                    "PL524",
                    f"{place} belongs to no body that could slide",
                    "name it among the body's points",
                )
        track = scene.track(self.along, point, self.mark)
        tangent, curvature = track.tangent or Vec(1, 0), track.curvature
        turns = self.body is None or not scene.vanishes(curvature)
        return Joining(self.name, mover, base, point, place, Path(tangent, curvature), turns), tangent.turned()

    def _demand_slot_told(self, scene: Setting, joining: Joining) -> None:
        """A body that is drawn by points alone has no line: its slot lies at 0 deg, as its points have to tell."""
        along = self._track()
        names = scene.drawn_by(along) if along == joining.base else ()
        places = [scene.point(name) for name in names]
        # A block lies somewhere on a cart, but a slot in which a point runs goes through the point.
        here = joining.point if self.point is not None else places[0] if places else joining.point
        reaches = [r for r in (place - here for place in places) if not scene.is_zero(r.dot(r))]
        level = [r for r in reaches if scene.is_zero(r.cross(scene.direction(along)))]
        spread = self.point is None and any(not scene.is_zero(r.cross(reaches[0])) for r in reaches)
        if reaches and not level and not spread:
            ends = list(dict.fromkeys([*names, joining.place] if self.point is not None else names))[:2]
            text = f"{along} is drawn by points, so that its slot lies at 0 deg, and not along {'/'.join(ends)}"
            hint = f"draw it as `{{rod: [{', '.join(ends)}]}}`, or fix a line to it: `surfaces: {{slot: {{through: "
            hint += f"{ends[0]}, angle: 30 deg, body: {along}}}}}` and `along: slot`"
            raise scene.refuse(self.mark, "PL538", text, hint)

    def _turning(self, scene: Setting, joining: Joining, sharpening: Any) -> tuple[Row, ...]:
        """A body that cannot turn against a curved track turns with its tangent: ω - ω_base = κ · speed along it."""
        if self.body is None or not joining.turns or joining.path is None or not scene.rigid(joining.mover):
            return ()
        tangent, curvature, words = joining.path.tangent, joining.path.curvature, "turns with its track"
        pulls = relative(joining.mover, joining.base, joining.point, -tangent * curvature)
        slides = relative(joining.mover, joining.base, joining.point, tangent)
        spins = ((joining.mover, 1), (joining.base, -1))
        title = f"{joining.mover} {words}"
        return (Row(self.name, title, pulls, spins, slides=slides, sharpening=sharpening),)

    def _push(self, name: str, kind: str, joining: Joining, direction: Vec) -> Push:
        actions = opposed(*_sliding(joining), joining.point, direction)
        return Push(name, kind, self.name, joining.place, actions)

    def _rough(
        self,
        scene: Setting,
        joining: Joining,
        turning: tuple[Row, ...],
        pushes: tuple[Push, ...],
        static: Any,
        kinetic: Any,
    ) -> tuple[Mode, ...]:
        """A two-sided guide presses on one side or the other: each mode has a sign of N."""
        normal, friction = f"N_{self.name}", f"F_{self.name}"
        path = joining.path
        tangent = path.tangent if path else Vec(1, 0)
        pulls = relative(*_sliding(joining), joining.point, tangent)
        sliding = Row(self.name, f"{joining.place} does not slide", pulls)
        modes = []
        for side in (1, -1):
            pressed = Test(self.name, "the side of the guide that is pressed", ((normal, side),))
            limits = tuple(
                Test(self.name, "friction within its limit", ((normal, side * static), (friction, s))) for s in (1, -1)
            )
            held = Facts((joining,), (*turning, sliding), pushes)
            modes.append(
                Mode("stick", f"{joining.place} does not slide in its guide", held, (pressed, *limits), sliding)
            )
        for direction in (1, -1):
            for side in (1, -1):
                pressed = Test(self.name, "the side of the guide that is pressed", ((normal, side),))
                moves = Test(self.name, "it slides as assumed", row=sliding, sense=direction, strict=True)
                law = Law(friction, -direction * side * kinetic, normal)
                facts = Facts((joining,), turning, pushes, (law,))
                modes.append(
                    Mode("slip", f"{joining.place} slides in its guide", facts, (pressed, moves), sliding, direction)
                )
        return tuple(modes)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        joining, _ = self._joining(scene)
        mover, base, point = joining.mover, joining.base, joining.point
        track = scene.track(self.along, point, self.mark)
        if scene.vanishes(track.curvature):
            track = replace(track, kind="straight")
        found = touching(self.name, Outline("corner", mover), track, point)
        if self.point is not None and track.kind == "straight":
            found = tuple(Residual(f"{self.name}: place of {self.point} across its line", r.of) for r in found)
        if mode.name == "stick":
            found = (together(f"{self.name}: place", mover, base, point),)
        if self.body is None or not (scene.rigid(mover) and scene.rigid(base)):
            return found
        if track.kind == "straight" or mode.name == "stick":
            return (*found, same_turn(f"{self.name}: angle", mover, base))
        return (*found, _with_tangent(self.name, mover, track, point))


def _sliding(joining: Joining) -> tuple[str, str]:
    """The body that slides, and what it slides on; over a fixed point the body with the track slides."""
    return (joining.base, joining.mover) if joining.mover == GROUND else (joining.mover, joining.base)


def _with_tangent(name: str, mover: str, track: Outline, point: Vec) -> Residual:
    """On a curved track the body turns with the tangent, as the radius from its centre does."""

    def angle(poses: Poses) -> Any:
        if track.curve:
            along = poses.along_curve(track, mover, point)
        else:
            along = poses.point(mover, point) - poses.point(track.body, center_of(track, point) or point)
        return poses.angle(mover) - poses.turned(along)

    return Residual(f"{name}: angle", angle, turns=True)
