"""What stands on a page already is told once: under another number, in a later part of a motion, or as a definition."""

from __future__ import annotations

import re

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.document.blocks import Equation, Math, Paragraph, line
from planar_cli.report.repeats.told_before import defined_once


@pytest.mark.parametrize(
    ("stem", "line"),
    [
        ("simple-pendulum", "as before: the diagram and (2) of the first part"),
        ("simple-pendulum", "as before: the diagram (turned), (1) and (2) of the first part"),
        ("disk-held-by-a-spring", "as before: (2) and (3) of case let go"),
        ("bicycle-driven-and-braked", "STEP 5 Kinematic analysis as from 1 to 2: (10) to (13), there (1) to (4)"),
        (
            "bicycle-driven-and-braked",
            "Diagrams as from 1 to 2, but on frame M_b ↻ in place of M_c ↺; on rear no M_c ↻; on front also M_b ↺.",
        ),
    ],
)
def test_equations_that_had_other_numbers(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_place_that_is_put_in() -> None:
    """At the highest place the line is S = m (g cos θ + l θ̇²), and which place that is."""
    page = page_of_file("simple-pendulum")
    assert "with θ = 180°, θ̇ = 0: S_top = m g cos 180° = -m g" in page
    assert page.count("↖ ΣF: S_rod - m g cos θ = m l θ̇²") == 1
    assert "eom = " not in page


def test_a_diagram_in_which_one_force_is_turned_is_drawn_again() -> None:
    assert "turned" not in page_of_file("body-block-sent-up-a-slope")


def test_results_from_equations_with_other_numbers() -> None:
    """What follows from rows of a table is as before."""
    page = page_of_file("chain-5-symbols")
    assert page.count("α_DE = -3 g cos β / (362 L)") == 3
    assert "As before: α_OA = -459 g cos β / (362 L), α_AB = 123 g cos β / (362 L)" in page


@pytest.mark.parametrize(
    "stem", ["bicycle-driven-and-braked", "ladder-leaving-the-wall", "roller-onto-a-spring", "ball-with-backspin"]
)
def test_a_moment_of_inertia_is_defined_once(stem: str) -> None:
    page = page_of_file(stem)
    defined = re.findall(r"moment of inertia of \w+:", page)
    assert defined
    assert len(defined) == len(set(defined))


def test_what_has_no_number_is_told_once_in_a_step() -> None:
    """T_1 = 0 of the first balance is that of the second."""
    assert page_of_file("slider-crank-with-a-spring").count(" T_1 = 0") == 1


def test_what_stands_alone_under_its_heading_stays() -> None:
    law = Equation((Math(sp.Symbol("a")), Math(sp.Symbol("g"))))
    blocks = [Paragraph(line("For x:")), law, Paragraph(line("For y:")), law, Paragraph(line("Hence:"))]
    assert list(defined_once(blocks)) == blocks


def test_where_a_body_is_drawn_is_not_told() -> None:
    """Diagrams that read alike are the same, wherever their arrows are drawn."""
    page = page_of_file("carriages-that-collide").split("CASE elastic")[1]
    assert "free-body" not in page
    assert "m_A v_A,1 →" not in page


def test_a_case_that_is_derived_as_the_first_part_tells_its_results() -> None:
    """With e = 1 all equations are those of e = 0.7."""
    case = page_of_file("carriages-that-collide").split("CASE elastic")[1]
    assert (
        "As in the first part, by (1), (2): v_B,2 = (e m_A (v_A,1 - v_B,1) + m_A v_A,1 + m_B v_B,1)/(m_A + m_B)" in case
    )
    assert "Restitution between" not in case
    assert "v_A,2 = v_B,2 - e (v_A,1 - v_B,1) = 4.6 - 1 (4 - 1) = 1.6 m/s" in case


@pytest.mark.parametrize("stem", ["chain-5", "lever-with-spring-and-damper", "rod-and-disk-pendulum"])
def test_no_heading_without_lines(stem: str) -> None:
    """What would stand under it stands under Given."""
    assert "Velocities: Accelerations:" not in " ".join(page_of_file(stem).split())


def test_named_quantities_by_the_same_formulas() -> None:
    """Another height of the same toy: its mass and mass centre by their new values alone."""
    page = page_of_file("toy-on-a-round-end")
    assert "As before, now with m_2 = 0.9 kg, y_2 = 0.145 m, m = 1.685 kg, y_G = 0.1043 m" in page
    assert page.count("y_1 = r - 4 r/(3 π)") == 1


def test_rows_that_are_solved_together() -> None:
    """Each equation once with its numbers and once collected; a later case quotes the results."""
    page = page_of_file("chain-5")
    assert "collected:" not in page
    assert "7 unknowns: α_OA, α_AB, α_BC, α_CD, α_DE, O_x, O_y; the accelerations in these by (1) to (10)" in page
    assert page.count("- 0.03473 α_CD - 3.849 in m/s²") == 1
    assert "acceleration of the mass centre" not in page


def test_the_check_of_power_is_told_once() -> None:
    assert page_of_file("slider-crank-driven").count("power: ") == 1


def test_a_component_of_an_earlier_case_stands_before_new_vectors() -> None:
    page = page_of_file("six-bar-class-3")
    assert "Kinematic analysis as before: (1) to (8) a_G,PC = " in page
    assert page.count("a_D along x:") == 1
