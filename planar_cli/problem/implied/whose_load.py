"""On which body a load acts of which the file does not say it: only where one alone can be meant.

A point tells its body: the one whose shape or list of points names it, else the one that a joint or another load joins
to it. A file with one body leaves no choice; a couple turns no particle, so that particles do not count for it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.nodes.reading import Report, listed
from planar_cli.problem.scene.scene import Body, Particle
from planar_cli.problem.scene.shapes import own_points


def with_bodies(
    loads: tuple[Load, ...], joints: tuple[Joint, ...], bodies: tuple[Body, ...], report: Report
) -> tuple[Load, ...]:
    """The loads, each with its body. Reported where more than one can be meant, or none."""
    owners = _Owners(loads, joints, bodies)
    return tuple(_with_body(load, owners, report).in_full() for load in loads)


def _with_body(load: Load, owners: _Owners, report: Report) -> Load:
    told: Any = load
    if getattr(load, "body", "told") or getattr(load, "between", None):
        return load
    point = next((name for key in ("at", "wound_at") if (name := getattr(load, key, None))), "")
    found = owners.of(point) if point else owners.alone(load)
    if len(found) == 1:
        found_load: Load = replace(told, body=found[0], name=load.name or found[0])
        return found_load
    if owners.names:
        write = listed(f"`body: {name}`" for name in (found or owners.names))
        two = ", or `between: [a, b]`: on b, reversed on a" if hasattr(load, "between") else ""
        report.add(load.mark, "PL311", _why(load, point, found), f"write {write}{two}")
    return load


def _why(load: Load, point: str, found: tuple[str, ...]) -> str:
    needs = f"the {load.kind} needs the key 'body'"
    if point and found:
        return f"{needs}: {point} is a point of {listed(found, 'and')}"
    if point:
        return f"{needs}: {point} is a point of no body"
    return f"{needs}: it may act on {listed(found)}" if found else needs


class _Owners:
    """The bodies of one file and whose the points are."""

    def __init__(self, loads: Iterable[Load], joints: Iterable[Joint], bodies: tuple[Body, ...]) -> None:
        self.names = tuple(body.name for body in bodies)
        self._turning = tuple(body.name for body in bodies if not isinstance(body.shape, Particle))
        self._named = [(p, b.name) for b in bodies for p in (b.name, *own_points(b.shape), *b.points)]
        self._joined = [pair for entry in (*joints, *loads) for pair in entry.attachments() if pair[1] in self.names]

    def of(self, point: str) -> tuple[str, ...]:
        """All bodies that a point may belong to."""
        for pairs in (self._named, self._joined):
            found = tuple(dict.fromkeys(body for name, body in pairs if name == point))
            if found:
                return found
        return self.names if len(self.names) == 1 else ()

    def alone(self, load: Load) -> tuple[str, ...]:
        """All bodies that a load without a point may act on."""
        return self._turning if load.turns_only else self.names
