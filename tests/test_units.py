"""Exact factors, dimensions, repairs and display of units."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planar_cli import units
from planar_cli.base_units import factor_to_base, in_base
from planar_cli.units import ATOMS, Dimension, UnitError, default_unit, describe, parse_unit, pretty_unit


@pytest.mark.parametrize(
    ("text", "factor", "pi_power", "dimension", "angle"),
    [
        ("N*m", 1, 0, units.ENERGY, False),
        ("m/s^2", 1, 0, units.ACCELERATION, False),
        ("kg*m^2", 1, 0, units.INERTIA, False),
        ("rad/s^2", 1, 0, units.RATE_OF_RATE, True),
        ("N*s/m", 1, 0, units.DAMPING, False),
        ("1/s", 1, 0, units.RATE, False),
        ("1", 1, 0, units.PURE, False),
        ("kN/m", 1000, 0, units.STIFFNESS, False),
        ("km/h", Fraction(5, 18), 0, units.VELOCITY, False),
        ("deg/s", Fraction(1, 180), 1, units.RATE, True),
        ("rev/min", Fraction(1, 30), 1, units.RATE, True),
        ("rpm", Fraction(1, 30), 1, units.RATE, True),
        ("rev", 2, 1, units.PURE, True),
        ("1/deg", 180, -1, units.PURE, True),
        ("lb*ft^2", Fraction(45359237, 10**8) * Fraction(3048, 10**4) ** 2, 0, units.INERTIA, False),
        ("lbf", Fraction(45359237, 10**8) * Fraction(980665, 10**5), 0, units.FORCE, False),
        ("slug*ft/s^2", Fraction(45359237, 10**8) * Fraction(980665, 10**5), 0, units.FORCE, False),
        ("in", Fraction(254, 10**4), 0, units.LENGTH, False),
        ("mph", Fraction(1609344, 3600 * 1000), 0, units.VELOCITY, False),
        ("kg/(m*s)", 1, 0, Dimension(Fraction(-1), Fraction(1), Fraction(-1)), False),
        ("m*s^-2", 1, 0, units.ACCELERATION, False),
        ("tonne", 1000, 0, units.MASS, False),
        ("g", Fraction(1, 1000), 0, units.MASS, False),
        ("N*m/rad", 1, 0, units.ENERGY, False),
    ],
)
def test_units(text: str, factor: Fraction | int, pi_power: int, dimension: Dimension, angle: bool) -> None:
    unit = parse_unit(text)
    assert (unit.factor, unit.pi_power, unit.dimension, unit.angle) == (factor, pi_power, dimension, angle)
    assert unit.text == text


def test_horsepower_is_550_foot_pounds_a_second() -> None:
    assert parse_unit("hp").factor == 550 * parse_unit("ft*lbf/s").factor


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("t", "tonne"),
        ("lbs", "`lbf`"),
        ("Nm", "`N*m`"),
        ("N.m", "`N*m`"),
        ("N-m", "`N*m`"),
        ("N m", "N*m"),
        ("kph", "`km/h`"),
        ("sec", "`s`"),
        ("°", "`deg`"),
        ("°/s", "`deg/s`"),
        ("degrees", "`deg`"),
        ("rads", "`rad`"),
        ("m/s²", "`m/s^2`"),
        ("N·m", "`N*m`"),
        ("m**2", "`m^2`"),
        ("m2", "`m^2`"),
        ("kn", "`kN`"),
        ("KG", "`kg`"),
        ("%", "fraction"),
        ("tonnes", "`tonne`"),
        ("*", "N*m"),
        ("", "`1`"),
        ("m^0.5/s", "`m^(1/2)`"),
        ("km^(1/2)", "`m`"),
    ],
)
def test_refused_units_say_what_to_write(text: str, hint: str) -> None:
    with pytest.raises(UnitError) as error:
        parse_unit(text)
    assert hint in error.value.hint


@pytest.mark.parametrize(
    "text", ["m^99", "m^13", "m^2.5", "m//s", "m/(s", "kg/()", "(m)", "m" * 50, "m^^2", "_", "2 m"]
)
def test_refused_units(text: str) -> None:
    with pytest.raises(UnitError):
        parse_unit(text)


@given(st.text(max_size=50) | st.text(alphabet="mskgN*/^()12-. °", max_size=20))
def test_any_text_is_a_unit_or_a_unit_error(text: str) -> None:
    with suppress(UnitError):
        assert parse_unit(text).factor > 0


@given(st.lists(st.tuples(st.sampled_from(sorted(ATOMS)), st.integers(-3, 3)), min_size=1, max_size=4))
def test_products_multiply_factors(parts: list[tuple[str, int]]) -> None:
    text = "*".join(f"{atom}^{power}" for atom, power in parts)
    if len(text) > units.MAX_UNIT_LENGTH:
        return
    factor = Fraction(1)
    for atom, power in parts:
        factor *= ATOMS[atom].factor ** power
    assert parse_unit(text).factor == factor


dimensions = st.builds(Dimension, *(st.integers(-4, 4).map(Fraction),) * 3)
broken = st.builds(Dimension, *(st.fractions(-4, 4, max_denominator=3),) * 3)


@given(broken)
def test_broken_powers_are_read_as_they_are_printed(dimension: Dimension) -> None:
    text = default_unit(dimension).text
    assert len(text) > units.MAX_UNIT_LENGTH or parse_unit(text).dimension == dimension


@given(dimensions, st.booleans(), st.booleans())
def test_default_unit_has_the_dimension(dimension: Dimension, angle: bool, us: bool) -> None:
    unit = default_unit(dimension, angle, us)
    assert unit.dimension == dimension
    assert parse_unit(unit.text).factor == unit.factor


@given(dimensions, dimensions)
def test_dimension_arithmetic(first: Dimension, second: Dimension) -> None:
    assert first * second / second == first
    assert (first ** Fraction(1, 2)) ** 2 == first


def test_words_and_print() -> None:
    assert describe(units.FORCE) == "a force (N)"
    assert describe(units.RATE, angle=True) == "an angular velocity (rad/s)"
    assert describe(units.PURE) == "a pure number"
    assert describe(units.FORCE * units.FORCE) == "a quantity in kg^2*m^2/s^4"
    assert [pretty_unit(text) for text in ("m/s^2", "N*m", "deg", "1", "s^-1")] == ["m/s²", "N·m", "°", "", "s⁻¹"]
    assert default_unit(units.ENERGY).text == "N*m"
    assert default_unit(units.FORCE, us=True).text == "lbf"
    assert default_unit(Dimension(Fraction(1, 2))).text == "m^(1/2)"


def test_base_units() -> None:
    """Formulas need no factors: m, kg, s, or ft, slug, s."""
    coherent = ("ft", "slug", "s", "lbf", "lbf*ft", "ft*lbf/s", "slug*ft^2", "rad")
    assert all(factor_to_base(parse_unit(text), us=True) == 1 for text in coherent)
    assert factor_to_base(parse_unit("psi"), us=True) == 144
    assert factor_to_base(parse_unit("lb"), us=True) == Fraction(30480, 980665)
    assert factor_to_base(parse_unit("mi/h"), us=True) == Fraction(88, 60)
    assert factor_to_base(parse_unit("m"), us=True) * factor_to_base(parse_unit("ft"), us=False) == 1
    root = factor_to_base(parse_unit("m^(1/2)"), us=True)
    assert abs(float(root) ** 2 - 1 / 0.3048) < 1e-14
    assert in_base(parse_unit("deg"), us=True) == in_base(parse_unit("deg"), us=False)
