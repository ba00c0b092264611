"""Several values of a sought constant with which a motion passes all states: the file must choose; none is left out
in silence.
"""

from __future__ import annotations

from math import acos, asin, cos, degrees, radians

import pytest
from answered import assert_close, number, solve

from planar_cli.errors import NoSolution

THROW = """
title: Throw at a target on the level
plane: vertical
given: {{v_0: 15 m/s}}
unknowns: {{beta: deg}}
{more}
points: {{P: [0, 0]}}
bodies: {{ball: {{particle: P, mass: 1 kg}}}}
states:
  1: [t = 0, r(P).x = 0, r(P).y = 0, v(P).mag = v_0, v(P).angle = beta]
  2: [r(P).y = 0, r(P).x = 20 m]
find: {{beta: beta in deg, T: t @ 2}}
"""
STEEP = 90 - degrees(asin(9.81 * 20 / 15**2)) / 2
"""Of sin 2β = g d/v_0²."""


def test_both_angles_of_a_throw_are_told() -> None:
    with pytest.raises(NoSolution, match=r"beta = 30\.35 deg; or beta = 59\.65 deg: with each of them") as refused:
        solve(THROW.format(more=""))
    assert [d.code for d in refused.value.diagnostics] == ["PL635"]


@pytest.mark.slow
def test_numbers_drawn_for_letters_are_no_values() -> None:
    text = THROW.format(more="symbols: {d: m}\nassume: [2*d*g < v_0^2]").replace("given: {v_0: 15 m/s}\n", "")
    text = text.replace("symbols: {d: m}", "symbols: {d: m, v_0: m/s}").replace("20 m", "d")
    with pytest.raises(NoSolution) as refused:
        solve(text)
    (why,) = refused.value.diagnostics
    assert why.message == "beta may have 2 values: with each of them the motion passes all states"


@pytest.mark.parametrize(
    ("assumed", "angle"), [("beta > 45 deg", STEEP), ("beta < 45 deg", 90 - STEEP), ("beta > 31 deg", STEEP)]
)
def test_an_inequality_chooses(assumed: str, angle: float) -> None:
    found = solve(THROW.format(more=f"assume: [{assumed}]"))
    assert_close(found["beta"], radians(angle), 6)
    assert_close(found["T"], 20 / (15 * cos(radians(angle))), 6)


def test_a_speed_is_not_negative_where_another_value_fits() -> None:
    """Either way round the speed at the foot of a hill is the same."""
    found = solve("""
title: Car that just comes over a hill
plane: vertical
unknowns: {v_0: m/s}
points: {A: [0, 0]}
bodies: {car: {particle: A, mass: 900 kg}}
joints: [{guide: {point: A, along: 30 deg}}]
states:
  1: [t = 0, v(A).x = v_0*cos(30 deg)]
  2: [y(A) = 5 m, v(A).x = 0]
find: {v_0: v_0}
""")
    assert_close(found["v_0"], (2 * 9.81 * 5) ** 0.5)


LET_GO = """
title: Pendulum let go at an unknown angle
plane: vertical
given: {l: 2 m}
unknowns: {phi: deg}
points: {O: [0, 0], P: {from: O, distance: l, angle: phi - 90 deg}}
bodies: {bob: {particle: P, mass: any}}
joints:
  - link: {between: [O, P]}
states:
  1: [t = 0, at rest, phi > 0]
  2: [x(bob) = 0, v(bob).mag = 3 m/s]
find: {phi: phi}
"""
CHUTE = """
title: Quickest smooth chute from a point to a slope
plane: vertical
given: {beta: 30 deg, h: 2 m}
unknowns: {phi: deg}
points: {P: [0, h], Q: [0, 0]}
surfaces: {chute: {through: P, angle: phi}}
bodies: {bead: {particle: P, mass: any}}
joints:
  - guide: {point: P, along: chute}
states:
  1: [t = 0, at rest]
  2: [y(bead) = -x(bead)*tan(beta), t is smallest, x(bead) < 0]
find: {phi: phi}
"""


@pytest.mark.slow
def test_an_angle_by_whole_turns_more_is_the_same_drawing() -> None:
    """cos φ = 1 - v²/(2 g l); -φ is excluded, and so is what is drawn as it is: 4 turns - φ."""
    angle = acos(1 - 9 / (2 * 9.81 * 2))
    assert float(number(solve(LET_GO)["phi"])) == pytest.approx(angle)


@pytest.mark.slow
def test_a_line_has_two_directions() -> None:
    """The chute halves the angle between the vertical and the normal of the slope: 75° and -105° are one line."""
    assert float(number(solve(CHUTE)["phi"])) == pytest.approx(radians(75))


def test_two_throws_with_the_same_answer_are_one() -> None:
    """v² = v_0² - 2 g h whichever of two angles it is."""
    text = """
title: Ball over a wall
plane: vertical
unknowns: {phi: deg}
bodies: {P: {particle: [0, 0], mass: any}}
states:
  1: [t = 0, v(P).mag = 20 m/s, v(P).angle = phi]
  2: [x(P) = 20 m, y(P) = 5 m]
find: {v: v(P).mag @ 2}
"""
    assert float(number(solve(text)["v"])) == pytest.approx((400 - 2 * 9.81 * 5) ** 0.5)
    with pytest.raises(NoSolution) as error:
        solve(text.replace("v: v(P).mag @ 2", "t: t @ 2"))
    assert error.value.diagnostics[0].code == "PL635"
