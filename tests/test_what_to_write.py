"""What a refusal says to write: a key with a value, the limit that ends a range, what a find divides by."""

from __future__ import annotations

import pytest
from answered import solve

from planar_cli.errors import FileProblem, NoSolution
from planar_cli.problem.structure import load_text

ROD = """
title: Rod that swings
plane: vertical
points: {A: [0, 0], B: [1 m, 0], C: [0.5 m, -1 m]}
bodies: {rod: {rod: [A, B], mass: 2 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
loads:
  - spring: {between: [B, C], stiffness: 20 N/m, natural_length: 0.3 m}
instant: [at rest]
find: {q: alpha(rod)}
"""
THROW = """
title: Throw that may not be steep
plane: vertical
given: {v_0: 10 m/s}
unknowns: {phi: deg}
assume: [phi <= 30 deg, phi >= 0]
points: {A: [0, 0]}
bodies: {P: {particle: A, mass: 1 kg}}
states:
  1: [t = 0, v(P).mag = v_0, v(P).angle = phi]
  2: [y(P) = 0, x(P) is largest]
find: {x: x(P) @ 2}
"""


@pytest.mark.parametrize(
    ("left_out", "hint"),
    [
        ("at: A, ", "write `at: A`: the common point"),
        ("stiffness: 20 N/m, ", "write `stiffness: 20 N/m`: its stiffness"),
    ],
)
def test_a_key_that_must_be_there(left_out: str, hint: str) -> None:
    _, wrong = load_text(ROD.replace(left_out, ""))
    assert [(d.code, d.hint) for d in wrong] == [("PL311", hint)]


def test_what_is_divided_by() -> None:
    with pytest.raises(FileProblem) as refused:
        solve(ROD.replace("alpha(rod)}", "alpha(rod)/omega(rod)}"))
    assert refused.value.diagnostics[0].message == "division by zero: omega(rod) is 0 here"


@pytest.mark.slow
def test_the_largest_at_the_end_of_what_is_allowed() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(THROW)
    (why,) = refused.value.diagnostics
    assert why.message.startswith("`x(P) is largest` at phi = 30 deg, the end of what `phi <= 30 deg` allows")
    assert (why.hint or "").startswith("write `phi = 30 deg` in its place")


def test_a_length_that_is_given_as_nothing() -> None:
    text = ROD.replace("points:", "given: {l: 0 m}\npoints:").replace("[1 m, 0]", "[l, 0]")
    with pytest.raises(FileProblem) as refused:
        solve(text)
    assert refused.value.diagnostics[0].message == "both ends of rod are at the same place"
