"""Vectors whose numbers are known where the page tells them, and their directions."""

from __future__ import annotations

from decimal import Decimal

from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.kinematics.told import Told
from planar_cli.report.words.words import Phrases


def is_known(told: Told, vector: Vec, level: str) -> bool:
    """Is it made of what the file gives, and of velocities that were found before?"""
    tree, inside = told.system.tree, vector.x.free_symbols | vector.y.free_symbols
    open_yet = set(tree.velocity_unknowns()) if level == "velocity" else set(tree.acceleration_unknowns())
    sure = not told.phrases.symbolic and told.phrases.has_numbers(vector.x + vector.y)
    return bool(told.given) and sure and not inside & ((open_yet | told.late) - told.given - told.zero)


def unit_along(normal: Vec, phrases: Phrases) -> list[Decimal]:
    """The components of the unit vector along a vector that has numbers."""
    x, y = phrases.certain(normal.x), phrases.certain(normal.y)
    size = (x * x + y * y).sqrt()
    return [x / size, y / size]
