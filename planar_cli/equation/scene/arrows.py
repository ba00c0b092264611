"""The direction of a vector as an arrow in print."""

from __future__ import annotations

from decimal import Decimal

ARROWS = {
    (1, 0): "→",
    (-1, 0): "←",
    (0, 1): "↑",
    (0, -1): "↓",
    (1, 1): "↗",
    (-1, 1): "↖",
    (1, -1): "↘",
    (-1, -1): "↙",
}


def vector_arrow(x: Decimal, y: Decimal) -> str:
    """The direction of a vector as one of eight arrows; oblique ones stand for their whole quadrant."""
    return ARROWS.get((_sign(x), _sign(y)), "")


def _sign(number: Decimal) -> int:
    return (number > 0) - (number < 0)
