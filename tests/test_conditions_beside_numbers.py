"""A decision that rests on letters is told with its condition, also where some of what it rests on has numbers."""

from __future__ import annotations

import pytest

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ROUND_A_PULLEY = """
title: Two blocks on a floor, with a rope from one round the other to a wall
plane: vertical
given: {m_A: 1 kg, m_B: 2 kg}
symbols: {F: N, mu: 1, d: m}
points: {A: [0, 0], B: [1 m, 0], W: [10 m, 0]}
surfaces: {floor: {through: A, angle: 0 deg}}
bodies: {one: {particle: A, mass: m_A}, two: {particle: B, mass: m_B}}
joints:
  - contact: {between: [one, floor], at: A, mu: mu}
  - contact: {between: [two, floor], at: B, mu: mu}
  - rope: {path: [B, A, W], along: 0 deg, name: rope}
loads:
  - force: {body: two, magnitude: F, angle: 0 deg}
states:
  1: [at rest]
  2: [x(two) = 1 m + d]
find: {v: v(one).x @ 2}
"""
ON_A_TABLE = """
title: Block on a table and a weight that hangs over its edge
plane: vertical
given: {M: 3 kg}
symbols: {m: kg, mu: 1, h: m}
points: {A: [-1 m, 0], C: [0, 0], B: [0, -1 m]}
surfaces: {table: {through: A, angle: 0 deg}}
bodies: {block: {particle: A, mass: M}, weight: {particle: B, mass: m}}
joints:
  - contact: {between: [block, table], at: A, mu: mu}
  - rope: {path: [A, over C, B], name: cord}
states:
  1: [at rest]
  2: [y(B) = -1 m - h]
find: {v: v(B).mag @ 2}
"""
STACKED = """
title: Block that is carried on a block which is pulled
plane: vertical
given: {m: 2 kg, M: 5 kg, h: 0.2 m}
symbols: {F: N, mu: 1, d: m}
assume: [F < 2*mu*(m + M)*g]
points: {A: [0, 0], B: [0, h]}
surfaces: {floor: {through: A, angle: 0 deg}, top: {through: B, angle: 0 deg, body: lower}}
bodies: {lower: {points: [A, B], center: A, mass: M}, upper: {particle: B, mass: m}}
joints:
  - guide: {body: lower, along: floor, mu: mu}
  - contact: {between: [upper, top], at: B, mu: mu}
loads:
  - force: {body: lower, at: A, magnitude: F, angle: 0 deg}
states:
  1: [at rest]
  2: [x(A) = d]
find: {v: v(lower).x @ 2}
"""


def _page(text: str) -> str:
    problem, wrong = load_text(text, "scene.yaml")
    assert problem is not None, wrong
    return " ".join(Terminal(width=200).render(narrate(solve_problem(problem))).split())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "masses", "told"),
    [
        # F x_B is the work of the force, of which friction takes μ m_A g x_B/2 and μ m_B g x_B.
        (ROUND_A_PULLEY, "m_A: 1 kg, m_B: 2 kg", ["Assume 2 F > μ (m_A + 2 m_B) g"]),
        (ON_A_TABLE, "M: 3 kg", ["Assume m > μ M"]),
        # It moves at all; that the friction which carries the upper block, m a, is within its limit is assumed.
        (STACKED, "m: 2 kg, M: 5 kg, ", ["Assume F < 2 μ (M + m) g F > μ (M + m) g"]),
    ],
)
def test_that_it_moves_at_all(text: str, masses: str, told: list[str]) -> None:
    letters = text.replace(masses, "").replace("given: {}\n", "")
    pairs = ", ".join(f"{name}: kg" for name in ("m_A", "m_B", "M", "m") if f"{name}: " in masses)
    letters = letters.replace("symbols: {", f"symbols: {{{pairs}, ")
    for page in (_page(text), _page(letters)):
        for condition in told:
            assert condition in page


def test_with_numbers_alone_nothing_is_assumed() -> None:
    numbers = ON_A_TABLE.replace("M: 3 kg", "M: 3 kg, m: 2 kg, mu: 0.2, h: 1 m")
    page = _page(numbers.replace("symbols: {m: kg, mu: 1, h: m}", ""))
    assert " > " not in page.split("STEP 1")[0]


@pytest.mark.slow
def test_a_window_that_few_draws_meet() -> None:
    """The force lies between that at which the blocks move and that at which the upper one slides, twice as large."""
    assert "v = v_A,2 = √(2 (F - μ (M + m) g) d / (M + m))" in _page(STACKED)


@pytest.mark.slow
def test_no_drawn_number_leaves_the_program() -> None:
    text = ON_A_TABLE.replace("find:", "assume: [m < mu*M]\nfind:")
    problem, wrong = load_text(text, "scene.yaml")
    assert problem is not None, wrong
    with pytest.raises(NoSolution) as error:
        solve_problem(problem)
    (told,) = error.value.diagnostics
    assert told.code == "PL621"
    assert told.hint.endswith("does the motion get there; say under `assume` for which letters it does")


ON_A_SLOPE = """
title: Block on a slope that is drawn up by a weight
plane: vertical
given: {m_A: 4 kg, beta: 30 deg}
symbols: {m_B: kg, mu: 1, h: m}
points: {Q: [0, 0], A: {from: Q, distance: 1 m, angle: 180 deg + beta}, B: [0, -1 m]}
surfaces: {slope: {through: A, angle: beta}}
bodies: {block: {particle: A, mass: m_A}, weight: {particle: B, mass: m_B}}
joints:
  - contact: {between: [block, slope], at: A, mu: mu}
  - rope: {path: [A, Q, B], name: cord}
states:
  1: [at rest]
  2: [y(B) = -1 m - h]
find: {v: v(B).mag @ 2}
"""


def test_a_condition_once() -> None:
    """In letters, and not with cos 30° = √3/2 again."""
    page = _page(ON_A_SLOPE)
    assert "Assume m_B > μ m_A cos β + m_A sin β block at A slips" in page
