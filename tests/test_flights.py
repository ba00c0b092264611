"""A throw is told as functions of the time once; each state puts its own time in. What is asked first comes first."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate


def _page(name: str) -> str:
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / f"{name}.yaml")[0]))
    return " ".join(page.split())


FUNCTIONS = "(1) v_x = v_x,launch (2) x = v_x,launch t (3) v_y = v_y,launch - g t (4) y = v_y,launch t - 1/2 g t²"


def test_functions_once_then_the_states_in_the_order_asked() -> None:
    page = _page("textbook/ex-1-11")
    assert FUNCTIONS in page
    assert page.count("constant acceleration:") == 1
    assert "(2), (4) in (5): v_y,launch t_B - 1/2 g t_B² = -3/4 v_x,launch t_B" in page
    assert page.index("At B, y = -3/4 x:") < page.index("At parallel, v_y = -3/4 v_x:")
    # The time is known there: no second law of the same motion.
    assert "(4): y_parallel = v_y,launch t_parallel - 1/2 g t_parallel²" in page
    assert "v_y,parallel²" not in page


@pytest.mark.parametrize(
    "line",
    [
        "At ground: (3): 0 = h + v_y,nozzle t_ground - 1/2 g t_ground² (3): t_ground =",
        "(2): x_ground = v_x,nozzle t_ground = 10.324 · 3.072 = 31.72 m",
    ],
)
def test_a_quadratic_equation_is_written_before_its_root(line: str) -> None:
    assert line in _page("motion/hose-over-a-wall")


def test_a_constant_velocity_needs_no_momentum_beside_the_place() -> None:
    page = _page("motion/ball-through-a-window")
    assert "(1): v_x,wall = v_x,throw = 11.57 m/s" in page
    assert "conservation of momentum" not in page
