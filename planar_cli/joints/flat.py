"""A body that lies flat on another in a horizontal plane."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, ClassVar

from planar_cli.errors import Diagnostic
from planar_cli.joints._outline_residuals import same_turn, together
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Facts, Joining, Mode, Push, Row, Skid, Test, opposed, relative
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import Choice, PartnersKey, SideKey, key
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.setting import Setting, StruckSetting, WrittenScene


@dataclass(frozen=True, slots=True, kw_only=True)
class Flat(Joint):
    """A body lies on another in a horizontal plane, and friction holds or brakes it.

    Meaning
        With `plane: horizontal` one looks from above: the first of `between` lies on the second (a table, a turning
        disk, or `ground`) and presses with its weight on it. Friction acts in the plane, up to mu m g. Say what there
        is: `mu` (static and kinetic; 0 is smooth), or `mu_s` and `mu_k` (`mu_k` alone: it slides; `mu_s` alone: does it
        slide, or at its limit), or `friction`, a fixed limit of the force.

    YAML
        title: Block on a turntable
        plane: horizontal
        points: {O: [0, 0], P: [0.5 m, 0]}
        bodies:
          table: {disk: O, radius: 1 m}
          block: {particle: P, mass: 2 kg}
        joints:
          - pin: {at: O, between: [ground, table]}
          - flat: {between: [block, table], mu: 0.3}
        motion: [omega(table) = 2 rad/s]
        instant: [v(P/table).mag = 0]
        find: {mode: mode(block), F: friction(block/block)}

    Equations
        stick  the body moves with what it lies on;               |F| <= mu_s m g
        slip   |F| = mu_k m g, against the relative velocity

    Signs
        `friction(j/b)` is the force on b, in the plane.

    Valid when
        The plane is horizontal and the body a particle, or sliding without turning.

    Reference
        An Introduction to Planar Dynamics, 3.1.2, 3.2.2.
    """

    kind: ClassVar[str] = "flat"
    quantities: ClassVar[tuple[str, ...]] = ("N", "friction", "mode")

    choices: ClassVar[tuple[Choice, ...]] = (
        Choice(
            (("mu",), ("mu_s", "mu_k"), ("mu_s",), ("mu_k",), ("friction",)),
            "`mu: 0` when it is smooth, `mu: 0.3`, or `mu_s: 0.3, mu_k: 0.2` (`mu_k` alone: it slides; "
            "`mu_s` alone: does it?), or `friction: 25 N`, a fixed limit",
        ),
    )

    between: tuple[str, ...] = key(PartnersKey(), "the body that lies, then the one it lies on or `ground`")
    mu: Side | None = key(SideKey("1"), "coefficient of friction, static and kinetic; 0 is smooth", default=None)
    mu_s: Side | None = key(SideKey("1"), "coefficient of static friction", default=None)
    mu_k: Side | None = key(SideKey("1"), "coefficient of kinetic friction", default=None)
    friction: Side | None = key(SideKey("N"), "the largest friction force, whatever the weight", default=None)

    def objections(self, scene: WrittenScene) -> Iterable[Diagnostic]:
        if scene.plane == "vertical":
            message, hint = "a flat contact needs `plane: horizontal`", "in a vertical plane write `contact`"
            yield Diagnostic(self.mark, "PL456", message, hint)
        if len(self.between) != 2:
            return
        light = {b.name: b.is_massless for b in scene.bodies}
        upper, lower = self.between
        if light.get(upper) and light.get(lower) is False:
            message = f"{upper} has no mass, so nothing presses it on {lower}"
            hint = f"the first of `between` lies on the second: write `between: [{lower}, {upper}]`"
            yield Diagnostic(self.mark, "PL456", message, hint)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        """The pressure carries the weight; friction holds the body, or acts at its mass centre against its sliding."""
        body, base = (scene.carrier(b) for b in self.between)
        point, place = scene.center(body), scene.center_name(body)
        largest, size = self._sizes(scene, body)
        if scene.is_zero(largest):
            return (Mode("slip", f"{body} slides freely on {base}", Facts()),)
        pushes = [self._push(axis, body, base, point, d) for axis, d in (("x", Vec(1, 0)), ("y", Vec(0, 1)))]
        if scene.rigid(body):
            actions = opposed(body, base, point, None, 1)
            pushes.append(Push(f"M_{self.name}", "couple", self.name, place, actions, "N*m"))
        sliding = tuple(
            Row(
                self.name,
                f"{body} does not slide on {base}",
                relative(body, base, point, d),
            )
            for d in (Vec(1, 0), Vec(0, 1))
        )
        held = Facts((Joining(self.name, body, base, point, place, turns=False),), pushes=tuple(pushes))
        within = Test(
            self.name, f"friction of {body} within its limit", constant=largest, within=(pushes[0].name, pushes[1].name)
        )
        slipping = Facts(skids=(Skid(self.name, body, base, point, size),))
        return (
            Mode("stick", f"{body} does not slide on {base}", held, (within,), sliding[0], touching=Facts()),
            Mode("slip", f"{body} slides on {base}", slipping, (), None),
        )

    def _sizes(self, scene: Setting, body: str) -> tuple[Any, Any]:
        """How large friction can be while the body lies still on the other, and how large it is while it slides [N]."""
        # Of what slides, the kinetic coefficient alone may be known: at rest it holds at least as much.
        static, kinetic = self.mu_s or self.mu or self.mu_k, self.mu_k or self.mu or self.mu_s
        if static is None or kinetic is None:
            fixed = scene.value(self.friction) if self.friction is not None else 0
            return fixed, fixed
        pressed = scene.heaviness(body)
        return scene.value(static) * pressed, scene.value(kinetic) * pressed

    def blows(self, scene: StruckSetting) -> tuple[Mode, ...]:
        """Nothing: the weight presses on the plane, and friction of a finite size has no impulse in no time."""
        return (Mode("", "", Facts()),)

    def _push(self, axis: str, body: str, base: str, point: Vec, direction: Vec) -> Push:
        actions = opposed(body, base, point, direction)
        return Push(f"F_{self.name}_{axis}", "friction", self.name, self.name, actions)

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        if mode.name != "stick":
            return ()
        body, base = (scene.carrier(b) for b in self.between)
        found = (together(f"{self.name}: place", body, base, scene.center(body)),)
        return (
            (*found, same_turn(f"{self.name}: angle", body, base)) if scene.rigid(body) and scene.rigid(base) else found
        )
