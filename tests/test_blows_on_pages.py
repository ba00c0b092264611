"""What a page says of a blow: momenta and impulses in letters."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.scene.impulse_letters import impulse_letters
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FILES = {p.stem: p for p in PROBLEMS}


@pytest.mark.parametrize(("stem", "row"), [
    ("ex-4-13", "= m AG ω_2 → at G, I ω_2 ↺"),
    ("wheel-over-a-kerb", "= m R ω_2 ↗ at G, I_G ω_2 ↻"),
    ("free-bar-struck-at-its-end", "I ω_2 ↺"),
    ("box-that-tips-over", "= m CG ω_2 ↗ at G, I_G ω_2 ↻"),
])  # fmt: skip
def test_momenta_after_a_blow_have_letters(stem: str, row: str) -> None:
    """m v_G and I ω, with AG where the distance of the mass centre is a number of the file."""
    printed = page_of_file(stem)
    assert row in printed
    assert not re.search(r"= [\d.]+ [vω]_\S+ [→↑↺]", printed)


@pytest.mark.parametrize(("stem", "row"), [
    ("rod-and-disk-pendulum", "= m OG α ↗ at G, m OG ω² ↖ at G, I α ↺"),
    ("bar-that-swings-down-from-a-rolling-disk", "= m_bar R α_disk → at G_bar, 1/2 m_bar l α_bar ↗ at G_bar"),
])  # fmt: skip
def test_distances_in_a_kinetic_diagram(stem: str, row: str) -> None:
    """A distance that is a number of the file is told by the points between which it lies, else by its length."""
    assert row in page_of_file(stem)


def test_what_hangs_still_is_no_matter_of_numbers() -> None:
    """A ball that hangs at rest stays so until it is struck, so that energy and momentum solve the whole."""
    printed = page_of_file("two-pendulums-that-collide")
    assert "No formula gives" not in printed
    assert "v_B - v_A = e L α̇_A,2" in printed
    assert "v_B = (1 + e) m_A L α̇_A,2 / (m_A + m_B)" in printed


def test_right_angles_in_a_blow() -> None:
    """The directions in which a blow acts are those of the place where it happens."""
    printed = page_of_file("row-of-hanging-balls")
    assert "No formula gives" not in printed
    assert "φ_B,2 = φ_B,1 = -90° it stays at rest in equilibrium" in printed
    assert "ball_A: m_ball,A v_A,2 → at A, J_S,string,A,3 ↑ at A, J_N,hit,AB,3 ←" in printed
    assert "v_B,3 - v_A,3 = e v_A,2" in printed
    assert "v_C,4 = (1 + e) m_ball,B v_B,3 / (m_ball,B + m_ball,C)" in printed


@pytest.mark.parametrize(("stem", "lines"), [
    ("two-balls-in-a-turning-tube", ("Q moves as P does, by symmetry.", ": ω_end = ")),
    ("spheres-that-slide-out-to-stops", ("B moves as A does, by symmetry.", "ω_rod,3 = ω_rod,2 = 2.080")),
])  # fmt: skip
def test_bodies_that_move_alike(stem: str, lines: tuple[str, ...]) -> None:
    """By symmetry, angular momentum and energy, with no step of time; a direction that cancels is no unknown."""
    printed = page_of_file(stem)
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
    ("pendulum-on-a-wagon", "(M + m) x_O,2 = m l sin φ"),
    ("block-down-a-free-wedge", "m s_P,2 cos β + (M + m) x_W,2 = 0"),
])  # fmt: skip
def test_a_mass_centre_that_keeps_its_place(stem: str, line: str) -> None:
    """From rest, along a direction in which no force acts."""
    printed = page_of_file(stem)
    assert "mass centre keeps its x:" in printed
    assert line in printed


@pytest.mark.parametrize(("stem", "lines"), [
    ("ex-4-13", "(1) ↺ H_A: J AS = I_A ω_2 AS = 1.5 m (1): ω_2 = J AS/I_A = 30 · 1.5 / 16 = 2.81"),
    ("ex-4-13", "J = 1000 N · 0.03 s = 30 N·s"),
    ("wheel-over-a-kerb", "I_K = m R² + I_G = 3/2 m R² = 3/2 · 10 · 0.3² = 1.35 kg·m²"),
    ("wheel-over-a-kerb", "ω_2 = (m v_0 (R - h) + I_G ω_1)/I_K = v_0 (1 - 2 h/(3 R)) / R = 1.5 (1 - 2 · 0.06 "),
    ("flywheels-coupled", "(1) ↺ H_O: I_A ω_A,1 + I_B ω_B,1 = (I_A + I_B) ω_A,2"),
    ("pendulum-set-swinging", "(4) ↺ H_A: J AS = I_A ω_2 AS = 0.6 m (4): J = I_A ω_2/AS = 6.336 · 4.755 / 0.6 = 50.2"),
    ("free-bar-struck-at-its-end", "(1) ↺ H_G: 1/2 S l = I ω_2"),
    ("dumbbell-hit-by-a-ball", "(1) → m_C v_0 = m_dumbbell v_G,dumbbell,x,2 - m_C v_1"),
    ("weight-on-a-heavy-pulley-that-lands", "= I_pulley ω_3 ↺"),
])  # fmt: skip
def test_moments_of_momentum_in_letters(stem: str, lines: str) -> None:
    """J · AS = I_A ω, as the course writes it, and solved in these letters."""
    assert lines in page_of_file(stem)


def test_an_impulse_in_numbers_has_a_letter() -> None:
    """J, or J and the name of the blow where J is taken; one that has letters of the file keeps these."""
    text = FILES["ex-4-13"].read_text(encoding="utf-8").split("answers:")[0]
    for old, new, letters in (
        ("m: 12", "m: 12", {"blow": "J"}),
        ("S: [0, -1.5 m]}", "S: [0, -1.5 m], J: [1 m, 0]}", {"blow": "J_blow"}),
        ("magnitude: 1000 N * 0.03 s", "magnitude: P * 0.03 s", {}),
    ):
        given = "given: {P: 1000 N}\n" if not letters else ""
        problem, wrong = load_text(given + text.replace(old, new))
        assert problem is not None
        assert not wrong
        assert {name: letter for name, (letter, _) in impulse_letters(problem).items()} == letters


def test_the_authors_letter_of_a_mass_centre() -> None:
    """The point of the file at which the mass centre of several parts lies, not a name of ours."""
    printed = page_of_file("ex-4-14")
    assert "AB: J → at A = m_AB v_Gx,2 → at G, I_AB ω_2 ↺" in printed
    assert "G_AB" not in printed


@pytest.mark.parametrize(("stem", "words"), [
    ("ex-4-12", "angular impulse and momentum about C (C moves parallel to G), through which N_C, F_C and m g pass:"),
    ("puck-drawn-in-by-a-string", "conservation of angular momentum about O, through which T_string passes:"),
    ("satellite-perigee-apogee", "conservation of angular momentum about O, through which F_attraction passes:"),
])  # fmt: skip
def test_why_forces_have_no_angular_impulse(stem: str, words: str) -> None:
    assert words in page_of_file(stem)


def test_energy_about_a_fixed_point() -> None:
    """I_A ω²/2, where the lengths of a body are numbers of the file."""
    assert "T_2 = 1/2 I_A ω_2² = 1/2 · 16 · 2.8125² = 63.28 J" in page_of_file("ex-4-13")


def test_a_velocity_that_stays_zero_and_is_in_no_equation_is_not_drawn() -> None:
    """The dumbbell and the ball move along x alone; so does the ball that hits a rod, of whose v_y nothing is told."""
    told = page_of_file("ex-4-14")
    assert "m_C v_Cy" not in told
    assert "m_AB v_Gy" not in told
    # Given tells it, as the file does; no line and no diagram does.
    assert page_of_file("ball-hits-a-hanging-rod").count("v_ball,y") == 2


def test_an_impulse_that_the_file_says_is_zero_is_not_drawn() -> None:
    """The hinge of a bar that is struck where it feels nothing; with a kick it is drawn."""
    told = page_of_file("bullet-that-does-not-jerk-the-hinge")
    assert "J_Ox = 0" in told
    assert "J_Ox →" not in told
    assert "J_Oy ↑ at O" in told
    assert page_of_file("ball-hits-a-hanging-rod").count("J_Ax → at A") == 2


def test_a_number_keeps_its_formula_where_its_equation_has_only_numbers() -> None:
    told = page_of_file("weight-on-a-heavy-pulley-that-lands")
    assert "J_N = 1/5 · 12 · 8.404 = 20.17 N·s" in told
    assert "v_By = 0.2 · 8.404 = 1.681 m/s" in told


def test_a_speed_that_enters_a_blow_by_another_has_its_relation() -> None:
    page = page_of_file("load-of-a-movable-pulley-that-lands")
    assert "(1): v_B = v_A/2" in page
    assert page.index("v_B = v_A/2") < page.index("B: 1/2 m_B v_A,2 ↓")
