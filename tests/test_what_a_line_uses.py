"""What a line of kinematics uses stands before it: no number before what it rests on is found."""

from __future__ import annotations

import pytest
from conftest import ROOT
from worked import page_of_file

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem


@pytest.mark.parametrize(
    ("stem", "first", "then"),
    [
        ("bar-driven-by-a-pin-on-a-rolling-wheel", "a_P = -ω_wheel² r_P/G =", "a_P · n ="),
        ("gripper-on-two-turning-arms", "v_A = ω_OA × r_A/O =", "v_P = v_A +"),
        ("gripper-on-two-turning-arms", "a_A = α_OA × r_A/O - ω_OA² r_A/O =", "a_P = a_A +"),
    ],
)
def test_a_vector_stands_before_what_uses_it(stem: str, first: str, then: str) -> None:
    page = page_of_file(stem)
    assert page.index(first) < page.index(then)


def test_a_speed_that_forces_tell_gives_no_number_before() -> None:
    page = page_of_file("flat-faced-follower-about-to-lift")
    assert "a_C = -ω_cam² r_C/A r_C/A = [0, 0.01] m" in page


def test_what_a_component_does_without_is_named() -> None:
    """Of a component that does without α the vector equation stands before its formula."""
    text = (ROOT / "problems" / "kinematics" / "disk-on-fixed-disk.yaml").read_text(encoding="utf-8")
    text = text.partition("find:")[0] + "find: {a_B: a(B).y}\n"
    problem, _ = load_text(text)
    assert problem is not None
    page = " ".join(Terminal(200).render(narrate(solve_problem(problem))).split())
    assert "along y, where α_arm and α_disk do not enter" in page
    first = page.index("a_B = a_G + α_disk × r_B/G - ω_disk² r_B/G")
    assert first < page.index("a_B = -(r ω_disk² + (R + r) ω_arm²)")
