"""A distance that is told as a function of time tells the way along a slot, and polar coordinates follow from it."""

from __future__ import annotations

import pytest
from answered import solve
from conftest import ROOT

from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FILE = ROOT / "problems/motion/bead-drawn-out-along-a-turning-tube.yaml"
TUBE = FILE.read_text(encoding="utf-8").partition("note:")[0]
LETTERS = "symbols: {w: rad/s, b: m, c: 1/s}"
NUMBERS = "given: {w: 2 rad/s, b: 0.2 m, c: 0.5 1/s}"


def test_the_page_differentiates_what_it_found() -> None:
    page = Terminal().render(narrate(solve_problem(read(str(FILE)))))
    assert "r̈_P = c² b exp(c t)" in page
    assert "θ̈_P = 0" in page


@pytest.mark.parametrize("text", [TUBE, TUBE.replace(LETTERS, NUMBERS), TUBE.replace("P: [b, 0]", "P: [-b, 0]")])
def test_in_letters_and_in_numbers_the_same_formula(text: str) -> None:
    found = solve(text)
    assert str(found["a_theta"].expressions) == str(solve(TUBE)["a_theta"].expressions)


def test_a_distance_that_grows_evenly() -> None:
    found = solve(TUBE.replace("b*exp(c*t)", "b + b*c*t"))["a_r"].expressions
    assert found is not None
    names = {s.name: s for s in found[0].free_symbols}
    w, b, c, t = (names[n] for n in ("w", "b", "c", "t"))
    assert (found[0] + w**2 * b * (1 + c * t)).expand() == 0
