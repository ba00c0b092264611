"""Two particles on a cord go round their mass centre, which goes on as if they were one."""

from __future__ import annotations

from pathlib import Path

import pytest
from worked import page_of_file, page_of_text

FALLING = """
title: Two balls on a cord that jerks taut in the air
plane: vertical
given: {m_P: 4 kg, m_Q: 2.5 kg}
bodies:
  P: {particle: [0, 0], mass: m_P}
  Q: {particle: [1 m, 0], mass: m_Q}
joints:
  - rope: {path: [P, Q], name: cord, during: 2->4}
states:
  1: [t = 0, v(P).x = 0, v(P).y = 6 m/s, v(Q).mag = 9 m/s, v(Q).angle = 60 deg]
  2: [r(Q/P).mag = 2 m]
  3: [just after 2]
  4: [t = 0.8 s]
find: {S: tension(cord) @ 4, v: v(Q) @ 4}
"""
DRAGGED = FALLING.replace(
    "states:", "loads:\n  - force: {body: P, at: P, magnitude: 3 N, angle: 200 deg, name: drag}\nstates:"
).replace("tension(cord) @ 4, v: v(Q) @ 4", "tension(cord) @ 3")


def test_a_pair_on_a_table() -> None:
    page = page_of_file("impact/rope-that-jerks-taut")
    lines = [
        "v_Gx = m_B v_Bx,2 / (m_A + m_B) = 2.5 · 2.5 / (4 + 2.5) = 0.9615 m/s",
        "AG = m_B l / (m_A + m_B) = 2.5 · 2 / (4 + 2.5) = 0.7692 m",
        "No force from outside acts on A and B: G keeps its velocity. The pull of the line passes through G,",
        "ω = v_B/A,3/l = 2.165/2 = 1.083 rad/s",
        "β_4 = β + ω (t_4 - t_2) = 0.5994 + 1.0825 (2 - 0.2606) = 2.482 rad = 142.2°",
        "x_A,4 = x_G,2 + v_Gx (t_4 - t_2) - AG cos β_4",
        "T = m_A AG ω² = 4 · 0.76923 · 1.0825² = 3.606 N",
    ]
    assert [told for told in lines if told not in page] == []
    assert "numerical integration" not in page
    assert "STATE" not in page


@pytest.mark.slow
def test_a_pair_in_the_air(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, FALLING)
    lines = [
        "PQ = 2 m",
        "Beside the weights no force from outside acts on P and Q: G is in free flight.",
        "the pull gives P the acceleration PG ω² towards G, beside g:",
        "v_Qy,4 = v_Gy,2 + QG ω cos β_4 - g (t_4 - t_2)",
        "S = m_P PG ω² = 4 · 0.7692 · 0.44856² = 0.6191 N",
    ]
    assert [told for told in lines if told not in page] == []
    assert "numerical integration" not in page


@pytest.mark.slow
def test_a_force_from_outside_leaves_no_free_pair(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, DRAGGED)
    assert "STATE 3" in page
    assert "mass centre of P and Q:" not in page


def test_a_length_of_the_cord_that_nothing_needs_is_not_told(tmp_path: Path) -> None:
    moving = "v(P).mag = 0 m/s, v(Q).x = -6 m/s, v(Q).y = 2 m/s"
    text = FALLING.replace("v(P).x = 0, v(P).y = 6 m/s, v(Q).mag = 9 m/s, v(Q).angle = 60 deg", moving)
    text = text.replace("[1 m, 0]", "[-1 m, 0.5 m]").replace("vertical", "horizontal").replace("0.8 s", "1.2 s")
    page = page_of_text(tmp_path, text.replace("v: v(Q) @ 4", "v: v(Q) @ 4, x: x(P) @ 4"))
    assert "x_P,4 = " in page
    assert "x_Q,4" not in page
    assert "keeps its length" not in page


def test_the_mass_centre_of_equal_ones_is_midway(tmp_path: Path) -> None:
    moving = "v(P).x = 0, v(P).y = -3 m/s, v(Q).x = -3 m/s, v(Q).y = 0"
    text = FALLING.replace("mass: m_Q", "mass: m_P").replace(", m_Q: 2.5 kg", "").replace("[1 m, 0]", "[1 m, 0.5 m]")
    text = text.replace("v(P).x = 0, v(P).y = 6 m/s, v(Q).mag = 9 m/s, v(Q).angle = 60 deg", moving)
    page = page_of_text(tmp_path, text.replace("vertical", "horizontal").replace("v: v(Q)", "y: y(P)"))
    assert "y_G,2 = y_P,2/2 + y_Q,2/2 = " in page


@pytest.mark.slow
def test_what_goes_on_when_the_cord_has_let_go_leaves_no_free_pair(tmp_path: Path) -> None:
    text = FALLING.replace("find: {", "  5: [t = 1.2 s]\nfind: {y: y(Q) @ 5, ")
    page = page_of_text(tmp_path, text)
    assert "G is in free flight" not in page
    assert "MOTION from 3 to 4" in page
