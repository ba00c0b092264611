"""Answers in letters as students and keys write them: what is read, graded, and told of what is wrong."""

from __future__ import annotations

from dataclasses import replace

import pytest

from planar_cli.homework.grading.grading import grade
from planar_cli.homework.sets.paper import Expected, Graded, Paper, Submission, Task
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.typed.typed_letters import readings
from planar_cli.homework.typed.unreadable import Unreadable

LETTERS = (("g", "m/s^2"), ("l", "m"))
OTHERS = (("m", "kg"), ("beta", "deg"), ("m_1", "kg"), ("e", "1"))
OMEGA = Expected(
    "w", "", "formula", (), "rad/s", "", 0.01, 1.0, rotation=True, formula="sqrt(3*g/l)", letters=LETTERS, others=OTHERS
)
FORCE = Expected(
    "F",
    "",
    "formula",
    (),
    "N",
    "",
    0.01,
    1.0,
    axis="y",
    formula="5*m*g/2",
    letters=(("g", "m/s^2"), ("m", "kg")),
    others=(("l", "m"), ("beta", "deg"), ("e", "1")),
)
WORK = Expected(
    "U",
    "",
    "formula",
    (),
    "J",
    "",
    0.01,
    1.0,
    formula="9*m*g*l/28",
    letters=(*LETTERS, ("m", "kg")),
    others=(("e", "1"),),
)
HALF = Rules(sign=0.5, unit=0.5)


def graded(expected: Expected, text: str) -> Graded:
    paper = Paper(0, (Task("p", "", "", (), (expected,)),))
    (one,) = grade(Submission("s", 0, (("p", expected.find, text),)), {0: paper}, HALF).graded
    return one


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("5/2 m g", "5/2*m*g"),
        ("2.5 m g", "2.5*m*g"),
        ("mgl/2", "m*g*l/2"),
        ("√(3 g l)", "sqrt(3*g*l)"),
        ("√3 g", "sqrt(3)*g"),
        (r"\frac{3}{8}\sqrt{3gl}", "((3)/(8))*sqrt(3*g*l)"),
        (r"\left(\frac{3 g}{l}\right)^{1/2}", "(((3*g)/(l)))^(1/2)"),
        ("SQRT(3*g/l)", "sqrt(3*g/l)"),
        ("(1 - e²) m g l", "(1-e^(2))*m*g*l"),
        ("mg sin β", "m*g*sin(beta)"),
        ("mgsinβ", "m*g*sin(beta)"),
        ("sin²β m", "(sin(beta))^(2)*m"),
        ("½ m₁ g", "(1/2)*m_1*g"),
        ("2,5*m*g", "2.5*m*g"),
        ("2½ m g", "(2+(1/2))*m*g"),
        ("2 1/2 m g", "(2+1/2)*m*g"),
        ("m g cos(25°)", "m*g*cos(25°)"),
        ("g**2", "g^2"),
    ],
)
def test_missing_signs_and_signs_of_print_are_read(text: str, read: str) -> None:
    assert readings(text, [n for n, _ in (*LETTERS, *OTHERS)]) == (read,)


def test_what_stands_behind_a_stroke_and_a_missing_sign_has_two_readings() -> None:
    assert readings("3g/2l", ["g", "l"]) == ("3*g/2*l", "3*g/(2*l)")


def test_a_word_that_splits_in_several_ways_is_not_split() -> None:
    with pytest.raises(Unreadable, match="several ways"):
        readings("mgl", ["m", "g", "l", "mg"])


@pytest.mark.parametrize(
    ("expected", "text"),
    [
        *((OMEGA, t) for t in ("√(3g/l)", "ω = √(3 g/l)", "sqrt(3g/l)", r"\omega = \sqrt{3 g/l}", "(3g/l)^0.5")),
        *((OMEGA, t) for t in ("sqrt(3*g/l) ccw", "sqrt(3*g/l) rad/s", "√(3g/l) 1/s ccw", "sqrt(3g/l) [rad/s]")),
        *((OMEGA, t) for t in ("1.732*sqrt(g/l)", "1.73 √(g/l)", "√(6g/2l)", "(1/l) √(3 g l)")),
        *((FORCE, t) for t in ("5/2 m g", "5mg/2", "5/2 mg", "2.5 m g N", "5*m*g/2 up", "F_y = 5/2 m·g")),
        *((WORK, t) for t in ("9/28 m g l", "9/28mgl", "0.3214*m*g*l", "0.321 m g l", "9 m g l / 28 J")),
    ],
)
def test_right_in_every_form(expected: Expected, text: str) -> None:
    one = graded(expected, text)
    assert (one.verdict, one.score) == ("right", 1.0), one.message


@pytest.mark.parametrize(
    ("expected", "text", "score"),
    [
        (OMEGA, "1.7 √(g/l)", 0.9),
        (OMEGA, "1.73 √(g/l)", 1.0),
        (OMEGA, "√(3.0 g/l)", 1.0),
        (OMEGA, "1.2*1.44*√(g/l)", 1.0),
        (WORK, "-0.32 m g l", 0.5),
    ],
)
def test_numbers_before_letters_have_their_figures(expected: Expected, text: str, score: float) -> None:
    rules = replace(HALF, precision=0.9, tolerance=0.02)
    paper = Paper(0, (Task("p", "", "", (), (expected,)),))
    (one,) = grade(Submission("s", 0, (("p", expected.find, text),)), {0: paper}, rules).graded
    assert (one.value, one.score) == ("right", score)
    assert (one.precision == "wrong") == (text in ("1.7 √(g/l)", "-0.32 m g l"))


@pytest.mark.parametrize(
    ("expected", "text", "score", "said"),
    [
        (OMEGA, "sqrt(3*g/l) cw", 0.5, "the sign or sense is not right"),
        (OMEGA, "-sqrt(3*g/l)", 0.5, "the sign or sense is not right"),
        (OMEGA, "sqrt(3*g/l) m/s", 0.5, "the unit is that of a velocity"),
        (FORCE, "5/2 m g down", 0.5, "the sign or sense is not right"),
        (FORCE, "5/2 m g right", 0.5, "the sign or sense is not right"),
        (FORCE, "m*g*l", 0.0, "it has the dimension of a moment or an energy"),
        (FORCE, "m*g + m*l", 0.0, "its terms do not have the same dimension"),
        (FORCE, "2 m g", 0.0, "the formula is not right"),
        (OMEGA, "5.42 rad/s", 0.0, "a formula in letters is asked"),
        (OMEGA, "1.70 √(g/l)", 0.0, "the formula is not right"),
        (OMEGA, "2 √(g/l)", 0.0, "the formula is not right"),
        (WORK, "0.33 m g l", 0.0, "the formula is not right"),
    ],
)
def test_what_differs_is_told(expected: Expected, text: str, score: float, said: str) -> None:
    one = graded(expected, text)
    assert (one.verdict, one.score) == ("wrong", score)
    assert said in one.message


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "sqrt(3*G/L)",
            "'G' is none of the letters of the problem, which are beta, e, g, l, m and m_1; did you mean 'g'?",
        ),
        ("l*omega", "'omega' is none of the letters of the problem"),
        ("see attached sheet", "this is not an answer that can be read"),
        ("(" * 200 + "g" + ")" * 200, "nested too deeply"),
        ("9**9**9**9", "this cannot be graded"),
        ("__import__('os')", "this cannot be graded"),
        ("√3g", "where the root ends"),
        ("sqrt(3 g/l) 2", "between ) and 2 the sign is missing"),
        ("l 2", "between l and 2 the sign is missing"),
        ("2 3 g", "between 2 and 3 the sign is missing"),
        ("g/l 2", "between l and 2 the sign is missing"),
        ("sqrt(3*g/l) deg/s", "leave deg/s out"),
    ],
)
def test_what_cannot_be_read_is_told(text: str, said: str) -> None:
    one = graded(OMEGA, text)
    assert one.verdict == "ungradable", one.message
    assert said in one.message


BLOW = Expected(
    "w",
    "",
    "formula",
    (),
    "rad/s",
    "",
    0.01,
    1.0,
    rotation=True,
    formula="(1 + e)*m*v_0*b/(M*l^2/3 + m*b^2)",
    letters=(("M", "kg"), ("b", "m"), ("e", "1"), ("l", "m"), ("m", "kg"), ("v_0", "m/s")),
    known=(("M", 9.0), ("b", 1.2), ("e", 0.6), ("l", 1.2), ("m", 2.0)),
)
JERK = replace(BLOW, rotation=False, unit="N*s", formula="(1 + e)*M*m*v_0/(2*(M + 3*m))")
FEET = replace(
    BLOW, us=True, formula="v_0/b", letters=(("b", "ft"), ("v_0", "ft/s")), known=(("b", 0.6096),), others=()
)


@pytest.mark.parametrize(
    ("expected", "text", "score"),
    [
        *((BLOW, t, 1.0) for t in ("0.533 v_0", "0.533 v_0 rad/m", "0.533 v_0 1/m", "0.533*v_0 rad/s", "0.533/m*v_0")),
        *((BLOW, t, 1.0) for t in ("0.533 rad/m v_0", "0.533 1/m v_0", "0.00533 v_0 1/cm")),
        *((JERK, t, 1.0) for t in ("0.96 kg v_0", "0.960 kg*v_0", "960 g v_0", "0.96 v_0 kg", "0.96*v_0 N*s")),
        *((FEET, t, 1.0) for t in ("0.500*v_0", "0.500 v_0 rad/ft", "0.500 rad/ft v_0", "1.64 v_0 1/m", "v_0/2 rad/s")),
        (BLOW, "0.533 v_0 m/s", 0.5),
        (BLOW, "0.533 v_0 rad", 0.5),
        (JERK, "0.96 s v_0", 0.5),
        (JERK, "-0.96 kg v_0", 0.5),
        (JERK, "0.7 kg*v_0", 0.0),
        (BLOW, "0.533 v_0 1/cm", 0.0),
        (FEET, "1.64*v_0", 0.0),
    ],
)
def test_a_number_before_letters_may_have_its_unit(expected: Expected, text: str, score: float) -> None:
    one = graded(expected, text)
    assert (one.score, one.verdict) == (score, "right" if score == 1 else "wrong"), one.message


AFTER = replace(BLOW, rotation=False, axis="x", unit="m/s", formula="v_0*(3*m*b^2 - e*M*l^2)/(M*l^2 + 3*m*b^2)")


@pytest.mark.parametrize(
    ("expected", "text", "said"),
    [
        (BLOW, "0.333*v_0", "the formula is not right: v_0 stands as it should, but not the number before it"),
        (BLOW, "0.333*v_0^2", "the formula is not right"),
        (BLOW, "2*m*v_0*b*(1 + e)/(M*l^2/3 + m*b^2)", "the formula is not right: M, b, e, l, m and v_0 stand as they"),
        (BLOW, "m*v_0*b/(M*l^2/3 + m*b^2)", "the formula is not right: e should stand in it"),
        (BLOW, "m*v_0*b*(1 - e)/(M*l^2/3 + m*b^2)", "the formula is not right"),
        (BLOW, "1.5*2*v_0*b/(3*l^2 + 2*b^2)", "the formula is not right"),
        (BLOW, "m*v_0*(1 + e)/(M*l^2/3 + m*b^2)", "the formula is not right: it has the dimension of"),
        # b and l have the same length here.
        (AFTER, "v_0*(m + e*M/3)/(m + M/3)", "the formula is not right"),
        (AFTER, "-e*v_0", "the formula is not right: M and m should stand in it"),
    ],
)
def test_what_is_said_fits_how_it_was_written(expected: Expected, text: str, said: str) -> None:
    one = graded(expected, text)
    assert one.verdict == "wrong"
    assert one.message.startswith(said) if said.endswith(("they", "of")) else one.message == said


def test_a_power_of_ten_before_letters_is_named() -> None:
    one = graded(JERK, "9.6 v_0")
    assert (one.message, one.mistakes) == ("the formula is not right", ("power-of-ten",))
    assert "the number is off by a power of ten" in one.feedback
    assert graded(JERK, "0.44 v_0").mistakes == ()
