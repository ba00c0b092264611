"""Lines of a page that must say what holds: lengths of ropes, derivatives, roots that are dropped, powers of sines."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from planar_cli.cli import run

Page = Callable[[str], str]


@pytest.fixture
def page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Page:
    """The printed solution of a file that a test writes out, in one line."""

    def told(text: str) -> str:
        path = tmp_path / "problem.yaml"
        path.write_text(text, encoding="utf-8")
        assert run(["solve", str(path)]) == 0
        return re.sub(r"\s+", " ", capsys.readouterr().out)

    return told


CABLE = """
title: Collar, pulley and block on one cable
points: {A: [0, -1 m], C: [0, 0], D: [0.4 m, -1.2 m], E: [0.8 m, 0], B: [0.8 m, -2 m]}
bodies: {collar: {particle: A}, pulley: {particle: D}, block: {particle: B}}
joints:
  - guide: {point: A, along: 90 deg}
  - guide: {point: D, along: 90 deg}
  - guide: {point: B, along: 90 deg}
  - rope: {path: [A, C, D, E, B], along: 90 deg, name: cable}
motion: [v(pulley).y = -3 m/s]
instant: [v(collar).y = 1 m/s, a(collar).y = -2 m/s^2]
find: {v: v(block).y, a: a(block).y}
"""


def test_a_rope_keeps_all_its_parts_where_one_end_moves_steadily(page: Page) -> None:
    text = page(CABLE)
    assert "y_A + y_B + 2 y_D = const., differentiated:" in text
    assert "y_A + y_B + 2 y_D = const., differentiated twice:" in text
    assert "y_A + y_B = const." not in text


ROCKET = """
title: Rocket tracked by radar
symbols: {b: m}
coordinates: {theta: deg}
points: {A: [0, 0], R: [b, b*tan(theta)]}
bodies: {rocket: {particle: R}}
find: {v: v(rocket).mag, a: a(rocket).y, ddr: ddot(r(R/A).mag)}
"""


def test_a_derivative_by_the_chain_rule_has_the_second_rate(page: Page) -> None:
    text = page(ROCKET)
    (line,) = re.findall(r"the velocities: \S+ = (.*?) =", text)
    assert "\N{GREEK SMALL LETTER THETA}\N{COMBINING DIAERESIS}" in line
    assert text.count("b tan θ ") == 1, "a particle and its point are told once"


JACK = """
title: Cylinder lifting a body
coordinates: {s: m}
points: {A: [0, 0], B: [3 m, 0], C: {distances: {A: 2.4 m, B: s}, side: above}}
bodies: {body: {rod: [A, C]}}
joints: [{pin: {at: A, between: [ground, body]}}]
motion: [dot(s) = 0.2 m/s]
instant: [theta(body) = 60 deg]
find: {w: omega(body), al: alpha(body)}
"""


def test_a_root_is_dropped_by_what_is_true_of_it(page: Page) -> None:
    text = page(JACK)
    assert "other roots: -2.750 m (a distance is not negative)" in text
    assert "smaller one" not in text
    assert "α = 0.001925 in m/s²" not in text, "an angular acceleration"


CRANK = """
title: Crank and slider in letters
symbols: {r: m, l: m, w: rad/s}
assume: [r < l]
coordinates: {theta: deg}
points: {O: [0, 0], A: {from: O, distance: r, angle: theta}, P: [r*cos(theta) + sqrt(l^2 - r^2*sin(theta)^2), 0]}
bodies: {crank: {rod: [O, A]}, rod: {rod: [A, P]}}
motion: [dot(theta) = w]
find: {v_P: v(P).x}
"""


def test_the_square_of_a_sine_is_no_sine_of_a_square(page: Page) -> None:
    text = page(CRANK)
    assert "√(l² - r² sin² θ), 0)" in text
    assert "sin θ²" not in text


ROAD = """
title: Speed that grows with the way
bodies: {bike: {particle: [0, 0]}}
joints: [{guide: {point: bike, along: 0 deg, name: road}}]
motion: [v(bike).x = 0.2 1/s * x(bike) + 5 m/s]
states:
  0: [t = 0]
  full: [x(bike) = 100 m]
find: {t_full: t @ full}
"""


def test_an_integral_is_solved_for_the_letter_of_the_page(page: Page) -> None:
    text = page(ROAD)
    assert "solved for q" not in text


LOOP = """
title: Pellet round a loop
plane: vertical
given: {m: 0.2 kg, R: 0.6 m}
unknowns: {v_B: m/s}
points: {O: [0, R], P: [0, 0]}
surfaces: {loop: {center: O, radius: R}}
bodies: {pellet: {particle: P, mass: m}}
joints:
  - contact: {between: [pellet, loop], at: P, mu: 0, name: track}
states:
  B: [t = 0, v(pellet).x = v_B, v_B > 0]
  D: [y(pellet) = 2*R, N(track) = 0]
find: {v_B: v_B}
"""


def test_what_a_state_says_of_a_force_is_given(page: Page) -> None:
    given = page(LOOP).split(" Find ")[0]
    assert given.endswith("D: y_pellet = 2 R, the normal force at track = 0")


ARC = """
title: Collar on an arc with a spring
plane: vertical
given: {m: 2 kg, R: 0.6 m, k: 150 N/m}
points: {O: [0, 0], A: [-R, 0], D: [R, -R]}
surfaces: {arc: {center: O, radius: R}}
bodies: {collar: {particle: A, mass: m}}
joints:
  - guide: {point: A, along: arc, name: rod}
loads:
  - spring: {between: [A, D], stiffness: k, natural_length: 0.3 m}
states:
  A: [at rest]
  B: [y(collar) = -R]
find: {v_B: v(collar).mag @ B}
"""


def test_an_angle_in_a_cosine_is_in_one_unit(page: Page) -> None:
    text = page(ARC)
    assert "cos(180° + 45°)" in text
    assert "0.785" not in text


def test_a_spring_is_called_by_both_ends(page: Page) -> None:
    assert "stretch of the spring AD, s_A" in page(ARC)


TWO_SPRINGS = (
    ARC.replace("states:", "  - spring: {between: [A, O], stiffness: 2*k, natural_length: 0.2 m}\nstates:")
    .replace("O: [0, 0]", "O: [0, 0], Q: [0, 0.4 m]")
    .replace("[A, O], stiffness", "[A, Q], stiffness")
)


def test_two_springs_are_called_by_their_ends(page: Page) -> None:
    text = page(TWO_SPRINGS)
    assert "stretch of the spring AD" in text
    assert "stretch of the spring AQ" in text


PUSHED = """
title: Block pushed on a rough plane
plane: vertical
unknowns: {P: N}
points: {B: [0, 0]}
surfaces: {floor: {through: B, angle: 0 deg}}
bodies: {block: {particle: B, mass: 90 kg}}
joints:
  - contact: {between: [block, floor], mu_k: 0.25}
loads:
  - force: {body: block, magnitude: P, angle: -30 deg}
instant: [v(block).x > 0, a(block).x = sqrt(3^2) * 1 m/s^2]
find: {P: P, N: N(block)}
"""


def test_a_direction_of_summing_is_chosen_for_what_does_not_count(page: Page) -> None:
    text = page(PUSHED)
    assert "block, in the direction in which P does not count:" in text
    assert "virtual motion" not in text


HUMP = """
title: Car over a hump
plane: vertical
given: {m: 900 kg, h: 12 m}
unknowns: {rho: m}
points: {K: [0, 5 m - rho], Q: [0, 5 m]}
surfaces: {hump: {center: K, radius: rho}}
bodies: {car: {particle: Q, mass: m}}
joints:
  - contact: {between: [car, hump], at: Q, mu: 0, name: track}
instant: [v(car).x = sqrt(2*g*(h - 5 m)), N(track) = 0]
find: {rho: rho}
"""


def test_a_relation_of_the_file_is_told_in_the_notation_of_the_page(page: Page) -> None:
    text = page(HUMP)
    assert "v = √(2 g (h - 5 m))" in text
    assert "sqrt" not in text
