"""What is the same of several bodies is told of the first; of the others, by their names and numbers, that it is."""

from __future__ import annotations

import re
from decimal import Decimal

import pytest
import sympy as sp
from conftest import ROOT
from worked import page_of_file, worked

from planar_cli.report.document.blocks import Answer, Equation, Math, Paragraph, Value, line
from planar_cli.report.repeats.likewise import told_likewise

PROBLEM = worked(ROOT / "problems" / "plans" / "parallelogram-6-cranks.yaml")[0].problem


def words(block: Paragraph) -> str:
    return "".join(str(getattr(p, "text", getattr(p, "name", getattr(p, "expr", "#")))) for p in block.line)


def test_six_cranks() -> None:
    page = page_of_file("parallelogram-6-cranks")
    others = "crank_2 (O2, B2), crank_3 (O3, B3), crank_4 (O4, B4), crank_5 (O5, B5), crank_6 (O6, B6)"
    assert f"(6) ↺ ΣM_O1: -1/2 m g l cos β - l B1_t = I_O1 α_crank,1 Likewise {others}: (7) to (11)." in page
    assert page.count(f"Likewise {others}") == 2
    assert "Likewise I_O2 = I_O3 = I_O4 = I_O5 = I_O6 = 0.3333 kg·m²." in page
    assert "(1) to (12) together" in page


@pytest.mark.parametrize("stem", ["parallelogram-6-cranks", "chain-5"])
def test_every_equation_has_its_number(stem: str) -> None:
    solving = page_of_file(stem).partition("Answer")[0]
    told = {int(n) for n in re.findall(r"\((\d+)\)  ?[^:]", solving)}
    for first, last in re.findall(r"\((\d+)\) to \((\d+)\)", solving):
        told |= set(range(int(first), int(last) + 1))
    assert told >= set(range(1, max(told) + 1))


def test_values_that_differ_are_told() -> None:
    page = page_of_file("chain-5")
    assert "Likewise I_AB = 0.02 kg·m², I_BC = 0.0075 kg·m², I_CD = 0.02 kg·m², I_DE = 0.04167 kg·m²." in page
    for given in ("ω_AB = -2 rad/s", "ω_BC = 3 rad/s"):
        assert given in page


def results(*letters: str) -> list[Equation]:
    one = Value(Decimal(1), "N")
    return [
        Equation((Math(sp.Symbol(x)), Math(-sp.Symbol(x.replace("t", "n"))), one), None, line(f"({i}):"))
        for i, x in enumerate(letters, 1)
    ]


def test_results_with_one_value() -> None:
    letters = [f"B{i}_t" for i in range(1, 7)]
    first, told = told_likewise(results(*letters), PROBLEM)
    assert isinstance(told, Paragraph)
    assert words(told) == "Likewise B2_t = B3_t = B4_t = B5_t = B6_t = # from (2) to (6)."
    assert first == results("B1_t")[0]


def test_answers_are_told_one_by_one() -> None:
    blocks = [*results(*(f"B{i}_t" for i in range(1, 7))), Answer("B3_t", line("1 N"))]
    assert told_likewise(blocks, PROBLEM) == blocks


def test_another_formula_is_not_alike() -> None:
    letters = [(sp.Symbol(f"B{i}_t"), sp.Symbol(f"B{i}_n") + 2 * sp.Symbol(f"O{i}_t")) for i in range(1, 7)]
    blocks = [Equation((Math(b), Math(o)), n) for n, (b, o) in enumerate(letters, 1)]
    assert len(told_likewise(blocks, PROBLEM)) == 2
    blocks[2] = Equation((blocks[2].sides[0], Math(3 * sp.Symbol("O3_t"))), 3)
    assert told_likewise(blocks, PROBLEM) == blocks


def test_moments_of_inertia_by_one_formula() -> None:
    """Also where the mass of one has no index, as a unit has none."""
    page = page_of_file("six-bar-class-3")
    assert "I_AB = 1/12 m AB² = 1/12 · 1 · 0.4472² = 0.01667 kg·m² Likewise I_PC = 0.03125 kg·m², I_QD = 0.025" in page


def test_a_further_component_of_a_shared_vector_stands_behind_its_words() -> None:
    page = page_of_file("six-bar-class-3")
    assert "(3) v_C along x: 0.4 ω_PC - 0.2 ω_AB - 0.2 ω_slab = 0.2 · 4 = 0.8 in m/s (4) v_D along x:" in page


def test_a_second_moment_of_inertia_of_a_body_names_its_axis_alone() -> None:
    page = page_of_file("four-bar-driven")
    assert "I_CB = 1/12 m_CB c² = 1/12 · 2 · 0.4² = 0.02667 kg·m² about C, parallel axes: I_C = 1/4 m_CB c²" in page
