"""Refusals where nothing holds say what the file means as it stands, and what to write for what may be meant."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load
from planar_cli.solve.run import solve_problem

DRUM = """title: A block in a drum that turns
plane: vertical
given: {R: 0.6 m, mu: 0.6}
unknowns: {n: rad/s}
points: {O: [0, 0], P: {from: O, distance: R, angle: -30 deg}}
surfaces: {wall: {center: O, radius: R, body: drum}}
bodies:
  drum: {ring: O, radius: R}
  block: {particle: P, mass: 0.5 kg}
joints:
  - pin: {at: O, between: [ground, drum]}
  - contact: {between: [block, wall], at: P, mu: mu, name: K}
motion: [omega(drum) = n]
instant: [mode(K) = stick, n is smallest, n > 0]
find: {n_min: n in rpm}
"""
ROAD = """title: A car in a banked curve
plane: vertical
given: {rho: 50 m, theta: 30 deg, mu: 0.2}
unknowns: {v: m/s}
points: {C: [0, 0]}
surfaces: {road: {through: C, angle: -theta}}
bodies: {car: {particle: C, mass: any}}
joints:
  - contact: {between: [car, road], mu: mu, name: tyres}
instant: [at rest, a(car).x = v^2/rho, a(car).y = 0, mode(tyres) = stick, v > 0, v is largest]
find: {v_max: v}
"""


def _refused(text: str, tmp_path: Path) -> tuple[str, str]:
    path = tmp_path / "file.yaml"
    path.write_text(text)
    with pytest.raises(NoSolution) as refused:
        solve_problem(load(str(path))[0])
    (told,) = refused.value.diagnostics
    assert told.code == "PL601"
    return told.message, told.hint or ""


def test_a_particle_on_a_ring_is_outside(tmp_path: Path) -> None:
    message, hint = _refused(DRUM.replace("[block, wall]", "[block, drum]"), tmp_path)
    assert "`block` is taken to lie outside of `drum`" in message
    assert "`surfaces: {wall: {center: O, radius: …, body: drum}}` and `between: [block, wall]`" in hint
    path = tmp_path / "inside.yaml"
    path.write_text(DRUM)
    (found,) = solve_problem(load(str(path))[0]).parts[0].found
    assert found.values is not None
    # By hand: mu N = m g cos 30 deg, and N = m n² R + m g sin 30 deg.
    assert float(found.values[0]) == pytest.approx((9.81 * (0.75**0.5 / 0.6 - 0.5) / 0.6) ** 0.5, rel=1e-6)


def test_what_does_not_slip_on_what_is_fixed_is_at_rest(tmp_path: Path) -> None:
    message, hint = _refused(ROAD, tmp_path)
    assert "`car` does not slip on `road`, which is fixed: it stays at rest" in message
    assert "`a(car).x = v^2/rho` is stated" in message
    assert "let a body carry `road`" in hint
