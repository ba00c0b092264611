"""Long runs of equations of one form: the first ones are told, and of the others by which numbers they go."""

from __future__ import annotations

import re
from decimal import Decimal

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import page_of_file, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.answers.sizes_listed import with_sizes_listed
from planar_cli.report.document.blocks import Equation, Heading, Math, Name, Paragraph, Value, line
from planar_cli.report.equations.results import told_by_others
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.report.repeats.components_listed import with_components_listed

CHAIN_5 = "Likewise with BC as well, about B; then AB about A; then OA about O: (13) to (15)"


@pytest.mark.parametrize(
    ("stem", "others", "components"),
    [
        (
            "chain-5",
            "with BC as well, about B; then AB about A; then OA about O: (13) to (15), collected",
            "(5) to (10)",
        ),
        ("chain-5-symbols", "with BC as well, about B; then AB about A; then OA about O: (13) to (15).", "(5) to (10)"),
        ("chain-10", "then bar_1 about P0: (22) to (29), collected", "(5) to (18)"),
    ],
)
def test_moments_of_groups_that_grow(stem: str, others: str, components: str) -> None:
    page = page_of_file(stem)
    assert others in page
    assert re.search(rf"Likewise the components of [^:]*: {re.escape(components)}\.", page)


@pytest.mark.parametrize("stem", ["chain-5", "chain-5-symbols"])
def test_what_is_told_so_stood_in_an_earlier_case(stem: str) -> None:
    inner = page_of_file(stem).partition("CASE inner")[2]
    assert "as before: (1) to (10)" in inner
    assert "as before: the diagram, (11) to (15)" in inner
    assert "Likewise the components" not in inner


def test_every_row_is_solved() -> None:
    page = page_of_file("chain-10")
    assert all(f"({n}):" in page or f"({n}) " in page for n in range(20, 30))


def test_from_the_free_end_no_reaction_enters() -> None:
    """The last bar is vertical and the first horizontal: about the last pin the first has no part."""
    page = page_of_file("chain-10")
    assert "bar_10, moments about P9:" in page
    assert "bar_9, bar_10, moments about P8:" in page


@pytest.mark.parametrize(
    ("said", "numbers"),
    [
        ("Likewise the components of a_C: (5) to (8).", [5, 6, 7, 8]),
        ("Likewise B: (3), (4), collected further down.", [3, 4]),
        ("From (3), (4):", []),
    ],
)
def test_numbers_of_a_sentence(said: str, numbers: list[int]) -> None:
    assert told_by_others(Paragraph(line(said))) == numbers


def test_sums_of_forces_body_by_body() -> None:
    inner = page_of_file("chain-5").partition("CASE inner")[2]
    assert "CD: (18) → ΣF_x: C_x - D_x = m_2 a_G,CD,x (19) ↑ ΣF_y: C_y - m_2 g - D_y = m_2 a_G,CD,y" in inner
    assert "Likewise BC (B, C, m_3), AB (A, B): (20) to (23)." in inner
    assert "Likewise B_x = -12.66 N, B_y = 7.657 N, A_x = -9.490 N, A_y = 21.78 N from (20) to (23)." in inner


def _value(name: str, number: int) -> Equation:
    return Equation((Math(sp.Symbol(name)), Math(2 * sp.Symbol("alpha")), Value(Decimal(number), "m/s^2")))


def test_values_of_components() -> None:
    run = [_value(f"a_G,{body}_x", i) for i, body in enumerate(("AB", "BC", "CD", "DE"))]
    *told, others = with_components_listed(run, ())
    assert told == run[:2]
    assert isinstance(others, Paragraph)
    assert [p.number for p in others.line if isinstance(p, Value)] == [2, 3]
    assert with_components_listed(run[:3], ()) == run[:3]
    assert with_components_listed(run, {"a_G,DE,x"}) == run


def test_each_step_tells_how_components_are_found() -> None:
    run = [_value(f"a_G,{body}_x", i) for i, body in enumerate(("AB", "BC", "CD", "DE"))]
    page = with_components_listed([*run, Heading("STEP 3", "Solving the equations"), *run], ())
    assert sum(b in run for b in page) == 4


def _vector(name: str) -> list[Equation]:
    number = Value(Decimal(5), "N")
    slope = line("direction of ", Name(name), " = ", Value(Decimal(30), "deg"), " above +x")
    return [
        Equation((line(Name(name)), line("[3, 4] N"))),
        Equation((line("|", Name(name), "|"), Math(sp.Symbol("r")), number), note=slope),
    ]


def test_sizes_of_vectors_in_a_row() -> None:
    rows = [b for name in ("F_A", "F_B", "F_C") for b in _vector(name)]
    told = with_sizes_listed(rows)
    assert told[:2] == rows[:2]
    assert len(told) == 4
    beside = line("likewise ", Value(Decimal(5), "N"), " at ", Value(Decimal(30), "deg"), " above +x")
    assert [b.note for b in told[2:] if isinstance(b, Equation)] == [beside, beside]
    assert with_sizes_listed(rows[:4]) == rows[:4]


def test_accelerations_alone_have_no_heading() -> None:
    assert "Accelerations:" not in page_of_file("chain-5")
    assert "Accelerations:" in page_of_file("four-bar-driven")


@pytest.mark.parametrize("stem", ["chain-5", "chain-5-symbols"])
def test_the_key_has_all_rows(stem: str) -> None:
    (path,) = (p for p in PROBLEMS if p.stem == stem)
    page = " ".join(Terminal(300).render(narrate(worked(path)[0], Voice(audience="exam"))).split())
    root, _, inner = page.partition("CASE inner")
    assert "(11) ↺ ΣM_D:" in root
    assert "about O: (13) to (15)" in root
    assert root.count("right side in") == 1
    assert "right side in" not in inner
