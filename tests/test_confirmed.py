"""Answers with which nothing was compared are said, in the line of checks and for programs."""

from __future__ import annotations

from planar_cli.problem.structure import load_text
from planar_cli.report.json_document import solution_data
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import NOT_COMPARED

LAW = """
title: Particle whose law of motion has no closed form
coordinates: {x: m}
bodies: {p: {particle: [x, 0]}}
motion: ["ddot(x) = -(1 1/s)*dot(x) - x^3/(1 m^2*s^2)"]
states: {1: [t = 0, x = 1 m, dot(x) = 0], 2: [t = %s]}
find: {x: x @ 2, a: ddot(x) @ 1}
"""


def test_what_only_a_step_method_tells() -> None:
    problem, wrong = load_text(LAW % "2 s")
    assert not wrong
    assert problem is not None
    solution = solve_problem(problem)
    data = solution_data(solution, (), 4, None)
    assert "step by step alone" in solution.parts[0].motion.unconfirmed["x"]
    assert not any("followed step by step from the first state: agrees" in text for text in data["checks"])
    # The motion followed by independent facts is a second road.
    assert data["unconfirmed"] == 0
    solution.parts[0].confirmed = NOT_COMPARED
    data = solution_data(solution, (), 4, None)
    assert data["unconfirmed"] == 1
    assert data["answers"]["x"]["confirmed"] is False
    assert "step by step alone" in data["answers"]["x"]["unconfirmed"]
    assert data["answers"]["a"]["confirmed"] is True
    assert any(text.startswith("not compared: x (") for text in data["checks"])


def test_what_two_roads_tell() -> None:
    text = (LAW % "2 s").replace("(1 1/s)*dot(x) - x^3/(1 m^2*s^2)", "(1 1/s^2)*x")
    problem, _ = load_text(text)
    assert problem is not None
    data = solution_data(solve_problem(problem), (), 4, None)
    assert data["unconfirmed"] == 0
    assert all(answer["confirmed"] for answer in data["answers"].values())
