"""Of small oscillations the forces stand to the first order in the deviation, and energies check the frequency."""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def _page(stem: str) -> str:
    return " ".join(Terminal(200).render(narrate(worked(FILES[stem])[0])).split())


@pytest.mark.parametrize(
    ("stem", "lines"),
    [
        (
            "hinged-beam-critical-damping",
            ["F_E = k δ L - 1/2 m g", "F_F = 1/2 c L δ̇", "ΣM_A: -1/4 c L² δ̇ - k δ L² = I_A α"],
        ),
        ("inverted-pendulum", ["F_W = -k a δ", "ΣM_O: δ (m_B g l + 1/2 m_b g l - k a²) = m_B l² α"]),
        ("disk-held-by-a-spring", ["F_V = 2 k_2 δ", "ΣM_C: (k_1 + 4 k_2) δ R = I_G α - m a_G R"]),
    ],
)
def test_forces_are_linear(stem: str, lines: list[str]) -> None:
    page = _page(stem)
    assert "to the first order in δ" in page
    for told in lines:
        assert told in page
    assert "sin φ)²" not in page


def test_short_ones_stand_as_they_are() -> None:
    page = _page("block-between-two-springs")
    assert "first order" not in page
    assert "k_2 (b - x - l_2) - k_1 (x - l_1)" in page


def test_a_motion_between_states_needs_the_whole_force() -> None:
    """In the case in which it is let go, the page tells the exact forces."""
    page = _page("bar-with-spring-and-damper")
    first = page.partition("CASE undamped")[0]
    assert "first order" not in first
    assert "first order" in page


@pytest.mark.parametrize(
    ("stem", "check"),
    [
        ("inverted-pendulum", "E_k = 1/2 · 1.813 δ̇², V = 1/2 · 13.96 δ² in J; ω_0 = √(13.96/1.813) = 2.774 rad/s"),
        ("hinged-beam-critical-damping", "E_k = 1/6 m L² δ̇², V = 1/2 k δ² L²; ω_0² = 3 k/m"),
        ("half-disk-rocking", "V = 2 m g δ² R/(3 π); ω_0² = 8 g / ((9 π - 16) R)"),
    ],
)
def test_energies_check_the_frequency(stem: str, check: str) -> None:
    assert check in _page(stem)


def test_no_energies_of_an_unstable_equilibrium() -> None:
    page = _page("inverted-pendulum")
    assert "energies near" not in page.partition("CASE soft")[2]


def test_a_spring_is_drawn_as_it_lies_at_rest() -> None:
    """To the first order in δ it pulls along the line in which it lies in the equilibrium, level here."""
    page = _page("disk-held-by-a-spring")
    assert "F_V ← at S" in page
    assert "F_S ↓ at Q" in _page("bar-with-a-mass-on-a-spring")
