"""What every name of a problem stands for: the look-up that the checks share."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from planar_cli.errors import Mark
from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.scene.keys import (
    BodyKey,
    DirectionKey,
    Flow,
    KeySpec,
    PartnersKey,
    PointKey,
    PointPairKey,
    RopePathKey,
    RopeStop,
    keys_of,
)
from planar_cli.problem.scene.scene import GROUND, Body, Case, Find, Particle, Problem, Surface, Symbol

Member = Joint | Load


def members_of(problem: Problem) -> tuple[Member, ...]:
    """The joints, then the loads."""
    members: tuple[Member, ...] = problem.joints
    return members + problem.loads


def names_in(value: object, spec: KeySpec) -> list[str]:
    """The names of points, bodies and surfaces in the value of a key."""
    match spec.type:
        case PointKey() | BodyKey() | DirectionKey() if isinstance(value, str):
            return [value]
        case PartnersKey() | PointPairKey() if isinstance(value, tuple):
            return [str(name) for name in value]
        case RopePathKey() if isinstance(value, tuple):
            return [name for stop in value if isinstance(stop, RopeStop) for name in (stop.name, stop.body) if name]
        case _:
            return [value.at] if isinstance(value, Flow) else []


@dataclass(frozen=True)
class Scope:
    """A problem, or one case of it with the `earlier` cases, whose finds it may use as `case.find`."""

    problem: Problem
    earlier: tuple[Case, ...]
    case: str = ""
    """The name of the case."""
    file_finds: frozenset[str] = frozenset()
    """The finds of the file itself, which its cases can not use."""

    @cached_property
    def numbers(self) -> dict[str, Symbol]:
        """The names of `given`, `symbols`, `unknowns` and `coordinates`."""
        p = self.problem
        return {s.name: s for s in (*p.given, *p.symbols, *p.unknowns, *p.coordinates)}

    @cached_property
    def bodies(self) -> dict[str, Body]:
        return {b.name: b for b in self.problem.bodies}

    @cached_property
    def surfaces(self) -> dict[str, Surface]:
        return {s.name: s for s in self.problem.surfaces}

    @cached_property
    def points(self) -> dict[str, Mark]:
        """Points of the file, and particles."""
        found = {p.name: p.mark for p in self.problem.points}
        for body in self.problem.bodies:
            if isinstance(body.shape, Particle):
                found.setdefault(body.name, body.mark)
        return found

    @cached_property
    def states(self) -> tuple[str, ...]:
        return tuple(s.name for s in self.problem.states)

    @cached_property
    def case_finds(self) -> dict[str, Find]:
        """The finds of earlier cases, by `case.find`."""
        return {f"{case.name}.{find.name}": find for case in self.earlier for find in case.problem.find}

    @cached_property
    def members(self) -> dict[str, tuple[Member, ...]]:
        """Joints and loads by name; several may be called by the same point or body."""
        found: dict[str, tuple[Member, ...]] = {}
        for member in members_of(self.problem):
            found[member.name] = (*found.get(member.name, ()), member)
        return found

    @property
    def point_like(self) -> set[str]:
        """What may stand where a point is meant in a formula: a point, or a body for its mass centre."""
        return {*self.points, *self.bodies}

    def partners(self, member: Member) -> tuple[str, ...]:
        """The bodies on which a joint or load acts, `ground` among them where it is fixed.

        A surface counts as the body that carries it. Points are not traced to their bodies: for a joint that only names
        points the tuple is empty.
        """
        between = getattr(member, "between", None) or ()
        named = [
            n
            for n in (*between, getattr(member, "body", None))
            if n in self.bodies or n in self.surfaces or n == GROUND
        ]
        holder = member.holder() if isinstance(member, Joint) else None
        named += [] if holder is None else [holder]
        named += [stop.body for stop in self.stops(member) if stop.body]
        return tuple(self.carrier(n) for n in named)

    def mentioned(self, member: Member) -> set[str]:
        """All points, bodies and surfaces that a joint or load names."""
        found: set[str] = set()
        for spec in keys_of(type(member)):
            found |= set(names_in(getattr(member, spec.name), spec))
        return found

    @staticmethod
    def stops(member: Member) -> tuple[RopeStop, ...]:
        """The stops of a rope; of anything else none."""
        path = getattr(member, "path", ())
        return tuple(stop for stop in path if isinstance(stop, RopeStop))

    def carrier(self, name: str) -> str:
        """The body of a surface (`ground` if none), or the body itself."""
        if name in self.surfaces:
            return self.surfaces[name].body or GROUND
        return name
