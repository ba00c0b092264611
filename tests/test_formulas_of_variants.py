"""Answers in letters keep their sign in each variant, and a key tells them by the letters and by the numbers."""

from __future__ import annotations

import pytest
from homework_made import BALL_ON_ROD, set_of

from planar_cli.commands._handed_out import page
from planar_cli.commands._told_formulas import told_formulas
from planar_cli.homework.homework import prepared
from planar_cli.homework.sets.paper import Paper
from planar_cli.homework.sets.ready import Homework, Prepared
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.sheets import Handed
from planar_cli.report.document.handed_out import key, sheet

HIT = f"""
plane: vertical
symbols: {{v_0: m/s}}
given: {{M: 6 kg, m: 1 kg, l: 1.2 m, b: 0.9 m, e: 0.6}}{BALL_ON_ROD}find: {{J: impulse(A).x @ 1->2, v: v(ball).x @ 2}}
variants: {{b: [0.9 m, 0.6 m, 1.2 m]}}
"""


@pytest.fixture(scope="module")
def hit(tmp_path_factory: pytest.TempPathFactory) -> Prepared:
    (problem,) = set_of(tmp_path_factory.mktemp("hit"), "variants: {number: 3}", hit=HIT).problems
    return prepared(problem, 3, 1, told_formulas)


def test_a_formula_that_changes_its_sign_is_no_variant(hit: Prepared) -> None:
    """J ~ 3 b - 2 l: at b = 0.6 m the hinge pushes the other way."""
    assert not any("the answers of another one" in w for w in hit.warnings), "their numbers differ"
    assert dict(hit.rejected) == {"J changes its sign": 1}
    assert sorted(dict(v)["b"] for v in hit.values[1:3]) == ["0.9 m", "1.2 m"]


def test_the_formula_of_the_file_stands_where_it_holds(hit: Prepared) -> None:
    """Where b = l the solution has b for 3 b - 2 l."""
    for task, values in zip(hit.tasks[1:3], hit.values[1:3], strict=True):
        b = float(dict(values)["b"].split()[0])
        j, v = task.expected
        coefficient = 6 * 1.2 * (3 * b - 2.4) * 1.6 / (2 * (6 * 1.44 + 3 * b**2))
        assert j.text == f"(1 + e) M m v_0 l (3 b - 2 l) / (2 (M l² + 3 m b²)) = {coefficient:.4f} v_0 (v_0 in m/s)"
        assert v.text.endswith(" v_0"), "a pure number needs no unit"


def test_the_sheet_tells_in_which_letters_a_formula_is_asked(hit: Prepared) -> None:
    homework = Homework("hit", "", {1: Paper(1, (hit.tasks[1],))}, {}, "", (), Rules())
    told = page(sheet(homework, Handed("sheet-1", 1)), "", "markdown").decode()
    assert "in N·s, as a formula in $v_{0}$ (1 point)" in told
    assert "# 2/7*v_0" in told
    assert "$v_{0}$ in m/s)" in page(key(homework, [1], worked=False), "", "markdown").decode()
