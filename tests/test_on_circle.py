"""What goes round a fixed axis: by r ω and by a_t, a_n; a component that is given as a letter is that letter."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from conftest import PROBLEMS, ROOT
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Equation, Math
from planar_cli.report.given.given_letters import with_given_letters
from planar_cli.report.instant.on_circle import components
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

V, W, R, X = sp.symbols("v omega r v_Ax", real=True)


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("ex-1-09", "(1) v_A = r_h ω (1): ω = v_A/r_h = v/r_h = 0.1/0.3 = 0.3333 rad/s"),
        ("ex-1-09", "θ_2 = ω t_2 = 0.33333 · 2 = 0.6667 rad = 38.20°"),
        (
            "ex-1-09",
            "θ_2 + 90° = 38.2° + 90° = 128.2° perpendicular to OB, that is 51.8° above -x v_Bx,2 = 0.2 cos 128.2°",
        ),
        ("ex-1-10", "(2): α = a_A/r_h = 0.05/0.3 = 0.1667 rad/s²"),
        ("ex-1-10", "e_n = [-cos θ_2, -sin θ_2] from B to O: a_B = a_t e_t + a_n e_n: a_Bx,2 = -a_t sin θ_2"),
        ("ex-1-10", "a_By,2 = a_t cos θ_2 - a_n sin θ_2 = 0.1 cos 57.30° - 0.2667 sin 57.30° = -0.1704 m/s²"),
    ],
)
def test_a_drum_that_a_cable_turns(stem: str, line: str) -> None:
    page = page_of_file(stem)
    assert line in page
    assert "×" not in page


def _asked(finds: str) -> str:
    """The page of the wheel of example 1-10 with other finds."""
    text = next(p for p in PROBLEMS if p.stem == "ex-1-10").read_text()
    problem, wrong = load_text(f"{text[: text.index('find:')]}find: {{{finds}}}\n")
    assert problem is not None, wrong
    return " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())


def test_two_vectors_at_one_angle_are_both_told_in_degrees() -> None:
    page = _asked("a_t: a(B).t @ 2, a_n: a(B).n @ 2, a: a(B) @ 2, v: v(B) @ 2, v_x: v(B).x @ 2")
    assert "0.1 cos 57.30° - 0.2667 sin 57.30° = -0.1704 m/s²" in page
    assert "v_x = -R ω_2 sin θ_2 = -0.6 · 0.6667 sin 57.30° = -0.3366 m/s" in page


def test_what_rests_on_parts_stands_below_them() -> None:
    page = _asked("a: a(B) @ 2, a_t: a(B).t @ 2, a_n: a(B).n @ 2")
    assert "√(0.2282² + 0.1704²) = 0.2848 m/s²" in page
    assert "a_t²" not in page


def test_what_has_no_angle_keeps_its_vector() -> None:
    assert "v_E = ω_wheel × r_E/B" in page_of_file("body-belt-and-gears-run-up")


def test_both_sides_of_a_relation_lose_their_minus() -> None:
    datum = Equation((Math(X), Math(-V)))
    solved = Equation((Math(W), Math(-X / R), Math(-X / R, {X: "-0.1", R: "0.3"})))
    relation, found = with_given_letters([Equation((Math(X), Math(-R * W)), 1), solved], [datum])
    assert relation == Equation((Math(V), Math(R * W)), 1)
    assert found == Equation((Math(W), Math(V / R), Math(V / R, {R: "0.3", V: "0.1"})))


def test_a_number_or_another_quantity_stays() -> None:
    told = [Equation((Math(X), Math(-R * W)), 1)]
    assert with_given_letters(told, [Equation((Math(X), Math(sp.Integer(-2))))]) == told
    assert with_given_letters(told, [Equation((Math(W), Math(V)))]) == told


def test_components_are_those_of_the_vector() -> None:
    theta, sizes = Decimal(0), [Decimal(3), Decimal(4)]
    angle = sp.Symbol("theta", real=True)
    assert components(("a_t", "a_n"), sizes, angle, theta, [Decimal(-4), Decimal(3)], 4) is not None
    # A point that goes round clockwise has its a_t the other way.
    assert components(("a_t", "a_n"), sizes, angle, theta, [Decimal(-4), Decimal(-3)], 4) is None


@pytest.mark.parametrize(("one", "other", "line"), [
    ("180 deg", "0 deg", "θ_2 - 90° = -38.2° - 90° = -128.2° perpendicular to OB, that is 51.8° below -x"),
    ("t = 2 s", "t = 20 s", "θ_2 + 90° - 360° = 382.0° + 90° - 360° = 112.0° perpendicular to OB"),
])  # fmt: skip
def test_a_direction_goes_on_from_the_angle_of_the_state(one: str, other: str, line: str) -> None:
    """It is the one of which the components are made."""
    text = (ROOT / "problems" / "textbook" / "ex-1-09.yaml").read_text()
    problem, wrong = load_text(text[: text.index("answers:")].replace(one, other))
    assert problem is not None, wrong
    assert line in " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
