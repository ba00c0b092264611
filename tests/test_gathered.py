"""Two equal rods that fold alike, at the one state at which forces are asked: first the speed, then diagrams with one
arrow along each axis.
"""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page() -> str:
    path = ROOT / "problems/energy/two-rods-falling-flat.yaml"
    return " ".join(Terminal(width=160).render(narrate(worked(path)[0])).split())


def test_the_energy_comes_before_the_forces_at_its_state() -> None:
    page = _page()
    assert "STEP 1 Work and energy states 1, 2" in page
    assert page.index("STEP 2 Kinematic analysis") > page.index("(1): θ̇_2 = -√(3 g sin β / l)")
    assert "STEP 5" not in page
    assert page.index("Hence: v_B = l |θ̇_2|") > page.index("STEP 4 Solving the equations")


def test_the_parts_of_m_a_g_along_an_axis_are_one_arrow() -> None:
    """α_BC = -α_AB is put in, where the couple turns the other way; couples of both rods are nothing together."""
    page = _page()
    assert "= 1/2 m l α_AB ↑ at G_BC, 3/2 m l ω_AB² ← at G_BC, I_BC α_AB ↻" in page
    assert "N_C l - 1/2 m g l = 1/2 m l α_AB · l/2 - I_BC α_AB = 1/6 m l² α_AB" in page
    assert "2 N_C l - 2 m g l = 1/2 m l α_AB · l/2 + 1/2 m l α_AB · 3 l/2 = m l² α_AB" in page
