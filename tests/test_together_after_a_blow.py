"""Two bodies on guides of their own that stay together after a blow: a spring pulls where they then are."""

from __future__ import annotations

from math import sqrt
from pathlib import Path

import pytest
from answered import solved
from conftest import ROOT
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate

DROPPED = """\
plane: vertical
given: {{m_A: 30 kg, m_B: 10 kg, h: 2 m, k: 20 kN/m}}
points: {{A: [0, h], B: [0, 0], O: [0, -1 m]}}
bodies:
  block: {{particle: A, mass: m_A}}
  pan: {{particle: B, mass: m_B}}
joints:
  - guide: {{point: A, along: 90 deg, name: shaft}}
  - guide: {{point: B, along: 90 deg, name: column}}
  - {joint}
loads:
  - spring: {{between: [O, B], stiffness: k, natural_length: 1 m + m_B*g/k}}
states:
  1: [t = 0, at rest]
  2: [y(block) = 0]
  3: [just after 2]
  4: [v(pan).y = 0]
find: {{v3: v(pan).y @ 3, s: y(pan) @ 4, lost: KE(all) @ 2 - KE(all) @ 3}}
"""
JOINTS = [
    "impact: {between: [block, pan], restitution: 0, during: 2->3}",
    "impact: {between: [pan, block], restitution: 0, during: 2->3}",
    "impact: {between: [block, pan], restitution: 0}",
    "weld: {at: B, between: [block, pan], during: 2->4}",
]


@pytest.mark.parametrize("joint", JOINTS)
def test_a_block_dropped_on_a_pan(tmp_path: Path, joint: str) -> None:
    """Energy after the blow: m v²/2 + m_A g s = k s²/2, s from where the spring carries the pan."""
    found = solved(tmp_path, DROPPED.format(joint=joint))
    v, m, k, w = 0.75 * sqrt(2 * 9.81 * 2), 40.0, 20000.0, 30 * 9.81
    assert float(found["v3"].values[0]) == pytest.approx(-v)
    assert float(found["s"].values[0]) == pytest.approx(-(w + sqrt(w**2 + k * m * v**2)) / k)
    assert float(found["lost"].values[0]) == pytest.approx(0.25 * 30 * 9.81 * 2)


CARTS = """\
plane: horizontal
symbols: {{m_A: kg, m_B: kg, k: N/m, v_0: m/s, d: m}}
points: {{A: [{sign}d, 0], B: [0, 0], O: [{other}d, 0]}}
bodies:
  one: {{particle: A, mass: m_A}}
  two: {{particle: B, mass: m_B}}
joints:
  - guide: {{point: A, along: 0 deg, name: rail_1}}
  - guide: {{point: B, along: 0 deg, name: rail_2}}
  - impact: {{between: [one, two], restitution: 0, during: 2->3}}
loads:
  - spring: {{between: [O, B], stiffness: k, natural_length: d}}
states:
  1: [t = 0, v(one).x = {other}v_0, two at rest]
  2: [x(one) = 0]
  3: [just after 2]
  4: [v(two).x = 0]
find: {{s: x(two) @ 4}}
"""


@pytest.mark.parametrize("sign", ["", "-"])
def test_carts_that_couple_in_letters(tmp_path: Path, sign: str) -> None:
    """(m_A + m_B) v²/2 = k s²/2 with m_A v_0 = (m_A + m_B) v."""
    found = solved(tmp_path, CARTS.format(sign=sign, other="" if sign else "-"))
    (expr,) = found["s"].expressions or ()
    told = {"m_A": 2.0, "m_B": 3.0, "k": 50.0, "v_0": 1.5, "d": 4.0}
    value = float(expr.subs({s: told[s.name] for s in expr.free_symbols}))
    assert value == pytest.approx((1 if sign else -1) * 3.0 / sqrt(5 * 50))


def test_the_forces_after_the_blow_are_told() -> None:
    """From them the equation of motion follows in which the start after the blow stands."""
    page = Terminal(200).render(
        narrate(worked(ROOT / "problems/impact/cart-that-couples-with-a-buffered-cart.yaml")[0])
    )
    assert "one, two:  k x_B ← at B   =   m_A a_A → at A,  m_B a_B → at B" in page
    assert "→ ΣF_x:   -k x_B = m_A a_A + m_B a_B" in page
