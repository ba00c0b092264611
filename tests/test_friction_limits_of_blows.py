"""Friction in a blow in letters: whether the points stick or slide at its end is told on the page, or in the file."""

from __future__ import annotations

from pathlib import Path

import pytest
from answered import solved

from planar_cli import cli

BALL = """\
plane: vertical
symbols: {{r: m, m: kg, e: 1, mu: 1, v_x: m/s, v_y: m/s}}
{assume}
points: {{C: [0, 0], G: [0, r]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{ball: {{sphere: G, radius: r, mass: m}}}}
joints:
  - impact: {{between: [ball, floor], restitution: e, mu: mu, during: 1->2}}
states:
  1: [v(ball).x = {sign}v_x, v(ball).y = -v_y, omega(ball) = 0]
  2: [just after 1]
find: {{v: v(ball).x @ 2, omega: omega(ball) @ 2}}
"""
SLIDES = "assume: [2*v_x > 7*mu*(1 + e)*v_y]"
STICKS = "assume: [2*v_x < 7*mu*(1 + e)*v_y]"
TOLD = {"r": 0.1, "m": 2.0, "e": 0.5, "mu": 0.3, "v_x": 4.0, "v_y": 3.0}


@pytest.mark.parametrize("sign", ["", "-"])
@pytest.mark.parametrize(("assume", "v", "omega"), [(STICKS, 20 / 7, -200 / 7), (SLIDES, 2.65, -33.75)])
def test_the_file_tells_which(tmp_path: Path, assume: str, v: float, omega: float, sign: str) -> None:
    """Sticking: 5 v_x/7 by the angular momentum about C; sliding: μ (1 + e) m v_y against the motion."""
    found = solved(tmp_path, BALL.format(assume=assume, sign=sign))
    for name, value in {"v": v, "omega": omega}.items():
        (expr,) = found[name].expressions or ()
        number = float(expr.subs({s: TOLD[s.name] for s in expr.free_symbols}))
        assert number == pytest.approx(-value if sign else value)


def test_what_the_file_leaves_open_stands_on_the_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """|J_F| < μ J_N, without the mass, which is positive."""
    file = tmp_path / "ball.yaml"
    file.write_text(BALL.format(assume="", sign=""))
    assert cli.run(["solve", str(file)]) == 0
    assert "Assume      e μ v_y + μ v_y > 2 v_x/7\n" in capsys.readouterr().out


NUMBERS = """\
plane: vertical
given: {r: 40 mm, m: 0.2 kg, e: 0.75, mu: 0.6}
points: {C: [0, 0], G: [0, r]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {ball: {sphere: G, radius: r, mass: m}}
joints:
  - impact: {between: [ball, floor], restitution: e, mu: mu, during: 1->2, name: bounce}
states:
  1: [v(ball).x = 6 m/s, v(ball).y = -4 m/s, omega(ball) = 0]
  2: [just after 1]
find: {omega: omega(ball) @ 2, J: impulse(bounce).x @ 1->2}
"""


def test_the_friction_impulse_against_its_limit(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "problem.yaml"
    file.write_text("title: Ball on a rough floor\n" + NUMBERS, encoding="utf-8")
    assert cli.run(["solve", str(file)]) == 0
    assert "|J_F| = 0.3429 N·s ≤ μ J_N = 0.84 N·s" in " ".join(capsys.readouterr().out.split())
