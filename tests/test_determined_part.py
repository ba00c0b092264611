"""A motion with a datum too few: roots are looked for only in the equations that the open letters leave alone."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from answered import solve

from planar_cli.errors import PlanarError
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.following import mode_search

SHOT = Path(__file__).parents[1] / "problems" / "impact" / "block-shot-along-a-carrier.yaml"
"""A bullet stays in a block on a rough carrier, which strikes a stop of the carrier."""


class Enough(BaseException):
    """So many modes have been looked at."""


def test_open_letters_do_not_multiply_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """The speed of the bullet is not told: each choice of modes took seconds."""
    took: list[float] = []
    candidates = mode_search.candidates

    def timed(course: MotionEquations) -> list[Branch]:
        if len(took) == 5:
            raise Enough
        begun = time.process_time()
        found = candidates(course)
        took.append(time.process_time() - begun)
        return found

    monkeypatch.setattr(mode_search, "candidates", timed)
    text = SHOT.read_text(encoding="utf-8").replace("v(bullet).x = v_0, ", "").replace(", v_0: 450 m/s", "")
    with pytest.raises((PlanarError, Enough)):
        solve(text)
    assert sum(took) < 2
