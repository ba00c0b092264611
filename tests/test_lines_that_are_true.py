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
