"""Integrals over time in numbers, taken piece by piece."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin

import pytest

from planar_cli.simulate.quadrature import Piece, integral


def test_corners_are_found() -> None:
    pieces = [Piece(lambda t: (abs(sin(t)), cos(t)), 1.7 * k, 1.7 * (k + 1)) for k in range(10)]
    assert integral(pieces) == pytest.approx((11 - cos(17 - 5 * pi), sin(17)), rel=1e-12)


def test_a_piece_of_nothing_but_rounding_is_left_alone() -> None:
    """Where two large numbers cancel, halves never agree with the whole, however often they are halved."""
    asked = 0

    def rounding(t: float) -> Sequence[float]:
        nonlocal asked
        asked += 1
        return (1e-15 * sin(1e9 * t * t),)

    assert integral([Piece(lambda t: (t,), 0.0, 2.0), Piece(rounding, 2.0, 2.001)]) == pytest.approx((2.0,))
    assert integral([Piece(rounding, 2.0, 2.001)]) == pytest.approx((0.0,), abs=1e-15)
    assert asked < 10_000
