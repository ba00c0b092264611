"""What the author asks for has one name on its page, where that is short for the letter of the solution."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.report.document.blocks import Answer, Block, Equation, Math, Name, Note, Text, Value, line
from planar_cli.report.words.one_name import with_one_name

CORD, GRAVITY, MASS = (sp.Symbol(x, real=True) for x in ("T_cord", "g", "m"))
SPEED = sp.Symbol("v_A__2", real=True)
TOLD = Equation((Math(CORD), Math(MASS * GRAVITY)))


def _answer(name: str, letter: sp.Symbol = CORD) -> Answer:
    return Answer(name, line(Math(letter), " = ", Value(Decimal(12), "N")))


def _letters(blocks: list[Block]) -> set[str]:
    sides = [m for b in blocks if isinstance(b, Equation) for m in b.sides]
    return {s.name for m in sides if isinstance(m, Math) for s in m.expr.free_symbols}


def test_the_name_of_the_author_stands_on_the_whole_page() -> None:
    found = with_one_name([TOLD, Note("Find", line(Name("T"))), _answer("T")])
    assert _letters(found) == {"T", "m", "g"}
    assert found[-1] == Answer("T", line(Value(Decimal(12), "N")))


def test_not_where_something_else_would_be_meant() -> None:
    """Another cord, an energy, a point; a speed at a state; a name of another letter; two names of one letter."""
    energy = Equation((Math(sp.Symbol("T_1", real=True)), Math(MASS)))
    at = Equation((Math(MASS), Math(GRAVITY)), None, line(Text("moments about T:")))
    for blocks in (
        [TOLD, energy, _answer("T")],
        [TOLD, at, _answer("T")],
        [TOLD, _answer("pull")],
        [TOLD, _answer("S")],
        [TOLD, _answer("T"), _answer("S")],
        [
            TOLD,
            Equation((Math(sp.Symbol("v_A__2", real=True)), Math(MASS))),
            _answer("v", sp.Symbol("v_A__2", real=True)),
        ],
    ):
        assert with_one_name(blocks) == blocks


def test_rates_have_the_name_of_what_changes() -> None:
    way, rate = sp.Symbol("r_P", real=True), sp.Symbol("r_P_dot", real=True)
    told = [Equation((Math(way), Math(MASS))), Equation((Math(rate), Math(GRAVITY))), _answer("r", way)]
    assert _letters(with_one_name(told)) == {"r", "r_dot", "m", "g"}
    page = page_of_file("ex-1-14")
    assert "r_P" not in page
    assert "v_θ = r θ̇" in page


def test_the_state_stays_where_the_author_names_it() -> None:
    letter = sp.Symbol("T_cord__low", real=True)
    told = [Equation((Math(letter), Math(MASS * GRAVITY))), _answer("T_low", letter)]
    assert _letters(with_one_name(told)) == {"T_low", "m", "g"}


@pytest.mark.parametrize(
    ("name", "letter", "beside"),
    [
        ("t_1", "t__stop_1", "m"),  # 1 is another state than stop_1
        ("x_top", "x_block__top", "v_block"),  # the block keeps its name elsewhere
        ("x_1", "x_block__1", "x_block__start"),
        ("a", "a_E", "m"),  # E is a point
        ("v_AC", "v_P_AC", "m"),
        ("t_left_again", "t__left_again", "m"),  # no shorter
    ],
)
def test_what_the_name_would_not_say(name: str, letter: str, beside: str) -> None:
    symbol = sp.Symbol(letter, real=True)
    told = [Equation((Math(symbol), Math(sp.Symbol(beside, real=True)))), _answer(name, symbol)]
    assert with_one_name(told) == told


def test_what_goes_with_it_is_called_after_the_same() -> None:
    """ω_gear,A beside α_gear,A, which is asked for as α_A."""
    page = page_of_file("gear-pair")
    assert "(1) r_A α_A = -r_B α_B" in page
    assert "ω_A = 20 rad/s" in page


def test_letters_of_one_kind_follow_one_scheme() -> None:
    """All of a set of letters take the names that are asked for, or none: T_A and T_D, never T_rope,A beside T_D."""
    page = page_of_file("beam-on-two-ropes")
    assert "T_A ↑ at A, T_D ↑ at D" in page
    assert "T_A,after = T_A = 29.43 N" in page
    assert "T_rope" not in page
    one, other = (sp.Symbol(f"T_rope_{end}", real=True) for end in "AD")
    told = [Equation((Math(one), Math(MASS))), Equation((Math(other), Math(MASS))), _answer("T_D", other)]
    assert with_one_name(told) == told
    assert _letters(with_one_name(told[1:])) == {"T_D", "m"}


def test_the_force_in_a_link_has_the_name_that_is_asked() -> None:
    """It counts as tension, whatever the letter of the solution."""
    page = page_of_file("plate-on-parallel-links")
    assert "T_AC ↗ at C, T_BD ↗ at D" in page
    assert "S_link" not in page
