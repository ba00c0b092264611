"""Angles that are sought and only say how something is drawn: one by whole turns more is the same drawing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TypeVar

from planar_cli.problem.language.expression import Name, Relation
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.units import parse_unit

Fit = TypeVar("Fit")


def within_a_turn(problem: Problem, name: str, fits: Sequence[Fit], values: Sequence[float]) -> list[Fit]:
    """Of what fits with these values [SI] of a sought constant that with one of the first turn, where it is such an
    angle and there is any. An angle that a relation or a load counts is none such.
    """
    symbol = next((u for u in problem.unknowns if u.name == name), None)
    if symbol is None or problem.loads or not parse_unit(symbol.unit or "1").angle:
        return list(fits)
    stated = [r for s in problem.states for r in s.relations if isinstance(r, Relation) and r.operator == "="]
    told = [*stated, *(law.statement for law in problem.motion)]
    if any(isinstance(node, Name) and node.name == name for r in told for node in walk(r)):
        return list(fits)
    return [fit for fit, value in zip(fits, values, strict=True) if -math.pi < value <= math.pi] or list(fits)
