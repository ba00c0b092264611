"""Every answer of a motion is confirmed by following it, is said not to be compared, or is none."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from answered import solve

from planar_cli.cli import run
from planar_cli.equation.values.exact import Settled
from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.json_document import solution_data
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.solve import run as solving
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution, Solution

THROW = """
title: Stone thrown up
plane: vertical
bodies: {P: {particle: [0, 0], mass: 2 kg}}
states: {1: [t = 0, v(P).x = 1 m/s, v(P).y = 6 m/s], top: [y(P) is largest], 3: [t = 1 s]}
find: {h: y(P) @ top, v: v(P) @ 3, high: y(P) @ top > 1 m, p: momentum(P).x @ top}
"""
LETTERS = """
title: Stone thrown up in letters
plane: vertical
symbols: {u: m/s}
bodies: {P: {particle: [0, 0], mass: any}}
states: {1: [t = 0, v(P).x = 0, v(P).y = u], top: [y(P) is largest]}
find: {h: y(P) @ top, a: a(P).y}
"""
FAR = """
title: Particle that is repelled and runs away
coordinates: {x: m}
bodies: {p: {particle: [x, 0]}}
motion: ["ddot(x) = (1 m^3/s^2)/x^2"]
states: {1: [t = 0, x = 1 m, dot(x) = 0], 2: [x = 2 m], far: [x = infinity]}
find: {v: v(p).x @ 2, end: v(p).x @ far}
"""
HIT = """
title: Particles that collide
plane: horizontal
bodies: {A: {particle: [0, 0], mass: 2 kg}, B: {particle: [1 m, 0], mass: 3 kg}}
joints:
  - impact: {between: [A, B], name: hit}
states:
  1: [v(A).x = 5 m/s, v(A).y = 0, v(B).x = -1 m/s, v(B).y = 0]
  2: [just after 1, v(B).x = 2 m/s]
find: {u: v(A).x @ 2, J: impulse(hit/B).x @ 1->2, Q: heat(hit) @ 1->2}
"""


def solved(text: str) -> Solution:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return solve_problem(problem)


def off(name: str, change: Callable[[Found], Found]) -> Callable[..., PartSolution]:
    """What solves a part, with one of its answers changed."""
    solve = solving.solve_part

    def wrong(*given: Any) -> PartSolution:
        part = solve(*given)
        return replace(part, found=tuple(change(f) if f.name == name else f for f in part.found))

    return wrong


def larger(found: Found) -> Found:
    """By one part in ten thousand."""
    assert found.values is not None
    return replace(found, values=tuple(Settled(v * Decimal("1.0001")) for v in found.values))


def test_all_answers_of_a_motion_agree() -> None:
    part = solved(THROW).parts[0]
    assert part.confirmed.finds == {"h", "v", "high", "p"}
    assert not part.confirmed.apart


@pytest.mark.parametrize("name", ["h", "v", "p"])
def test_a_wrong_number_is_refused(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(solving, "solve_part", off(name, larger))
    with pytest.raises(
        Disagreement, match=f"{name} is not confirmed: solved .*, in the motion followed .* at t = "
    ) as e:
        solved(THROW)
    assert [d.code for d in e.value.diagnostics] == ["PL720"]


def test_a_wrong_truth_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(solving, "solve_part", off("high", lambda f: replace(f, word="false")))
    with pytest.raises(Disagreement, match=r"high is not confirmed: solved false, .* true"):
        solved(THROW)


@pytest.mark.parametrize("name", ["h", "a"])
def test_a_wrong_formula_is_refused(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever numbers are drawn for its letters."""
    assert solved(LETTERS).parts[0].confirmed.finds == {"h", "a"}

    def change(f: Found) -> Found:
        assert f.expressions
        values = None if f.values is None else tuple(Settled(v * Decimal("1.0001")) for v in f.values)
        return replace(f, values=values, expressions=tuple(e * sp.Rational(10001, 10000) for e in f.expressions))

    monkeypatch.setattr(solving, "solve_part", off(name, change))
    with pytest.raises(Disagreement, match=f"{name} is not confirmed"):
        solved(LETTERS)


def test_a_state_that_is_not_reached_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The solution says when; the motion that is followed does not come there."""
    problem, _ = load_text(THROW.replace("top: [y(P) is largest]", "top: [y(P) = 1.5 m]"))
    other, _ = load_text(THROW.replace("top: [y(P) is largest]", "top: [y(P) = 2.5 m]"))
    assert problem is not None
    assert other is not None
    part = solving.solve_part(problem, "", {}, {})
    with pytest.raises(Disagreement, match=r"h is not confirmed: solved reached at t = .*not reached \(state top\)"):
        solving._confirmed(other, part, {})


def test_a_refusal_has_its_status_and_its_data(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "throw.yaml"
    path.write_text(THROW.lstrip())
    monkeypatch.setattr(solving, "solve_part", off("h", larger))
    assert run(["solve", str(path), "--format", "json"]) == 3
    told = capsys.readouterr()
    data = json.loads(told.out)
    assert data["outcome"] == "undecided"
    assert data["answers"] == {}
    assert data["diagnostics"][0]["code"] == "PL720"
    assert "h is not confirmed: solved 1.83" in told.err


def test_what_is_only_approached_is_not_compared() -> None:
    solution = solved(FAR)
    data = solution_data(solution, (), 4, None)
    assert data["answers"]["v"]["confirmed"] is True
    assert data["answers"]["end"]["confirmed"] is False
    assert data["answers"]["end"]["unconfirmed"] == "state far is only approached"
    assert data["unconfirmed"] == 1
    page = " ".join(Terminal().render(narrate(solution, Voice(verbose=True))).split())
    assert "not compared: end (state far is only approached)" in page
    page = " ".join(Terminal().render(narrate(solution)).split())
    assert "all but end checked by an independent multibody solution" in page


def test_a_restitution_that_a_velocity_tells() -> None:
    """It is all that is taken from the solution: (2 - u)/6 with 2 u + 6 = 7."""
    assert solved(HIT).parts[0].confirmed.finds == {"u", "J", "Q"}


SWING = """
title: Pendulum in letters
plane: vertical
symbols: {l: m}
coordinates: {theta: rad}
points: {O: [0, 0], P: {from: O, distance: l, angle: theta - 90 deg}}
bodies: {bob: {particle: P, mass: any}}
joints: [link: {between: [O, P]}]
states: {1: [equilibrium, theta = 0]}
find: {T: period(1)}
"""


def test_what_belongs_to_no_motion_is_not_compared() -> None:
    part = solved(SWING).parts[0]
    assert part.confirmed.apart == {"T": "small oscillations are about an equilibrium, not along a motion"}


EMBEDDED = """
title: A bullet in a block that slides to rest
plane: vertical
given: {m: 20 g, M: 2 kg, v: 400 m/s, mu: 0.35}
points: {P: [0, 0]}
surfaces: {floor: {through: P, angle: 0}}
bodies: {bullet: {particle: P, mass: m}, block: {particle: P, mass: M}}
joints:
  - contact: {between: [block, floor], mu: mu}
  - weld: {at: P, between: [bullet, block], during: before->stop}
states:
  before: [t = 0, v(bullet).x = v, block at rest]
  after: [just after before]
  stop: [v(block).x = 0]
find: {v: v(block).x @ after}
"""


def test_answers_that_rest_on_a_velocity_that_is_not_told_are_none() -> None:
    """With an upward velocity of the bullet the floor could hold the block: then it would not slide at all."""
    with pytest.raises(NoSolution) as caught:
        solve(EMBEDDED)
    (told,) = caught.value.diagnostics
    assert (told.code, told.mark.line) == ("PL704", 12)
    assert "`v(bullet).y = …`" in told.hint
    found = solve(EMBEDDED.replace("v(bullet).x = v,", "v(bullet).x = v, v(bullet).y = 0,"))
    assert float(found["v"].values[0]) == pytest.approx(400 * 0.02 / 2.02)


CASES = """
title: An unknown of another case
plane: vertical
unknowns: {F: N}
bodies: {b: {particle: [0, 0], mass: 2 kg}}
cases:
  falls:
    states: {0: [t = 0, at rest], 1: [t = 2 s]}
    find: {v: v(b).y @ 1}
  lifted:
    loads:
      - force: {body: b, magnitude: F, angle: 90 deg}
    states: {0: [t = 0, at rest], 1: [t = 2 s, y(b) = 3 m]}
    find: {F: F}
"""


def test_an_unknown_of_another_case_keeps_nothing_from_being_compared() -> None:
    assert [sorted(part.confirmed.finds) for part in solved(CASES).parts] == [["v"], ["F"]]
