"""A particle on a circle is on the side on which it presses; the page says which, and a disk leaves it no choice."""

from __future__ import annotations

from pathlib import Path

import pytest
from answered import solve

from planar_cli.cli import run

DOME = """
title: Block sent over a dome
plane: vertical
given: {R: 5 m, v_0: 7.1 m/s}
points: {O: [0, 0], P: [0, R]}
surfaces: {dome: {center: O, radius: R}}
bodies: {block: {particle: P, mass: any}}
joints:
  - contact: {between: [block, dome], at: P, mu: 0, name: touch}
states:
  top: [t = 0, v(block).x = v_0]
  ground: [y(block) = 0]
find: {x: x(block) @ ground}
"""
DISK = DOME.replace("surfaces: {dome: {center: O, radius: R}}", "").replace(
    "mass: any}}\njoints:",
    "mass: any}, dome: {disk: O, radius: R}}\njoints:\n  - weld: {at: O, between: [ground, dome], name: fixed}",
)


@pytest.mark.parametrize(("speed", "side"), [("7.1", "inside"), ("3", "outside")])
def test_the_side_on_which_it_presses_is_told(
    speed: str, side: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "problem.yaml"
    path.write_text(DOME.replace("7.1", speed), encoding="utf-8")
    assert run(["solve", str(path)]) == 0
    assert f"block at P stays in contact, {side} dome\n" in capsys.readouterr().out


def test_a_disk_has_only_an_outside() -> None:
    x = solve(DISK)["x"]
    assert float(x.values[0]) == pytest.approx(7.1 * (10 / 9.81) ** 0.5)
