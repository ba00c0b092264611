"""What is constant on each stretch of a motion is told by its own equations, in which mistakes can be made."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from homework_made import with_known_mistakes

from planar_cli.homework.variants.worked_problem import read_and_solve

PROBLEM = Path(__file__).parents[1] / "problems" / "motion" / "body-block-sent-up-a-slope.yaml"
G, MU, V = 9.81, 0.25, 6.0
SIN, COS = math.sin(math.radians(30)), math.cos(math.radians(30))


def mistakes() -> dict[str, dict[str, float]]:
    row = with_known_mistakes(read_and_solve(str(PROBLEM), "p"))
    return {e.find: {m.name: m.values[0] for m in reversed(e.mistakes)} for e in row}


def test_up_and_back_have_their_own_friction() -> None:
    found = mistakes()
    assert found["s_top"]["friction-left-out"] == pytest.approx(V**2 / (2 * G * SIN))
    assert found["s_top"]["friction-reversed"] == pytest.approx(V**2 / (2 * G * (SIN - MU * COS)))
    assert found["t_top"]["normal-force-is-weight"] == pytest.approx(V / (G * (SIN + MU)))
    assert found["a_back"]["friction-left-out"] == pytest.approx(-G * SIN)
    assert found["a_back"]["friction-reversed"] == pytest.approx(-G * (SIN + MU * COS))
    assert found["v_back"]["friction-left-out"] == pytest.approx(V)
