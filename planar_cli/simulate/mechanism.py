"""Rigid bodies, pins and weights: what other packages are told of a scene that has nothing else."""

from __future__ import annotations

import math
from collections.abc import Iterator
from xml.sax.saxutils import quoteattr

from planar_cli.errors import PlanarError
from planar_cli.motion.regime.model import Model
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.simulate.run import Run

__all__ = ["GROUND", "Mechanism"]


@record
class Body:
    """A rigid body at the start, in SI units; x, y of its centre of mass."""

    name: str
    mass: float
    inertia: float
    x: float
    y: float
    angle: float
    vx: float
    vy: float
    omega: float


@record
class Pin:
    """A point that two bodies share: where it is on each, from its centre of mass, in its own directions [m]."""

    a: str
    b: str
    on_a: tuple[float, float]
    """On the ground: its place."""
    on_b: tuple[float, float]

    @property
    def reversed(self) -> Pin:
        """The same, told from the other body."""
        return Pin(self.b, self.a, self.on_b, self.on_a)


@record
class Mechanism:
    """A scene at its start."""

    bodies: tuple[Body, ...]
    pins: tuple[Pin, ...]
    gravity: float
    """Downward [m/s²]."""
    begin: float
    end: float
    """s."""

    @classmethod
    def of(cls, run: Run) -> Mechanism:
        """The scene of a run. PlanarError: it has more than rigid bodies, pins and weights."""
        model, start = run.model, run.prepared.start
        if any(
            load.potential(model.scene) is None or w.kind != "weight" for load, ws in model.wrenches.items() for w in ws
        ):
            raise PlanarError("only weights can be expressed")
        if model.drives or len(run.trajectory.segments) > 1:
            raise PlanarError("neither drives nor changes of mode can be expressed")
        half = model.layout.count
        bodies = []
        for name, frame in model.layout.frames.items():
            place = model.scene.places[name]
            if frame.theta is None or place.inertia.value <= 0:
                raise PlanarError("only rigid bodies can be expressed")
            numbers = (frame.x, frame.y, frame.theta)
            places, speeds = ([start.y[n + k] for n in numbers] for k in (0, half))
            bodies.append(Body(name, place.mass.value, place.inertia.value, *places, *speeds))
        if 3 * len(bodies) != half:
            raise PlanarError("only bodies can be expressed, no coordinates of their own")
        pins = tuple(_pin(model, joining) for joining in _joinings(model))
        return cls(tuple(bodies), pins, model.scene.gravity.value, run.trajectory.t0, run.trajectory.t1)

    def parents(self) -> dict[str, Pin | None]:
        """The pin by which each body hangs on the tree that begins at the ground, with its body nearer to it as `a`."""
        found: dict[str, Pin | None] = {}
        reached = [GROUND]
        while len(found) < len(self.bodies):
            for near in reached:
                for pin in self.pins:
                    for p in (pin, pin.reversed):
                        if p.a == near and p.b != GROUND and p.b not in found:
                            found[p.b] = p
                            reached.append(p.b)
            loose = next((b.name for b in self.bodies if b.name not in found), None)
            if loose is not None:
                found[loose] = None
                reached.append(loose)
        return found

    def as_mjcf(self, step: float) -> str:
        """A model for MuJoCo: a tree of hinges, and the pins that close loops as soft connections."""
        parents = self.parents()
        taken = {p for p in parents.values() if p is not None}
        ties = [
            f"<connect body1={_name(p.b)} body2={_name('world' if p.a == GROUND else p.a)} "
            f'anchor="{_along_axes(self._body(p.b), p.on_b)}"/>'
            for p in self.pins
            if p not in taken and p.reversed not in taken
        ]
        tree = "".join(
            self._nested(name, parents, (0.0, 0.0)) for name, p in parents.items() if p is None or p.a == GROUND
        )
        return (
            f'<mujoco><option timestep="{step!r}" integrator="RK4" gravity="0 {-self.gravity!r} 0"/>'
            f"<worldbody>{tree}</worldbody><equality>{''.join(ties)}</equality></mujoco>"
        )

    def _body(self, name: str) -> Body:
        return next(b for b in self.bodies if b.name == name)

    def _nested(self, name: str, parents: dict[str, Pin | None], origin: tuple[float, float]) -> str:
        """A body with all that hangs on it; its own frame is at its centre of mass, along the fixed axes."""
        body, pin = self._body(name), parents[name]
        at = "0 0 0" if pin is None else _along_axes(body, pin.on_b)
        joints = f'<joint name={_name("turn " + name)} type="hinge" axis="0 0 1" pos="{at}"/>'
        if pin is None:
            slides = (("x", "1 0 0"), ("y", "0 1 0"))
            joints = (
                "".join(f'<joint name={_name(f"{k} {name}")} type="slide" axis="{a}"/>' for k, a in slides) + joints
            )
        inner = "".join(
            self._nested(other, parents, (body.x, body.y))
            for other, p in parents.items()
            if p is not None and p.a == name
        )
        place = f"{body.x - origin[0]!r} {body.y - origin[1]!r} 0"
        inertia = f'mass="{body.mass!r}" diaginertia="{body.inertia!r} {body.inertia!r} {body.inertia!r}"'
        return f'<body name={_name(name)} pos="{place}">{joints}<inertial pos="0 0 0" {inertia}/>{inner}</body>'


def _joinings(model: Model) -> Iterator[Joining]:
    """What all joints forbid, if they are pins."""
    for joint in model.joints:
        modes = model.modes[joint.name]
        facts = modes[0].facts
        plain = len(modes) == 1 and not facts.rows and not facts.laws and not facts.skids
        if not plain or any(j.path is not None or not j.turns or j.rolling or j.drift for j in facts.joinings):
            raise PlanarError("only pins can be expressed")
        yield from facts.joinings


def _pin(model: Model, joining: Joining) -> Pin:
    """Where a pin is on both bodies, as drawn."""
    graph = model.graph
    x, y = graph.of(joining.point.x).value, graph.of(joining.point.y).value
    ends = []
    for name in (joining.base, joining.mover):
        if name == GROUND:
            ends.append((x, y))
            continue
        place = model.scene.places[name]
        angle = place.theta.value if place.theta is not None else 0.0
        dx, dy = x - place.x.value, y - place.y.value
        ends.append((dx * math.cos(angle) + dy * math.sin(angle), dy * math.cos(angle) - dx * math.sin(angle)))
    return Pin(joining.base, joining.mover, ends[0], ends[1])


def _along_axes(body: Body, local: tuple[float, float]) -> str:
    """A point of a body from its centre of mass along the fixed axes, at the start."""
    c, s = math.cos(body.angle), math.sin(body.angle)
    return f"{c * local[0] - s * local[1]!r} {s * local[0] + c * local[1]!r} 0"


def _name(text: str) -> str:
    return quoteattr(text)
