"""An equation that stands as unknown = formula is not told again as its solution; a rope is called as in a sentence."""

from __future__ import annotations

from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def page(stem: str) -> str:
    return Terminal(200).render(narrate(worked(FILES[stem])[0]))


def test_a_relation_is_its_own_solution() -> None:
    assert page("body-hoist-starting-softly").count("v_Ly = R ω\n") == 1


def test_a_rope_keeps_its_length() -> None:
    assert "At 2, the cable keeps its length:" in page("pulley-pulled-against-a-spring")


def test_an_equation_whose_numbers_hide_units_leaves_its_heading() -> None:
    """The load hangs at -6 m, a number of the file, and the angle of the drum is nil there."""
    told = page("load-wound-up-against-axle-friction")
    assert "At 3, the rope keeps its length:\n    (11)  θ_3 = 0 rad\n" in told
    assert "atan2" not in told
