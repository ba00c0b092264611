"""Problems in letters solved with numbers: coefficients are below one, and a case without a solution is left out."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.homework.variants.numbered import numbered
from planar_cli.homework.variants.worked_problem import read_and_solve

IMPACT = Path(__file__).parents[1] / "problems" / "impact"


@pytest.mark.parametrize("name", ["central-impact-in-letters", "level-rod-caught-by-an-edge"])
def test_blows_in_letters_have_numbers(name: str) -> None:
    problem = read_and_solve(str(IMPACT / f"{name}.yaml"), "p")
    found = numbered(problem)
    assert found is not None
    assert all(part.replay is not None for part in found.problem.parts)
    assert found.places
    assert all(0 < place["e"] < 1 for place in found.places)
