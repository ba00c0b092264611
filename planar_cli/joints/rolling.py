"""Rolling without slipping."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.joints._outline_residuals import stuck
from planar_cli.joints._tangency import away, demand_above, demand_common_tangent
from planar_cli.joints.base import Joint
from planar_cli.problem.scene.facts import Facts, Joining, Mode, Outline, Push, opposed
from planar_cli.problem.scene.facts import Rolling as NoSlip
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import PartnersKey, PointKey, key
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.setting import Setting


@dataclass(frozen=True, slots=True, kw_only=True)
class Rolling(Joint):
    """Two bodies roll on each other without slipping.

    Meaning
        The wheel touches the other body or surface at `at` and does not slip: a wheel on the floor, a gear on a rack,
        two gears, a wheel inside a ring. The force that this takes is asked by `N` and `friction`; if the wheel might
        slip, write `contact` with a coefficient. From one surface to another: one `during: 1->2`, the next
        `during: 2->3`, where state 2 says that the wheel touches the next one (`y(wheel) = R` on a floor at y = 0).
        A wheel whose centre is written with a coordinate, `G: [x, R]`, touches at a point that goes along, `C: [x, 0]`:
        planar explain coordinates.

    YAML
        title: Cylinder rolls down an incline
        plane: vertical
        points: {C: [0, 0], G: {from: C, distance: 0.2 m, angle: 60 deg}}
        surfaces: {incline: {through: C, angle: -30 deg}}
        bodies: {cylinder: {disk: G, radius: 0.2 m, mass: 18 kg}}
        joints:
          - rolling: {between: [cylinder, incline], at: C}
        instant: [at rest]
        find: {alpha: alpha(cylinder), a: a(G).along(-30 deg)}

    Equations
        The two points that touch have the same velocity: on a fixed line v_G = ω R along it, and a_G along = α R
        (with the sign of the rotation). Two reactions, normal and friction.

    Signs
        `N(j)` > 0 presses. `friction(j)` is a vector, the force on the body whose partner is the ground, else on the
        body named, `friction(j/b)`.

    Valid when
        |friction| <= mu_s N, which the file does not say; then `contact` tells.

    Reference
        An Introduction to Planar Dynamics, Example 1-3, 1-9, 2.3.1, 2.3.2, 4.3.
    """

    kind: ClassVar[str] = "rolling"
    guides: ClassVar[bool] = True
    quantities: ClassVar[tuple[str, ...]] = ("N", "friction", "mode")
    touches: ClassVar[bool] = True

    between: tuple[str, ...] = key(PartnersKey(), "the wheel and what it rolls on")
    at: str = key(PointKey(), "the point where they touch; left out where the shapes tell it", default="")

    def attachments(self) -> tuple[tuple[str, str], ...]:
        return tuple((self.at, body) for body in self.between)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        place = scene.point(self.at)
        a, b = self._outlines(scene, place)
        if a.body == "ground" or (a.kind != "arc" and b.kind == "arc"):
            a, b = b, a
        if a.tangent is None or b.tangent is None:
            corner = a.body if a.tangent is None else b.body
            if len(scene.drawn_by(corner)) == 1:
                (center,) = scene.drawn_by(corner)
                text = f"{self.name}: {corner} has no radius: nothing but {center} tells its shape, and so no rim"
                hint = f"write `{corner}: {{disk: {center}, radius: …}}`, the distance from {center} to where it rolls"
                raise scene.refuse(self.mark, "PL523", text, hint)
            raise scene.refuse(
                self.mark,
                "PL523",
                f"{self.name}: a corner can not roll, and {corner} has its end or a corner there",
                "rolling needs a round rim on a rim, rack or surface: a wheel is `disk: O, radius: R`, "
                "with `center: G` where its mass centre is not O; let a rack reach beyond the point on both sides",
            )
        demand_common_tangent(self.between, self.at, a, b, scene, self.mark)
        same = scene.sign(a.tangent.dot(b.tangent))
        tangent = b.tangent
        joining = Joining(
            self.name,
            a.body,
            b.body,
            place,
            self.at,
            rolling=NoSlip(tangent, same * a.curvature, b.curvature),
            drift=b.drift,
        )
        normal = tangent.turned()
        if scene.sign(away(a, b, place, scene).dot(normal)) < 0:
            normal = -normal
        demand_above(b, normal, self.between, self.at, scene, self.mark)
        pushes = []
        for stem, kind, direction in (("N", "normal", normal), ("F", "friction", tangent)):
            actions = opposed(a.body, b.body, place, direction)
            pushes.append(Push(f"{stem}_{self.name}", kind, self.name, self.at, actions))
        return (Mode("stick", "", Facts((joining,), pushes=tuple(pushes))),)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        place = scene.point(self.at)
        a, b = self._outlines(scene, place)
        return stuck(self.name, a, b, place)

    def _outlines(self, scene: Setting, place: Vec) -> tuple[Outline, Outline]:
        """Of the two partners where they touch."""
        a, b = (scene.outline(p, scene.spot(p, place, self.during), self.mark) for p in self.between)
        return a, b
