"""A joint that the file lets begin just after a blow takes hold in it, and the page says so."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

BULLET = Path(__file__).parent.parent / "problems/impact/bullet-stays-in-a-block.yaml"


@pytest.mark.parametrize("late", [True, False])
def test_a_weld_that_begins_just_after_the_blow(late: bool) -> None:
    text = BULLET.read_text(encoding="utf-8")
    problem, wrong = load_text(text.replace("before->stop", "after->stop") if late else text)
    assert problem is not None, wrong
    page = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    assert ("The weld at P takes hold in the blow, so that it acts from before on." in page) == late
    assert "u = v_P,after = 3.960 m/s" in page
