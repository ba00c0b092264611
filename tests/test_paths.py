"""Paths and hodographs, and finds that are formulas of the time: what is found, and what is refused and why."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
import sympy as sp

from planar_cli.errors import FileProblem
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.problem.structure import load_text
from planar_cli.report.page.json_document import solution_data
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

WHEEL = """
title: Wheel drawn at its start
given: {r: 0.5 m}
points: {C: [0, 0], G: [0, r], P: [0, 0], Q: [0, r/2]}
surfaces: {road: {through: C, angle: 0 deg}}
bodies: {wheel: {disk: G, radius: r, points: [P, Q]}}
joints:
  - rolling: {between: [wheel, road], at: C}
motion: [omega(wheel) = 2 rad/s cw]
"""
FOUR_BAR = """
title: Four-bar linkage
points: {O: [0, 0], A: [0, 1 m], B: [3 m, 2 m], C: [3 m, 0], M: {midpoint: [A, B]}}
bodies:
  crank: {rod: [O, A]}
  coupler: {points: [A, B, M], center: M}
  rocker: {rod: [C, B]}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, coupler]}
  - pin: {at: B, between: [coupler, rocker]}
  - pin: {at: C, between: [ground, rocker]}
motion: [omega(crank) = 2 rad/s]
"""
TRAMMEL = """
title: Slider crank with equal arms
symbols: {l: m}
points:
  O: [0, 0]
  A: {from: O, distance: l, angle: 40 deg}
  B: {from: O, distance: 2*l*cos(40 deg), angle: 0 deg}
  M: {midpoint: [A, B]}
bodies:
  crank: {rod: [O, A]}
  conrod: {rod: [A, B], points: [M]}
  piston: {points: [B], center: B}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, conrod]}
  - pin: {at: B, between: [conrod, piston]}
  - guide: {body: piston, along: 0 deg}
motion: [omega(crank) = 2 rad/s]
"""
ARM = """
title: Arm that turns ever faster
points: {O: [0, 0], A: [2 m, 0]}
bodies: {arm: {rod: [O, A]}}
joints:
  - pin: {at: O, between: [ground, arm]}
motion: [omega(arm) = 3 rad/s^2 * t]
"""
THROW = """
title: Throw
plane: vertical
symbols: {v_0: m/s, alpha: deg}
bodies: {P: {particle: [0, 0], mass: any}}
states:
  start: [t = 0, v(P).mag = v_0, v(P).angle = alpha]
  top: [v(P).y = 0]
"""


def solved(tmp_path: Path, text: str, finds: str, answers: str = "") -> tuple[Solution, list[str]]:
    """The solution, and what is wrong with the stated answers."""
    path = tmp_path / "problem.yaml"
    path.write_text(f"{text}find: {{{finds}}}\n" + (f"answers: {{{answers}}}\n" if answers else ""), encoding="utf-8")
    solution, verdicts = solve_and_compare(read(str(path)))
    return solution, [v.message for v in verdicts if not v.agrees]


def found(solution: Solution) -> dict[str, Any]:
    return {f.name: f for part in solution.parts for f in part.found}


@pytest.mark.parametrize(
    ("text", "find", "words", "answer"),
    [
        (WHEEL, "path(G)", "straight line parallel to the x axis", "y = r"),
        (WHEEL, "path(P/G)", "circle about G", "x^2 + y^2 = r^2"),
        (WHEEL, "hodograph(P)", "circle about (2*r, 0)", "(x - 1 m/s)^2 + y^2 = (1 m/s)^2"),
        (FOUR_BAR, "path(A)", "circle about O", "x^2 + y^2 = 1 m^2"),
        (FOUR_BAR, "path(B)", "circle about C", "(x - 3 m)^2 + y^2 = 4 m^2"),
        (FOUR_BAR, "path(B/A)", "circle about A", "x^2 + y^2 = 10 m^2"),
        (TRAMMEL, "path(M)", "ellipse", "(2*x/(3*l))^2 + (2*y/l)^2 = 1"),
        (TRAMMEL, "path(B)", "straight line parallel to the x axis", "y = 0"),
        (ARM, "path(A)", "circle about O", "x^2 + y^2 = (2 m)^2"),
        (THROW, "path(P)", "parabola", "y = x*tan(alpha) - g*x^2/(2*v_0^2*cos(alpha)^2)"),
        (THROW, "hodograph(P)", "straight line", "vx = v_0*cos(alpha)"),
    ],
)  # fmt: skip
def test_curve(tmp_path: Path, text: str, find: str, words: str, answer: str) -> None:
    solution, wrong = solved(tmp_path, text, f"curve: {find}", f"curve: {answer}")
    assert not wrong
    curve = found(solution)["curve"].curve
    assert curve.words == words
    assert words.split(maxsplit=1)[0] in Terminal().render(narrate(solution))


def test_rim_points_of_a_wheel_describe_cycloids(tmp_path: Path) -> None:
    solution, _ = solved(tmp_path, WHEEL, "P: path(P), Q: path(Q)")
    assert found(solution)["P"].curve.kind == "cycloid"
    assert found(solution)["Q"].curve.kind == "curtate cycloid"


def test_a_point_that_rests_in_its_frame(tmp_path: Path) -> None:
    solution, _ = solved(tmp_path, WHEEL, "G: path(G/wheel), v: hodograph(G)")
    assert found(solution)["G"].curve.words.startswith("point")
    assert "velocity does not change" in found(solution)["v"].curve.words


def test_a_coupler_curve_is_no_conic(tmp_path: Path) -> None:
    solution, _ = solved(tmp_path, FOUR_BAR, "M: path(M)")
    assert found(solution)["M"].curve.kind == "curve"
    assert found(solution)["M"].expressions is None


def test_hodograph_has_axes_of_its_own_in_json(tmp_path: Path) -> None:
    solution, _ = solved(tmp_path, WHEEL, "h: hodograph(P), p: path(P/G)")
    answers = solution_data(solution, (), 4, None)["answers"]
    assert set(map(str, sp.sympify(answers["h"]["expression"].split(" = ")[0]).free_symbols)) == {"vx", "vy", "r"}
    assert answers["p"]["expression"] == "x**2 + y**2 = r**2"
    assert answers["p"]["text"].startswith("circle about G")
    assert answers["p"]["value"] is None


def test_formulas_of_time(tmp_path: Path) -> None:
    finds = "th: theta(arm), v: v(A), a: a(A).mag"
    answers = "th: 1.5 rad/s^2 * t^2, v: [-6 m/s^2 * t*sin(1.5 rad/s^2 * t^2), 6 m/s^2 * t*cos(1.5 rad/s^2 * t^2)]"
    solution, wrong = solved(tmp_path, ARM, finds, answers)
    assert not wrong
    assert sp.simplify(found(solution)["a"].expressions[0] ** 2 - 36 - 324 * sp.Symbol("t", real=True) ** 4) == 0


def test_several_freedoms_are_refused_where_they_are_asked(tmp_path: Path) -> None:
    text = "title: Two\nsymbols: {l: m}\ncoordinates: {s: m, b: deg}\n"
    text += "points: {A: [s, 0], B: {from: A, distance: l, angle: b}}\n"
    with pytest.raises(FileProblem) as error:
        solved(tmp_path, text + "bodies: {rod: {rod: [A, B]}}\n", "p: path(B)")
    (diagnostic,) = error.value.diagnostics
    assert diagnostic.code == "PL650"
    assert "s and b" in diagnostic.message
    assert diagnostic.mark.line == 6


def test_where_the_start_is_given_it_is_not_asked_for(tmp_path: Path) -> None:
    text = "title: T\nplane: horizontal\npoints: {O: [0, 0], P: [2 m, 0]}\nbodies: {P: {particle: P, mass: 1 kg}}\n"
    text += "loads:\n  - force: {body: P, magnitude: (8 N*m^2)/r(P/O).mag^2, towards: O}\n"
    text += "states: {1: [t = 0, v(P).x = 0, v(P).y = 2.2 m/s], 2: [x(P) = 0]}\n"
    with pytest.raises(FileProblem, match="no formula was found") as error:
        solved(tmp_path, text, "p: path(P), v: v(P).mag @ 2")
    (diagnostic,) = error.value.diagnostics
    assert diagnostic.code == "PL650"
    assert "start" not in (diagnostic.hint or "")


def test_a_throw_without_its_start_has_no_path(tmp_path: Path) -> None:
    text = "title: T\nplane: vertical\nbodies: {P: {particle: [0, 0], mass: any}}\n"
    with pytest.raises(FileProblem) as error:
        solved(tmp_path, text, "p: path(P)")
    assert error.value.diagnostics[0].code == "PL650"
    assert "states" in (error.value.diagnostics[0].hint or "")


def test_a_dated_state_is_told_as_an_instant() -> None:
    """Polar components with their numbers, and nothing in x and y that is called given."""
    text = """
        title: Slider on a telescoping arm
        bodies: {B: {particle: free}}
        motion:
          - r(B).mag = 0.2 m + 0.04 m/s^2 * t^2
          - r(B).angle = 0.2 rad/s * t + 0.02 rad/s^3 * t^3
        states: {then: [t = 3 s]}
        find: {v_theta: v(B).theta @ then, a_r: a(B).r @ then, a: a(B).mag @ then}
    """
    problem, wrong = load_text(dedent(text))
    assert problem is not None, wrong
    page = Terminal(width=110).render(narrate(solve_problem(problem)))
    assert "v_Bθ = r_B θ̇_B = 0.56 · 0.74 = 0.4144 m/s" in page
    assert "Values are those at t = 3 s" in page
    assert "v_Bx" not in page
    assert "STATE" not in page
