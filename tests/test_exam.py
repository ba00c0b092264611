"""`--audience exam` prints a page as short as a key: the principle, what the answers rest on, the results."""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal
from pathlib import Path

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Answer, Block, Equation, Forces, Math, Name, Paragraph, Table, Text, Value
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.page.exam import key_blocks
from planar_cli.report.page.narrate import Voice, narrate
from planar_cli.report.page.rests_on import rests_on

STEMS = ("double-pulley", "ex-2-09", "ex-4-10", "ladder-sliding", "puck-hits-a-free-rod", "ex-1-02")
LONG = 25
"""A page of fewer lines is hardly more than its results."""
FILES = [p for p in PROBLEMS if p.stem in STEMS]


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_short_with_all_results(path: Path) -> None:
    page = narrate(worked(path)[0])
    key = narrate(worked(path)[0], Voice(audience="exam"))
    assert not [b for b in key.blocks if isinstance(b, Forces | Paragraph)]
    assert [b for b in key.blocks if isinstance(b, Answer)] == [b for b in page.blocks if isinstance(b, Answer)]
    short, long = (len(Terminal().render(x).splitlines()) for x in (key, page))
    assert short < (0.75 * long if long > LONG else long)


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_the_equations_are_those_of_the_page(path: Path) -> None:
    """With the numbers of the page."""
    page = [b for b in narrate(worked(path)[0]).blocks if isinstance(b, Equation)]
    key = [b for b in narrate(worked(path)[0], Voice(audience="exam")).blocks if isinstance(b, Equation)]
    assert key
    assert {(b.number, str(b.sides)) for b in key} <= {(b.number, str(b.sides)) for b in page}


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_each_answer_has_its_line(path: Path) -> None:
    """Formula, numbers and value: a number of an answer ends a line of the key, there perhaps in m and here in mm."""
    key = narrate(worked(path)[0], Voice(audience="exam")).blocks
    lines = tuple(b.sides[1:] for b in key if isinstance(b, Equation))
    ends = [float(abs(p.number)) for p in pieces_of(lines) if isinstance(p, Value)]
    for answer in (b for b in key if isinstance(b, Answer)):
        numbers = [p.number for p in answer.line if isinstance(p, Value)]
        assert not numbers or any(
            float(abs(n)) == pytest.approx(e * u) for n in numbers for e in ends for u in (1, 1000)
        )


def test_energies_and_work_stay() -> None:
    """Of the rod in its slots the kinetic energy, both parts of the work and the last line."""
    path = next(p for p in FILES if p.stem == "ex-4-10")
    key = Terminal(200).render(narrate(worked(path)[0], Voice(audience="exam")))
    for words in ("T_2 = 1/2 m v_G,2²", "U of the weight", "U of the spring", "ω_2 = √(19.364/0.2667) = 8.521 rad/s"):
        assert words in key
    assert "T_1 = 0" not in key


def line_of(letter: str, *sides: object, number: int | None = None, lead: tuple[str, ...] = ()) -> Equation:
    """A line letter = side = side …, each side a formula."""
    own = tuple(Math(sp.sympify(s)) for s in (letter, *sides))
    return Equation(own, number, tuple(Name(p) if p[0].isalpha() else Text(p) for p in lead))


@pytest.mark.parametrize(("blocks", "kept"), [
    pytest.param([line_of("a", "r*b", number=1), line_of("c", "d"), Answer("c", (Text("2"),))], {1}, id="unused"),
    pytest.param(
        [line_of("p*q", "a", number=1), line_of("b", "c", number=2), line_of("a", "b", lead=("(1):",)),
         Answer("a", (Text("2"),))], {0, 1, 2}, id="named by number, used by letter"),
    pytest.param(
        [line_of("T__1", 0), line_of("T__2", "m*u"), line_of("U", "f"),
         line_of("f*s", "m*u", number=1, lead=("T__1", " + ", "U", " = ", "T__2")),
         line_of("u", "f/m", lead=("(1):",)), Answer("u", (Text("2"),))], {1, 2, 3, 4}, id="energies"),
    pytest.param([line_of("7*a", 14), line_of("a", 2), Answer("a", (Text("2"),))], {0, 1}, id="a quotient"),
    pytest.param([line_of("x_ddot", "-c*x"), line_of("omega_0", "sqrt(c)"), Answer("omega_0", (Text("2"),))], {0, 1},
                 id="a frequency"),
    pytest.param(
        [line_of("v__3", "w", number=1), line_of("v__3", "u - g*t", number=2),
         line_of("t", "(u - v__3)/g", lead=("(2):",)), Answer("t", (Text("2"),))],
        {0, 1, 2}, id="a time from a speed that was found before"),
    pytest.param([line_of("a", "b"), Answer("z", (Text("2"),))], None, id="no line"),
])  # fmt: skip
def test_what_answers_rest_on(blocks: list[Block], kept: set[int] | None) -> None:
    assert rests_on(blocks) == (None if kept is None else frozenset(kept))


def test_signs_of_an_assumption_stay() -> None:
    """What was assumed, and its test; no other check."""
    path = next(p for p in FILES if p.stem == "ladder-sliding")
    key = Terminal(200).render(narrate(worked(path)[0], Voice(audience="exam")))
    assert "Instead     ladder slips at A and B" in key
    assert "N_A = 116.8 N > 0" in key
    assert "multibody" not in key


def test_each_letter_is_solved_for_once() -> None:
    """What is put in on the way to the first number stands with its own number, once."""
    solved = [line_of("a", "-c", lead=("(1):",)), line_of("c", "d", lead=("(2):",))]
    last = Equation((*solved[0].sides, Value(Decimal(3), "m/s^2")), lead=solved[0].lead)
    found = Equation((*solved[1].sides, Value(Decimal(-3), "m/s^2")), lead=solved[1].lead)
    key = key_blocks([solved[0], found, last, Answer("a", (Value(Decimal(3), "m/s^2"),))], ())
    assert [b for b in key if isinstance(b, Equation)] == [found, last]


def test_a_motion_followed_in_numbers_has_its_table() -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "dog-that-runs-at-a-cyclist")
    key = narrate(worked(path)[0], Voice(audience="exam")).blocks
    assert any(isinstance(b, Table) for b in key)


def test_an_integral_rests_on_the_law() -> None:
    t = sp.Symbol("t")
    force = line_of("F", "m*a", number=1, lead=("ΣF_x",))
    integral = Equation((Math(sp.Integral(sp.Symbol("F"), t)), Math(sp.Symbol("q"))))
    blocks = [force, integral, line_of("v", "F*t/m", number=2), Answer("v", (Text("2"),))]
    assert rests_on(blocks) == frozenset({0, 1, 2})


def test_a_particle_is_its_point() -> None:
    blocks = [line_of("v_B", "c"), line_of("v_rel", "v_collar - d"), Answer("v_rel", (Text("2"),))]
    assert rests_on(blocks, {"collar": "B"}) == frozenset({0, 1})
    assert rests_on(blocks, {"collar": "B", "puck": "P"}) == frozenset({0, 1})
    assert rests_on(blocks, {"col": "B", "lar": "P"}) == frozenset({1})


def test_which_root_it_is_stays() -> None:
    told = replace(
        line_of("v", "-sqrt(c)", lead=("(1):",)), note=(Text("the negative root: "), Text("it moves downward"))
    )
    arm = replace(line_of("c", "d"), note=(Text("r = 2"),))
    key = key_blocks([arm, told, Answer("v", (Text("2"),))], ())
    assert [b.note for b in key if isinstance(b, Equation)] == [(), told.note]
