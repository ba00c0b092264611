"""Files that leave out what can only mean one thing."""

from __future__ import annotations

from math import radians, sin

import pytest
from answered import assert_close, solve

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text

SLOPE = """
title: Disk on a smooth slope, of any distribution of its mass
plane: vertical
points: {C: [0, 0], G: {from: C, distance: 0.2 m, angle: 60 deg}}
surfaces: {slope: {through: C, angle: -30 deg}}
bodies: {disk: {disk: G, radius: 0.2 m, mass: 2 kg, inertia: any}}
joints:
  - contact: {between: [disk, slope], mu: 0}
instant: [at rest]
find: {value: a(G).along(-30 deg)}
"""

LIGHT = """
title: Wheel without mass that is hard to turn
plane: vertical
bodies: {wheel: {disk: [0, 0], radius: 0.2 m, mass: 0, inertia: 3 kg*m^2}}
joints:
  - pin: {at: [0, 0], between: [ground, wheel]}
loads:
  - torque: {moment: 6 N*m}
instant: [at rest]
find: {value: alpha(wheel)}
"""

SLIDES = """
title: Block that slides
plane: vertical
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {block: {particle: [0, 0], mass: 20 kg}}
joints:
  - contact: {between: [block, floor], mu_k: 0.2}
loads:
  - force: {magnitude: 60 N, angle: 0 deg}
instant: [v(block).x = 1 m/s]
find: {value: a(block).x}
"""

BOWL = """
title: Bead in a bowl, its place constructed
plane: vertical
bodies: {bead: {particle: {from: [0, 0], distance: 1 m, angle: -60 deg}, mass: 1 kg}}
surfaces: {bowl: {center: [0, 0], radius: 1 m}}
joints:
  - contact: {between: [bead, bowl], mu: 0}
instant: [at rest]
find: {value: N(bead)}
"""

INERTIA = """
title: Moment of inertia, which no weight has a part in
bodies: {wheel: {disk: [0, 0], radius: 0.2 m, mass: 20 kg}}
find: {value: I(wheel)}
"""

SPEED = """
title: Speed, which no weight has a part in
points: {O: [0, 0], A: [2 m, 0]}
bodies: {bar: {rod: [O, A], mass: 20 kg}}
joints:
  - pin: {at: O, between: [ground, bar]}
instant: [omega(bar) = 3 rad/s]
find: {value: v(A).y}
"""

SLIDER = """
title: Slider on a rod, its pin by its place
plane: horizontal
points: {B: [1 m, 0]}
bodies: {slider: {particle: B, mass: 2 kg}}
joints:
  - guide: {point: [1 m, 0], along: 0 deg}
loads:
  - force: {at: [1 m, 0], magnitude: 6 N, angle: 60 deg}
instant: [at rest]
find: {value: a(slider).x}
"""

BED = """
title: Box on the bed of a lorry that speeds up, both joint and body called box
plane: vertical
points: {C: [0, 0], D: [-1 m, -0.2 m]}
bodies: {lorry: {points: [D, C], center: D, mass: 20 kg}, box: {particle: C, mass: 2 kg}}
surfaces: {bed: {through: C, angle: 0 deg, body: lorry}}
joints:
  - guide: {body: lorry, along: 0 deg}
  - contact: {between: [box, bed], mu: 0.3}
motion: [a(lorry).x = 1 m/s^2]
instant: [v(lorry).x = 3 m/s, v(box/lorry).x = 0]
find: {value: friction(box).x}
"""

CALLED = """
title: Disk called as its centre
plane: vertical
points: {A: [0, 0.5 m], C: [0, 0], B: [1 m, 0.5 m]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {A: {disk: A, radius: 0.5 m, mass: 3 kg}, AB: {rod: [A, B]}}
joints:
  - rolling: {between: [A, floor]}
  - pin: {at: A, between: [A, AB]}
  - guide: {point: B, along: 0 deg}
loads:
  - force: {at: B, magnitude: 9 N, angle: 0 deg}
instant: [at rest]
find: {value: a(A).x}
"""

SYSTEM = """
title: All bodies together
plane: horizontal
bodies: {P: {particle: [0, 2 m], mass: 2 kg}, Q: {particle: [1 m, 2 m], mass: 2 kg}}
instant: [v(P).x = 3 m/s, v(P).y = 0, v(Q).x = 1 m/s, v(Q).y = 1 m/s]
find: {value: KE()}
"""

DRIVEN = """
title: Rod driven by the rate of its coordinate
plane: vertical
coordinates: {theta: deg}
points: {O: [0, 0], A: {from: O, distance: 2 m, angle: theta}}
bodies: {OA: {rod: [O, A], mass: 6 kg}}
joints:
  - pin: {at: O, between: [ground, OA]}
motion: [dot(theta) = 3 rad/s]
instant: [theta = 0 deg]
find: {value: reaction(O).x}
"""

CARRIED = """
title: Block accelerated by the second rate of its coordinate
plane: vertical
coordinates: {s: m}
points: {P: [s, 0]}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {P: {particle: P, mass: 2 kg}}
joints:
  - contact: {between: [P, floor], mu: 0}
motion: [ddot(s) = 3 m/s^2]
states: {1: [t = 0, s = 0, dot(s) = 1 m/s], 2: [t = 2 s]}
find: {value: s @ 2}
"""

CRATE = """
title: Crate that lies on a slope with a whole face
plane: vertical
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: -20 deg}}
bodies: {box: {plate: {from: A, distance: 0.5 m, angle: 70 deg}, angle: -20 deg, width: 1 m, height: 1 m, mass: 10 kg}}
joints:
  - contact: {between: [box, slope], mu: 0.6}
instant: [at rest]
find: {value: friction(box).along(160 deg)}
"""


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (SLOPE, 9.81 / 2),
        (LIGHT, 2),
        (SLIDES, 3 - 0.2 * 9.81),
        (BOWL, 9.81 * 3**0.5 / 2),
        (INERTIA, 0.4),
        (SPEED, 6),
        (SLIDER, 1.5),
        (BED, 2),
        (CALLED, 2),
        (SYSTEM, 11),
        (DRIVEN, -54),
        (DRIVEN.replace("instant: [theta = 0 deg]\n", "").replace("reaction(O).x", "v(A).mag"), 6),
        (CARRIED, 8),
        (CRATE, 98.1 * sin(radians(20))),
    ],
)
def test_value(text: str, value: float) -> None:
    assert_close(solve(text)["value"], value, 9)


@pytest.mark.parametrize("asked", ["a(A).y", "reaction(O).y", "alpha(bar)"])
def test_a_plane_where_weight_may_have_a_part(asked: str) -> None:
    _, diagnostics = load_text(SPEED.replace("v(A).y", asked))
    assert [d.code for d in diagnostics] == ["PL450"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (CALLED.replace("a(A).x", "v(B/A).x"), "PL427"),
        (CALLED.replace("a(A).x", "reaction(A).x").replace("[A, floor]", "[A, floor], at: C"), "PL424"),
        (SYSTEM.replace("KE()", "H()"), "PL208"),
        (SYSTEM.replace("KE()", "KE"), "PL410"),
        (SYSTEM.replace("Q: {particle: [1 m, 2 m]", "Q: {sector: Q, radius: 1 m, span: 90 deg"), "PL403"),
    ],
)
def test_what_may_mean_two_things(text: str, code: str) -> None:
    _, diagnostics = load_text(text)
    assert [d.code for d in diagnostics] == [code]


CIRCLES = """
title: A point at a distance on a line
given: {l: 2 m, b: 3 m}
points: {O: [0, 0], A: [0, l], B: PLACE}
find: {value: x(B)}
"""


@pytest.mark.parametrize(
    "place",
    [
        "{distances: {A: b}, line: [O, 0 deg], side: right}",
        "{distances: {A: b}, line: {through: O, angle: 0 deg}, side: right}",
        "{distances: {A: b}, on: {through: O, angle: 0 deg}, side: right}",
        "{from: A, distance: b, on: [O, 0 deg], side: right}",
    ],
)
def test_a_point_on_a_line(place: str) -> None:
    assert_close(solve(CIRCLES.replace("PLACE", place))["value"], 5**0.5, 9)


@pytest.mark.parametrize(
    ("place", "code", "hint"),
    [
        ("{distances: {A: b}, line: [O, 0 deg], on: [O, 0 deg]}", "PL323", ""),
        ("{from: A, distance: b, on: [O, 0 deg], x: b}", "PL321", ""),
        ("{from: A, length: b, angle: 30 deg}", "PL310", "write `distance: b`"),
    ],
)
def test_a_point_that_is_told_twice_or_otherwise(place: str, code: str, hint: str) -> None:
    _, diagnostics = load_text(CIRCLES.replace("PLACE", place))
    assert (code, hint) in [(d.code, d.hint if hint else "") for d in diagnostics]


def test_a_list_of_unknowns() -> None:
    _, diagnostics = load_text(CIRCLES.replace("PLACE", "[u, w]").replace("points", "unknowns: [u, w]\npoints"))
    assert [(d.code, d.hint) for d in diagnostics] == [
        ("PL301", "write `unknowns: {u: UNIT, w: UNIT}`, each with its unit: N, deg, m/s, or `1` for a pure number")
    ]


GROWING = """
title: Growth of a force from the moment of slipping
plane: vertical
unknowns: {c: N/s}
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {crate: {particle: [0, 0], mass: 10 kg}}
joints:
  - contact: {name: C, between: [crate, floor], mu: 0.4}
loads:
  - force: {magnitude: c*t, angle: 0 deg}
states:
  1: [t = 0, at rest]
  2: [mode(C) = slip, TIME]
find: {value: c}
"""


def test_a_mode_that_begins_at_a_time() -> None:
    assert_close(solve(GROWING.replace("TIME", "t - t @ 1 = 5 s"))["value"], 0.4 * 98.1 / 5, 9)


def test_a_mode_at_a_given_time_tells_no_constant() -> None:
    with pytest.raises(NoSolution) as raised:
        solve(GROWING.replace("TIME", "t = 5 s"))
    (found,) = raised.value.diagnostics
    assert (found.code, found.message) == ("PL623", "c is open: no state tells enough")
    assert found.hint.startswith("where `mode(C) = slip` is to begin at `t = 5 s`")


STATIC = """
title: Block of which only the static coefficient is known
plane: vertical
surfaces: {floor: {through: [0, 0], angle: 0 deg}}
bodies: {block: {particle: [0, 0], mass: 20 kg}}
joints:
  - contact: {between: [block, floor], mu_s: 0.2}
loads:
  - force: {magnitude: FORCE, angle: 0 deg}
INSTANT
find: {value: ASKED}
"""


@pytest.mark.parametrize(
    ("force", "instant", "asked", "value"),
    [
        ("30 N", "instant: [at rest]", "friction(block).x", -30),
        ("10 N/s * t", "states: {1: [t = 0, at rest], 2: [mode(block) = slip]}", "t @ 2", 0.02 * 196.2),
    ],
)
def test_a_static_coefficient_alone(force: str, instant: str, asked: str, value: float) -> None:
    text = STATIC.replace("FORCE", force).replace("INSTANT", instant).replace("ASKED", asked)
    assert_close(solve(text)["value"], value, 9)


def test_what_slides_needs_the_kinetic_coefficient() -> None:
    text = STATIC.replace("FORCE", "60 N").replace("INSTANT", "instant: [at rest]")
    assert solve(text.replace("ASKED", "mode(block)"))["value"].word == "slip"
    with pytest.raises(
        NoSolution, match="value depends on the kinetic friction at block, of which only `mu_s` is given"
    ):
        solve(text.replace("ASKED", "a(block).x"))


GEARS = """
title: Stepped wheel that turns another one
plane: vertical
bodies:
  stepped: {{disk: [0, 0], radius: 0.3 m, hub: 0.1 m, mass: 4 kg}}
  other: {{disk: [{at} m, 0], radius: 0.2 m, mass: 2 kg}}
joints:
  - pin: {{at: [0, 0], between: [ground, stepped]}}
  - pin: {{at: [{at} m, 0], between: [ground, other]}}
  - rolling: {{between: [stepped, other]}}
instant: [omega(stepped) = 6 rad/s]
find: {{omega: omega(other)}}
"""
RAIL = """
title: Axle of a reel on a rail
plane: horizontal
surfaces: {rail: {through: [0, 0], angle: 0 deg}}
bodies: {reel: {disk: [0, 0.1 m], radius: 0.3 m, hub: 0.1 m, mass: 4 kg}}
joints:
  - rolling: {between: [reel, rail]}
instant: [omega(reel) = -2 rad/s]
find: {v: v(reel).x}
"""


@pytest.mark.parametrize(("at", "ratio"), [(0.5, -0.3 / 0.2), (0.3, -0.1 / 0.2)])
def test_of_a_stepped_wheel_that_rim_touches_that_can(at: float, ratio: float) -> None:
    """Beside the rim, or beside the hub."""
    assert_close(solve(GEARS.format(at=at))["omega"], ratio * 6)


def test_the_hub_of_a_reel_touches_a_rail() -> None:
    assert_close(solve(RAIL)["v"], "0.2")


FLYWHEEL = """plane: horizontal
points: {O: [0, 0]}
bodies: {w: {disk: O, mass: 3 kgTOLD}}
joints:
  - pin: {at: O, between: [ground, w]}
loads:
  - torque: {body: w, moment: 4 N*m}
instant: [at rest]
find: {value: alpha(w)}
"""


def test_a_wheel_that_nothing_touches_needs_no_radius() -> None:
    assert_close(solve(FLYWHEEL.replace("TOLD", ", inertia: 0.2 kg*m^2"))["value"], 20)


def test_its_inertia_needs_a_radius_where_something_rests_on_it() -> None:
    with pytest.raises(NoSolution) as error:
        solve(FLYWHEEL.replace("TOLD", ""))
    (told,) = error.value.diagnostics
    assert told.code == "PL614"
    assert (told.hint or "").endswith("or its `radius`, if it is a uniform wheel")


def test_a_wheel_that_does_not_turn_needs_no_radius() -> None:
    text = FLYWHEEL.replace("TOLD", "").replace("alpha(w)", "a(w).x").replace("torque: {body: w, moment: 4 N*m}", PULL)
    assert_close(solve(text.replace("pin: {at: O, between: [ground, w]}", RAIL_OF_IT))["value"], 4)


PULL = "force: {body: w, at: O, magnitude: 12 N, angle: 0 deg}"
RAIL_OF_IT = "guide: {point: O, along: 0 deg}"


def test_a_part_that_is_a_wheel_needs_one() -> None:
    parts = "{parts: [{disk: O, mass: 3 kg}, {particle: O, mass: 1 kg}]}"
    _, wrong = load_text(FLYWHEEL.replace("{disk: O, mass: 3 kgTOLD}", parts))
    assert [(d.code, d.hint) for d in wrong] == [("PL311", "give its `radius`")]


THROWN = """plane: vertical
bodies: {P: {particle: [0, 0], mass: 2 kg}}
states:
  1: [v(P).x = 3 m/s, v(P).y = 4 m/s]
  2: [v(P).y = 0 m/s]
find: {height: y(P) @ 2}
cases:
  now:
    instant: [v(P).x = 3 m/s, v(P).y = 4 m/s]
    find: {rho: rho(P)}
  moon:
    given: {g: 1.62 m/s^2}
    find: {there: y(P) @ 2}
"""


def test_a_case_of_states_may_ask_about_one_instant() -> None:
    """ρ = v²/a_n with a_n = g v_x/v; the other case still has the states."""
    found = solve(THROWN)
    for name, truth in (("height", 8 / 9.81), ("rho", 25 / (9.81 * 0.6)), ("there", 8 / 1.62)):
        assert_close(found[name], truth)


DROPPED = """plane: vertical
bodies: {P: {particle: [0, 5 m], mass: 2 kg}}
instant: [at rest]
find: {a: a(P).y}
cases:
  moon:
    given: {g: 1.62 m/s^2}
    find: {there: a(P).y}
  below:
    states: {1: [at rest], 2: [y(P) = 0]}
    find: {v: v(P).mag @ 2}
"""


def test_a_case_of_an_instant_may_have_states() -> None:
    """The other case still has the instant."""
    found = solve(DROPPED)
    for name, truth in (("a", -9.81), ("there", -1.62), ("v", (2 * 9.81 * 5) ** 0.5)):
        assert_close(found[name], truth)
