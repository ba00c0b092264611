"""Small oscillations: the scene shows the equilibrium and, dashed, where the body swings to, with the angle that the
page counts; the diagrams are drawn turned from the equilibrium, as their sums are written.
"""

from __future__ import annotations

import math

import pytest
from test_figures_bodies import drawings

from planar_cli.figures.illustrated import figures_of, illustrated
from planar_cli.problem.structure import load_text
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Angle, Arrow, Coil, Figure, Polyline, Symbol, Tag
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

LEVER = """
title: Lever on a spring
text: A lever OA of 0.5 m and 2 kg stands upright on a hinge; a spring of 400 N/m holds its middle.
plane: vertical
given: {l: 0.5 m, m: 2 kg, k: 400 N/m}
coordinates: {phi: deg}
points:
  O: [0, 0]
  A: {from: O, distance: l, angle: 90 deg - phi}
  M: {midpoint: [O, A]}
  W: [-0.3 m, l/2]
bodies: {lever: {rod: [O, A], mass: m, points: [M]}}
joints: [pin: {at: O, between: [ground, lever]}]
loads: [spring: {between: [W, M], stiffness: k, relaxed_at: [phi = 0]}]
states: {upright: [phi = 0 deg, equilibrium]}
find: {T: period(upright)}
"""


def figures(text: str) -> dict[str, Figure]:
    problem, wrong = load_text(text, "scene.yaml")
    assert problem is not None, wrong
    solution = solve_problem(problem)
    return dict(figures_of(illustrated(narrate(solution), solution)))


def test_where_it_swings_to_is_dashed_with_its_angle_and_no_spring() -> None:
    marks = figures(LEVER)["scene"].panels[0].marks
    (bar,) = (m.places for m in marks if isinstance(m, Polyline) and m.style == "hidden")
    assert math.atan2(bar[1][1], bar[1][0]) == pytest.approx(math.pi / 2 - 0.25)
    (angle,) = (m for m in marks if isinstance(m, Angle))
    assert (angle.start, angle.sweep, angle.words) == (
        pytest.approx(math.pi / 2),
        pytest.approx(-0.25),
        line(Name("phi")),
    )
    assert len([m for m in marks if isinstance(m, Coil)]) == 1
    assert not [m for m in marks if isinstance(m, Tag) and "upright" in str(m.words)]


def test_the_diagram_is_turned_and_the_spring_pulls_as_its_letter_counts() -> None:
    for panel in figures(LEVER)["lever"].panels:
        (bar,) = (m.places for m in panel.marks if isinstance(m, Polyline))
        assert bar[-1][0] == pytest.approx(0.5 * math.sin(0.25), abs=1e-6)
    pulls = [m for m in figures(LEVER)["lever"].panels[0].marks if isinstance(m, Arrow) and math.cos(m.angle) < -0.9]
    assert len(pulls) == 1


def test_several_freedoms_are_seen_turned_too() -> None:
    marks = drawings("oscillations/bob-under-a-free-cart-in-letters")["scene"].panels[0].marks
    (angle,) = (m for m in marks if isinstance(m, Angle))
    assert abs(angle.sweep) == pytest.approx(0.25)
    bob = drawings("oscillations/bob-under-a-free-cart-in-letters")["bob"].panels[0].marks
    assert [m.angle for m in bob if isinstance(m, Arrow)][1] == pytest.approx(math.pi / 2 + 0.25)


def test_a_hoop_that_is_driven_does_not_swing() -> None:
    marks = drawings("oscillations/bead-on-a-turning-hoop")["scene-2"].panels[0].marks
    assert not [m for m in marks if isinstance(m, Polyline) and m.style == "hidden"]
    assert [m for m in marks if isinstance(m, Symbol) and m.kind == "place"]
