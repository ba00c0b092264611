"""Problem files that are written out in a test, solved within a limit of time."""

from __future__ import annotations

import random
from decimal import Decimal
from pathlib import Path

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import FileProblem
from planar_cli.homework.checking.checking import read
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solution import Found

Answers = dict[str, Found]

FOUR_BAR = """
title: Four-bar linkage
points:
  A: [0, 0]
  D: [0.6 m, 0]
  B: {{from: A, distance: 0.2 m, angle: 60 deg}}
  C: {{distances: {{B: 0.5 m, D: 0.4 m}}, side: {side}}}
bodies: {{AB: {{rod: [A, B]}}, BC: {{rod: [B, C]}}, DC: {{rod: [D, C]}}}}
joints:
  - pin: {{at: A, between: [ground, AB]}}
  - pin: {{at: B, between: [AB, BC]}}
  - pin: {{at: C, between: [BC, DC]}}
  - pin: {{at: D, between: [ground, DC]}}
"""

BARS_IN_A_LOOP = """
title: Three bars in a loop with the ground
plane: vertical
points: {{A: {A}, B: {B}, C: {C}, D: {D}}}
bodies:
  AB: {{rod: [A, B], mass: 1 kg}}
  BC: {{rod: [B, C], mass: {mass}}}
  CD: {{rod: [C, D], mass: 1 kg}}
joints:
  - pin: {{at: A, between: [ground, AB]}}
  - pin: {{at: B, between: [AB, BC]}}
  - pin: {{at: C, between: [BC, CD]}}
  - pin: {{at: D, between: [CD, ground]}}
"""

CORD = """
title: Stone on an elastic cord
plane: vertical
points: {O: [0, 0]}
bodies: {stone: {particle: [0, -1 m], mass: 2 kg}}
joints:
  - guide: {point: stone, along: 90 deg}
loads:
  - spring: {between: [O, stone], stiffness: 200 N/m, natural_length: 2 m, acts: pull}
states: {0: [t = 0, at rest], lowest: [v(stone).y = 0, y(stone) < -2 m]}
find: {y: y(stone) @ lowest, t: t @ lowest}
"""

BUFFER = """
title: Block that runs into a spring
plane: horizontal
points: {P: [0, 0], W: [2 m, 0]}
bodies: {block: {particle: P, mass: 2 kg}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [P, W], stiffness: 800 N/m, natural_length: 0.8 m, acts: push, name: buffer}
states: {0: [t = 0, v(P).x = 3 m/s], deepest: [v(P).x = 0], back: [x(P) = 0]}
find: {x: x(P) @ deepest, t_1: t @ deepest, v: v(P).x @ back, t_2: t @ back}
"""

LEVEL_ROD = """\
title: Rod let go level
plane: vertical
points: {O: [0, 0], A: [1 m, 0]}
bodies: {rod: {rod: [O, A], mass: 2 kg}}
joints:
  - pin: {at: O, between: [ground, rod]}
"""

HELD_ROD = """
title: Rod let go
plane: vertical
given: {m: 2 kg, l: 3 m}
points: {O: [0, 0], A: [l, 0]}
bodies: {rod: {rod: [O, A], mass: m}}
joints:
  - pin: {at: O, between: [ground, rod]}
instant: [at rest]
"""

BRAKED = """
title: Disk that is braked
plane: vertical
given: {m: 4 kg, R: 0.5 m}
points: {O: [0, 0]}
bodies: {disk: {disk: O, radius: R, mass: m}}
joints:
  - pin: {at: O, between: [ground, disk]}
loads:
  - torque: {body: disk, moment: -1 N*m, name: brake}
states:
  1: [t = 0, omega(disk) = 10 rad/s]
  2: [t = 2 s]
"""

GUN = """
title: A ball from a tube
plane: vertical
given: {m: 0.2 kg, s: 120 mm, k: 1.6 kN/m, beta: 55 deg, h: 3 m, l_0: 300 mm}
points:
  O: {from: Q, distance: l_0, angle: beta + 180 deg}
  Q: [0, 0]
  P: {from: Q, distance: s, angle: beta + 180 deg}
bodies: {ball: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: beta, during: 1->2}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: l_0, during: 1->2}
states: {1: [at rest], 2: [y(ball) = 0], 3: [y(ball) = h]}
find: {v_0: v(ball).mag @ 2, t_f: t @ 3 - t @ 2, x_f: x(ball) @ 3}
"""


def solve(text: str) -> Answers:
    """All finds of a file, by name; what keeps it from being solved is raised."""
    problem, wrong = load_text(text)
    if wrong or problem is None:
        raise FileProblem(wrong)
    return {f.name: f for part in solve_problem(problem).parts for f in part.found}


def solved(tmp_path: Path, text: str) -> Answers:
    """All finds of a text that is read from a file."""
    file = tmp_path / "problem.yaml"
    file.write_text(text, encoding="utf-8")
    return {f.name: f for part in solve_problem(read(str(file))).parts for f in part.found}


def first(found: Found) -> float:
    """The first number of a find, in SI units."""
    assert found.values is not None
    return float(found.values[0])


def number(found: Found) -> Decimal:
    """The only number of a find, in SI units."""
    assert found.values is not None, f"{found.name} has no value but {found.expressions or found.word}"
    (value,) = found.values
    return value


def assert_close(found: Found, truth: Decimal | float | str, digits: int = 12) -> None:
    """A find with this value, to so many digits of its size (or of 1, if it is smaller than a thousandth)."""
    value, want = number(found), Decimal(truth)
    scale = max(abs(want), Decimal("1e-3"))
    assert abs(value - want) <= Decimal(10) ** -digits * scale, f"{found.name} = {value}, and not {want}"


def somewhere(expr: sp.Expr, back: dict[str, str], numbers: dict[str, Decimal], draw: random.Random) -> Decimal:
    """The value of a formula with numbers by name, drawn where there are none; `back`: names that stand for others."""
    named = {s: back.get(s.name, s.name) for s in expr.free_symbols}
    for name in sorted(named.values()):
        numbers.setdefault(name, Decimal(draw.randrange(300, 3000)) / 1000)
    return Valuation({s: numbers[name] for s, name in named.items()})(expr)
