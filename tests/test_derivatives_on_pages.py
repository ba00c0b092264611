"""What a file gives stands before its derivatives, and a constant rate is said to have none."""

from __future__ import annotations

import unicodedata

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

HOIST = """
title: Man who walks away with a rope over a pulley
given: {h: 15 m, L: 30 m, v_A: 0.5 m/s}
coordinates: {x: m, y: m}
points: {D: [0, h], A: [x, 0], S: [0, y]}
bodies: {man: {particle: A}, safe: {particle: S}}
motion: [v(A).x = v_A, h - y + r(A/D).mag = L]
instant: [y = 10 m, x > 0]
find: {v_S: v(S).y, a_S: a(S).y}
"""


def test_a_relation_stands_before_its_derivatives() -> None:
    problem, wrong = load_text(HOIST)
    assert problem is not None, wrong
    told = unicodedata.normalize("NFC", " ".join(Terminal().render(narrate(solve_problem(problem))).split()))
    relation = "Given: h - y + the distance of A from D = L"
    marks = [f"{relation} (", f"{relation}, differentiated (", f"{relation}, differentiated twice ("]
    assert sorted(marks, key=told.index) == marks
    assert "ẍ = 0 ẋ constant" in told
    assert "v_S = ẏ = 0.4 m/s" in told
