"""Equal bodies are told once, and bodies at rest have no moments of inertia that anything uses."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import page_of_file, page_of_text

from planar_cli.report.energy.alike import told_of_each, weights_of_each


@pytest.mark.parametrize(("stem", "line"), [
    ("ex-4-11", "G is the common mass centre of AB, AC, BD, CD, midway between A and D."),
    ("ex-4-11", "U of the weights of AB, AC, BD, CD = 4 m g (y_G,1 - y_G,2) = 2 m g x_max"),
    ("ex-4-17", "moments of inertia of OA, AB: I_OA = I_AB = 1/12 m l² = 1/12 · 1 · 0.5² = 0.02083 kg·m²"),
    ("two-hinged-bars-that-collapse", "T_2 of AB, BC, each = 1/2 m (1/2 l θ̇_2)² + 1/2 (1/12 m l²) θ̇_2² = 1/6 m l²"),
    ("two-hinged-bars-that-collapse", "U of the weights of AB, BC, each = 1/2 m g l sin θ_0"),
])  # fmt: skip
def test_equal_bodies_are_told_once(stem: str, line: str) -> None:
    assert line in page_of_file(stem)


def test_a_mass_that_is_a_product_stands_in_brackets(tmp_path: Path) -> None:
    (text,) = (p.read_text() for p in PROBLEMS if p.stem == "two-rods-falling-flat")
    other = text.partition("note:")[0].replace("mass: m}", "mass: 2*m}")
    page = page_of_text(tmp_path, other)
    assert "each = 1/2 (2 m) (1/2 l θ̇_2)² + 1/2 (1/6 m l²) θ̇_2² = 1/3 m l² θ̇_2²" in page


def test_nothing_of_turning_where_all_is_at_rest() -> None:
    """From rest to rest no energy is kinetic: no angular velocity, and no moment of inertia."""
    printed = page_of_file("ex-4-11")
    assert "T_1 = T_2 = 0" in printed
    assert "ω_AB" not in printed
    assert "inertia" not in printed


def test_each_of_several() -> None:
    """Only weights stand together, and only those with one formula."""
    x, y = sp.symbols("x y")
    assert told_of_each([("A", x), ("B", y), ("C", x)]) == {0: "A, C, each", 1: "B"}
    sources = [("weight of A", x), ("spring s", x), ("weight of B", x), ("weight of C", y)]
    assert weights_of_each(sources) == {0: "weights of A, B, each", 1: "spring s", 3: "weight of C"}
