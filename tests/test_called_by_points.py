"""A joint that does not say where it touches may be called by the point that alone can be meant."""

from __future__ import annotations

import pytest
from answered import assert_close, solve

from planar_cli.problem.structure import load_text

WHEEL = """
title: Wheel pushed at its centre
plane: vertical
points: {C: [0, 0], G: [0, 0.3 m]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {w: {disk: G, radius: 0.3 m, mass: 5 kg}}
joints:
  - rolling: {between: [w, floor]}
loads:
  - force: {body: w, at: G, magnitude: 20 N, angle: 0 deg}
instant: [at rest]
find: {value: friction(C).x}
"""

BLOCK = """
title: Block thrown up a rough slope
plane: vertical
points: {A: [0, 0]}
surfaces: {slope: {through: A, angle: 20 deg}}
bodies: {b: {particle: A, mass: 5 kg}}
joints:
  - contact: {between: [b, slope], mu: 0.3}
instant: [v(b).along(20 deg) > 0]
find: {value: N(A)}
"""


@pytest.mark.parametrize(
    ("text", "value"),
    [
        (WHEEL, -20 / 3),
        (WHEEL.replace("friction(C)", "friction(w)"), -20 / 3),
        (BLOCK, 46.0920),
        (BLOCK.replace("N(A)", "N(b)"), 46.0920),
    ],
)
def test_value(text: str, value: float) -> None:
    assert_close(solve(text)["value"], value, 5)


def test_a_rim_touches_where_it_is_said_to() -> None:
    _, diagnostics = load_text(WHEEL.replace("G: [0, 0.3 m]", "G: [0.1 m, 0.3 m], E: [0.2 m, 0]").replace("(C)", "(E)"))
    assert [d.code for d in diagnostics] == ["PL420"]


def test_two_that_may_be_meant() -> None:
    two = WHEEL.replace("points: {", "points: {H: [1 m, 0.3 m], ").replace(
        "bodies: {", "bodies: {u: {disk: H, radius: 0.3 m, mass: 2 kg}, "
    )
    _, diagnostics = load_text(two.replace("joints:\n", "joints:\n  - rolling: {between: [u, floor]}\n"))
    assert [d.code for d in diagnostics] == ["PL420"]
