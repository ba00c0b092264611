"""Masses that are written with places: of a chain that hangs longer and longer, `mass: rho*y(end)`."""

from __future__ import annotations

from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Body, Problem

PLACES = frozenset(("x", "y", "theta"))
"""The quantities that a mass may be written with."""


def placed(problem: Problem) -> frozenset[str]:
    """Bodies whose mass or moment of inertia is written with coordinates or places."""
    coordinates = {c.name for c in problem.coordinates}
    return frozenset(b.name for b in problem.bodies if _uses(b, coordinates))


def varying(problem: Problem) -> frozenset[str]:
    """The same, and those whose mass or moment of inertia is written with the time."""
    return frozenset(b.name for b in problem.bodies if _uses(b, {"t", *(c.name for c in problem.coordinates)}))


def _uses(body: Body, names: set[str]) -> bool:
    nodes = (n for side in (body.mass, body.weight, body.inertia) if side is not None for n in walk(side))
    return any(isinstance(n, Quantity) or (isinstance(n, Name) and n.name in names) for n in nodes)
