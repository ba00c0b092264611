"""Lengths and angles of a construction have their units; nothing else is called checked."""

from __future__ import annotations

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem

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
