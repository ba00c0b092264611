"""States that are told by a mode alone: the first instant at which it is so, worked out like any other state."""

from __future__ import annotations

import pytest
import sympy as sp

from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution

HOOP = """
title: Hoop thrown along a rough floor
plane: vertical
symbols: {{m: kg, R: m, v_0: m/s, mu: 1}}
points: {{C: [0, 0], G: [0, R]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{hoop: {{ring: G, radius: R, mass: m}}}}
joints:
  - contact: {{between: [hoop, floor], at: C, mu: mu}}
states: {{start: [t = 0, v(hoop).x = v_0, v(hoop).y = 0, omega(hoop) = 0], rolls: [{rolls}]}}
find: {{t: t @ rolls, v: v(hoop).x @ rolls, d: x(hoop) @ rolls, F: friction(C).x @ rolls}}
"""
PARCEL = """
title: Parcel thrown against the run of a belt
plane: vertical
given: {{m: 3 kg, v_0: 3 m/s, u: 2 m/s, mu: 0.3}}
points: {{C: [0, 0]}}
surfaces: {{conveyor: {{through: C, angle: 0 deg, speed: u}}}}
bodies: {{parcel: {{particle: C, mass: m}}}}
joints:
  - contact: {{between: [parcel, conveyor], at: C, mu: mu}}
states: {{start: [t = 0, v(parcel).x = -v_0], turn: [v(parcel).x = 0], rides: [{rides}], back: [x(parcel) = 0]}}
find: {{t: t @ rides, back: t @ back, v: v(parcel).x @ rides}}
"""
DOME = """
title: Stone that leaves a dome
plane: vertical
given: {{R: 2 m, v_0: 2 m/s, m: 1 kg}}
points: {{O: [0, 0], P: [0, R]}}
surfaces: {{dome: {{center: O, radius: R}}}}
bodies: {{stone: {{particle: P, mass: m}}}}
joints:
  - contact: {{between: [stone, dome], at: P, mu: 0}}
states: {{push: [v(stone).x = v_0], leaves: [{leaves}], lands: [y(stone) = 0]}}
find: {{y: y(stone) @ leaves, v: v(stone).mag @ leaves, x: x(stone) @ lands}}
"""
THREAD = """
title: Bob on a thread that goes slack
plane: vertical
given: {{m: 0.3 kg, l: 0.8 m, v_0: 6 m/s}}
points: {{O: [0, 0], P: [0, -l]}}
bodies: {{bob: {{particle: P, mass: m}}}}
joints:
  - rope: {{path: [O, P], name: thread}}
states: {{1: [t = 0, v(P).x = v_0], 2: [{slack}]}}
find: {{y: y(P) @ 2, v: v(P).mag @ 2}}
"""
BOB = """
title: Bob on a thread that goes slack, in letters
plane: vertical
symbols: {m: kg, l: m, v_0: m/s}
assume: [v_0^2 > 2*g*l, v_0^2 < 5*g*l]
points: {O: [0, 0], P: [0, -l]}
bodies: {bob: {particle: P, mass: m}}
joints:
  - rope: {path: [O, P], name: thread}
states: {start: [t = 0, v(bob).x = v_0, v(bob).y = 0], slack: [mode(thread) = slack]}
find: {y: y(bob) @ slack}
"""
CRATE = """
title: Crate that a growing force sets in motion
plane: vertical
given: {{m: 10 kg, mu_s: 0.4, mu_k: 0.3}}
points: {{C: [0, 0]}}
surfaces: {{floor: {{through: C, angle: 0 deg}}}}
bodies: {{crate: {{particle: C, mass: m}}}}
joints:
  - contact: {{between: [crate, floor], at: C, mu_s: mu_s, mu_k: mu_k}}
loads:
  - force: {{body: crate, magnitude: 20 N/s * t, angle: 0 deg}}
states: {{1: [t = 0, at rest], moves: [{moves}], later: [t = 3 s]}}
find: {{t: t @ moves, v: v(crate).x @ later}}
"""


@pytest.mark.parametrize(
    ("text", "mode", "equation"),
    [
        (HOOP, {"rolls": "mode(C) = stick"}, {"rolls": "v(hoop).x = -omega(hoop)*R"}),
        (PARCEL, {"rides": "mode(C) = stick"}, {"rides": "v(parcel).x = u"}),
        (DOME, {"leaves": "mode(P) = apart"}, {"leaves": "N(P) = 0"}),
        (THREAD, {"slack": "mode(thread) = slack"}, {"slack": "tension(thread) = 0"}),
        (CRATE, {"moves": "mode(C) = slip"}, {"moves": "friction(C).x = -mu_s*m*g"}),
    ],
    ids=["sticks", "sticks-to-a-belt", "apart", "slack", "slips"],
)
def test_a_mode_tells_the_same_instant_as_its_equation(
    text: str, mode: dict[str, str], equation: dict[str, str]
) -> None:
    by_mode, by_equation = _part(text.format(**mode)), _part(text.format(**equation))
    assert by_mode.followed is None
    assert by_mode.motion is not None
    for one, other in zip(by_mode.found, by_equation.found, strict=True):
        assert one.expressions == other.expressions
        if other.values is not None:
            assert [float(v) for v in one.values or ()] == pytest.approx([float(v) for v in other.values], rel=1e-12)


def test_where_a_thread_goes_slack_in_letters() -> None:
    """By energy and along the thread, two equations in v² and sin φ, both linear."""
    part = _part(BOB)
    assert part.found[0].expressions is not None
    (y,) = part.found[0].expressions
    length, v, g = (next(s for s in y.free_symbols if s.name == name) for name in ("l", "v_0", "g"))
    assert sp.simplify(y - (v**2 - 2 * g * length) / (3 * g)) == 0


def _part(text: str) -> PartSolution:
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    (part,) = solve_problem(problem).parts
    return part
