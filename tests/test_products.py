"""A law that is linear in its speed is told as the derivative of a product, whose integral follows at once."""

from __future__ import annotations

from pathlib import Path

import pytest

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.narrate import narrate
from planar_cli.solve.run import solve_problem

PROBLEMS = Path(__file__).parent.parent / "problems"


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        (
            "momentum/sand-wagon",
            [
                "d[(M + q t) v]/dt = (M + q t) dv/dt + v q = F (M + q t) v = F t (2) v_2 = F t_2 / (M + q t_2) =",
                "d[(M + q t) v]/dt = (M + q t) dv/dt + v q = 0 so that the momentum of wagon is conserved:",
                "(M + q t) v = M v_1",
            ],
        ),
        ("momentum/drop-that-grows-in-mist", ["+ v_A q = -g (M + q t) (M + q t) v_A = -g t (M + 1/2 q t)"]),
    ],
)
def test_product_is_written_and_integrated(name: str, lines: list[str]) -> None:
    source = PROBLEMS / f"{name}.yaml"
    problem, wrong = load_text(source.read_text())
    assert not wrong
    page = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    for wanted in lines:
        assert wanted in page
    assert "μ" not in page
