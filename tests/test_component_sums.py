"""The components of vector sums are told with their numbers; a square less one is a sine."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.kinematics.component_sums import Turned, components_told
from planar_cli.report.notation.pythagoras import of_one

ZERO = Decimal(0)
a, x = sp.symbols("a x")


def test_what_is_one_number_each_is_not_told() -> None:
    assert components_told(Turned((Decimal(2), ZERO), ZERO, (Decimal(1), ZERO), ZERO), 4) == ()


def test_a_component_that_vanishes_is_zero() -> None:
    told = components_told(Turned((Decimal(2), ZERO), Decimal(4), (ZERO, Decimal("0.5")), ZERO), 4)
    assert told == () or told[1].expr == 0


def test_the_acceleration_of_a_mass_centre_has_its_numbers() -> None:
    page = page_of_file("bar-on-two-slanting-cords")
    assert "a_G = a_A + α × r_G/A = [-1.307, -0.75462 + 0.6 (-11.319)] = [-1.307, -7.546] m/s²" in page


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("four-bar", "v_B = ω_AB × r_B/A = [-0.1732 (-10), 0.1 (-10)] = [1.732, -1] m/s"),
        ("four-bar", "a_B = -ω_AB² r_B/A = [-0.1 · 10², -0.1732 · 10²] = [-10, -17.32] m/s²"),
        ("planetary-gear", "a_D,annulus = -ω_annulus² r_D/O = [-0.12 · 5², 0] = [-3, 0] m/s²"),
        ("car-that-brakes-in-a-bend", "a_P = a_car,t e_t + v_car²/ρ e_n = [-6, 60²/450] = [-6, 8] ft/s²"),
        ("pendulum-tension", "= [0.86603 (-4.905) - 0.5 · 1.8² / 1.2,"),
    ],
)
def test_what_is_known_at_once_has_its_numbers(name: str, told: str) -> None:
    assert told in page_of_file(name)


def test_a_square_less_one_is_a_sine() -> None:
    assert of_one(a * (sp.cos(x) ** 2 - 1)) == -a * sp.sin(x) ** 2
    assert of_one(a - a * sp.sin(x) ** 2) == a * sp.cos(x) ** 2
    assert of_one(1 - 2 * sp.sin(x) ** 2) == 1 - 2 * sp.sin(x) ** 2
    assert "-1/2 m g l sin² β = 1/4 m l² α sin² β + I α" in page_of_file("bar-on-two-slanting-cords")
