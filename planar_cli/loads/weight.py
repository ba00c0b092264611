"""Weight: on every body with mass, by itself."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from planar_cli.loads.base import Load
from planar_cli.problem.scene.facts import Effect, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.setting import MovingSetting, Setting


@dataclass(frozen=True, slots=True, kw_only=True)
class Weight(Load):
    """Every body that has mass is heavy, in a vertical plane.

    Meaning
        Weight is never written in `loads`. With `plane: vertical` it acts on each body at its mass centre, downwards
        (-y); with `plane: horizontal` it presses on what the body lies on and does not enter the plane. `g` is
        9.81 m/s^2 unless `given` says otherwise; in a file with `symbols` it stays a letter.

    YAML
        title: Falling stone
        plane: vertical
        given: {g: 1.62 m/s^2}
        bodies: {stone: {particle: [0, 0], mass: 2 kg}}
        states:
          1: [t = 0, at rest]
          2: [t = 3 s]
        find: {v: v(stone).y @ 2, y: y(stone) @ 2}

    Equations
        F = m g downwards at the mass centre; potential energy m g y_G.

    Signs
        y is up, so the weight is (0, -m g).

    Valid when
        The field is uniform.

    Reference
        An Introduction to Planar Dynamics, 3.1.2, 3.5.2.
    """

    kind: ClassVar[str] = "weight"
    effect: ClassVar[Effect] = Effect("weight", rank=0)
    line: ClassVar[str] = "weight of {}"
    letter: ClassVar[str] = "W"
    working: ClassVar[str] = "weight of {}"

    def wrenches(self, scene: MovingSetting) -> tuple[Wrench, ...]:
        """The weight m g of one body, downward at its mass centre; `name` is the body."""
        weight = scene.mass(self.name) * scene.gravity
        if scene.vanishes(weight):
            return ()
        point, place = scene.center(self.name), scene.center_name(self.name)
        return (Wrench(self.name, "weight", self.name, point, Vec(0, -1) * weight, 0, weight, place),)

    def stored(self, scene: Setting) -> tuple[Any, Any, int, str]:
        """m g y_G, from y = 0."""
        place = scene.own_name(self.name)
        return scene.mass(self.name) * scene.gravity, scene.center(self.name).y, 1, f"y_{place}"
