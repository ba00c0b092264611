"""What a page says of a blow: momenta and impulses in letters."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem

FILES = {p.stem: p for p in PROBLEMS}


def page(stem: str) -> str:
    """The page with single spaces."""
    return " ".join(Terminal(400).render(narrate(worked(FILES[stem])[0])).split())


@pytest.mark.parametrize(("stem", "row"), [
    ("ex-4-13", "= m AG ω_2 → at G, I ω_2 ↺"),
    ("wheel-over-a-kerb", "= m R ω_2 ↙ at G, I_G ω_2 ↺"),
    ("free-bar-struck-at-its-end", "I ω_2 ↺"),
    ("box-that-tips-over", "= m CG ω_2 ↙ at G, I_G ω_2 ↺"),
])  # fmt: skip
def test_momenta_after_a_blow_have_letters(stem: str, row: str) -> None:
    """m v_G and I ω, with AG where the distance of the mass centre is a number of the file."""
    printed = page(stem)
    assert row in printed
    assert not re.search(r"= [\d.]+ [vω]_\S+ [→↑↺]", printed)


@pytest.mark.parametrize(("stem", "row"), [
    ("rod-and-disk-pendulum", "= m OG α ↗ at G, m OG ω² ↖ at G, I α ↺"),
    ("five-bar-chain", "= m AB α_AB ↗ at G_BC, m BG_BC α_BC ↑ at G_BC"),
])  # fmt: skip
def test_distances_in_a_kinetic_diagram(stem: str, row: str) -> None:
    """A distance that is a number of the file is told by the points between which it lies."""
    assert row in page(stem)


def test_what_hangs_still_is_no_matter_of_numbers() -> None:
    """A ball that hangs at rest stays so until it is struck, so that energy and momentum solve the whole."""
    printed = page("two-pendulums-that-collide")
    assert "No formula gives" not in printed
    assert "(8) v_B - v_A = e L α̇_A,2" in printed
    assert "v_B = (1 + e) m_A L α̇_A,2 / (m_A + m_B)" in printed


def test_right_angles_in_a_blow() -> None:
    """The directions in which a blow acts are those of the place where it happens."""
    printed = page("row-of-hanging-balls")
    assert "No formula gives" not in printed
    assert "φ_B,2 = φ_B,1 = -90° it stays at rest in equilibrium" in printed
    assert "ball_A: m_ball,A v_A,2 → at A, J_S,string,A,3 ↑ at A, J_N,hit,AB,3 ← at hit_AB" in printed
    assert "v_B,3 - v_A,3 = e v_A,2" in printed
    assert "v_C,4 = (1 + e) m_ball,B v_B,3 / (m_ball,B + m_ball,C)" in printed


@pytest.mark.parametrize(("stem", "lines"), [
    ("two-balls-in-a-turning-tube", ("Q moves as P does, by symmetry: (1) s_Q,end = -s_P,end", "(2): ω_end = ")),
    ("spheres-that-slide-out-to-stops", ("other moves as one does, by symmetry:", "(5): ω_rod,3 = ω_rod,2 = 2.080")),
])  # fmt: skip
def test_bodies_that_move_alike(stem: str, lines: tuple[str, ...]) -> None:
    """By symmetry, angular momentum and energy, with no step of time; a direction that cancels is no unknown."""
    printed = page(stem)
    assert "No formula gives" not in printed
    assert all(words in printed for words in lines)


def test_unlike_bodies_do_not_move_alike() -> None:
    """Where one of them is heavier, or begins farther out, nothing is said of the other."""
    for old, new in (("{particle: Q, mass: 0.5 kg}", "{particle: Q, mass: 0.6 kg}"), ("Q: [-0.2 m", "Q: [-0.3 m")):
        text = FILES["two-balls-in-a-turning-tube"].read_text(encoding="utf-8")
        assert old in text
        problem, wrong = load_text(text.replace(old, new).split("answers:")[0])
        assert problem is not None
        assert not wrong
        assert "by symmetry" not in Terminal(400).render(narrate(solve_problem(problem)))


@pytest.mark.parametrize(("stem", "line"), [
    ("rod-falling-on-a-smooth-floor", "1/2 m l cos θ_2 + m s_2 = 1/2 m l cos θ_1"),
    ("pendulum-on-a-wagon", "M x_O,2 + m l cos φ_wagon,1 + m x_O,2 = m l cos φ_wagon,2"),
    ("block-down-a-free-wedge", "M x_W,2 + m s_P,2 cos β + m x_W,2 = 0"),
])  # fmt: skip
def test_a_mass_centre_that_keeps_its_place(stem: str, line: str) -> None:
    """From rest, along a direction in which no force acts."""
    printed = page(stem)
    assert "mass centre keeps its x:" in printed
    assert line in printed
