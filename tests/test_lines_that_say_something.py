"""Lengths and angles of a construction have their units; nothing else is called checked."""

from __future__ import annotations

from conftest import ROOT

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

PROBLEMS = ROOT / "problems"
TEE = """
title: T of two rods
PLANE
symbols: {m: kg, l: m}
points: {F: [0, 0], J: [0, l], L: [-l/2, l], R: [l/2, l]}
bodies: {tee: {parts: [{rod: [F, J], mass: m}, {rod: [L, R], mass: m}]}}
find: {I_F: I(tee/F)}
"""
CRANK = """
title: Rod on a circle
points:
  O: [0, 0]
  A: {from: O, distance: 100 mm, angle: 40 deg}
  B: {distances: {A: 250 mm}, WHERE, side: right}
bodies: {crank: {rod: [O, A]}, rod: {rod: [A, B]}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, rod]}
  - guide: {point: B, along: 0 deg}
motion: [omega(crank) = 2 rad/s]
find: {omega: omega(rod), v: v(B)}
"""


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    return " ".join(Terminal().render(narrate(solve_problem(problem))).split())


def test_a_moment_of_inertia_rests_on_no_motion() -> None:
    for plane in ("", "plane: vertical"):
        assert "multibody" not in page(TEE.replace("PLANE\n", plane + "\n" if plane else ""))


def test_lengths_and_angles_have_their_units() -> None:
    assert "B is 250 mm from A and at y = 20 mm" in page(CRANK.replace("WHERE", "y: 20 mm"))
    told = page(CRANK.replace("WHERE", "line: [O, 10 deg]"))
    assert "B is 250 mm from A and on the line through O at 10°" in told
    assert "independent multibody solution" in told


CURVE = """
title: Car on a level curve
plane: horizontal
given: {m: 1500 kg, rho: 100 m, F: 3000 N}
unknowns: {v: m/s}
bodies: {car: {particle: [0, 0], mass: m}}
loads:
  - force: {body: car, magnitude: F, angle: 180 deg}
instant: [at rest, a(car).x = -v^2/rho, v > 0]
find: {v_max: v in km/h}
"""


def test_a_constant_in_a_given_acceleration_is_solved_for_on_the_page() -> None:
    told = page(CURVE)
    assert "2 equations, 2 unknowns: a, v" in told
    assert "v = √(-ρ a) = √(-100 (-2)) = 14.14 m/s" in told
    assert "v_max = v = 50.91 km/h" in told


def test_a_given_acceleration_has_its_number() -> None:
    text = CURVE
    for old, new in (
        ("magnitude: F", "magnitude: P"),
        ("v > 0", "v = 20 m/s"),
        ("{v: m/s}", "{v: m/s, P: N}"),
        (", F: 3000 N", ""),
        ("{v_max: v in km/h}", "{P: P}"),
    ):
        text = text.replace(old, new)
    assert "a = -v²/ρ = -20²/100 = -4 m/s² given" in page(text)


def test_what_is_zero_at_sight_stands_in_no_check() -> None:
    told = page((PROBLEMS / "particles" / "sphere-on-two-wires-in-a-circle.yaml").read_text())
    assert "sphere: ↑ ΣF_y = -49.05 + 29.28 + 19.77 = 0 N" in told
