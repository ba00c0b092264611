"""The pin joint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from planar_cli.joints._outline_residuals import joined, same_turn
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Facts, Joining, Law, Mode, Push, Row, Test, opposed
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import PartnersKey, PointKey, SideKey, key
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import Setting
from planar_cli.problem.scene.sketches import Hinge, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Pin(Joint):
    """Two or more bodies turn about a common point.

    Meaning
        A smooth pin, hinge or axle at the point `at` holds the bodies of `between` together there; each may turn
        freely against the others. `ground` among them makes the point fixed. With three bodies or more it is one
        common pin. `friction_torque` is the constant moment with which a rough axle opposes the relative turning.

    YAML
        title: Pendulum of a rod
        plane: vertical
        points: {A: [0, 0], B: [1.2 m, 0]}
        bodies: {rod: {rod: [A, B], mass: 4 kg}}
        joints:
          - pin: {at: A, between: [ground, rod]}
        instant: [at rest]
        find: {alpha: alpha(rod), R: reaction(A)}

    Equations
        r_A of one body = r_A of the other; so also v_A and a_A. Two reactions per further body, no moment (or the
        friction torque, against the relative rotation). A body without mass on which two pins alone act is a two-force
        member: one reaction along it, at both pins.

    Signs
        `reaction(A)` is the force *on* the body whose partner is the ground, x to the right, y up. Between two moving
        bodies say on which: `reaction(A/AB)`.

    Valid when
        The pin fits closely; its own mass is neglected.

    Reference
        An Introduction to Planar Dynamics, 2.2.2 (rotation), 4.4 (a slab about a fixed point).
    """

    kind: ClassVar[str] = "pin"
    quantities: ClassVar[tuple[str, ...]] = ("friction",)

    at: str = key(PointKey(), "the common point")
    between: tuple[str, ...] = key(
        PartnersKey(most=0), "the bodies that it holds together; `ground` among them fixes it"
    )
    friction_torque: Side | None = key(SideKey("N*m"), "constant friction moment of a rough axle", default=None)

    def attachments(self) -> tuple[tuple[str, str], ...]:
        return tuple((self.at, body) for body in self.between)

    def fixes(self) -> str | None:
        return self.at if "ground" in self.between and self.during is None else None

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        bodies = tuple(scene.carrier(b) for b in self.between)
        return (Hinge(scene.point(self.at), GROUND in bodies, tuple(b for b in bodies if b != GROUND)),)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        hub = "ground" if "ground" in self.between else self.between[0]
        movers = [scene.carrier(b) for b in self.between if b != hub]
        hub, place = scene.carrier(hub), scene.point(self.at)
        joinings = tuple(Joining(self.name, mover, hub, place, self.at) for mover in movers)
        pushes = tuple(
            p for mover in movers for p in components(self.name, self.at, mover, hub, place, len(movers) > 1)
        )
        facts = Facts(joinings, pushes=pushes)
        if self.friction_torque is None:
            return (Mode("", "", facts),)
        return self._rough(scene, facts, movers[0], hub)

    def _rough(self, scene: Setting, facts: Facts, mover: str, hub: str) -> tuple[Mode, ...]:
        """The axle turns against its friction torque, or is held by it."""
        limit = scene.value(self.friction_torque) if self.friction_torque is not None else 0
        place = scene.point(self.at)
        turning = Row(self.name, f"{mover} turns on its axle", spins=((mover, 1), (hub, -1)))
        couple = f"M_{self.name}"
        actions = opposed(mover, hub, place, None, 1)
        push = Push(couple, "friction", self.name, self.at, actions, "N*m")
        modes = []
        for direction, words in ((1, "counterclockwise"), (-1, "clockwise")):
            slipping = Facts(facts.joinings, (), (*facts.pushes, push), (Law(couple, -direction * limit, None),))
            turns = Test(self.name, f"{mover} turns {words}", row=turning, sense=direction, strict=True)
            modes.append(
                Mode("slip", f"{mover} turns {words} on its axle at {self.at}", slipping, (turns,), turning, direction)
            )
        held = Facts(facts.joinings, (turning,), (*facts.pushes, push))
        tests = (
            Test(self.name, "friction torque within its limit", ((couple, 1),), limit),
            Test(self.name, "friction torque within its limit", ((couple, -1),), limit),
        )
        return (
            Mode("stick", f"{mover} is held by the friction of its axle at {self.at}", held, tests, turning),
            *modes,
        )

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        first, *others = (scene.carrier(b) for b in self.between)
        place = scene.point(self.at)
        owner = scene.owner(self.at)
        found = tuple(
            joined(scene, f"{self.name}: place on {first} and {b}", self.during, first, b, place, owner) for b in others
        )
        if mode.name != "stick":
            return found
        return (*found, *(same_turn(f"{self.name}: angle of {first} and {b}", first, b) for b in others))


def components(joint: str, place: str, mover: str, base: str, point: Vec, several: bool = False) -> tuple[Push, Push]:
    """The reaction of a pin on the mover (reversed on the base), in components along x and y."""
    stem = f"{joint}_{mover}" if several else joint
    found = []
    for axis, direction in (("x", Vec(1, 0)), ("y", Vec(0, 1))):
        actions = opposed(mover, base, point, direction)
        found.append(Push(f"{stem}_{axis}", "component", joint, place, actions))
    return found[0], found[1]
