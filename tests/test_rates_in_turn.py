"""Rates of what depends on coordinates: each is the derivative of what stands before it."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from conftest import ROOT
from worked import worked

from planar_cli.equation.values.exact import Valuation
from planar_cli.formats.terminal import Terminal
from planar_cli.report.notation.sizes import on_one_side, sizes_of
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    return Terminal(width=110).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))


def test_each_rate_is_the_derivative_of_the_one_before() -> None:
    page = _page("kinematics/radar-that-tracks-an-aircraft")
    assert "θ̈ = dθ̇/dt = 2 v θ̇ sin θ cos θ / h = 2 v² sin³ θ cos θ / h²\n" in page
    assert "r = h/sin θ\n" in page
    assert "ṙ = -h θ̇ cos θ / sin² θ = -v cos θ\n" in page
    assert "r̈ = dṙ/dt = v θ̇ sin θ = v² sin³ θ / h\n" in page
    assert "a_load = u h² ẋ / (h² + x²)^(3/2) = u² h²" in _page("motion/rope-pulled-by-a-walker")


def test_a_size_of_a_side_is_assumed_positive() -> None:
    page = _page("kinematics/radar-that-tracks-an-aircraft")
    assert "Assume      sin θ > 0\n" in page
    assert "|sin θ|" not in page
    theta, v = sp.Symbol("theta", real=True), sp.Symbol("v", real=True)
    assert sizes_of(v * sp.Abs(sp.sin(theta)) + sp.Abs(v), [theta]) == [sp.sin(theta)]
    acute, reflex = (Valuation({theta: Decimal(n)}) for n in ("0.7", "4"))
    assert on_one_side(v * sp.Abs(sp.sin(theta)), [theta], acute) == v * sp.sin(theta)
    assert on_one_side(v * sp.Abs(sp.sin(theta)), [theta], reflex) == -v * sp.sin(theta)


def test_a_point_that_is_written_with_a_coordinate_is_differentiated_at_once() -> None:
    """The middle of the bar, and its length, are no matter of the question."""
    page = _page("kinematics/bar-leaning-on-a-half-cylinder")
    assert "x_A = -r/sin θ differentiated; given: v_Ax = -u:\n    (1)         r θ̇ cos θ / sin² θ = -u\n" in page
    assert "ω = θ̇ = -u sin² θ / (r cos θ)\n" in page
    assert "α = dω/dt = -u θ̇ sin(θ) (1 + cos² θ) / (r cos² θ) = " in page
    assert "Position vectors, differentiated: v = dr/dt, a = dv/dt.\n" in page
    assert "v_AB" not in page
    assert "Positions and curves" not in page


@pytest.mark.parametrize("stem", ["kinematics/radar-that-tracks-an-aircraft", "motion/rope-pulled-by-a-walker"])
def test_derivatives_of_places_do_not_repeat_what_the_equations_told(stem: str) -> None:
    assert "Positions and curves" not in _page(stem)
