"""What an answer rests on is told where no equation has told it, and what is zero is no small number."""

from __future__ import annotations

from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    """The page with single spaces."""
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    return " ".join(Terminal(200).render(narrate(solution)).split())


def test_the_force_of_a_stream_that_is_asked() -> None:
    page = _page("momentum/vane-that-runs-before-a-jet")
    assert "momentum per second of the stream jet: F_jet = ρ (v_j - u)² A = 1000 (30 - 12)² · 0.0005 = 162 N" in page
    assert "Principle Momentum of a stream: its force is the mass per second times its velocity." in page


def test_the_parts_of_a_moment_of_inertia_that_is_asked() -> None:
    page = _page("rigid-bodies/flywheel-with-four-holes")
    assert "I_3 = 1/2 m_3 r_h² = 1/2 (-3.551) · 0.06² = -0.006392 kg·m²" in page
    assert "k_O = √(I/m)" in page
    assert "x_G" not in page


def test_the_acceleration_at_a_largest_speed() -> None:
    page = _page("energy/plate-let-go-at-a-corner")
    assert "α_lowest = -3 g (b cos θ_lowest + h sin θ_lowest) / (2 (b² + h²)) = 0 rad/s²" in page
    assert "×10⁻" not in page


def test_a_moment_of_inertia_about_a_point_is_checked_part_by_part() -> None:
    told = "moments of inertia about O, part by part: 1.57 - 0.2436 = 1.326 kg·m²"
    assert told in _page("rigid-bodies/plate-with-a-hole")
