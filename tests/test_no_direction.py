"""What has no direction, or sizes that none can have, is refused where it is written."""

from __future__ import annotations

import math
import re

import pytest
from answered import assert_close, solve

from planar_cli.errors import FileProblem, NoSolution, PlanarError
from planar_cli.integrators.base import Setting, StepTooSmall
from planar_cli.motion.terms.crossings import Watch
from planar_cli.motion.trajectory.drive import drive
from planar_cli.problem.structure import load_text
from planar_cli.registry import members
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.simulate.run import Settings, simulate
from planar_cli.solve.run import solve_problem

BELT = """
title: Belt drive
points: {A: [0, 0], B: [0.5 m, 0]}
bodies: {small: {disk: A, radius: 0.1 m}, large: {disk: CENTRE, radius: 0.3 m}}
joints:
  - pin: {at: A, between: [ground, small]}
  - pin: {at: CENTRE, between: [ground, large]}
  - belt: {between: [small, large]}
motion: [omega(small) = 60 rpm]
find: {omega: omega(large) in rpm}
"""


def test_a_belt_runs_from_one_centre_to_another() -> None:
    assert solve(BELT.replace("CENTRE", "B"))["omega"].values is not None
    with pytest.raises(FileProblem, match="small and large have one centre") as refused:
        solve(BELT.replace("CENTRE", "A"))
    assert refused.value.diagnostics[0].mark.line == 8


BALLS = """
title: Two balls
plane: horizontal
points: {A: [0, 0], B: [0, 0]}
bodies: {one: {disk: A, radius: 10 mm, mass: 0.1 kg}, two: {disk: B, radius: 10 mm, mass: 0.1 kg}}
joints:
  - impact: {between: [one, two], restitution: 1}
states:
  1: [t = 0, v(A).x = 1 m/s, v(A).y = 0, omega(one) = 0, two at rest]
  2: [t = 0.01 s]
find: {v: v(A).x @ 2}
"""


def test_balls_in_one_place_strike_in_no_direction() -> None:
    with pytest.raises(PlanarError, match="both partners have one centre") as refused:
        solve(BALLS)
    assert isinstance(refused.value, NoSolution)
    assert refused.value.diagnostics[0].mark.line == 7


SPRING = """
title: Block on a spring
plane: vertical
given: {g: GRAVITY, l_0: LENGTH, k: 200 N/m}
coordinates: {y: m}
points: {P: [0, 0], Q: [0, y]}
bodies: {block: {particle: Q, mass: 2 kg}}
joints:
  - guide: {point: Q, along: 90 deg}
loads:
  - spring: {between: [P, Q], stiffness: k, natural_length: l_0}
states: {rest: [equilibrium, y < 0]}
find: {y: y @ rest}
"""


@pytest.mark.parametrize("length", ["0.1 m", "0 m"])
def test_a_natural_length_may_be_zero(length: str) -> None:
    assert solve(SPRING.replace("GRAVITY", "9.81 m/s^2").replace("LENGTH", length))["y"].values is not None


@pytest.mark.parametrize(
    ("gravity", "length", "words"),
    [
        ("9.81 m/s^2", "-0.1 m", "length of the spring from P to Q is negative"),
        ("-9.81 m/s^2", "0.1 m", "g is negative"),
    ],
)
def test_sizes_are_not_negative(gravity: str, length: str, words: str) -> None:
    with pytest.raises(FileProblem, match=words):
        solve(SPRING.replace("GRAVITY", gravity).replace("LENGTH", length))


def test_a_spring_may_pass_through_its_own_end() -> None:
    """Where its ends meet it pulls in no direction, and nothing breaks there."""
    states = "states: {1: [t = 0, y = -0.5 m, at rest], 2: [y is largest]}\nfind: {y: y @ 2}\n"
    text = SPRING.replace("GRAVITY", "9.81 m/s^2").replace("LENGTH", "0 m").replace("k: 200", "k: 981")
    found = solve(text.split("states:")[0] + states)
    assert found["y"].values is not None
    assert float(found["y"].values[0]) == pytest.approx(0.46)


ARM = """
title: Arm that turns about a pin
symbols: {l: m, w: rad/s}
coordinates: {theta: deg}
points: {O: [0, 0], C: [l, 0]}
bodies: {arm: {rod: [O, theta], length: 2*l}}
joints:
  - pin: {at: O, between: [ground, arm]}
MORE
motion: [dot(theta) = w]
find: {turns: omega(arm)}
"""


def test_a_body_turns_as_its_written_direction_does() -> None:
    """And neither a relation nor a joint may say otherwise."""
    text = ARM.replace("MORE\n", "")
    found = solve(text)["turns"].expressions
    assert found is not None
    assert str(found[0]) == "w"
    with pytest.raises(NoSolution, match="omega\\(arm\\) = 2"):
        solve(text.replace("= w]", "= w, omega(arm) = 2*w]"))
    with pytest.raises(NoSolution, match="contradicts what the joints make of"):
        solve(ARM.replace("MORE", "  - guide: {point: C, along: arm}"))


BLOCKS = """
title: Two blocks
plane: horizontal
points: {A: [0, 0.2 m], B: [0, 0]}
bodies: {upper: {particle: A, mass: 5 kg}, lower: {particle: B, mass: 8 kg}}
joints:
  - guide: {body: upper, along: 0 deg}
  - guide: {body: lower, along: 0 deg}
loads:
  - force: {body: lower, at: POINT, magnitude: 90 N, angle: 0 deg}
instant: [at rest]
find: {a: a(B).x}
"""


def test_a_force_on_a_particle_acts_where_it_is() -> None:
    assert_close(solve(BLOCKS.replace("POINT", "B"))["a"], "11.25")
    with pytest.raises(FileProblem, match="A is a point of upper") as refused:
        solve(BLOCKS.replace("POINT", "A"))
    assert refused.value.diagnostics[0].code == "PL465"


CRATE = """
title: Crate that stops
plane: vertical
points: {C: [0, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {crate: {particle: C, mass: 3 kg}}
joints: [contact: {between: [crate, floor], at: C, mu: 0.2}]
states: {1: [t = 0, v(crate).x = 4 m/s], 2: [t = 5 s]}
find: {x: x(crate) @ 2}
"""


def test_a_date_after_all_has_come_to_rest_is_told() -> None:
    problem, wrong = load_text(CRATE)
    assert problem is not None
    assert not wrong
    page = members("formats")["markdown"]().render(narrate(solve_problem(problem), Voice()))
    assert re.search(r"It stops sliding at .*, before t = 5 s:", page.replace("$", ""))


def test_what_is_watched_may_have_no_value() -> None:
    """A root that has left its domain ends the motion there."""
    watch = Watch(lambda t, y: [math.sqrt(1.0 - t) + 1.0], [1.0])
    with pytest.raises(StepTooSmall, match="what tells the next state has no value beyond t = 0"):
        drive(lambda t, y: [1.0], 0.0, [0.0], 5.0, Setting([1.0]), watch=watch)


BEAM = """
title: Beam on two pins, struck along it
plane: horizontal
points: {A: [0, 0], B: [2 m, 0], S: [0.5 m, 0]}
bodies: {beam: {rod: [A, B], mass: 4 kg}}
joints:
  - pin: {at: A, between: [ground, beam]}
  - pin: {at: B, between: [ground, beam]}
loads:
  - impulse: {body: beam, at: S, magnitude: 3 N*s, angle: 0 deg, during: 1->2}
states: {1: [at rest], 2: [just after 1]}
find: {J: impulse(A).mag @ 1->2}
"""


def test_impulses_that_are_not_unique_are_told_as_the_file_asks_for_them() -> None:
    with pytest.raises(NoSolution, match=r"not unique: impulse\(A\)\.x @ 1->2;"):
        solve(BEAM)


HUNG = """
title: Block hung on springs
plane: vertical
given: {m: 2 kg, k_1: 200 N/m, k_2: 300 N/m, l: 0.2 m}
coordinates: {u: m, y: m}
points: {O: [0, 0], K: [0, u], Q: [0, y]}
bodies: {knot: {particle: K}, block: {particle: Q, mass: m}}
joints:
  - guide: {point: K, along: 90 deg, name: a}
  - guide: {point: Q, along: 90 deg, name: b}
loads:
  - spring: {between: [O, K], stiffness: k_1, natural_length: l, name: upper}
  - spring: {between: [K, Q], stiffness: k_2, natural_length: l, name: lower}
instant: [equilibrium, WHERE]
find: {u_0: u, y_0: y}
"""


@pytest.mark.parametrize(
    ("where", "upper", "lower"),
    [
        ("u < 0, y < u", -1, -1),
        ("u < -0.1 m, y < -0.4 m, y > -2 m", -1, -1),
        ("u > 0, y > u", 1, 1),
        ("u > 0, u < l, y < u", 1, -1),
    ],
)
def test_inequalities_tell_on_which_side_a_spring_holds(where: str, upper: int, lower: int) -> None:
    """A knot without mass, held by two springs; each of them may hold what hangs on it or stands on it."""
    found = solve(HUNG.replace("WHERE", where))
    weight = 2 * 9.81
    u = upper * 0.2 - weight / 200
    assert_close(found["u_0"], u, 10)
    assert_close(found["y_0"], u + lower * 0.2 - weight / 300, 10)


@pytest.mark.parametrize("statement", ["v(one).mag = -2 m/s", "v(one).mag < -2 m/s", "-2 m/s = v(one).mag"])
def test_a_magnitude_is_not_negative(statement: str) -> None:
    text = BALLS.replace("B: [0, 0]", "B: [1 m, 0]").replace("v(A).x = 1 m/s", statement)
    with pytest.raises(FileProblem, match="a magnitude is zero or more"):
        solve(text)


DAMPED = """
title: Beam with a spring and a damper
plane: vertical
symbols: {m: kg, L: m, k: N/m, h: m}
unknowns: {c: N*s/m}
coordinates: {theta: deg}
points:
  A: [0, 0]
  B: {from: A, distance: L, angle: theta}
  D: {from: A, distance: L/2, angle: theta}
  E: [L, -h]
  F: [L/2, -h]
bodies: {AB: {rod: [A, B], mass: m, points: [D]}}
joints:
  - pin: {at: A, between: [ground, AB]}
loads:
  - spring: {between: [E, B], stiffness: k, natural_length: h + m*g/(2*k)}
  - damper: {between: [F, D], coefficient: c}
states: {rest: [equilibrium, theta = 0, frequency(rest) = 0]}
find: {c_cr: c}
"""


def test_forces_that_rest_on_speeds_pass_where_they_may() -> None:
    found = solve(DAMPED)["c_cr"].expressions
    assert found is not None


def test_a_coordinate_that_nothing_tells_is_not_guessed_where_ends_meet() -> None:
    """A cord over a point 1 m from the origin: where the block begins is open, and no fault."""
    text = """
title: Block and weight on a cord
plane: vertical
coordinates: {x: m}
points: {P: [x, 0], D: [1 m, 0], Q: [1 m, -x - 0.5 m]}
bodies: {block: {particle: P, mass: 3 kg}, load: {particle: Q, mass: 2 kg}}
joints:
  - guide: {body: block, along: 0 deg, name: table}
  - guide: {body: load, along: 90 deg, name: shaft}
  - rope: {path: [P, over D, Q], name: cord}
states: {1: [t = 0, at rest], 2: [t = 0.1 s]}
find: {v: v(block).x @ 2}
"""
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    with pytest.raises(FileProblem, match="x at the start is not told"):
        simulate(problem, Settings(estimate=False))


PLATE = """
title: Plate with a hole
plane: vertical
given: {rho: DENSITY, b: WIDTH, d: 150 mm}
points: {O: [0, 0]}
bodies:
  plate:
    parts:
      - {plate: O, width: b, height: 300 mm, mass: rho*b*300 mm}
      - {disk: O, radius: d/2, mass: -rho*pi*d^2/4}
find: {I: I(plate/O)}
"""


@pytest.mark.parametrize(
    ("density", "width", "words"),
    [
        ("-10 kg/m^2", "400 mm", "the mass of plate is not more than zero"),
        ("10 kg/m^2", "-400 mm", "the width"),
        ("10 kg/m^2", "40 mm", "the mass of plate is not more than zero"),
    ],
)
def test_a_body_weighs_more_than_its_holes(density: str, width: str, words: str) -> None:
    text = PLATE.replace("mass: rho*b*300 mm", "mass: rho*b*(300 mm)")
    assert solve(text.replace("DENSITY", "10 kg/m^2").replace("WIDTH", "400 mm"))["I"].values is not None
    with pytest.raises(FileProblem, match=words):
        solve(text.replace("DENSITY", density).replace("WIDTH", width))


TWICE = """
title: Rod that turns
plane: vertical
points: {A: [0, 0], B: [1 m, 0]}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
instant: [omega(rod) = 2 rad/s, v(B).mag = SPEED]
find: {a: alpha(rod)}
"""


def test_a_second_velocity_that_does_not_fit_is_refused() -> None:
    assert_close(solve(TWICE.replace("SPEED", "2 m/s"))["a"], "-14.715")
    with pytest.raises(NoSolution, match="contradicts what the rest says of the velocities"):
        solve(TWICE.replace("SPEED", "3 m/s"))
