"""A friction force of fixed limit acts as long as bodies touch, also where nothing presses them together."""

from __future__ import annotations

import pytest
from answered import first, solve

POST = """
title: Post gripped by the ground
plane: vertical
points: {{P: [0, 0]}}
surfaces: {{soil: {{through: P, angle: 90 deg}}}}
bodies: {{post: {{particle: P, mass: 140 kg}}}}
joints:
  - contact: {{between: [post, soil], friction: 7000 N, name: grip}}
loads:
  - force: {{body: post, magnitude: {push} N, angle: -90 deg}}
instant: [at rest]
find: {{a: a(post).y, m: mode(grip)}}
"""
DRIVEN = """
title: Post driven into the ground
plane: vertical
unknowns: {R: N}
points: {P: [0, 0]}
surfaces: {soil: {through: P, angle: 90 deg}}
bodies: {post: {particle: P, mass: 140 kg}}
joints:
  - contact: {between: [post, soil], friction: R, name: grip}
states:
  1: [v(post).y = -4 m/s]
  2: [y(post) = -0.11 m, v(post).y = 0]
find: {R: R}
"""


@pytest.mark.parametrize(("push", "mode", "a"), [(5000, "stick", 0.0), (10000, "slip", -(10000 - 7000) / 140 - 9.81)])
def test_nothing_lifts_off_where_nothing_presses(push: int, mode: str, a: float) -> None:
    found = solve(POST.format(push=push))
    assert found["m"].word == mode
    assert first(found["a"]) == pytest.approx(a)


def test_a_limit_that_is_sought_is_not_negative() -> None:
    # R d = m v²/2 + m g d
    assert first(solve(DRIVEN)["R"]) == pytest.approx(140 * (9.81 + 16 / 0.22))
