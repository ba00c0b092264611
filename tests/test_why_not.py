"""Files that contradict themselves or say too little: the message tells what is so, at its line."""

from __future__ import annotations

from decimal import Decimal

import pytest
from answered import assert_close, solve

from planar_cli.errors import Diagnostic, FileProblem, NoSolution
from planar_cli.problem.structure import load_text

UNUSED = """
title: Crank whose torque stands nowhere
plane: vertical
unknowns: {M: N*m}
points: {O: [0, 0], A: [0.1 m, 0]}
bodies: {crank: {rod: [O, A], mass: 0.8 kg}}
joints:
  - pin: {at: O, between: [ground, crank]}
motion: [omega(crank) = 100 rad/s]
instant: [theta(crank) = 0]
find: {moment: M}
"""
IDLE = """
title: Motor that does not drive the hoist
plane: vertical
given: {r: 0.2 m}
unknowns: {M: N*m}
points: {A: [-2 m, 0], O: [0, 0], T: [r, 0], L: [r, -6 m]}
bodies:
  motor: {disk: A, radius: r, inertia: 0.1 kg*m^2}
  drum: {disk: O, radius: r, inertia: 3 kg*m^2}
  cage: {particle: L, mass: 150 kg}
joints:
  - pin: {at: A, between: [ground, motor]}
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [L, T on drum]}
loads:
  - torque: {body: motor, moment: M}
states:
  1: [t = 0, at rest]
  2: [y(L) = y(L) @ 1 + 4 m, v(L).y = 2 m/s]
find: {moment: M}
"""
COMES_TO_REST = """
title: Pendulum with a rubbing pivot that never gets so high
plane: vertical
points: {O: [0, 0], E: [0.9 m, 0]}
bodies: {rod: {rod: [O, E], mass: 6 kg}}
joints:
  - pin: {at: O, between: [ground, rod], friction_torque: 8 N*m}
states:
  1: [at rest]
  2: [theta(rod) = 60 deg]
  3: [omega(rod) = 0]
find: {turned: theta(rod) @ 3}
"""


def refused(text: str) -> Diagnostic:
    """Why a file has no solution."""
    with pytest.raises(NoSolution) as error:
        solve(text)
    return error.value.diagnostics[0]


def test_an_unknown_that_stands_in_no_equation() -> None:
    why = refused(UNUSED)
    assert (why.code, why.mark.line) == ("PL606", 4)
    assert why.message == "nothing tells M: it stands in no equation"


def test_an_unknown_that_changes_nothing_of_what_is_said() -> None:
    why = refused(IDLE)
    assert (why.code, why.mark.line) == ("PL623", 5)
    assert why.message == "M is open: what the states say is the same whatever it is"


def test_a_motion_that_comes_to_rest_before_a_state() -> None:
    why = refused(COMES_TO_REST)
    assert (why.code, why.mark.line) == ("PL621", 10)
    assert why.message == "state 2 is never reached: theta(rod) = 60 deg"
    assert why.hint is not None
    assert why.hint.startswith("nothing moves any more from t = ")


TURNTABLE = """
title: Block on a turntable, whose friction turns as it begins to slip
plane: horizontal
points: {O: [0, 0], B: [0.4 m, 0]}
bodies: {table: {disk: O, radius: 0.6 m}, block: {particle: B, mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, table]}
  - flat: {between: [block, table], mu: 0.45, name: F}
motion: [alpha(table) = 0.8 rad/s^2]
states:
  1: [t = 0, at rest]
  2: [mode(F) = slip]
find: {t: t @ 2}
"""


def test_a_block_on_a_turntable_slips_when_friction_is_used_up() -> None:
    """m r √(α² + ω⁴) = μ m g."""
    omega = ((0.45 * 9.81 / 0.4) ** 2 - 0.8**2) ** 0.25
    assert_close(solve(TURNTABLE.replace("find: {t:", "find: {time:"))["time"], omega / 0.8, digits=8)


def test_the_friction_as_it_begins_to_slip() -> None:
    """Along the motion it is m r α still; no formula leads there, the motion that is followed does."""
    asked = TURNTABLE.replace("{t: t @ 2}", "{f: friction(F/block).across(table) @ 2}")
    assert_close(solve(asked)["f"], 2 * 0.4 * 0.8, digits=6)


ON_TRACK = """
title: Bead on a parabola, its place told by a relation
plane: vertical
surfaces: {track: {y: x^2/(2 m)}}
bodies: {P: {particle: free, mass: 1 kg}}
joints:
  - guide: {point: P, along: track}
states:
  1: [t = 0, x(P) = 1 m, at rest]
  2: [x(P) = 0]
find: {v: v(P).mag @ 2}
"""


@pytest.mark.parametrize(
    ("surface", "start", "height"),
    [
        ("y: x^2/(2 m)", "x(P) = 1 m", "0.5"),
        ("y: x^2/(2 m)", "1 m = r(P).x", "0.5"),
        ("through: [0, 0], angle: 45 deg", "y(P) = 3 m", "3"),
        ("center: [0, 2 m], radius: 2 m", "x(P) = 2 m, y(P) = 2 m", "2"),
    ],
)
def test_the_start_puts_a_free_particle_on_its_surface(surface: str, start: str, height: str) -> None:
    """It slides down to x = 0: v = √(2 g h)."""
    found = solve(ON_TRACK.replace("y: x^2/(2 m)", surface).replace("x(P) = 1 m", start))
    assert_close(found["v"], (2 * Decimal("9.81") * Decimal(height)).sqrt())


def test_a_free_particle_whose_place_is_open() -> None:
    """Of a circle two places have the same x."""
    circle = "center: [0, 2 m], radius: 2 m"
    _, wrong = load_text(ON_TRACK.replace("y: x^2/(2 m)", circle))
    (why,) = wrong
    assert (why.code, why.mark.line) == ("PL521", 7)
    assert why.message == "P is free, and lies on track: where it lies at first is open"


WALL = """
title: Ball thrown against a wall
plane: vertical
unknowns: {e: 1}
points: {W: [5 m, 0]}
surfaces: {wall: {through: W, angle: 90 deg}}
bodies: {ball: {particle: [0, 2 m], mass: 0.3 kg}}
joints:
  - impact: {between: [ball, wall], restitution: e}
states:
  1: [v(ball).x = 10 m/s, v(ball).y = 4 m/s]
  2: [x(ball) = 5 m]
  3: [just after 2]
  4: [y(ball) = 0, x(ball) = 6 m]
find: {e: e}
"""
BOX = """
title: Box that falls flat
plane: vertical
points: {G: [0, 1.1 m], A: [-0.2 m, 1 m]}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {box: {plate: G, width: 0.4 m, height: 0.2 m, mass: 2 kg, points: [A]}}
joints:
  - contact: {between: [box, floor], at: A, mu: 0.3}
states: {1: [at rest], 2: [y(A) = 0]}
find: {v: v(box).y @ 2}
"""
GROOVE = """
title: Pin in a groove
given: {b: 0.2 m}
points: {O: [0, 0], E: [1 m, 0], P: [0.6 m, 0]}
surfaces: {groove: {r: b*(2 + cos(theta))}}
bodies: {arm: {points: [O, E]}, pin: {particle: P}}
joints:
  - pin: {at: O, between: [ground, arm]}
  - guide: {point: pin, along: arm}
  - guide: {point: pin, along: groove}
motion: [omega(arm) = 2 rad/s]
instant: [v(pin).mag is largest]
find: {v: v(pin).mag}
"""


VANE = """
title: Vane without mass before a jet
plane: horizontal
given: {u: 30 m/s, c: 5 kg/m}
unknowns: {V: m/s}
points: {P: [0, 0]}
bodies: {vane: {particle: P}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - stream:
      name: jet
      body: vane
      rate: c*(u - V)
      enters: {at: P, speed: u - V, angle: 0 deg}
      leaves: {at: P, speed: u - V, angle: 120 deg}
instant: [v(vane).x = V, power(jet) is largest]
find: {V: V}
"""
CAR = """
title: Car whose pull falls with its speed
plane: horizontal
given: {m: 900 kg, F: 4 kN, u: 50 m/s}
points: {P: [0, 0]}
bodies: {car: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - force: {body: car, magnitude: F*(1 - v(car).x/u), angle: 0 deg, name: pull}
instant: [power(pull) is largest]
find: {P: power(pull)}
"""


@pytest.mark.parametrize(
    ("text", "code", "message", "hint"),
    [
        (VANE, "PL613", "vane has no mass, so that the forces on it must balance", "`v(vane).x = V`"),
        (CAR, "PL613", "what power(pull) may rest on, v(P), is left open", "`unknowns: {V: m/s}`"),
        (
            WALL,
            "PL619",
            "the coefficient of restitution -0.1503: they would pass through each other",
            "between 0 and 1",
        ),
        (BOX, "PL521", "the point of contact is not on floor as drawn", "`during: 2->3`"),
        (GROOVE, "PL613", "v(pin).mag is what the places as drawn make it", "under `coordinates`"),
    ],
)
def test_what_to_write(text: str, code: str, message: str, hint: str) -> None:
    with pytest.raises((NoSolution, FileProblem)) as caught:
        solve(text)
    (why,) = caught.value.diagnostics
    assert why.code == code
    assert message in why.message
    assert hint in why.hint


SPIN = """
title: Bead on a free rod whose place does not change
plane: horizontal
points: {A: [-0.5 m, 0], B: [0.5 m, 0], P: [0.2 m, 0]}
bodies: {rod: {rod: [A, B], mass: 4 kg}, bead: {particle: P, mass: 1 kg}}
joints:
  - guide: {point: bead, along: rod, mu: 0}
states: {1: [omega(rod) = 5 rad/s, v(rod) = 0, v(bead/rod) = 0], 2: [r(bead/P).mag = 0.3 m]}
find: {w: omega(rod) @ 2}
"""


def test_of_squares_no_distance_is_told() -> None:
    """0.3 m and nothing do not differ by 0.09 m."""
    with pytest.raises(NoSolution) as caught:
        solve(SPIN)
    (why,) = caught.value.diagnostics
    assert why.code == "PL621"
    assert "0.09" not in f"{why.message} {why.hint}"


SPINNING = """
title: Rear wheels that spin
plane: vertical
given: {mu: 0.8}
points: {B: [0, 0], F: [2.5 m, 0], G: [1.2 m, 0.5 m]}
surfaces: {road: {through: B, angle: 0 deg}}
bodies: {car: {points: [B, F], center: G, mass: 1500 kg, inertia: any}}
joints:
  - contact: {between: [car, road], at: B, mu: 0}
  - contact: {between: [car, road], at: F, mu: 0}
loads:
  - force: {body: car, at: B, magnitude: mu*N(B), angle: 0 deg, name: drive}
instant: [at rest]
find: {a: a(car).x}
"""
LORRY = """
title: Crate on an accelerating lorry
plane: vertical
unknowns: {a_0: m/s^2}
points: {G: [0, 0.75 m], C: [0, 0]}
surfaces: {bed: {through: C, angle: 0 deg, body: lorry}}
bodies: {lorry: {particle: [3 m, 0]}, crate: {plate: G, width: 0.6 m, height: 1.5 m, mass: 1500 kg}}
joints:
  - guide: {body: lorry, along: 0 deg, name: road}
  - contact: {between: [crate, bed], mu: 0.5, name: foot}
instant: [at rest, a(lorry).x = a_0, mode(foot) = stick, a_0 is largest]
find: {a_max: a_0}
cases: {harder: {given: {a_0: 4.4 m/s^2}, find: {what: mode(foot)}}}
"""
LOOP = """
title: Least speed for a loop
plane: vertical
symbols: {R: m}
unknowns: {v_0: m/s}
points: {O: [0, R], P: [0, 0]}
surfaces: {loop: {center: O, radius: R}}
bodies: {ball: {particle: P, mass: any}}
joints: [{contact: {between: [ball, loop], mu: 0}}]
states: {low: [t = 0, v(ball).x = v_0, v_0 > 0], high: [y(ball) = 2*R, v_0 is smallest]}
find: {v_min: v_0}
"""


def why(text: str) -> Diagnostic:
    with pytest.raises((FileProblem, NoSolution)) as wrong:
        solve(text)
    return wrong.value.diagnostics[0]


def test_a_load_that_is_proportional_to_a_reaction() -> None:
    told = why(SPINNING)
    assert told.code == "PL555"
    assert "`unknowns: {D: N}`, `magnitude: D`, `instant: [D = …N(B)]`" in (told.hint or "")
    with_letter = SPINNING.replace("given: {mu: 0.8}", "given: {mu: 0.8}\nunknowns: {D: N}")
    with_letter = with_letter.replace("magnitude: mu*N(B)", "magnitude: D").replace(
        "[at rest]", "[at rest, D = mu*N(B)]"
    )
    assert_close(solve(with_letter)["a"], Decimal("0.8") * Decimal("9.81") * Decimal("1.3") / Decimal("2.1"))


def test_a_case_that_gives_what_is_largest() -> None:
    told = why(LORRY)
    assert told.code == "PL431"
    assert told.message.startswith("case harder: 'a_0 is largest'")
    assert "write it in the case that asks for it" in (told.hint or "")


def test_an_extreme_at_the_edge_of_reach_in_letters() -> None:
    told = why(LOOP)
    assert told.code == "PL623"
    assert "`N(ball) = 0`" in (told.hint or "")
    assert "simulate" not in (told.hint or "")
    assert solve(LOOP.replace("v_0 is smallest", "N(ball) = 0"))["v_min"].expressions
