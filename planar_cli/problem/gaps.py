"""Gaps of a drawing in words: by how much a point is off the line or the point where it should be."""

from __future__ import annotations

from typing import Any


def gap(scene: Any, length: Any) -> str:
    """A length as drawn, with its unit; "" where letters are in it, or the scene knows no numbers yet."""
    numbers = getattr(scene, "valuations", ())
    if not numbers or scene.ledger.symbolic:
        return ""
    number = abs(float(numbers[0](scene.as_drawn(length))))
    return f"{number:.4g} {'ft' if scene.problem.us else 'm'}"
