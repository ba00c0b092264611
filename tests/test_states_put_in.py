"""What a page says of a state that the solution puts in: up to where a spring pushes, and when."""

from __future__ import annotations

from pathlib import Path

import pytest
from answered import solve
from worked import page_of_file, page_of_text

from planar_cli.errors import NoSolution

THROWN = """
title: Rod thrown up by a spring
plane: vertical
given: {m: 5 kg, l: 0.8 m, b: 0.2 m, k: 120 kN/m, delta: 15 mm, l_0: 0.1 m}
points:
  O: [0, 0]
  A: [b - l, 0]
  B: [b, 0]
  S: [b - l, delta - l_0]
bodies: {AB: {rod: [A, B], mass: m, points: [O]}}
joints:
  - pin: {at: O, between: [ground, AB]}
loads:
  - spring: {between: [S, A], stiffness: k, natural_length: LENGTH, acts: push}
states: {1: [at rest], 2: [x(A) = 0]}
find: {omega: omega(AB) @ 2}
"""
UP_TO = "Up to state free the spring from S to A is compressed; there "


@pytest.mark.parametrize(
    ("length", "words"),
    [("l_0", "its length is l_0."), ("100 mm", "it is relaxed."), ("2*l_0 - 0.1 m", "it is relaxed.")],
)
def test_a_spring_is_relaxed_in_words_where_its_length_takes_lines(tmp_path: Path, length: str, words: str) -> None:
    assert UP_TO + words in page_of_text(tmp_path, THROWN.replace("LENGTH", length))


@pytest.mark.parametrize(
    ("stem", "words"),
    [
        ("block-shot-up-a-slope-by-a-spring", "Up to state free the spring is compressed; there c - s_block = 0."),
        (
            "roller-onto-a-spring",
            "Up to t_free = 1.599 s (state free) the spring bumper is compressed; there s - d = 0.",
        ),
    ],
)
def test_a_time_stands_where_the_page_comes_back_to_it(stem: str, words: str) -> None:
    assert words in page_of_file(stem)


@pytest.mark.parametrize(("delta", "hinted"), [("15 mm", True), ("-15 mm", False)])
def test_a_spring_that_is_compressed_at_first_may_be_meant_to_push_only(delta: str, hinted: bool) -> None:
    """Fastened it draws the rod back, which never comes to stand upright."""
    text = THROWN.replace("LENGTH", "l_0").replace(", acts: push", "").replace("15 mm", delta)
    with pytest.raises(NoSolution) as error:
        solve(text)
    hint = error.value.diagnostics[0].hint or ""
    told = "; the spring from S to A also pulls, where it is stretched; with `acts: push` it only pushes"
    assert "repeats itself" in hint
    assert hint.endswith(told) is hinted
