"""Where velocities alone are sought: ω of a wheel by the size of the given velocity of its centre, and the reasons of
lengths from an instantaneous centre.
"""

from __future__ import annotations

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

WHEEL = """
title: Wheel
plane: vertical
given: {m: 2 kg, r: 0.3 m, v: 6 m/s}
points: {C: [0, 0], O: [0, r]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies:
  wheel: {disk: O, radius: r, mass: m}
joints:
  - rolling: {between: [wheel, floor], at: C}
instant: [v(O).x = v]
find: {T: KE(all)}
"""


def _page(text: str) -> str:
    return " ".join(Terminal(200).render(narrate(solve_problem(load_text(text)[0]))).split())


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (WHEEL, "ω = v/r = 6/0.3 = 20 rad/s clockwise"),
        (WHEEL.replace("v(O).x = v", "v(O).x = -v"), "20 rad/s"),
    ],
)
def test_a_wheel_turns_about_its_contact_by_the_size_of_the_given_velocity(text: str, line: str) -> None:
    page = _page(text)
    assert line in page
    assert "T = 54 J" in page


def test_of_another_point_than_the_centre_its_arm_is_told() -> None:
    text = WHEEL.replace("O: [0, r]", "O: [0, r], A: [0, 2*r]").replace("radius: r,", "radius: r, points: [A],")
    page = _page(text.replace("v(O).x = v", "v(A).x = -v"))
    assert "r_A/C = [0, 2 r]" in page


def test_where_the_turning_is_asked_it_keeps_its_sign() -> None:
    assert "-20 rad/s" in _page(WHEEL.replace("find: {T: KE(all)}", "find: {w: omega(wheel)}"))


def test_lengths_from_the_centre_have_their_reasons() -> None:
    page = page_of_file("ex-4-07")
    assert "disk rolls without slipping, C is at rest: (1) ω_disk = v_O/r = 1/0.1 = 10 rad/s clockwise" in page
    assert "above O, at the height of E; I = [0, 0.3121] m" in page
    assert "G is the midpoint of OE, angle OIE is 90°" in page
