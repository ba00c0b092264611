"""Where bodies touch that the file does not name, what rolls there, and roots that were found in numbers."""

from __future__ import annotations

import sympy as sp
from conftest import ROOT
from worked import worked

from planar_cli.equation.values.exact import Valuation
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.kinematics.rolled_points import in_plain_lengths
from planar_cli.report.page.narrate import narrate

NO_DATA = Valuation({})


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def test_a_plank_that_rolls_on_a_trunk() -> None:
    page = _page("energy/plank-on-a-tree-trunk")
    assert "C_1: the point where plank touches trunk\n" in page
    assert "plank rolls without slipping:   a_C1 = R ω² ↖\n" in page
    assert "a_G = a_C1 + α × r_G/C1 - ω² r_G/C1   r_G/C1 = [R θ cos θ, R θ sin θ]\n" in page
    assert "= m R α θ ↖ at G,  m R ω² ↖ at G,  m R ω² θ ↙ at G,  I α ↺\n" in page
    assert "θ_2 = 15.07°                 solved numerically\n" in page
    assert "N_1 = m (g + R ω_1²) = 10 (9.81 + 0.5 · 1²) = 103.1 N\n" in page


def test_a_vector_of_two_plain_lengths() -> None:
    theta, radius = sp.Symbol("theta", real=True), sp.Symbol("R", positive=True)
    along, across = Vec(-sp.cos(theta), -sp.sin(theta)), Vec(-sp.sin(theta), sp.cos(theta))
    found = in_plain_lengths(across * radius + along * (radius * theta), sp.S.One, NO_DATA)
    assert {size for _, size in found} == {radius, radius * theta}
    assert in_plain_lengths(across * radius, theta, NO_DATA) == [(across * radius, theta)]


def test_parts_that_may_point_the_other_way_stay_together() -> None:
    """From a place (x, y) towards a centre (0, -d) it is one arrow; R → and c ↓ are two, and c may stand for others."""
    x, y, d, c = sp.Symbol("x", real=True), sp.Symbol("y", real=True), *sp.symbols("d c", positive=True)
    inward = Vec(-x, -d - y)
    assert in_plain_lengths(inward, sp.S.One, NO_DATA) == [(inward, sp.S.One)]
    assert {size for _, size in in_plain_lengths(Vec(d, -c), sp.S.One, NO_DATA)} == {c, d}
    stands = Valuation({}, {y: d / 2})
    assert {size for _, size in in_plain_lengths(Vec(d, -y), sp.S.One, stands)} == {d, y}
