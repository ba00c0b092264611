"""A force that stays what it is: its impulse is itself times the time, and its mean itself; what nothing asks of a
later part of a motion is not told.
"""

from __future__ import annotations

import pytest
from conftest import PROBLEMS
from worked import page_of_file, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import Voice, narrate


@pytest.mark.parametrize("told", [
    "rear_driven = F_C t_2 = 27.83 · 10 = 278.3 N·s",
    "front_braked = F_D (t_3 - t_2) = -112.5 (12.5 - 10) = -281.2 N·s",
    "N_rear,driven = N_C = 451.5 N",
    "N_rear,braked = N_C = 310.0 N",
])  # fmt: skip
def test_by_its_letter(told: str) -> None:
    assert told in page_of_file("bicycle-driven-and-braked")


def test_a_force_that_grows_has_its_integral() -> None:
    assert "T_A = ∫[t_1 → t_2] (599.3 + 39.09 t) dt/(t_2 - t_1)" in page_of_file("winch-with-counterweight")


@pytest.mark.parametrize("told", [
    "J_axle,y = A_y t_2 = 12.5 · 1.309 = 16.36 N·s",
    "(14) ↺ ΣM_A: F_C R = I_large α_large",
    "From 2 to 3, no angular acceleration of the large: (16) ω_large,3 = ω_large,2 = 43.64 rad/s",
])  # fmt: skip
def test_wheels_that_turn_on(told: str) -> None:
    assert told in page_of_file("two-wheels-pressed-together")


def test_no_reaction_of_a_span_that_is_not_asked() -> None:
    """The impulse of the axle is asked up to 2."""
    page = page_of_file("two-wheels-pressed-together")
    assert page.count("A_x - N_C = 0") == page.count("A_y - μ N_C = 0") == 1
    assert "F_C + A_y" not in page


@pytest.mark.parametrize(("stem", "told"), [
    ("bicycle-driven-and-braked", "(2), (5), (6) in (7): α_front = M_c/("),
    ("bicycle-driven-and-braked", "(11), (14), (15) in (16): α_front = -M_b/("),
    ("heavy-disk-in-the-bight-of-a-rope", "(3) to (5) in (6): α = (2 m - M) g R / ("),
    ("two-blocks-on-a-free-double-wedge", "(1) to (4) together, in terms of a_A,wedge:"),
])  # fmt: skip
def test_equations_put_in_at_once(stem: str, told: str) -> None:
    assert told in page_of_file(stem)


def test_a_key_has_its_equations() -> None:
    """It has no sentence that says of which earlier ones they are."""
    (path,) = (p for p in PROBLEMS if p.stem == "bicycle-driven-and-braked")
    key = Terminal().render(narrate(worked(path)[0], Voice(audience="exam")))
    assert [n for n in range(10, 19) if f"({n})  " not in key] == []


def test_an_equation_in_numbers_stands_once() -> None:
    page = page_of_file("rear-wheel-drive")
    assert "(4) in numbers: F_C = -416 α_rear" not in page
    assert "(2) in (4): F_C = -416 α_rear in N" in page
