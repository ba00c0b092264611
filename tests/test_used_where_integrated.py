"""A page on which Newton's law is integrated in numbers rests on all masses: it gives them, and none is not used."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.cli import run

STRUCK = """
title: Dumbbell struck by a sphere
plane: horizontal
given: {L: 1.5 m, e: 0.75}
points: {A: [0, 0], B: [0, L], C: [0, 0]}
bodies:
  A: {particle: A, mass: 2 kg}
  B: {particle: B, mass: 2 kg}
  C: {particle: C, mass: 1 kg}
joints:
  - link: {between: [A, B], name: rod}
  - impact: {between: [C, A], normal: 0 deg, restitution: e, during: 1->2}
states:
  1: [A at rest, B at rest, v(C).x = 6 m/s, v(C).y = 0]
  2: [just after 1]
find: {v_A: v(A).x @ 2, v_B: v(B).x @ 2, v_C: v(C).x @ 2, omega: v(A/B).mag @ 2/L in rad/s, T: tension(rod) @ 2}
"""
FALLING = """
title: Rod with a wheel at one end slides down a wall
plane: vertical
given: {l: 1.2 m, r: 150 mm}
points: {C: [0, 0], B: [0, r], A: {from: B, distance: l, angle: 140 deg}}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies:
  wheel: {disk: B, radius: r, mass: 4 kg}
  AB: {rod: [A, B], mass: 12 kg}
joints:
  - pin: {at: B, between: [wheel, AB]}
  - rolling: {between: [wheel, floor], at: C}
  - guide: {point: A, along: 90 deg, name: wall}
states:
  1: [at rest]
  2: [y(A) = y(B)]
find: {omega: omega(AB) @ 2, v_A: v(A).y @ 2}
"""


@pytest.mark.parametrize(
    ("text", "masses"),
    [(STRUCK, ("m_A = 2 kg", "m_B = 2 kg", "m_C = 1 kg")), (FALLING, ("m_wheel = 4 kg", "m_AB = 12 kg"))],
)
def test_masses_are_given_and_none_is_called_unused(
    text: str, masses: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "one.yaml"
    path.write_text(text, encoding="utf-8")
    assert run(["solve", str(path)]) == 0
    told = " ".join(capsys.readouterr().out.split())
    if "integrated numerically" in told:
        assert "Not used" not in told
        assert all(m in told.partition("Find")[0] for m in masses)
