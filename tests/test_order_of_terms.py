"""A balance of energies stands in the order of its heading: the kinetic energy before, then what is brought."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def test_the_kinetic_energy_comes_first() -> None:
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / "energy" / "string-that-goes-slack.yaml")[0]))
    assert "T_1 + U = T_2:   1/2 m v_B,1² - m g l (1 + sin φ_B,2) = 1/2 m v_B,2²" in page
    thrown = Terminal(200).render(narrate(worked(ROOT / "problems" / "textbook" / "ex-1-06.yaml")[0]))
    assert "v_top = 0\n" in thrown


def test_a_time_by_the_velocity_that_is_asked_too() -> None:
    """No quadratic equation, as v at half the height has been found."""
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / "textbook" / "ex-1-06.yaml")[0]))
    assert "v_half = v0 - g t_half" in page
    assert "t_half = (v0 - v_half)/g = (v0 + √(g h + v0²))/g" in page
    assert "as t_half > 0" not in page
    assert "Check       y_half = h + v0 t_half - 1/2 g t_half² = h/2" in page
