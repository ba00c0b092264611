"""What hangs on ropes and starts at rest does not sway: its motion is told as the course tells it, not step by step."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from answered import assert_close, first, solve

from planar_cli.errors import NoSolution

OVER_A_DISK = """
title: Two loads on a rope over a light disk, drawn in numbers
plane: vertical
given: {m1: 4 kg, m2: 6 kg, r: 0.1 m}
points: {O: [0, 2 m], A: [-0.1 m, 1 m], B: [0.1 m, 1 m]}
bodies:
  A: {particle: A, mass: m1}
  B: {particle: B, mass: m2}
  pulley: {disk: O, radius: r}
joints:
  - pin: {at: O, between: [ground, pulley]}
  - rope: {path: [A, over pulley, B], name: cord}
states:
  1: [at rest]
  2: [y(A) = 1.5 m]
find: {v: v(B).mag @ 2, T: tension(cord) @ 2}
"""

FROM_A_TABLE = """
title: A block on a rough table, and a load over a light disk
plane: vertical
given: {m1: 4 kg, m2: 6 kg, r: 0.1 m, mu: 0.2}
points: {O: [0, 0], A: [-1 m, r], B: [r, -0.5 m]}
surfaces: {table: {through: A, angle: 0 deg}}
bodies:
  A: {particle: A, mass: m1}
  B: {particle: B, mass: m2}
  pulley: {disk: O, radius: r}
joints:
  - pin: {at: O, between: [ground, pulley]}
  - contact: {between: [A, table], mu: mu}
  - rope: {path: [A, over pulley, B], name: cord}
states:
  1: [at rest]
  2: [x(A) = -0.6 m]
find: {v: v(B).mag @ 2, T: tension(cord) @ 2}
"""

MOVING_DISK = """
title: A load that hangs from a disk in a loop of the rope
plane: vertical
given: {m1: 4 kg, m2: 6 kg, r: 0.1 m}
points: {O: [0, 2 m], G: [0.2 m, 1 m], A: [-0.1 m, 1 m], C: [0.3 m, 2 m]}
bodies:
  A: {particle: A, mass: m1}
  pulley: {disk: O, radius: r}
  low: {disk: G, radius: r, mass: m2, inertia: 0}
joints:
  - pin: {at: O, between: [ground, pulley]}
  - rope: {path: [A, over pulley, under low, C], name: cord}
states:
  1: [at rest]
  2: [y(G) = 1.3 m]
find: {v: v(A).mag @ 2, T: tension(cord) @ 2}
"""


def _told(text: str) -> dict[str, float]:
    """The answers, of a motion that is derived and not only followed."""
    found = solve(text)
    assert all(a.expressions is not None for a in found.values())
    return {name: float(a.values[0]) for name, a in found.items() if a.values}


def test_two_loads_over_a_disk() -> None:
    found = _told(OVER_A_DISK)
    assert found["v"] == pytest.approx(math.sqrt(2 * 9.81 * 2 / 10 * 0.5))
    assert found["T"] == pytest.approx(2 * 4 * 6 * 9.81 / 10)


def test_a_block_on_a_table_and_a_load() -> None:
    found = _told(FROM_A_TABLE)
    assert found["v"] == pytest.approx(math.sqrt(2 * 9.81 * (6 - 0.2 * 4) / 10 * 0.4))
    assert found["T"] == pytest.approx(6 * 4 * 1.2 * 9.81 / 10)


@pytest.mark.slow
def test_a_disk_in_a_loop_of_the_rope() -> None:
    found = _told(MOVING_DISK)
    assert found["T"] == pytest.approx(3 * 4 * 6 * 9.81 / 22)
    assert found["v"] == pytest.approx(math.sqrt(2 * 9.81 * (4 * 0.6 - 6 * 0.3) / (4 + 6 / 4)))


def test_a_state_that_is_the_other_way() -> None:
    with pytest.raises(NoSolution, match="a free part of cord has run out"):
        solve(MOVING_DISK.replace("1.3 m", "0.7 m"))


ON_A_DRUM = """
title: Load that is drawn nearer to the drum than it rises
plane: vertical
given: {r: 5 in}
points: {A: [0, 0], E: [-r, 0], B: [-r, -20 in]}
bodies:
  drum: {disk: A, radius: r}
  load: {particle: B}
joints:
  - pin: {at: A, between: [ground, drum]}
  - guide: {point: B, along: 90 deg}
  - rope: {path: [E on drum, B], name: cable}
motion: [alpha(drum) = -3 rad/s^2]
states:
  0: [t = 0, omega(drum) = -4 rad/s]
  2: [t = 2 s]
find: {rise: y(B) @ 2 - y(B) @ 0}
"""


def test_a_rope_that_is_drawn_too_short_is_told() -> None:
    with pytest.raises(NoSolution, match="a free part of cable has run out") as caught:
        solve(ON_A_DRUM)
    assert [d.code for d in caught.value.diagnostics] == ["PL712"]
    assert "further off" in caught.value.diagnostics[0].hint
    # In feet, as everything in a file in US customary units.
    assert float(solve(ON_A_DRUM.replace("-20 in", "-80 in"))["rise"].values[0]) == pytest.approx(70 / 12)


LANDING = """
title: Two loads on a heavy pulley, one of which lands
plane: vertical
points: {O: [0, 3 m], S: [-0.2 m, 3 m], T: [0.2 m, 3 m], A: [-0.2 m, 0.9 m], B: [0.2 m, 0.9 m], F: [-0.2 m, 0]}
surfaces: {floor: {through: F, angle: 0 deg}}
bodies:
  pulley: {disk: O, radius: 0.2 m, mass: 10 kg}
  A: {particle: A, mass: 12 kg}
  B: {particle: B, mass: 8 kg}
joints:
  - pin: {at: O, between: [ground, pulley]}
  - rope: {path: [A, S on pulley], name: left}
  - rope: {path: [B, T on pulley], name: right}
  - impact: {between: [A, floor], restitution: 0, name: thud}
states:
  1: [at rest]
  2: [y(A) = 0]
  3: [just after 2]
  4: [y(B) is largest]
find: {v: v(B).y @ 2, S: impulse(thud/A).y @ 2->3, rise: y(B) @ 4 - y(B) @ 3}
"""


def test_what_strikes_a_level_floor_does_not_sway() -> None:
    """The pulley goes on and pulls the other load up: m v² / 2 + I ω² / 2 = m g h."""
    found = _told(LANDING)
    v = math.sqrt(2 * 9.81 * 4 / 25 * 0.9)
    assert found["v"] == pytest.approx(v)
    assert found["S"] == pytest.approx(12 * v)
    assert found["rise"] == pytest.approx((8 + 5) * v**2 / (2 * 8 * 9.81))


IN_A_LOOP = """
title: Load in a loop of the rope that lands, while the block on the table slides on
plane: vertical
points: {A: [0, 0], D: [3 m, 0], E: [3 m, 0.2 m], B: [3 m, -0.6 m], Q: [3 m, -1.1 m]}
surfaces: {table: {through: A, angle: 0 deg}, floor: {through: Q, angle: 0 deg}}
bodies: {A: {particle: A, mass: 10 kg}, B: {particle: B, mass: 6 kg}}
joints:
  - contact: {between: [A, table], mu: 0.2}
  - rope: {path: [A, D, B, E]}
  - impact: {between: [B, floor], restitution: 0}
states:
  1: [at rest]
  2: [y(B) = -1.1 m]
  3: [just after 2]
  4: [v(A).x = 0]
find: {v: v(A).x @ 2, way: x(A) @ 4}
"""


def test_what_lies_on_the_floor_in_the_end_does_not_sway_before() -> None:
    found = _told(IN_A_LOOP)
    energy = 6 * 9.81 * 0.5 - 0.2 * 10 * 9.81 * 1
    v = math.sqrt(2 * energy / (10 + 6 / 4))
    assert found["v"] == pytest.approx(v)
    assert found["way"] == pytest.approx(1 + v**2 / (2 * 0.2 * 9.81))


STRUCK = """
title: Bullet that stays in a bob on a string, least speed for which the bob gets to the top
plane: vertical
symbols: {m: kg, M: kg, l: m}
unknowns: {v_0: m/s}
points: {O: [0, 0], P: [0, -l]}
bodies: {bob: {particle: P, mass: M}, bullet: {particle: [0, -l], mass: m}}
joints:
  - rope: {path: [O, P], name: string}
  - weld: {at: P, between: [bob, bullet], during: 1->3}
states:
  1: [bob at rest, v(bullet).x = v_0, v(bullet).y = 0]
  2: [just after 1]
  3: [y(bob) = l, tension(string) = 0]
find: {v_0: v_0, T: tension(string) @ 2}
"""


def test_what_catches_something_that_comes_from_the_side_sways() -> None:
    """At the top v² = g l, at the bottom 5 g l; T = (M + m) (g + 5 g)."""
    found = solve(STRUCK)
    m, mass, length, g = sp.symbols("m M l g", positive=True)
    asked = {"v_0": (mass + m) / m * sp.sqrt(5 * g * length), "T": 6 * (mass + m) * g}
    for name, right in asked.items():
        (told,) = found[name].expressions
        plain = told.subs({s: sp.Symbol(s.name, positive=True) for s in told.free_symbols})
        assert sp.simplify(plain / right) == 1


FROM_A_DRUM = """
title: Drum with a load that hangs from a point of its rim
plane: vertical
given: {m: 10 kg, R: 0.3 m, m_2: 2 kg}
points: {O: [0, 0], A: [R, 0], B: [R, -1 m]}
bodies: {drum: {disk: O, radius: R, mass: m, points: [A]}, load: {particle: B, mass: m_2}}
joints:
  - pin: {at: O, between: [ground, drum]}
  - rope: {path: [A, B]}
states:
  1: [at rest]
  2: [t = 0.5 s]
find: {omega: omega(drum) @ 2, T: tension(A) @ 2}
"""


def test_what_hangs_from_a_point_that_turns_aside_sways() -> None:
    """Lagrange's equations in the two angles, integrated by a Runge-Kutta method with 20,000 steps."""
    found = solve(FROM_A_DRUM)
    assert first(found["omega"]) == pytest.approx(-4.7153475891, rel=1e-9)
    assert first(found["T"]) == pytest.approx(34.1762569673, rel=1e-9)


CRANE = """title: Load under a trolley
plane: vertical
given: {m: 100 kg, l: 4 m, v: 2 m/s}
points: {T: [0, 5 m], L: {from: T, distance: l, angle: -90 deg}}
bodies:
  trolley: {particle: T}
  load: {particle: L, mass: m}
joints:
  - guide: {point: trolley, along: 0 deg}
  - rope: {path: [T, L], name: cord}
motion: [LAW]
states:
  1: [t = 0]
  2: [t = 1 s]
find: {T: tension(cord) @ 2, x: x(load) @ 2}
"""


def test_it_goes_along_with_the_upper_end_of_its_rope() -> None:
    """Hanging straight down it moves as fast as the trolley."""
    answers = solve(CRANE.replace("LAW", "v(trolley).x = v"))
    assert_close(answers["T"], 981)
    assert_close(answers["x"], 2)


def test_it_goes_on_where_a_law_of_that_end_ends() -> None:
    text = CRANE.replace("LAW", "v(trolley).x = v during 1->2, a(trolley).x = 0 during 2->3")
    text = text.replace("2: [t = 1 s]", "2: [t = 1 s]\n  3: [t = 1.5 s]").replace("x(load) @ 2", "x(load) @ 3")
    assert_close(solve(text)["x"], 3)


def test_a_speed_that_is_driven_in_phases() -> None:
    text = """title: Trolley driven in phases
points: {T: [0, 5 m]}
bodies: {trolley: {particle: T}}
joints: [guide: {point: trolley, along: 0 deg}]
motion: [v(trolley).x = 2 m/s during 1->2, v(trolley).x = -1 m/s during 2->3]
states: {1: [t = 0], 2: [t = 1 s], 3: [t = 3 s]}
find: {x: x(trolley) @ 3}
"""
    assert_close(solve(text)["x"], 0)
