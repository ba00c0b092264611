"""The conditions under which a choice of modes holds over time, from the tests that joints and loads state."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.scales import Scales
from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.problem.scene.facts import Mode, Push, Row, Test
from planar_cli.problem.scene.setting import MovingSetting
from planar_cli.records import record

LENGTH = "length"
"""The kind of a guard behind which nothing goes on: a free part of a rope has run out."""
AGAIN = "again"
"""The kind of one behind which nothing goes on either: partners of an impact that is over meet again."""
SHORTEST = 1e-3
"""It has when its length is below this part of the scale."""


@record
class Guard:
    """A value that is >= 0, or > 0 where it is strict, as long as its regime holds."""

    joint: str
    """The joint, or the key of the load, whose mode it belongs to."""
    kind: str
    """presses, limit, slips, gap, again, taut, stretch, tips, mass or length."""
    words: str
    """The condition, as it holds."""
    strict: bool
    """May it not stay zero?"""
    scale: float
    """The size of a usual value, in its unit."""
    index: int
    """Its place among the guards of the regime."""


@record
class Measured:
    """A guard and how its value is computed: state + Σ factor · push, less the resultant of `within`."""

    guard: Guard
    state: Term
    """What depends on the state alone."""
    forces: tuple[tuple[str, Term], ...] = ()
    """Pushes by name, with factors."""
    within: tuple[str, ...] = ()
    """Pushes at right angles to each other."""

    def value(self, pushes: Mapping[str, Term]) -> Term:
        """The value, with the pushes at hand."""
        total = self.state
        for name, factor in self.forces:
            total = total + factor * pushes[name]
        if self.within:
            graph = total.graph
            square = graph.number(0.0)
            for name in self.within:
                square = square + pushes[name] * pushes[name]
            total = total - graph.call("sqrt", square)
        return total

    @property
    def needs_forces(self) -> bool:
        """Must the equations of motion be solved for it?"""
        return bool(self.forces or self.within)


@record
class Watch:
    """What the guards of one joint in one mode are made with."""

    layout: Layout
    scales: Scales
    scene: MovingSetting
    joint: str
    mode: Mode
    speeds: tuple[Term, ...]
    """Of what slides with friction of a fixed size, in the order of the mode's skids."""
    gap: Term | None
    """How far the partners are apart, where the mode is that they are; how slack a rope is."""

    def measured(self) -> list[Measured]:
        """All conditions of the mode; they are numbered later."""
        found = [*(self._of(test) for test in self.mode.tests), *self._lengths()]
        for skid, speed in zip(self.mode.facts.skids, self.speeds, strict=True):
            guard = Guard(self.joint, "slips", f"{skid.body} slides on {skid.base}", True, self.scales.speed, 0)
            found.append(Measured(guard, speed))
        return found

    def _lengths(self) -> list[Measured]:
        """Free parts of a rope, by the squares of their lengths: what has no length left has no direction.

        A square has a value, below zero, also where a point has come inside the rim that the part touches. They end
        while the directions are still those of before.
        """
        graph, found = self.layout.graph, []
        usual = self.scales.length**2
        segments = [s for row in (*self.mode.facts.rows, *self.mode.touching.rows) for s in row.segments]
        if self.mode.parted and len(segments) == 1:
            # The ends of a slack rope may meet.
            return []
        for segment in segments:
            length = graph.of(0.0 if segment.length is None else segment.length)
            if not length.constant:
                square = length.args[0] if length.op == "sqrt" else length * length
                words = f"every free part of {self.joint} has a length"
                guard = Guard(self.joint, LENGTH, words, True, usual, 0)
                found.append(Measured(guard, square - SHORTEST**2 * usual))
        return found

    def _of(self, test: Test) -> Measured:
        graph = self.layout.graph
        if test.row is not None or test.joining is not None:
            return self._of_motion(test)
        kinds = {p.name: p for p in self.mode.facts.pushes}
        guard = Guard(self.joint, self._kind(test, kinds), test.words, test.strict, self._size(test, kinds), 0)
        forces = tuple((name, graph.of(factor)) for name, factor in test.pushes)
        return Measured(guard, graph.of(test.constant), forces, test.within)

    def _kind(self, test: Test, pushes: Mapping[str, Push]) -> str:
        if not test.pushes and not test.within:
            return "stretch"
        kinds = {pushes[name].kind for name in (*(n for n, _ in test.pushes), *test.within)}
        if "friction" in kinds:
            return "limit"
        return "taut" if kinds == {"tension"} else "presses"

    def _size(self, test: Test, pushes: Mapping[str, Push]) -> float:
        if not test.pushes and not test.within:
            return self.scales.length
        couple = any(pushes[name].unit != "N" for name in (*(n for n, _ in test.pushes), *test.within))
        return self.scales.force * (self.scales.length if couple else 1.0)

    def _of_motion(self, test: Test) -> Measured:
        """A speed of sliding, a distance, or the angle by which a face has tipped."""
        graph, mode = self.layout.graph, self.mode
        if self.gap is not None:
            return Measured(Guard(self.joint, "gap", test.words, test.strict, self.scales.length, 0), self.gap)
        row = test.row
        assert row is not None, self.joint
        if row == mode.sliding:
            speed = speed_of(graph, self.scene, row) * test.sense
            size = self.scales.speed / (1.0 if row.pulls else self.scales.length)
            return Measured(Guard(self.joint, "slips", test.words, test.strict, size, 0), speed)
        angle = graph.number(0.0)
        for body, factor in row.spins:
            frame = self.layout.frames.get(body)
            if frame is not None and frame.theta is not None:
                theta = self.layout.slots[frame.theta].coordinate
                angle = angle + (theta - theta.value) * graph.of(factor)
        return Measured(Guard(self.joint, "tips", test.words, test.strict, 1.0, 0), angle * test.sense)


def speed_of(graph: Graph, scene: MovingSetting, row: Row) -> Term:
    """What the row says of velocities, less what it should be: 0 where it holds [m/s, or rad/s]."""
    total = -graph.of(row.rate)
    for pull in row.pulls:
        total = total + graph.of(scene.velocity(pull.anchor.point, pull.anchor.body).dot(pull.direction))
    for body, factor in row.spins:
        total = total + graph.of(factor) * scene.turn(body)
    for segment in row.segments:
        ends = (segment.end, 1), (segment.start, -1)
        for anchor, sign in ends:
            total = total + graph.of(scene.velocity(anchor.point, anchor.body).dot(segment.direction)) * sign
    return total
