"""Nothing stands twice on a page: no closed form beside the formula that is it already, no vector by a detour."""

from __future__ import annotations

from conftest import ROOT
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


def test_no_closed_form_beside_the_same_formula() -> None:
    """I_G = m k_G² names what the closed form writes out; the letters of the data come before the numbers."""
    page = page_of_file("ex-4-05")
    assert "α = P (R + r) / (m R² + I_G) = 100 (0.45 + 0.3)" in page
    told = page_of_file("bob-whose-cord-catches-on-a-nail")
    assert "T_before = m (g + v_P,2²/l) = 3 m g = 3 · 1.5 · 9.81 = 44.145 N" in told


def test_a_velocity_that_is_given_is_not_found_from_what_follows() -> None:
    page = page_of_file("ex-4-07")
    assert "v⃗_O = [1, 0]" not in page  # it stands under Given
    assert page.count("ω_disk = v_O/r") == 1


def test_a_vector_that_says_the_answer_stands_once_before_it() -> None:
    page = page_of_file("ex-1-13")
    assert "a_P = v_P²/ρ e_n = [-(0.08/m) v², (0.04/m) v²]" in page
    assert "a, x" not in page


def test_a_diagram_from_which_forces_are_gone_is_drawn_again() -> None:
    case = page_of_file("car-with-locked-wheels").partition("CASE")[2]
    assert "car: m g ↓ at G, N_B ↑ at B, μ N_B ← at B = m a_A → at G At the limit: N_A vanishes" in case


def test_a_diagram_about_another_point_is_drawn_again() -> None:
    """After the cut moments are taken about another C."""
    case = page_of_file("bar-when-one-of-its-cords-is-cut").split("CASE after")[1]
    assert "bar: m g ↓ at G, T_left ↖ at A = " in case


def test_before_is_the_last_diagram() -> None:
    """The case before has another mass, and nothing that enters: its diagram is not the one without F."""
    text = (ROOT / "problems" / "momentum" / "sand-wagon.yaml").read_text(encoding="utf-8")
    problem, wrong = load_text(f"method: newton\n{text}")
    assert problem is not None, wrong
    page = " ".join(Terminal(400).render(narrate(solve_problem(problem))).split())
    case = page.partition("CASE coasting")[2]
    assert "wagon: g (M + q t) ↓, v q ←, N_rails ↑ = (M + q t) a →" in case


def test_what_is_as_before_has_a_name() -> None:
    case = page_of_file("wheel-over-a-kerb").partition("CASE")[2]
    assert "As before: I_G = 0.45 kg·m², I_K = 1.35 kg·m². At 3, x_G = 0." in case
    assert "As before." not in case


def test_a_kinetic_energy_is_worked_out_once() -> None:
    page = page_of_file("ball-on-a-cord-that-goes-slack")
    assert page.count("T_1 = 1/2 m ") == 1
    assert page.count("T_1 = 6.4 J as above") == 2


def test_a_height_that_was_found_is_not_found_again() -> None:
    assert page_of_file("bob-whose-cord-catches-on-a-nail").count("y_P,2 = -l = -2 m") == 1


def test_what_turns_about_a_fixed_point_needs_no_place_of_its_mass_centre() -> None:
    page = page_of_file("plate-let-go-at-a-corner")
    assert "T_lowest = 1/2 I_A ω_lowest² = 0.4533 ω_lowest² in J" in page
    assert page.count("y_G,lowest = ") == 1


def test_a_line_that_is_short_by_letters_above_has_no_other_formula() -> None:
    """ω_n and φ_eq are told by then; a longer side in letters gives way to the formula in the data."""
    assert "ω_n φ_eq sin(π/2) = ω_n φ_eq = 1.2247 · 4 = 4.899 rad/s" in page_of_file("body-arm-driven-by-its-angle")
    assert "dt = M_0² t_2²/(4 m R²) = 15² · 4² / (4 · 20 · 0.3²) = 500 J" in page_of_file(
        "body-rotor-with-varying-torque"
    )
