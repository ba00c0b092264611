"""A round body that slides along a rod strikes its end with its rim, along the rod."""

from __future__ import annotations

import pytest

from planar_cli.errors import FileProblem, Unplanned
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

ON_A_TURNING_ROD = """
title: Sphere flung outward on a turning rod
plane: horizontal
given: {m: 1.5 kg, R: 50 mm, I_O: 0.45 kg*m^2, r_1: 0.2 m, r_2: 0.5 m, omega_1: 12 rad/s}
points: {O: [0, 0], A: [0.55 m, 0], S: [r_1, 0]}
bodies:
  rod: {rod: [O, A], mass: 3 kg, inertia: I_O, about: O}
  sphere: {sphere: S, radius: R, mass: m}
joints:
  - pin: {at: O, between: [ground, rod]}
  - guide: {body: sphere, along: rod, name: slide}
  - impact: {between: BETWEEN, at: A, restitution: 0, during: 2->3}
states:
  1: [omega(rod) = omega_1, v(S/rod).mag = 0]
  2: [r(S/O).mag = r_2]
  3: [just after 2]
find:
  omega_2: omega(rod) @ 2
  v_rel: v(S/rod).mag @ 2
  omega_3: omega(rod) @ 3
  v_3: v(S/rod).mag @ 3
  lost: KE(all) @ 2 - KE(all) @ 3
"""


@pytest.mark.parametrize("between", ["[sphere, rod]", "[rod, sphere]"])
def test_a_sphere_on_a_rod_stops_at_its_end(between: str) -> None:
    problem, wrong = load_text(ON_A_TURNING_ROD.replace("BETWEEN", between))
    assert problem is not None, wrong
    found = {f.name: float(f.values[0]) for f in solve_problem(problem).parts[0].found if f.values}
    # I ω is kept, I = 0.45 + 2/5 m R² + m r²; what is lost is m v²/2 along the rod.
    before, after = (0.45 + 1.5 * (0.4 * 0.05**2 + r**2) for r in (0.2, 0.5))
    omega = before * 12 / after
    speed = ((before * 144 - after * omega**2) / 1.5) ** 0.5
    assert found == pytest.approx(
        {"omega_2": omega, "v_rel": speed, "omega_3": omega, "v_3": 0, "lost": 0.75 * speed**2}, rel=1e-9, abs=1e-12
    )


def test_a_blow_that_no_equations_tell_is_told_in_words() -> None:
    across = ON_A_TURNING_ROD.replace("BETWEEN", "[sphere, rod]").replace(
        "at: A,", "at: A, normal: theta(rod) + 90 deg,"
    )
    problem, wrong = load_text(across)
    assert problem is not None, wrong
    with pytest.raises(Unplanned) as caught:
        solve_problem(problem)
    (told,) = caught.value.diagnostics
    assert (told.code, told.mark.line) == ("PL627", 12)
    assert "the angular velocity of rod just after the blow" in told.message
    assert "__" not in told.message + told.hint


def test_which_end_it_strikes_is_not_guessed() -> None:
    problem, wrong = load_text(ON_A_TURNING_ROD.replace("BETWEEN", "[sphere, rod]").replace("at: A, ", ""))
    assert problem is not None, wrong
    with pytest.raises(FileProblem) as caught:
        solve_problem(problem)
    (told,) = caught.value.diagnostics
    assert (told.code, told.mark.line) == ("PL528", 12)
    assert "named by `at`" in told.hint
