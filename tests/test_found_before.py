"""A case that only asks more of the same instant does not solve again for what an earlier one has found."""

from __future__ import annotations

from decimal import Decimal

from sympy import Symbol
from worked import page_of_file

from planar_cli.report.document.blocks import Block, Equation, Forces, Heading, Math, Paragraph, Value, line
from planar_cli.report.repeats.found_before import goes_on

S, N, R = (Math(Symbol(name)) for name in "SNR")


def result(number: int, letter: Math, value: int) -> Equation:
    return Equation((letter, Value(Decimal(value), "N", 4)), lead=line(f"({number}):"))


def sum_of(number: int, letter: Math) -> Equation:
    return Equation((letter, Math(Symbol("P"))), number, line("→ ΣF_x:"))


DRAWN: list[Block] = [Heading("STEP 1", "Kinetic analysis"), Forces("box", line(S))]
ASIDE = line("(1) to (3), 3 unknowns: ", S, ", ", N, ", ", R)
SOLVED: list[Block] = [result(1, S, 5), result(2, N, 7), result(3, R, 9)]
STATED: list[Block] = [*DRAWN, line_of := Paragraph(line("box:")), sum_of(1, S), sum_of(2, N), sum_of(3, R)]


def test_what_is_found_is_not_solved_again() -> None:
    blocks = [*STATED, Heading("STEP 2", "Solving the equations", ASIDE), *SOLVED]
    assert goes_on(blocks, [result(4, N, 7)]) == [
        *DRAWN,
        line_of,
        sum_of(1, S),
        sum_of(2, R),
        Heading("STEP 2", "Solving the equations", line("(1), (2), 2 unknowns: ", S, ", ", R)),
        Paragraph(line("As before: ", N, " = ", Value(Decimal(7), "N", 4), ".")),
        result(1, S, 5),
        result(2, R, 9),
    ]


def test_another_value_is_another_quantity() -> None:
    blocks = [*STATED, Heading("STEP 2", "Solving the equations", ASIDE), *SOLVED]
    assert goes_on(blocks, [result(4, N, 8)]) == blocks
    assert goes_on(blocks, SOLVED) == blocks


def test_pin_forces_go_on_from_what_the_torque_took() -> None:
    page = page_of_file("slider-crank-driven")
    assert page.count("α_AB = √3 r (ω_OA² - ω_AB²)") == 1
    assert "As before: α_AB = 116.9 rad/s², A_t = 45.60 N. (3): B_x =" in page
    assert "(3) to (7), 5 unknowns: B_x, B_y, A_n, O_x, O_y" in page
    assert "AB, perpendicular to A_n" not in page
    assert "As before: α_AB = 116.9 rad/s². (3): N_track =" in page


def test_kinematics_of_which_no_later_line_names_an_equation_stand_once() -> None:
    page = page_of_file("four-bar-driven")
    assert page.count("Kinematic analysis") == 1
    assert "CASE pins STEP 1 Kinetic analysis" in page
    assert "STEP 2 Solving the equations (7) to (12), 6 unknowns: C_x" in page
