"""A speed at any time by a balance of momentum: likewise only below that balance, and once from one state."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

WAGON = """
title: Wagon into which sand falls
plane: vertical
given: {M: 800 kg, q: 40 kg/s, F: 500 N}
points: {P: [0, 0]}
bodies: {wagon: {particle: P, mass: M + q*t}}
joints:
  - guide: {point: P, along: 0 deg, name: rails}
loads:
  - force: {body: wagon, at: P, magnitude: F, angle: 0 deg, name: pull}
  - stream: {body: wagon, rate: q, enters: {at: P, speed: v(wagon).x, angle: 180 deg}, name: sand}
states:
  1: [t = 0, at rest]
  2: [t = 15 s]
  3: [t = 20 s]
find: {FINDS}
"""


def _page(finds: str) -> str:
    problem, wrong = load_text(WAGON.replace("FINDS", finds))
    assert problem is not None, wrong
    return " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())


def test_it_is_told_once_from_one_state() -> None:
    page = _page("v: v(wagon).x @ 2, s: x(wagon) @ 2, far: x(wagon) @ 3")
    assert "Likewise at any time, with t for t_2: v_P = F t / (M + q t)" in page
    assert page.count("v_P = F t / (M + q t)") == 1


def test_where_no_balance_stands_above_it_says_its_own() -> None:
    page = _page("s: x(wagon) @ 2, v: v(wagon).x @ 2")
    assert "Impulse and momentum from 1 to any time t: v_P = F t / (M + q t)" in page
    assert "Likewise" not in page


BOAT = """
title: Man on a boat
plane: vertical
given: {m: 70 kg, M: 180 kg, s: 4 m, T: 5 s}
points: {Q: [0, 0], P: [-2 m, 0.4 m]}
surfaces: {deck: {through: P, angle: 0 deg, body: boat}}
bodies: {boat: {points: [Q], center: Q, mass: M}, man: {particle: P, mass: m}}
joints:
  - guide: {body: boat, along: 0 deg, name: water}
  - guide: {point: P, along: deck, name: feet}
motion: [v(man/boat).x = (6*s/T)*(t/T)*(1 - t/T)]
states: {start: [t = 0, at rest], one: [t = 1 s], mid: [t = T/2], end: [t = T]}
find: {moved: x(boat) @ end - x(boat) @ start, v: v(boat).x @ mid, F: (mass(boat)*a(boat).x) @ one, K: KE(all) @ mid}
"""


def test_a_balance_to_another_state_tells_it_too() -> None:
    problem, wrong = load_text(BOAT)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "Likewise at any time, with t for t_mid: v_Q = -m v_P,boat / (M + m) = 6 m s t (t - T)" in page
    assert "∫[0 → T] (6 m s t (t - T) / ((M + m) T³)) dt" in page
    # A displacement, and a mass times an acceleration, have a direction; each stands under its state.
    assert "that is 1.12 m to the left" in page
    assert "F = 29.03 N to the left" in page
    assert page.index("At mid: ") < page.index("At one: ") < page.index("F = M a_Q,one") < page.index("At mid: K = ")


def test_what_keeps_the_motion_as_given_is_not_told_where_only_both_together_are_summed() -> None:
    """It acts between boat and man."""
    problem, wrong = load_text(BOAT)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "m g ↓ at P = M a_Q → at Q, m a_P → at P (2) → ΣF_x: 0 = M a_Q + m a_P" in page
    assert "drive_1" not in page


def test_a_given_relative_velocity_has_its_value_before_the_balance() -> None:
    problem, wrong = load_text(BOAT)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    given = "v_P,boat,mid = 6 s t_mid (T - t_mid) / T³ = 6 · 4 · 2.5 (5 - 2.5) / 5³ = 1.2 m/s"
    assert page.count(given) == 1
    assert page.index(given) < page.index("0 = M v_Q,mid + m (v_P,boat,mid + v_Q,mid)")
    assert "v_Q,mid = -m v_P,boat,mid / (M + m) = -70 · 1.2 / (180 + 70) = -0.336 m/s" in page


def test_beside_a_given_speed_it_is_a_multiple_of_that() -> None:
    problem, wrong = load_text(BOAT)
    assert problem is not None, wrong
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "; from mid to end: mean acceleration times the time, (0 + 0.2688)/2 · 2.5 = 0.336 m/s; 0 - v_Q,mid" in page
