"""The other assembly of a linkage, carried out from the equations of the one that is drawn: as if the file drew it."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import graded, homework_of, mistakes_of, set_of

from planar_cli.homework.variants.worked_problem import base_expected, read_and_solve

FOUR_BAR = """
points:
  A: [0, 0]
  D: [0.55 m, 0]
  B: {from: A, distance: 0.15 m, angle: 70 deg}
  C: {distances: {B: 0.45 m, D: 0.4 m}, side: above}
  E: {midpoint: [B, C]}
bodies: {AB: {rod: [A, B]}, BC: {rod: [B, C], points: [E]}, DC: {rod: [D, C]}}
joints:
  - pin: {at: A, between: [ground, AB]}
  - pin: {at: B, between: [AB, BC]}
  - pin: {at: C, between: [BC, DC]}
  - pin: {at: D, between: [ground, DC]}
motion: [omega(AB) = 9 rad/s]
find: {omega_DC: omega(DC), alpha_BC: alpha(BC), v_E: v(E), a_C: a(C).mag}
"""
PUMP = """
given: {r: 70 mm, l: 210 mm, e: 25 mm, m: 0.6 kg, F: 90 N}
plane: horizontal
points:
  O: [0, 0]
  A: {from: O, distance: r, angle: 40 deg}
  B: {y: -e, distances: {A: l}, side: right}
bodies: {crank: {rod: [O, A]}, AB: {rod: [A, B]}, piston: {particle: B, mass: m}}
joints:
  - pin: {at: O, between: [ground, crank]}
  - pin: {at: A, between: [crank, AB]}
  - pin: {at: B, between: [AB, piston]}
  - guide: {body: piston, along: 0 deg}
loads:
  - force: {body: piston, magnitude: F, angle: 180 deg}
  - torque: {body: crank, moment: M}
unknowns: {M: N*m}
motion: [omega(crank) = 20 rad/s]
find: {M: M, v_B: v(piston).x, a_B: a(piston).x}
"""


@pytest.mark.parametrize(
    ("text", "drawn", "other", "place"),
    [(FOUR_BAR, "side: above", "side: below", "C below"), (PUMP, "side: right", "side: left", "B on the left")],
)
def test_the_other_assembly_is_that_of_a_file_that_draws_it(
    tmp_path: Path, text: str, drawn: str, other: str, place: str
) -> None:
    mistakes = {e.find: [m for m in e.mistakes if m.name == "other-root"] for e in mistakes_of(tmp_path, text)}
    (tmp_path / "other.yaml").write_text(text.replace(drawn, other))
    right = {e.find: e for e in base_expected(read_and_solve(str(tmp_path / "other.yaml"), "other"))}
    assert right.keys() == mistakes.keys()
    for find, (one,) in mistakes.items():
        assert one.values == pytest.approx(right[find].values, rel=1e-9)
        assert one.feedback == f"this is the result for the other assembly, with {place}"


def test_it_is_named(tmp_path: Path) -> None:
    homework = homework_of(set_of(tmp_path, bars=FOUR_BAR))
    right = next(e for t in homework.papers[0].tasks for e in t.expected if e.find == "omega_DC")
    (wrong,) = (m for m in right.mistakes if m.name == "other-root")
    one = graded(homework, "bars.omega_DC", f"{wrong.values[0]:.5g} rad/s")
    assert one.mistakes == ("other-root",)
    assert "with C below" in one.feedback
