"""The point that a carried surface names moves with its body, whether the body lists it or not."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest

from planar_cli.cli import run

BOWL = """
title: Ball slides down a quarter circle cut in a free cart
plane: vertical
given: {m: 2 kg, M: 6 kg, R: 0.5 m}
points: {O: [0, R], P: [-R, R], C: [0, -R]}
surfaces: {bowl: {center: O, radius: R, body: cart}}
bodies:
  cart: CART
  ball: {particle: P, mass: m}
joints:
  - guide: {body: cart, along: 0 deg, name: rails}
  - contact: {between: [ball, bowl], mu: 0}
states:
  1: [at rest]
  2: [x(ball) - x(cart) = 0]
find: {v_cart: v(cart).x @ 2, v_ball: v(ball).x @ 2}
"""


@pytest.mark.parametrize(
    "cart",
    [
        "{particle: C, mass: M}",
        "{particle: C, points: [O], mass: M}",
        "{points: [C], center: C, mass: M, inertia: any}",
        "{points: [O], center: C, mass: M}",
    ],
)
def test_a_bowl_moves_with_the_cart_in_which_it_is_cut(
    cart: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "problem.yaml"
    path.write_text(BOWL.replace("CART", cart), encoding="utf-8")
    assert run(["solve", str(path)]) == 0
    page = re.sub(r"\s+", " ", capsys.readouterr().out)
    # M V + m v = 0 and m g R = M V²/2 + m v²/2.
    cart_speed = 2 * math.sqrt(2 * 9.81 * 0.5 / (6 * 8))
    assert f"v_C,2 = -{cart_speed:.4f} m/s" in page
    assert f"v_ball = {3 * cart_speed:.3f} m/s" in page
