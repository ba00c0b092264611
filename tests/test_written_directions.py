"""Angles begin as the file writes them: a rod whose end is constructed at 210 deg begins there, and not at -150 deg."""

from __future__ import annotations

from math import degrees, sin, sqrt

import pytest
from answered import Answers, first, solve

from planar_cli.errors import NoSolution
from planar_cli.problem.implied.written_directions import ORIGIN, WrittenDirections
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

ROD = """
title: Rod that swings about its end
plane: vertical
given: {{l: 1 m, b: 210 deg}}
{more}
points: {{A: [0, 0], {points}}}
bodies: {{rod: {{{rod}, mass: 2 kg}}}}
joints:
  - pin: {{at: A, between: [ground, rod]}}
states: {{1: [{start}at rest], 2: [{end}]}}
find:
  theta_1: theta(rod) @ 1
  theta_2: theta(rod) @ 2
  phi_1: r(B).angle @ 1
  phi_2: r(B/A).angle @ 2
  omega: omega(rod) @ 2
"""
ENDS = "rod: [A, B]"


def swing(
    points: str, rod: str = ENDS, end: str = "theta(rod) = 270 deg", start: str = "", more: str = ""
) -> tuple[list[float], float]:
    """Angles of the rod and of its end at both states, in degrees, and the angular velocity at the second one."""
    found = solve(ROD.format(points=points, rod=rod, end=end, start=start, more=more))
    return in_degrees(found, "theta_1", "theta_2", "phi_1", "phi_2"), first(found["omega"])


def in_degrees(found: Answers, *names: str) -> list[float]:
    return [degrees(first(found[name])) for name in names]


@pytest.mark.parametrize(
    ("points", "rod"),
    [
        ("B: {from: A, distance: l, angle: 210 deg}", ENDS),
        ("B: {from: A, distance: l, angle: 210 deg}", "rod: [A, 210 deg], length: l, points: [B]"),
        ("B: {from: A, distance: l, angle: b}", ENDS),
        ("B: {from: A, distance: l, angle: b/2 + 105 deg}", ENDS),
        ("B: [l*cos(b), l*sin(b)]", ENDS),
        ("B: {line: [A, 210 deg], distances: {A: l}, side: below}", ENDS),
        ("C: {from: A, distance: l/2, angle: b}, B: {from: C, distance: l/2, angle: 210 deg}", ENDS),
        ("C: {from: A, distance: l/2, angle: b}, B: {from: A, towards: C, distance: l}", ENDS),
        ("D: {from: A, distance: 2*l, angle: b}, B: {midpoint: [A, D]}", ENDS),
        ("C: {from: A, distance: 2*l, angle: b}, B: {from: C, distance: l, angle: b - 180 deg}", ENDS),
    ],
)  # fmt: skip
def test_every_way_to_write_210_degrees(points: str, rod: str) -> None:
    """From 210 to 270 deg the middle sinks by l/2 (1 - sin 30°): ω² = 3 g/l (1 - sin 30°)."""
    angles, omega = swing(points, rod)
    assert angles == pytest.approx([210, 270, 210, 270])
    assert omega == pytest.approx(sqrt(3 * 9.81 * (1 - sin(0.5235987755982988))))


@pytest.mark.parametrize(
    ("drawn", "end"),
    [
        (210, "theta(rod) = 270 deg"),
        (-150, "theta(rod) = -90 deg"),
        (210, "r(B).angle = 270 deg"),
        (570, "phi = 630 deg"),
    ],
)
def test_a_coordinate_begins_where_its_state_says(drawn: float, end: str) -> None:
    points, more = "B: {from: A, distance: l, angle: phi}", "coordinates: {phi: deg}"
    angles, _ = swing(points, end=end, start=f"phi = {drawn} deg, ", more=more)
    assert angles == pytest.approx([drawn, drawn + 60, drawn, drawn + 60])


@pytest.mark.parametrize(
    "place", ["{from: A, distance: l, angle: phi - 90 deg}", "[l*cos(phi - 90 deg), l*sin(phi - 90 deg)]"]
)
def test_a_sum_with_a_coordinate(place: str) -> None:
    angles, _ = swing(f"B: {place}", end="phi = 0 deg", start="phi = -150 deg, ", more="coordinates: {phi: deg}")
    assert angles == pytest.approx([-240, -90, -240, -90])


def test_minus_150_degrees_stay() -> None:
    angles, omega = swing("B: {from: A, distance: l, angle: -150 deg}", end="theta(rod) = -90 deg")
    assert angles == pytest.approx([-150, -90, -150, -90])
    assert omega == pytest.approx(sqrt(3 * 9.81 / 2))


@pytest.mark.parametrize("more", ["", "coordinates: {phi: deg}"])
def test_a_rod_named_from_its_other_end(more: str) -> None:
    """Nothing is written of the direction from B to A: it lies in (-180, 180] deg at first."""
    angle, start = ("phi", "phi = 210 deg, ") if more else ("210 deg", "")
    points = f"B: {{from: A, distance: l, angle: {angle}}}"
    angles, _ = swing(points, "rod: [B, A]", "theta(rod) = 90 deg", start, more)
    assert angles == pytest.approx([30, 90, 210, 270])


def test_a_distance_against_the_direction() -> None:
    angles, _ = swing("B: {from: A, distance: -l, angle: 30 deg}", end="theta(rod) = -90 deg")
    assert angles == pytest.approx([-150, -90, -150, -90])


def test_one_instant() -> None:
    found = solve("""
title: Rod let go
plane: vertical
points: {A: [1 m, 2 m], B: {from: A, distance: 1 m, angle: 210 deg}}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
instant: [at rest]
find: {theta: theta(rod), there: r(B/A).angle, back: r(A/B).angle, turned: theta(rod) - 30 deg}
""")
    assert in_degrees(found, "theta", "there", "back", "turned") == pytest.approx([210, 210, 30, 180])


def test_letters() -> None:
    """An angle of b + 180 deg is one; a formula tells it."""
    found = solve("""
title: Rod in letters
plane: vertical
symbols: {l: m, m: kg, b: deg}
points: {A: [0, 0], B: {from: A, distance: l, angle: b + 180 deg}}
bodies: {rod: {rod: [A, B], mass: m}}
joints:
  - pin: {at: A, between: [ground, rod]}
states: {1: [at rest], 2: [theta(rod) = 270 deg]}
find: {theta: theta(rod) @ 1, phi: r(B).angle @ 1}
""")
    for name in ("theta", "phi"):
        assert [str(e) for e in found[name].expressions] == ["b + pi"]


def test_a_body_of_several_rods() -> None:
    """Its angle is that of its first rod; the mass centre, at 255 deg, swings as far to the other side as it began."""
    found = solve("""
title: Angle iron
plane: vertical
points:
  A: [0, 0]
  B: {from: A, distance: 1 m, angle: 210 deg}
  C: {from: A, distance: 1 m, angle: 300 deg}
bodies: {iron: {parts: [{rod: [A, B], mass: 1 kg}, {rod: [A, C], mass: 1 kg}]}}
joints:
  - pin: {at: A, between: [ground, iron]}
states: {1: [at rest], 2: [omega(iron) = 0, t > 0]}
find: {theta_1: theta(iron) @ 1, theta_2: theta(iron) @ 2}
""")
    assert in_degrees(found, "theta_1", "theta_2") == pytest.approx([210, 240])


def test_a_motion_that_is_given() -> None:
    """Two cranks, one on the other: 310 deg + 3 rad/s t = 400 deg."""
    found = solve("""
title: Two driven cranks
plane: horizontal
given: {l: 1 m}
coordinates: {phi: deg, psi: deg}
points: {A: [0, 0], B: {from: A, distance: l, angle: phi}, C: {from: B, distance: l, angle: phi + psi}}
bodies: {one: {rod: [A, B], mass: 1 kg}, two: {rod: [B, C], mass: 1 kg}}
joints:
  - pin: {at: A, between: [ground, one]}
  - pin: {at: B, between: [one, two]}
motion: ['phi = 210 deg + 1 rad/s * t', 'psi = 100 deg + 2 rad/s * t']
states: {1: [t = 0], 2: [theta(two) = 400 deg]}
find: {one: theta(one) @ 1, two: theta(two) @ 1, relative: theta(two/one) @ 1, end: r(C/B).angle @ 2, t: t @ 2}
""")
    assert in_degrees(found, "one", "two", "relative", "end") == pytest.approx([210, 310, 100, 400])
    assert first(found["t"]) == pytest.approx(0.5235987755982988)


@pytest.mark.parametrize("begun", [0, 2])
def test_a_tie_that_goes_with_the_time_is_met_as_drawn(begun: float) -> None:
    """The drawing tells both angles where what `motion` says of them together holds there."""
    found = solve(f"""
title: Crank on a crank
points: {{A: [0, 0], B: {{from: A, distance: 1 m, angle: 210 deg}}, C: {{from: B, distance: 1 m, angle: 300 deg}}}}
bodies: {{one: {{rod: [A, B]}}, two: {{rod: [B, C]}}}}
joints:
  - pin: {{at: A, between: [ground, one]}}
  - pin: {{at: B, between: [one, two]}}
motion: [omega(one) = 1 rad/s, 'theta(two/one) = 90 deg + 1 rad/s * (t - {begun} s)']
states: {{1: [t = {begun} s], 2: [t = {begun + 1} s]}}
find: {{two: theta(two) @ 1, later: theta(two) @ 2}}
""")
    assert in_degrees(found, "two", "later") == pytest.approx([300, 300 + degrees(2)])


def test_a_particle_in_x_and_y() -> None:
    """On a circle with 2 rad/s, from 210 deg on: at 270 deg after π/6 s."""
    found = solve("""
title: Particle drawn to a point by a spring
plane: horizontal
points: {O: [0, 0], B: {from: O, distance: 1 m, angle: 210 deg}}
bodies: {p: {particle: B, mass: 1 kg}}
loads:
  - spring: {between: [O, p], stiffness: 4 N/m, natural_length: 0 m}
states: {1: [t = 0, v(p).along(300 deg) = 2 m/s, v(p).along(210 deg) = 0], 2: [r(p).angle = 270 deg]}
find: {phi_1: r(p).angle @ 1, phi_2: r(B).angle @ 2, t: t @ 2}
""")
    assert in_degrees(found, "phi_1", "phi_2") == pytest.approx([210, 270])
    assert first(found["t"]) == pytest.approx(0.5235987755982988)


def test_a_simulated_motion() -> None:
    points = "B: {from: A, distance: l, angle: b}"
    text = ROD.format(points=points, rod=ENDS, end="theta(rod) = 270 deg", start="", more="")
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    found = {a.name: a.values for a in simulate(problem, Settings()).answers}
    angles = [degrees(found[name][0]) for name in ("theta_1", "theta_2", "phi_1", "phi_2")]
    assert angles == pytest.approx([210, 270, 210, 270], abs=1e-6)


def test_directions_that_are_not_written() -> None:
    """Two places by coordinates, and a way round a corner."""
    problem, wrong = load_text("""
title: Places
given: {b: 20 deg}
points:
  A: [1 m, 0]
  B: [2 m, 3 m]
  C: {from: A, distance: 1 m, angle: b}
  D: {from: C, distance: 1 m, angle: 2*b}
  E: {from: C, distance: 1 m, angle: 200 deg - 9*b}
  F: {from: A, towards: C, distance: 1 m, offset: 1 m}
find: {x: r(D/A).angle}
""")
    assert problem is not None, wrong
    written = WrittenDirections(problem)
    assert not any(written.between(*pair) for pair in [("A", "B"), ("A", "D"), (ORIGIN, "C"), ("A", "F"), ("C", "A")])
    assert [w.sense for w in written.between("A", "E")] == [1]


LED = """
title: Rod written with a coordinate
plane: vertical
coordinates: {{phi: deg}}
points: {{A: [0, 0], B: {{from: A, distance: 1 m, angle: phi}}}}
bodies: {{rod: {{rod: [A, B], mass: 2 kg}}}}
joints:
  - pin: {{at: A, between: [ground, rod]}}
{rest}
"""


@pytest.mark.parametrize("said", ["theta(rod) = 210 deg", "r(B).angle = 210 deg", "phi = 210 deg"])
def test_what_tells_a_coordinate_at_one_instant(said: str) -> None:
    rest = f"instant: [{said}, at rest]\nfind: {{phi_1: phi, theta: theta(rod), there: r(B).angle}}"
    assert in_degrees(solve(LED.format(rest=rest)), "phi_1", "theta", "there") == pytest.approx([210, 210, 210])


def test_a_direction_tells_where_a_coordinate_begins() -> None:
    rest = """states: {1: [r(B).angle = 210 deg, at rest], 2: [phi = 270 deg]}
find: {phi_1: phi @ 1, there: r(B).angle @ 2, omega: omega(rod) @ 2}"""
    found = solve(LED.format(rest=rest))
    assert in_degrees(found, "phi_1", "there") == pytest.approx([210, 270])
    assert first(found["omega"]) == pytest.approx(sqrt(3 * 9.81 / 2))


@pytest.mark.parametrize("said", ["theta(rod) = -150 deg", "r(B).angle = -150 deg"])
def test_a_whole_turn_off_is_said(said: str) -> None:
    place = "B: {from: A, distance: l, angle: 210 deg}"
    with pytest.raises(NoSolution) as raised:
        solve(ROD.format(points=place, rod=ENDS, end="theta(rod) = 270 deg", start=f"{said}, ", more=""))
    (told,) = raised.value.diagnostics
    assert told.message == f"state 1: `{said}` does not hold in the drawn position"
    assert told.hint == "it is 1 whole turn off: an angle begins as the points are written"
