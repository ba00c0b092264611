"""Orbits under an attraction that falls with the square of the distance: conic sections and Kepler's third law."""

from __future__ import annotations

import math
import re

import pytest
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

SCENE = """
title: Satellite
plane: horizontal
given: {m: 100 kg, K: 3.986e14 m^3/s^2, r_1: 7000 km, v_1: SPEED}
points: {O: [0, 0], P: [r_1, 0]}
bodies: {satellite: {particle: P, mass: m}}
loads:
  - force: {body: satellite, magnitude: K*m/r(satellite).mag^2, towards: O}
states:
  near: [t = 0, v(satellite).x = 0, v(satellite).y = v_1]
STATES
find: {FIND}
"""
HALF, WHOLE, CONIC, BY_STEPS = "half a revolution", "one revolution", "a conic section", "numerical integration"


def page(speed: str, states: str, find: str) -> str:
    """The page of a satellite that starts at right angles to the line from the centre."""
    problem, _ = load_text(SCENE.replace("SPEED", speed).replace("STATES", states).replace("FIND", find))
    assert problem is not None
    return re.sub(r"\s+", " ", Terminal(200).render(narrate(solve_problem(problem))))


def half(speed: float) -> float:
    """Half the time of a revolution [s], by Kepler's third law."""
    return math.pi * math.sqrt((1 / (2 / 7e6 - speed**2 / 3.986e14)) ** 3 / 3.986e14)


@pytest.mark.parametrize(
    ("speed", "state", "said", "time"),
    [
        ("9 km/s", "is largest", HALF, half(9000)),
        ("-9 km/s", "is largest", HALF, half(9000)),
        ("7 km/s", "is smallest", HALF, half(7000)),
        ("9 km/s", "is smallest", WHOLE, 2 * half(9000)),
    ],
)
def test_from_one_end_to_an_end(speed: str, state: str, said: str, time: float) -> None:
    told = page(speed, f"  end: [r(satellite).mag {state}]", "t: t @ end")
    assert said in told
    assert BY_STEPS not in told
    assert float(told.split("Answer t = ")[1].split(" s")[0]) == pytest.approx(time, rel=1e-3)


def test_an_end_after_another_half_is_followed() -> None:
    states = "  s: [r(satellite).angle = 200 deg]\n  far: [r(satellite).mag is largest]"
    told = page("9 km/s", states, "t: t @ far")
    assert HALF not in told
    assert float(told.split("Answer t = ")[1].split(" s")[0]) == pytest.approx(3 * half(9000), rel=1e-3)


@pytest.mark.parametrize("speed", ["9 km/s", "12 km/s"])
def test_the_direction_at_a_distance(speed: str) -> None:
    told = page(speed, "  s: [r(satellite).mag = 15000 km]", "phi: r(satellite).angle @ s in deg")
    flat = 3.986e14 / (7e6 * float(speed.split(maxsplit=1)[0]) * 1000) ** 2
    angle = math.degrees(math.acos((1 / 15e6 - flat) / (1 / 7e6 - flat)))
    assert CONIC in told
    assert float(re.findall(r"Answer φ = (?:φ\S+ = )?([\d.]+)°", told)[0]) == pytest.approx(angle, rel=1e-3)


def test_a_circle_has_no_ends() -> None:
    told = page("sqrt(K/r_1)", "  s: [r(satellite).angle = 90 deg]", "t: t @ s")
    assert HALF not in told
    assert CONIC not in told


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("satellite-launched-level", "t_2 = π √((r_1/2 + r_2/2)³/g_0) / R"),
        ("satellite-once-round-the-earth", "t_round = π √((r_1 + r_far)³ / (2 K))"),
        ("descent-to-the-moon", "1/r_B = K/(r_A⁴ φ̇_ship,A²) + (1/r_A - K/(r_A⁴ φ̇_ship,A²)) cos φ_ship,B"),
    ],
)
def test_pages(name: str, said: str) -> None:
    assert said in page_of_file(name)
