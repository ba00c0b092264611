"""Pages of letters: every answer has a line that ends with its formula in the letters of the file."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.report.blocks import Equation, Math
from planar_cli.report.narrate import narrate, phrases_of
from planar_cli.report.notation import plain


@pytest.mark.parametrize("name", ["impact/billiard-ball", "motion/throw-up-a-slope", "motion/pendulum-from-rest"])
def test_every_answer_ends_a_line(name: str) -> None:
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    lines = [b.sides for b in narrate(solution).blocks if isinstance(b, Equation)]
    ends = {plain(sides[-1].expr) for sides in lines if isinstance(sides[-1], Math)}
    for part in solution.parts:
        phrases = phrases_of(part.instants[-1], 4)
        asked = [f for f in part.found if f.kind == "number" and f.values is None and f.expressions]
        assert asked
        assert not [f.name for f in asked if plain(phrases.neat(f.expressions[0])) not in ends]


def test_an_equation_is_not_its_own_solution() -> None:
    """v = μ g t was printed for t: the formula of v in the letters of the file stands where v is found."""
    solution, _ = worked(ROOT / "problems/momentum/spinning-wheel-set-down.yaml")
    lines = [b for b in narrate(solution).blocks if isinstance(b, Equation)]
    closed = [
        b for b in lines if len(b.sides) > 2 and isinstance(b.sides[0], Math) and plain(b.sides[0].expr) == "v_G,2"
    ]
    assert [b.number for b in closed] == [None]
