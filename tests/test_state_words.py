"""How a page speaks of a state, and of what happens there."""

from __future__ import annotations

import pytest

from planar_cli.report.words.state_words import at, place, turning
from planar_cli.solve.law import IN_THE_END


@pytest.mark.parametrize(
    ("state", "words", "said"),
    [
        ("taut", turning("the spring cord is not stretched"), "At taut the spring cord begins to be stretched:"),
        ("slips", turning("friction at A within its limit"), "At slips the friction at A reaches its limit:"),
        ("2", turning("the tension pulls"), "At 2 the tension ceases to pull:"),
        ("2", turning("it stops sliding"), "At 2 it stops sliding:"),
        ("2", turning("the water is calm"), "At 2, up to here the water is calm:"),
        ("end", IN_THE_END, "At end the speed no longer changes:"),
        ("at_8", "as given", "In state at_8, as given:"),
        ("top", "", "At top:"),
        ("", "as given", "as given:"),
    ],
)
def test_words_before_what_holds(state: str, words: str, said: str) -> None:
    assert at(state, words) == said


def test_inside_a_sentence() -> None:
    assert f"Hence, {place('2')}:" == "Hence, at 2:"
    assert f"Hence, {place('at_8')}:" == "Hence, in state at_8:"
