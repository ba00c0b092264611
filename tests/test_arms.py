"""Arms of wheels are their radii, and what rolls is told along the contact (equation/scene/arms.py)."""

from __future__ import annotations

import pytest

from planar_cli.errors import PlanarError
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

TRAIN = """\
plane: horizontal
given: {{b: 140 mm, r_S: {sun}, r_P: 60 mm, R: 200 mm}}
points: {{O: [0, 0], A: {{from: O, distance: b, angle: {angle}}}}}
surfaces: {{ring: {{center: O, radius: R}}}}
bodies:
  sun: {{disk: O, radius: r_S}}
  arm: {{rod: [O, A]}}
  planet: {{disk: A, radius: r_P}}
joints:
  - pin: {{at: O, between: [ground, sun, arm]}}
  - pin: {{at: A, between: [arm, planet]}}
  - rolling: {{between: [planet, sun]}}
  - rolling: {{between: [planet, ring], at: {{from: O, distance: R, angle: {angle}}}}}
instant: [omega(arm) = 2 rad/s]
find: {{w: omega(sun), w_P: omega(planet)}}
"""


def page(text: str) -> str:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return Terminal().render(narrate(solve_problem(problem)))


@pytest.mark.parametrize("angle", ["0 deg", "90 deg", "37 deg"])
def test_a_planet_is_told_by_its_radius_and_not_by_what_the_ring_leaves(angle: str) -> None:
    told = page(TRAIN.format(sun="80 mm", angle=angle))
    assert "b ω_arm" in told
    assert "r_S ω_sun" in told
    assert "r_P ω_planet" in told
    assert "R - b" not in told
    assert "b - r_P" not in told
    assert "both have the same velocity; along the contact" in told
    assert "planet rolls: at" in told


def test_lengths_that_do_not_fit_are_no_radii() -> None:
    """Where the drawing leaves a gap nothing rolls, and nothing is put in for a radius."""
    with pytest.raises(PlanarError):
        page(TRAIN.format(sun="79 mm", angle="0 deg"))
