"""What slides along a curve of a body that turns is told in axes that turn with it, each line with its numbers."""

from __future__ import annotations

from math import cos, hypot, sin
from unicodedata import normalize

import pytest
from worked import page_of_file

LINES = [
    "ξ, η: coordinates of P along axes that turn with frame, x and y at the start",
    "(2) ξ_2 = ξ_1 + u t_2 = 1 + 0.4 · 0.5 = 1.2 m",
    "At 2, in axes ξ, η that turn with frame: η = ξ²/(2 p) = 1.2² / (2 · 1) = 0.72 m",
    "Velocity, v = v_rel + ω × r, along ξ and η: v_rel = [ξ̇, η̇], ω × r = [-w η, w ξ]",
    "sliding = √(ξ̇² + η̇²) = √(0.4² + 0.48²) = 0.6248 m/s",
    "a = a_rel + 2 ω × v_rel - ω² r, along ξ and η: a_rel = [0, η̈], 2 ω × v_rel = [-2 w η̇, 2 w ξ̇]",
    "v_ξ = ξ̇ - η w = 0.4 - 0.72 · 3 = -1.76 m/s",
    "v_Px,2 = v_ξ cos θ_2 - v_η sin θ_2 = -1.76 cos 85.94° - 4.08 sin 85.94° = -4.194 m/s",
    "η̈ = (d²η/dξ²) ξ̇² = ξ̇²/p = 0.4²/1 = 0.16 m/s²",
    "a_ξ = -w² ξ - 2 w η̇ = -3² · 1.2 - 2 · 3 · 0.48 = -13.68 m/s²",
    "acceleration = √(a_ξ² + a_η²) = √(13.68² + 3.92²) = 14.23 m/s²",
]


@pytest.mark.parametrize("told", LINES)
def test_a_bead_on_a_turning_wire(told: str) -> None:
    assert normalize("NFC", told) in normalize("NFC", page_of_file("body-bead-on-turning-parabola"))


def test_the_same_by_differences() -> None:
    """The place x = ξ cos w t - η sin w t, differentiated in numbers."""

    def place(t: float) -> tuple[float, float]:
        xi = 1 + 0.4 * t
        eta = xi**2 / 2
        return xi * cos(3 * t) - eta * sin(3 * t), xi * sin(3 * t) + eta * cos(3 * t)

    step, at = 1e-4, 0.5
    before, here, after = (place(at + n * step) for n in (-1, 0, 1))
    second = [(a - 2 * b + c) / step**2 for a, b, c in zip(before, here, after, strict=True)]
    assert hypot(*second) == pytest.approx(14.23, abs=5e-3)
    assert (after[0] - before[0]) / (2 * step) == pytest.approx(-4.194, abs=5e-4)


def test_one_letter_for_one_coordinate() -> None:
    assert "x_P," not in page_of_file("body-bead-on-turning-parabola")
