"""Unknowns that follow together are told one after the other where their equations allow it, and none twice."""

from __future__ import annotations

from collections import Counter

import pytest
from conftest import PROBLEMS, ROOT
from worked import page_of_file, worked

from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem

FILES = {p.stem: p for p in PROBLEMS}


def test_no_unknown_is_found_twice() -> None:
    """A block of three equations had given the angular velocity at state 1 again, which an earlier one had told."""
    (part,) = worked(FILES["disk-that-screws-itself-up-a-slope"])[0].parts
    found = Counter(r.unknown.name for step in part.motion.route.steps for r in step.results)
    assert set(found.values()) == {1}


def test_a_largest_speed_gives_its_place_first() -> None:
    """The rate of v² is a product with v, which does not vanish: what is left has the place alone."""
    text = page_of_file("block-down-a-slope-onto-a-buffer")
    assert "s_fastest = m g (sin β - μ cos β) / k + a" in text
    assert text.index("s_fastest = m g (sin β") < text.index("T_fastest =")


def test_no_law_of_motion_for_the_impulse_of_a_blow() -> None:
    """Over a blow alone nothing is integrated: the reactions of the motion after it are not asked."""
    text = page_of_file("wheel-over-a-kerb")
    assert "J_Kx" in text
    assert "Newton" not in text


def test_an_impulse_that_is_unique_where_the_reactions_after_the_blow_are_not() -> None:
    """Three parallel cranks hold a platform: along it each takes ω m l/6 of its own, across it nothing is unique."""
    text = (ROOT / "tests" / "bad_solve" / "blow-on-three-cranks.yaml").read_text().replace("(A).y", "(A).x")
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    (part,) = solve_problem(problem).parts
    found = {f.name: float((f.values or ())[0]) for f in part.found}
    assert found == pytest.approx({"omega": -10, "kick": 10 / 6})
