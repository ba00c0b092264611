"""What acts during a span that ends before it begins would act never: the file is told so."""

from __future__ import annotations

import pytest

from planar_cli.problem.structure import load_text

PUSHED = """title: Block pushed for a while
plane: horizontal
points: {A: [0, 0]}
bodies: {block: {particle: A, mass: 2 kg}}
LOADS
states:
  before: [at rest, t = 0]
  stop: [WHEN]
  after: [LATER]
find: {v: v(block).x @ after}
"""
FORCE = "loads: [{force: {body: block, magnitude: 8 N, angle: 0 deg, during: SPAN}}]"
LAW = "motion: [a(block).x = 2 m/s^2 during SPAN, a(block).y = 0]"


def codes(loads: str, span: str, when: str, later: str) -> list[tuple[str, int]]:
    text = PUSHED.replace("LOADS", loads).replace("SPAN", span).replace("WHEN", when).replace("LATER", later)
    return [(d.code, d.mark.line) for d in load_text(text)[1]]


@pytest.mark.parametrize("loads", [FORCE, LAW])
@pytest.mark.parametrize(
    ("span", "when", "later", "back"),
    [
        ("before->stop", "t = 3 s", "t = 5 s", False),
        ("after->stop", "t = 3 s", "t = 5 s", True),
        ("after->stop", "t = 5 s", "t = 3 s", False),
        ("after->stop", "x(block) = 3 m", "x(block) = 5 m", True),
        ("stop->before", "x(block) = 3 m", "t = 5 s", True),
        ("after->stop", "t = 3 s", "just after stop", False),
    ],
)
def test_a_span_that_runs_back(loads: str, span: str, when: str, later: str, back: bool) -> None:
    assert codes(loads, span, when, later) == ([("PL434", 5)] if back else [])
