"""What students type: numbers with units, senses, pairs, lists, words, formulas; and what is refused."""

from __future__ import annotations

import math

import pytest

from planar_cli.homework.typed.typed import read
from planar_cli.homework.typed.typed_formula import same_equation, same_formula
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.homework.typed.written_numbers import significant

LETTERS = (("m", "kg"), ("g", "m/s^2"), ("beta", "deg"), ("mu", "1"))
RIGHT = "m*g*(sin(beta) - mu*cos(beta))"


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        ("12.5 N", 12.5, "N"),
        ("= 12.5 N", 12.5, "N"),
        ("F = 12.5 N", 12.5, "N"),
        ("1.25*10^1 N", 12.5, "N"),
        ("1.25 x 10^1 N", 12.5, "N"),
        ("1.25e1N", 12.5, "N"),
        ("25/2 N", 12.5, "N"),
        ("5*sqrt(2) m/s", 5 * math.sqrt(2), "m/s"),
        ("2*pi rad/s", 2 * math.pi, "rad/s"),
        ("−3.20 m/s²", -3.2, "m/s^2"),
        ("45°", 45, "deg"),
        ("12 N·m", 12, "N*m"),
        ("12 N-m", 12, "N*m"),
        ("12 Nm", 12, "N*m"),
        ("12 ft-lb", 12, "lbf*ft"),
        ("12 lbs", 12, "lb"),
        ("3 meters per second", 3, "m/s"),
        ("3 rad/sec", 3, "rad/s"),
        ("7", 7, None),
        ("4.98 s⁻¹", 4.98, "s^-1"),
        ("3 m·s⁻²", 3, "m*s^-2"),
        ("533.5 [N]", 533.5, "N"),
        ("444,5 N", 444.5, "N"),
        ("0,437 m", 0.437, "m"),
        ("approx. 1.2 m/s", 1.2, "m/s"),
        ("about 1.2 m/s", 1.2, "m/s"),
        ("~1.2 m/s", 1.2, "m/s"),
        ("ω = 5 rad/s", 5, "rad/s"),
        ("-9.436 1/s", -9.436, "1/s"),
        ("4.093/s", 4.093, "1/s"),
        ("≈ 4.61 m/s²", 4.61, "m/s^2"),
        ("5 m/s squared", 5, "m/s^2"),
        ("(250*cos(25 deg)/45) m/s^2", 250 * math.cos(math.radians(25)) / 45, "m/s^2"),
        ("-0.25*(40*9.81-200*sin(25 deg)) N", -0.25 * (40 * 9.81 - 200 * math.sin(math.radians(25))), "N"),
        ("200*sin(25°) N", 200 * math.sin(math.radians(25)), "N"),
        ("200*sin(25 deg)", 200 * math.sin(math.radians(25)), None),
    ],
)
def test_numbers_with_units(text: str, value: float, unit: str | None) -> None:
    typed = read(text, "number")
    assert typed.values == (pytest.approx(value),)
    assert (typed.unit.text if typed.unit else None) == unit


@pytest.mark.parametrize(
    ("text", "sense", "axis", "way"),
    [
        ("6.2 rad/s cw", -1, "", 0),
        ("6.2 rad/s counterclockwise", 1, "", 0),
        ("9.81 m/s^2 down", 0, "y", -1),
        ("3 m/s to the right", 0, "x", 1),
        ("3 m/s", 0, "", 0),
        ("1.954 m/s (to the left)", 0, "x", -1),
        ("4.093/s cw", -1, "", 0),
        ("cw 21.2 rad/s^2", -1, "", 0),
        ("clockwise: 21.2 rad/s^2", -1, "", 0),
        ("21.2 ccw rad/s^2", 1, "", 0),
        ("to the left 3 m/s", 0, "x", -1),
        ("4 m in the x direction", 0, "x", 1),
        ("15.8 m/s^2 in -x direction", 0, "x", -1),
        ("1.836 m/s in +x", 0, "x", 1),
        ("3 m/s (in the negative y-direction)", 0, "y", -1),
        ("3 ft along -x", 0, "x", -1),
    ],
)
def test_senses_and_directions(text: str, sense: int, axis: str, way: int) -> None:
    typed = read(text, "number")
    assert (typed.sense, typed.axis, typed.way) == (sense, axis, way)


@pytest.mark.parametrize(
    ("text", "value", "note"),
    [
        ("-36.76 m/s^2 to the left", 36.76, "read as 36.76 m/s^2 to the left"),
        ("-4.481 rad/s cw", 4.481, "read as 4.481 rad/s cw"),
        ("-5 m/s right", -5, "the opposite"),
        ("4.00 m/s down the slope", 4, "not read: 'down the slope'"),
        ("59.42 N opposite to the motion", 59.42, "not read: 'opposite to the motion'"),
        ("533 ± 1 N", 533, "not read: '± 1'"),
        ("12 N m towards the wall", 12, "not read: 'towards the wall'"),
    ],
)
def test_how_words_were_read_is_told(text: str, value: float, note: str) -> None:
    typed = read(text, "number")
    assert typed.values == (value,)
    assert note in typed.notes[0]


@pytest.mark.parametrize(
    ("text", "values", "polar"),
    [
        ("[3, -4] m/s", (3, -4), False),
        ("(3 m/s, -4 m/s)", (3, -4), False),
        ("3i - 4j m/s", (3, -4), False),
        ("<3, -4>", (3, -4), False),
        ("5 m/s at -53 deg", (5, -math.radians(53)), True),
        ("10 N @ 30°", (10, math.radians(30)), True),
        ("9.81 m/s^2 down", (0, -9.81), False),
        ("1.61 m/s i - 0.579 m/s j", (1.61, -0.579), False),
        ("v_x = 1.61 m/s, v_y = -0.579 m/s", (1.61, -0.579), False),
        ("{1.61, -0.579} m/s", (1.61, -0.579), False),
        ("[1.61 -0.579] m/s", (1.61, -0.579), False),
        ("[1,15; -0,437] m/s", (1.15, -0.437), False),
        ("[3,4] m/s", (3, 4), False),
        ("1.709 m/s at 19.8 deg below +x", (1.709, -math.radians(19.8)), True),
        ("5 m/s, 30° above the negative x-axis", (5, math.radians(150)), True),
        ("A_y = 74.4 lbf, A_x = 0", (0, 74.4), False),
        ("v_x=3 m/s and v_y=-4 m/s", (3, -4), False),
        ("3 m/s, -4 m/s", (3, -4), False),
        ("3, -4 m/s", (3, -4), False),
        ("5 m/s, 30°", (5, math.radians(30)), True),
        ("up 74.4 lbf", (0, 74.4), False),
    ],
)
def test_pairs(text: str, values: tuple[float, float], polar: bool) -> None:
    typed = read(text, "vector")
    assert typed.values == pytest.approx(values)
    assert typed.polar == polar


def test_lists_and_words() -> None:
    assert read("[1.2 s, 3.4 s, 5 s]", "list").values == (1.2, 3.4, 5)
    assert read("1.2, 3.4 s", "list").values == (1.2, 3.4)
    assert read("Yes.", "word").word == "yes"
    assert read("slides", "word").word == "slip"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("", "number"),
        ("nan", "number"),
        ("inf", "number"),
        ("1e999", "number"),
        ("12.7 ± 1000", "number"),
        ("3 +/- 1000 N", "number"),
        ("1,200 N", "number"),
        ("9**9**9**9", "number"),
        ("__import__('os').system('x')", "number"),
        ("0*m + 3", "number"),
        ("12 furlong", "number"),
        ("-9.43.6 1/s", "number"),
        ("3 km per fortnight", "number"),
        ("3 N or 4 N", "number"),
        ("4 m/s to the left and down", "number"),
        ("2 m*sin(3 m)", "number"),
        ("-5 m/s at 30 deg", "vector"),
        ("[1 m, 2 s]", "vector"),
        ("perhaps", "word"),
        ("3 N\x1b[31m", "number"),
        ("x" * 600, "number"),
    ],
)
def test_what_is_no_answer_is_told_so(text: str, kind: str) -> None:
    with pytest.raises(Unreadable) as told:
        read(text, kind)
    assert str(told.value)


def test_a_comma_before_three_digits_is_a_decimal_point_only_where_the_set_says_so() -> None:
    assert read("3,607 N", "number", comma=True).values == (3.607,)
    with pytest.raises(Unreadable, match=r"write 3607 or 3\.607"):
        read("3,607 N", "number")


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("√(3*9.81*(1-cos 65°)/1.2) rad/s", 3.7630),
        ("13*9.81*cos 25° N", 115.581),
        ("13*9.81*cos 25 deg N", 115.581),
        ("13*9.81*cos(25 deg) N", 115.581),
        ("2 sqrt(2) m/s", 2.82843),
        ("2√3 m/s^2", 3.46410),
        ("\\frac{3}{4} m", 0.75),
        ("\\sqrt{2*9.81} m/s", 4.42945),
        ("2½ m", 2.5),
        ("3π/4 rad", 2.35619),
    ],
)
def test_numbers_are_typed_as_formulas_are(text: str, value: float) -> None:
    found = read(text, "number")
    assert found.unit is not None
    assert found.values[0] == pytest.approx(value, rel=1e-5)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("3/2√3 m", "two ways"),
        ("m_1*g*cos(beta)", "not a formula in letters: 'm_1' is one"),
        ("√(3g(1-cos φ)/L)", "not a formula in letters: 'g' is one"),
        ("m_2 (g - R α)", "not a formula in letters: 'm_2' is one"),
        ("12.5*g N", "not a formula in letters: 'g' is one"),
        ("<script>alert(1)</script>", "a number with its unit is asked"),
        ("[12.5 N", "a number with its unit is asked"),
    ],
)
def test_what_is_no_number_is_told_as_what_it_is(text: str, told: str) -> None:
    with pytest.raises(Unreadable, match=told):
        read(text, "number")


def test_words_are_no_number() -> None:
    with pytest.raises(Unreadable, match="a number with its unit is asked"):
        read("see attached sheet", "number")


@pytest.mark.parametrize(("number", "figures"), [("0.0120", 3), ("120", 3), ("1.20e3", 3), ("5", 1), ("-0.5", 1)])
def test_significant_figures(number: str, figures: int) -> None:
    assert significant(number) == figures


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("m*g*sin(beta) - mu*m*g*cos(beta)", True),
        ("g*m*(sin(beta)^2 + cos(beta)^2)*(sin(beta) - mu*cos(beta))", True),
        ("m*g*cos(beta)", False),
        ("m*g*(sin(beta) - 0.3*cos(beta))", False),
        # It has no value where the right one has them.
        ("sqrt(-m)", False),
    ],
)
def test_formulas_are_compared_by_identity(text: str, same: bool) -> None:
    assert same_formula(text, RIGHT, LETTERS) == same


@pytest.mark.parametrize("text", ["x*m", "m g", "v(P)", "m @ 2", "m*(", "9**9**9**9"])
def test_what_is_no_formula_of_these_letters(text: str) -> None:
    with pytest.raises(Unreadable):
        same_formula(text, RIGHT, LETTERS)


def test_an_equation_of_a_curve_may_have_any_factor() -> None:
    letters = (("x", "m"), ("y", "m"))
    assert same_equation("2*y^2 = 450 - 2*x^2", "x^2 + y^2 = 225", letters)
    assert not same_equation("x^2 - y^2 = 225", "x^2 + y^2 = 225", letters)
    with pytest.raises(Unreadable):
        same_equation("x^2", "x^2 + y^2 = 225", letters)
