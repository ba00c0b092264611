"""The state of a scene as one list of numbers: all coordinates, then their rates, the same for every regime."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field

from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.problem.scene.facts import Action, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record

Column = Mapping[int, Term]
"""A generalized force, or the coefficients of a relation between rates: by the number of the coordinate."""


@record
class Slot:
    """One coordinate."""

    coordinate: Term
    rate: Term
    mass: Term
    """What belongs to it in the kinetic energy, mass · rate²/2: a mass, a moment of inertia, or 0."""
    body: str
    """Whose it is; "" of a coordinate of the file."""
    kind: str
    """x, y, theta, or coordinate."""


@record
class Frame:
    """Where a body's coordinates stand in the state."""

    x: int
    y: int
    theta: int | None


@record
class Layout:
    """What stands where in the state."""

    graph: Graph
    time: Term
    slots: tuple[Slot, ...]
    frames: Mapping[str, Frame]
    """By body."""
    arm: Callable[[str, Vec], Vec]
    """From a body's mass centre to a place."""
    drawn: tuple[float, ...]
    """Coordinates from which a configuration is sought: as drawn, and anywhere for what the drawing leaves open."""
    count: int = field(init=False)
    """How many coordinates there are."""
    numbers: Mapping[Term, int] = field(init=False)
    """The number of a coordinate."""
    coordinates: tuple[Term, ...] = field(init=False)
    """The first half of the state."""
    speeds: tuple[Term, ...] = field(init=False)
    """The second half of the state."""
    state: tuple[Term, ...] = field(init=False)
    """All variables in the order of the state."""

    def __post_init__(self) -> None:
        coordinates, speeds = tuple(s.coordinate for s in self.slots), tuple(s.rate for s in self.slots)
        known = {
            "count": len(self.slots),
            "numbers": {q: i for i, q in enumerate(coordinates)},
            "coordinates": coordinates,
            "speeds": speeds,
            "state": (*coordinates, *speeds),
        }
        for name, value in known.items():
            object.__setattr__(self, name, value)

    def rates(self, accelerations: Mapping[Term, Term] | None = None) -> dict[Term, Term]:
        """The rate of every variable; that of the rates, if it is not given, 0."""
        found = {s.coordinate: s.rate for s in self.slots}
        found[self.time] = self.graph.number(1.0)
        return found | dict(accelerations or {})

    def values(self, t: float, y: Iterable[float]) -> dict[Term, float]:
        """The variables at a state."""
        return {self.time: t, **dict(zip(self.state, y, strict=True))}

    def wrench(self, body: str, point: Vec, force: Vec | None, couple: Term) -> dict[int, Term]:
        """The generalized force of a force at a point and a couple."""
        if body == GROUND:
            return {}
        frame, graph = self.frames[body], self.graph
        found: dict[int, Term] = {}
        if force is not None:
            found = {frame.x: graph.of(force.x), frame.y: graph.of(force.y)}
            if frame.theta is not None:
                couple = couple + graph.of(self.arm(body, point).cross(force))
        if frame.theta is not None:
            found[frame.theta] = couple
        return {i: t for i, t in found.items() if not (t.constant and t.value == 0)}

    def of_actions(self, actions: Iterable[Action | Wrench]) -> dict[int, Term]:
        """The generalized force of all that a unit of a push, or a load, does."""
        total: dict[int, Term] = {}
        for a in actions:
            for i, t in self.wrench(a.body, a.point, a.force, self.graph.of(a.couple)).items():
                total[i] = total[i] + t if i in total else t
        return total
