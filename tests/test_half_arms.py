"""The middle of a rod is half as far as its end."""

from __future__ import annotations

import sympy as sp
from worked import page_of_file

from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.kinematics.half_arms import half_of

X, L = sp.symbols("x l", positive=True)
TOLD = {"r_B/A": Vec(X - L / 2, L), "r_C/D": Vec(X, L)}


def test_half_of_an_arm_from_the_same_point() -> None:
    assert half_of("r_G/A", Vec(X / 2 - L / 4, L / 2), TOLD) == line("1/2 ", Name("r_B/A"), " = ")
    assert half_of("r_G/A", Vec(X / 2, L / 2), TOLD) == ()
    assert half_of("r_G/D", Vec(X / 2, L / 2), TOLD) == line("1/2 ", Name("r_C/D"), " = ")
    assert half_of("r_G/D", Vec(X / 2, L), TOLD) == ()


def test_on_a_page() -> None:
    assert "r_G,AB/A = 1/2 r_B/A = [0.2219, -0.0375] m" in page_of_file("slider-crank-with-a-spring")
