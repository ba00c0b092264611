"""Small oscillations by the linear equation that an earlier case had are not derived again."""

from __future__ import annotations

import unicodedata
from pathlib import Path

from answered import first
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

BAR = """
title: Bar on a table with a spring and a damper
plane: horizontal
given: {m: 2 kg, l: 0.5 m, h: 0.3 m, k: 300 N/m, c: 8 N*s/m}
coordinates: {theta: deg}
points:
  O: [0, 0]
  A: {from: O, distance: l, angle: theta}
  B: {from: O, distance: l/2, angle: theta}
  K: [l, -h]
  W: [l/2, -h]
bodies: {bar: {rod: [O, A], mass: m, points: [B]}}
joints:
  - pin: {at: O, between: [ground, bar]}
loads:
  - spring: {between: [K, A], stiffness: k, relaxed_at: [theta = 0 deg], name: coil}
  - damper: {between: [W, B], coefficient: c, name: dashpot}
cases:
  damped:
    states: {rest: [theta = 0 deg, equilibrium]}
    find: {T_d: period(rest)}
  undamped:
    given: {c: 0 N*s/m, k: 600 N/m}
    states: {rest: [theta = 0 deg, equilibrium]}
    find: {T_0: period(rest)}
"""


def _cases(solution: Solution) -> dict[str, str]:
    page = unicodedata.normalize("NFC", Terminal(200).render(narrate(solution)))
    cases = [case.partition("\n") for case in page.split("CASE  ")[1:]]
    return {name: " ".join(text.split()) for name, _, text in cases}


def test_what_is_zero_here_leaves_the_equation(tmp_path: Path) -> None:
    file = tmp_path / "bar.yaml"
    file.write_text(BAR, encoding="utf-8")
    solution = solve_problem(read(str(file)))
    cases = _cases(solution)
    assert "ΣM_O" in cases["damped"]
    assert "ΣM_O" not in cases["undamped"]
    told = "STEP 1 Small oscillations As in case damped, with c = 0: δ̈ + 3 k δ/m = 0 ω_0 = √(3 k/m) = √(3 · 600 / 2)"
    assert told in cases["undamped"]
    assert abs(first(solution.parts[1].found[0]) - 2 * 3.14159265 / 30) < 1e-6


def test_a_coordinate_that_is_zero_at_rest_is_the_deviation() -> None:
    cases = _cases(worked(ROOT / "problems/oscillations/bar-with-spring-and-damper.yaml")[0])
    small = "δ a small deviation from the equilibrium rest:"
    assert f"As in case light, with c = 0 and {small} δ̈ + 3 k δ/m = 0" in cases["undamped"]
    assert f"As in case light, with {small} δ̈ + 3 c δ̇/(4 m) + 3 k δ/m = 0" in cases["damped"]
    assert "As before: ω_0 = 14.14 rad/s, ζ = 0.1768, ω_d = 13.92 rad/s." in cases["damped"]
    assert "At 2: t_2 = 0.1265 s, θ̇_2 = -2.155 rad/s At 3: θ_3" in cases["light"]


def test_another_equation_is_derived() -> None:
    cases = _cases(worked(ROOT / "problems/oscillations/disk-held-by-a-spring.yaml")[0])
    assert not any("As in case" in text and "δ̈" in text for text in cases.values())
