"""The rope, over and under pulleys and on drums."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from planar_cli.errors import Diagnostic
from planar_cli.joints._rope_length import rope_directions, rope_length
from planar_cli.joints._rope_path import RopePath, free_parts, stops_of
from planar_cli.joints._swing import swing
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Facts, Mode, Push, Row, Segment, Test
from planar_cli.problem.scene.fixed_ends import fixed_ends
from planar_cli.problem.scene.keys import RopePathKey, RopeStop, SideKey, key
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import Setting, WrittenBody, WrittenScene
from planar_cli.problem.scene.sketches import Cord, CordStop, Sketch


@dataclass(frozen=True, slots=True, kw_only=True)
class Rope(Joint):
    """A light inextensible rope runs from stop to stop.

              over D                    A fixed                    T on drum
              .--.                      |      |
             ( D  )                     |      |                  .---.
             |'--'|                     |      |                 (  G  )T   the rope is wound on the drum,
             |    |                     | .--. |                  '---'|    and leaves it at its rim point T
             |    |                     |( E  )|                       |
             A    B                       '--'                         B
      path: [A, over D, B]        path: [A, under E, B]        path: [T on drum, B]

    Meaning
        `path` lists the stops in order. A name alone is a point: at the ends where the rope is fastened, in the middle
        a small pulley or smooth peg of no size. `over D` and `under E` pass above or below the disk D, E (the body or
        its centre); where D is a mere point, no disk's centre, `over D` is D alone: a peg without a radius, fixed
        where D is. `T on drum`: wound on the body `drum`, leaving it at the rim point T; it stands at an end.
        `along: 90 deg`: all parts run parallel to that direction, and the sizes of pulleys are left out. One rope has
        one tension; over a heavy pulley that turns with it write two ropes, each wound on the pulley.

    YAML
        title: Two blocks and a light pulley
        plane: vertical
        points: {A: [0, 0], B: [0.4 m, 0], D: [0.2 m, 1 m]}
        bodies:
          A_block: {particle: A, mass: 3 kg}
          B_block: {particle: B, mass: 2 kg}
        joints:
          - rope: {path: [A, D, B], along: 90 deg, name: rope}
        instant: [at rest]
        find: {a: a(A).y, T: tension(rope)}

    Equations
        The sum of the lengths of all parts (free, on pulleys, wound) is constant. One reaction, the tension, the same
        in all parts.

    Signs
        `tension(j)` > 0 pulls; a rope cannot push: `mode(j)` is taut or slack.

    Valid when
        The rope is light and inextensible, and pulleys it only passes over are light and turn freely.

    Reference
        An Introduction to Planar Dynamics, 1.6, 3.5.4, Example 1-9.
    """

    kind: ClassVar[str] = "rope"
    quantities: ClassVar[tuple[str, ...]] = ("tension", "mode")
    nouns: ClassVar[tuple[str, ...]] = ("cord", "cable", "string", "thread", "line", "chain", "wire", "tape", "band")

    path: tuple[RopeStop, ...] = key(RopePathKey(), "its stops in order: A, over D, under E, T on drum")
    along: Side | None = key(
        SideKey("deg", angle=True), "the direction of all its parts; pulley sizes left out", default=None
    )

    @property
    def called(self) -> str:
        start, end = self.path[0].name, self.path[-1].name
        # Without a name of its own it has that of its first stop, with a number where others have it too.
        own = self.name.removeprefix(start).removeprefix("_")
        return self.phrase(self.name) if own and not own.isdigit() else f"the rope from {start} to {end}"

    @property
    def drawn_beside(self) -> bool:
        return self.along is not None

    def passes_through(self, names: frozenset[str]) -> str | None:
        """The bare point over which its last part runs, as a string through a hole."""
        ends = (self.path[:2], self.path[:-3:-1])
        stops = [stop for end, stop in ends if end.name in names and stop.way == "point"]
        return stops[0].name if len(stops) == 1 and len(self.path) > 2 and self.along is None else None

    def attachments(self) -> tuple[tuple[str, str], ...]:
        return self.rims()

    def rims(self) -> tuple[tuple[str, str], ...]:
        return tuple((stop.name, stop.body) for stop in self.path if stop.way == "on" and stop.body is not None)

    def tangents(self) -> tuple[tuple[str, str, str], ...]:
        if self.along is not None:
            return ()
        ends = ((self.path[0], self.path[1]), (self.path[-1], self.path[-2]))
        return tuple((a.name, a.body, b.name) for a, b in ends if a.way == "on" and a.body and b.way == "point")

    def objections(self, scene: WrittenScene) -> Iterable[Diagnostic]:
        passed = {stop.name for stop in self.path if stop.way in ("over", "under")}
        drums = {stop.body for stop in self.path if stop.way == "on"}
        for body in scene.bodies:
            if body.name in drums and body.is_particle:
                text = f"{body.name} is a particle: no rope is wound on it"
                yield Diagnostic(self.mark, "PL458", text, f"write `path: […, {body.name}]` where it hangs on the rope")
            if body.is_round and body.resists_turning and passed & {body.name, body.hub_point}:
                text = f"{body.name} has mass, and a rope over it has one tension and does not turn it"
                one, other = self._wound_on(body)
                hint = (
                    f"where it turns with the rope write two ropes wound on it, `{one}` and `{other}`, whose ends "
                    "leave its rim; where it is smooth, give the body `inertia: 0`"
                )
                yield Diagnostic(self.mark, "PL457", text, hint)

    def _wound_on(self, body: WrittenBody) -> tuple[str, str]:
        """The two ropes in the place of one over a pulley, with points of its rim that the path does not name."""
        at = next(i for i, stop in enumerate(self.path) if stop.name in (body.name, body.hub_point))
        taken = {body.name, *(stop.name for stop in self.path)}
        first, second = [letter for letter in "STUVWKL" if letter not in taken][:2]
        before = [f"{stop.way} {stop.name}".removeprefix("point ") for stop in self.path[:at]]
        after = [f"{stop.way} {stop.name}".removeprefix("point ") for stop in self.path[at + 1 :]]
        one = ", ".join([*before, f"{first} on {body.name}"])
        return f"[{one}]", f"[{', '.join([f'{second} on {body.name}', *after])}]"

    def sketch(self, scene: Setting) -> tuple[Sketch, ...]:
        told = zip(stops_of(self._route(), scene), self.path, strict=True)
        stops = tuple(
            CordStop(s.center, s.radius, s.side, s.rim, s.body == GROUND, stop.name, s.body) for s, stop in told
        )
        along = None if self.along is None else scene.unit(self.along)
        return (Cord(stops, fixed_ends(scene, self.path[0].name, self.path[-1].name), along, self.name),)

    def modes(self, scene: Setting) -> tuple[Mode, ...]:
        segments, spins, actions = free_parts(self._route(), scene)
        row = Row(self.name, f"{self.called} keeps its length", spins=spins, segments=segments)
        push = Push(f"T_{self.name}", "tension", self.name, self.name, actions)
        taut = Facts(rows=(row,), pushes=(push,))
        # A part of fixed direction does not swing with the body at its end.
        if (
            len(segments) == 1
            and not spins
            and (segments[0].length is not None or _to_ground(segments[0]) or not scene.rigid(segments[0].end.body))
        ):
            tie = segments[0]
            ends = ((self.path[0].name, tie.start), (self.path[1].name, tie.end))
            curvature = 0 if tie.length is None else 1 / tie.length
            taut = Facts((swing(scene, self.name, *ends, tie.direction, curvature),), pushes=(push,))
        pulls = Test(self.name, "the tension pulls", ((push.name, 1),))
        shortens = Test(self.name, "the ends do not move apart", row=row, sense=-1)
        return (
            Mode("taut", f"{self.called} is taut", taut, (pulls,), row),
            Mode(
                "slack",
                f"{self.called} is slack",
                Facts(),
                (shortens,),
                touching=Facts(taut.joinings, taut.rows),
            ),
        )

    def residuals(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        if mode.name == "slack":
            return ()
        along = None if self.along is None else scene.unit(self.along)
        return (rope_length(f"{self.called}: length", stops_of(self._route(), scene), along),)

    def presumes(self, scene: Setting, mode: Mode) -> tuple[Residual, ...]:
        if self.along is None or mode.name == "slack":
            return ()
        names = [stop.name for stop in self.path]
        return rope_directions(stops_of(self._route(), scene), names, scene.unit(self.along))

    def _route(self) -> RopePath:
        return RopePath(self.name, self.path, self.along, self.mark)


def _to_ground(segment: Segment) -> bool:
    return "ground" in (segment.start.body, segment.end.body)
