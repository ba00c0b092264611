"""A flight between two states of which no line tells when they are: by the time that it lasts."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

FILE = """\
title: Ball that bounces off a rough slope
plane: vertical
given: {m: 50 g, h: 1.2 m, beta: 25 deg, e: 0.7, mu: 0.2}
points: {O: [0, 0]}
surfaces: {slope: {through: O, angle: -beta}}
bodies: {ball: {particle: [0, h], mass: m}}
joints:
  - impact: {name: bounce, between: [ball, slope], restitution: e, mu: mu, during: 2->3}
states:
  1: [at rest]
  2: [y(ball) = 0]
  3: [just after 2]
  4: [y(ball) = -x(ball)*sin(beta)/cos(beta)]
find: {x_4: x(ball) @ 4, y_4: y(ball) @ 4}
"""


@pytest.mark.parametrize("said", [
    "(12), (13) in (11): v_x,3 Δt tan β + v_y,3 Δt = 1/2 g Δt² Δt = t_4 - t_3",
    "divided by Δt ≠ 0: Δt = 2 (v_x,3 tan β + v_y,3) / g = 2 (1.8044 tan 25° + 2.5552) / 9.81 = 0.6925 s",
    "(12): x_4 = v_x,3 Δt = 1.804 · 0.6925 = 1.249 m",
])  # fmt: skip
def test_the_time_of_a_flight_comes_before_its_places(said: str, tmp_path: Path) -> None:
    path = tmp_path / "flight.yaml"
    path.write_text(FILE, encoding="utf-8")
    assert said in " ".join(Terminal(100).render(narrate(solve_and_compare(read(str(path)))[0])).split())
