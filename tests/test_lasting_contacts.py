"""What follows a plastic impact: its partners stay in contact, or the file must say."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution
from planar_cli.problem.structure import load_text
from planar_cli.simulate.run import Settings, simulate

SCALE = """
title: Block dropped onto the pan of a spring scale
plane: vertical
given: {{mA: 30 kg, mB: 10 kg, k: 20 kN/m, h: 2 m}}
points: {{A: [0, h], B: [0, 0], F: [0, -1 m]}}
bodies: {{block: {{particle: A, mass: mA}}, pan: {{particle: B, mass: mB}}}}
joints:
  - guide: {{point: B, along: 90 deg, name: shaft}}
  - impact: {{between: [block, pan], normal: 90 deg, restitution: 0{during}}}
loads:
  - spring: {{between: [F, B], stiffness: k, natural_length: 1 m + mB*g/k}}
states: {{1: [at rest], 2: [y(A) = 0], 3: [just after 2], 4: [y(B) is smallest]}}
find: {{gap: y(A) @ 4 - y(B) @ 4, v: v(pan).y @ 3, y: y(B) @ 4}}
"""
LANDING = """
title: Block on a table, pulled by one that lands
plane: vertical
given: {{m_A: 3 kg, m_B: 2 kg, mu: 0.25, h: 0.6 m}}
points: {{A: [-2 m, 0], D: [0, 0], B: [0, -0.4 m], F: [0, -0.4 m - h]}}
surfaces: {{table: {{through: A, angle: 0 deg}}, floor: {{through: F, angle: 0 deg}}}}
bodies: {{A: {{particle: A, mass: m_A}}, B: {{particle: B, mass: m_B}}}}
joints:
  - contact: {{between: [A, table], at: A, mu: mu}}
  - impact: {{between: [B, floor], restitution: 0{during}}}
  - rope: {{path: [A, D, B], name: cord}}
states: {{start: [t = 0, at rest], lands: [y(B) = y(F)], after: [just after lands], stop: [v(A).x = 0]}}
find: {{y: y(B) @ stop, x: x(A) @ stop - x(A) @ lands}}
"""
SLIDE = """
title: Stone that drops onto a rough slope and stays on it
plane: vertical
given: {m: 1 kg, h: 2 m, beta: 30 deg, mu: 0.2}
points: {O: [0, 0], P: [0, h]}
surfaces: {slope: {through: O, angle: -beta}}
bodies: {stone: {particle: P, mass: m}}
joints:
  - impact: {between: [stone, slope], restitution: 0, mu: mu, during: 2->3}
states: {1: [at rest], 2: [y(P) = 0], 3: [just after 2], 4: [t - t @ 3 = 1 s]}
find: {v: v(stone).mag @ 4}
"""
PENDULUM = """
title: Bullet and block on a cord
plane: vertical
given: {{m: 20 g, M: 2 kg, v: 300 m/s, l: 1.5 m}}
points: {{O: [0, l], B: [0, 0]}}
bodies: {{bullet: {{particle: {place}, mass: m}}, block: {{particle: B, mass: M}}}}
joints:
  - rope: {{path: [O, block], name: cord}}
  - impact: {{between: [bullet, block], normal: 0 deg, restitution: 0, during: 1->2}}
{weld}
states: {{1: [v(bullet).x = v, v(bullet).y = 0, block at rest], 2: [just after 1], 3: [y(block) is largest]}}
find: {{h: y(block) @ 3}}
"""
BOUNCE = """
title: Ball that falls, with one impact
plane: vertical
given: {h: 1 m, e: 0.6, m: 1 kg}
points: {P: [0, h], O: [0, 0]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {ball: {particle: P, mass: m}}
joints:
  - impact: {between: [ball, floor], restitution: e, during: 2->3}
states: {1: [at rest], 2: [y(ball) = 0], 3: [just after 2], 4: [t - t @ 3 = 1 s]}
find: {y: y(ball) @ 4}
"""
FLAT = """
title: Rod that falls flat on both ends at once
plane: vertical
given: {m: 3 kg, l: 1.2 m, h: 0.8 m, e: 0.4}
points: {A: [-l/2, h], B: [l/2, h], O: [0, 0]}
surfaces: {floor: {through: O, angle: 0 deg}}
bodies: {AB: {rod: [A, B], mass: m}}
joints:
  - impact: {between: [AB, floor], restitution: e, name: hit}
states: {1: [t = 0, at rest], 2: [y(A) = 0], 3: [just after 2], 4: [y(A) is largest]}
find: {v: v(A).y @ 3, w: omega(AB) @ 3, h: y(B) @ 4}
"""
WELD = "  - weld: {between: [bullet, block], at: B, during: 1->3}"
G = 9.81


def _first(text: str) -> dict[str, float]:
    return {name: float(f.values[0]) for name, f in solve(text).items() if f.values}


@pytest.mark.parametrize("during", ["", ", during: 2->3"])
def test_a_block_stays_on_the_pan_that_it_hits(during: str) -> None:
    """Both go on with one velocity; by energy k y²/2 + m_A g y = (m_A + m_B) v²/2."""
    found = _first(SCALE.format(during=during))
    v = 30 * math.sqrt(2 * G * 2) / 40
    assert found["v"] == pytest.approx(-v)
    weight, k = 30 * G, 20000
    assert found["y"] == pytest.approx(-(weight + math.sqrt(weight**2 + k * 40 * v**2)) / k)
    assert found["gap"] == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("during", ["", ", during: lands->after"])
def test_what_lands_stays_down(during: str) -> None:
    """The cord is slack then, and the other one slides on by v²/(2 μ g)."""
    found = _first(LANDING.format(during=during))
    a = (2 - 0.25 * 3) / 5 * G
    assert found["y"] == pytest.approx(-1)
    assert found["x"] == pytest.approx(2 * a * 0.6 / (2 * 0.25 * G))


def test_friction_of_the_impact_lasts_too() -> None:
    """Of the speed on arrival the impact takes v cos β, and by friction μ times that along the slope."""
    v, beta = math.sqrt(2 * G * 2), math.radians(30)
    along = v * (math.sin(beta) - 0.2 * math.cos(beta)) + G * (math.sin(beta) - 0.2 * math.cos(beta))
    assert _first(SLIDE)["v"] == pytest.approx(along)


@pytest.mark.parametrize("place", ["B", "[-0.2 m, 0]"])
def test_what_stays_together_must_be_said(place: str) -> None:
    """Points have no faces along which they could slide, and bodies drawn apart do not touch."""
    with pytest.raises(NoSolution) as refused:
        solve(PENDULUM.format(place=place, weld=""))
    (found,) = refused.value.diagnostics
    assert (found.code, found.mark.line) == ("PL714", 9)
    assert "weld: {between: [bullet, block], at: P, during: 1->3}" in found.hint


def test_points_that_slide_are_told_without_during_too() -> None:
    """An impact that names no states acts whenever its bodies meet; what it leaves open is the same."""
    text = PENDULUM.format(place="B", weld="").replace(", during: 1->2", "")
    assert "during" not in text
    with pytest.raises(NoSolution) as refused:
        solve(text)
    assert [d.code for d in refused.value.diagnostics] == ["PL714"]


def test_lengths_are_told_in_feet_where_the_file_is_in_feet() -> None:
    """As the author drew them."""
    text = PENDULUM.format(place="[-0.2 ft, 0]", weld="")
    for metric, us in (("20 g", "0.05 lb"), ("2 kg", "5 lb"), ("300 m/s", "900 ft/s"), ("1.5 m", "5 ft")):
        text = text.replace(metric, us)
    with pytest.raises(NoSolution) as refused:
        solve(text)
    assert "0.2 ft apart" in refused.value.diagnostics[0].message


def test_a_weld_beside_the_impact_keeps_them_together() -> None:
    """By momentum and energy: v = m v_0/(m + M), h = v²/(2 g), and both principles agree."""
    v = 0.02 * 300 / 2.02
    assert _first(PENDULUM.format(place="B", weld=WELD))["h"] == pytest.approx(v**2 / (2 * G))


def test_partners_of_an_impact_that_is_over_do_not_pass_through_each_other() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(BOUNCE)
    (found,) = refused.value.diagnostics
    assert (found.code, found.mark.line) == ("PL715", 9)
    problem, _ = load_text(BOUNCE)
    assert problem is not None
    assert simulate(problem, Settings()).run.trajectory.outcome.code == "PL715"
    # With states for it, and an impact at all times, it strikes again.
    twice = BOUNCE.replace(", during: 2->3", "").replace("4: [t - t @ 3 = 1 s]", "a: [y(ball) = 0], b: [just after a]")
    again = _first(twice.replace("y: y(ball) @ 4", "t: t @ b, v: v(ball).y @ b"))
    assert again["v"] == pytest.approx(0.36 * math.sqrt(2 * G))
    assert again["t"] == pytest.approx((1 + 2 * 0.6) * math.sqrt(2 / G))


def test_a_rod_falls_flat() -> None:
    """Both ends rise with e times the speed with which they come."""
    found = _first(FLAT)
    assert found == pytest.approx({"v": 0.4 * math.sqrt(2 * G * 0.8), "w": 0, "h": 0.16 * 0.8}, abs=1e-12)


PILE = """
title: Pile that is driven into the ground
plane: vertical
points: {Q: [0, -3 m], T: [0, 0], K: [0, 2 m]}
bodies: {pile: {rod: [Q, T], mass: 250 kg}, hammer: {particle: K, mass: 400 kg}}
joints:
  - guide: {body: pile, along: 90 deg, name: hole}
  - guide: {point: K, along: 90 deg, name: mast}
  - weld: {at: Q, between: [ground, pile], during: 1->2}
  - impact: {between: [hammer, pile], at: T, normal: 90 deg, restitution: 0, name: blow}
loads:
  - force: {body: pile, at: Q, magnitude: 150 kN, angle: 90 deg, during: 3->4}
states: {1: [t = 0, at rest], 2: [y(hammer) = 0], 3: [just after 2], 4: [v(pile).y = 0]}
find: {depth: y(Q) @ 3 - y(Q) @ 4, press: N(blow) @ 3}
"""


def test_what_falls_on_the_end_of_a_rod_goes_on_with_it() -> None:
    """Both are braked together: u = M v/(M + m), (R - M g - m g) d = (M + m) u²/2."""
    found = _first(PILE)
    u = 400 * math.sqrt(4 * 9.81) / 650
    braked = 150000 / 650 - 9.81
    assert found["depth"] == pytest.approx(u**2 / (2 * braked))
    assert found["press"] == pytest.approx(400 * (9.81 + braked))
