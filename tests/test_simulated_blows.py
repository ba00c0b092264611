"""Blows in a motion that is followed in numbers: who strikes, and what impulses do over a span."""

from __future__ import annotations

import pytest

from planar_cli.problem.structure import load_text
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.run import Settings, simulate

PARTICLES = """
title: Two particles collide head on
plane: horizontal
bodies: {A: {particle: [0, 0], mass: 2 kg}, B: {particle: [1 m, 0], mass: 3 kg}}
joints:
  - impact: {between: [A, B], restitution: 0.25, name: hit}
states:
  1: [v(A).x = 5 m/s, v(A).y = 0, v(B).x = -1 m/s, v(B).y = 0%s]
  2: [just after 1]
find: {u: v(A).x @ 2, J: impulse(hit/B).x @ 1->2, W: work(hit/A) @ 1->2, all: work(all) @ 1->2, Q: heat(hit) @ 1->2}
"""
BLOCK = """
title: Block on a floor, struck
plane: vertical
points: {C: [0, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {block: {particle: C, mass: 2 kg}}
joints:
  - contact: {between: [block, floor], at: C, mu: 0.3}
loads:
  - impulse: {name: blow, body: block, magnitude: 6 N*s, angle: %s deg, during: 1->2}
states: {1: [t = 0, at rest], 2: [just after 1]}
find: {mode: mode(C) @ 2, W: work(blow) @ 1->2, T: KE(block) @ 2, J: impulse(C).y @ 1->2, Q: heat(all) @ 1->2}
"""


def answers(text: str) -> dict[str, Answered]:
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return {a.name: a for a in simulate(problem, Settings(estimate=False)).answers}


def test_particles_drawn_apart_strike_where_the_file_says_so() -> None:
    """They stand for bodies of any size; every impulse works by the mean of the velocities where it acts."""
    found = answers(PARTICLES % "")
    numbers = [found[n].values[0] for n in ("u", "J", "W", "all", "Q")]
    assert numbers == pytest.approx([0.5, 9.0, -9 * (5 + 0.5) / 2, -20.25, 20.25])


def test_particles_that_a_state_holds_apart_do_not_strike() -> None:
    found = answers(PARTICLES % ", x(B) - x(A) = 1 m, y(B) = y(A)")
    assert [found[n].values[0] for n in ("u", "J", "Q")] == [5.0, 0.0, 0.0]


@pytest.mark.parametrize(("angle", "mode"), [(30, "apart"), (-30, "slip"), (-80, "stick")])
def test_a_mode_just_after_a_blow_is_the_one_of_what_follows(angle: float, mode: str) -> None:
    assert answers(BLOCK % angle)["mode"].word == mode


def test_what_an_impulse_of_a_load_works_and_what_friction_takes() -> None:
    """J (v_1 + v_2)/2 of the load is what the block gets and what friction takes from it."""
    found = {n: a.values[0] for n, a in answers(BLOCK % -30).items() if a.values}
    assert found["J"] == pytest.approx(3.0)
    assert found["W"] == pytest.approx(found["T"] + found["Q"])
    assert found["Q"] > 0


def test_a_blow_that_moves_nothing_has_impulses() -> None:
    found = {n: a.values[0] for n, a in answers(BLOCK % -80).items() if a.values}
    assert found["J"] == pytest.approx(6 * 0.984807753012208)
    assert found["W"] == found["Q"] == 0


RING = """
title: Ball in a ring
plane: vertical
points: {O: [0, 0], G: [0.5 m, 0]}
bodies: {ball: {disk: G, radius: 0.1 m, mass: 1 kg}, drum: {ring: O, radius: 1 m, mass: 5 kg}}
joints:
  - pin: {at: O, between: [ground, drum]}
  - impact: {between: [%s], restitution: 0.8}
states: {1: [t = 0, at rest], 2: [t = 0.5 s]}
find: {x: x(G) @ 2, y: y(G) @ 2, v: v(G).mag @ 2}
"""


def test_a_ring_struck_from_within_whoever_is_named_first() -> None:
    """It falls sqrt(0.81 - 0.25) m to the ring, whose normal there is along the radius."""
    one, other = (answers(RING % names) for names in ("ball, drum", "drum, ball"))
    depth, g = 0.56**0.5, 9.81
    down, n = (2 * g * depth) ** 0.5, (-0.5 / 0.9, depth / 0.9)
    gain = 1.8 * down * n[1]
    u, w, t = gain * n[0], gain * n[1] - down, 0.5 - (2 * depth / g) ** 0.5
    for found in (one, other):
        assert found["x"].values == pytest.approx([0.5 + u * t])
        assert found["y"].values == pytest.approx([-depth + w * t - g * t * t / 2])
        assert found["v"].values == pytest.approx([(u**2 + (w - g * t) ** 2) ** 0.5])


HOOK = """
title: Falling bar whose end catches on a hook
plane: vertical
given: {m: 4 kg, l: 1 m, h: 0.8 m}
points: {A: [0, 0], B: [l, 0]}
bodies: {bar: {rod: [A, B], mass: m}}
joints:
  - pin: {at: A, between: [ground, bar], during: %s}
states:
  1: [v(bar).x = 0, v(bar).y = -sqrt(2*g*h), omega(bar) = 0]
  2: [just after 1]
  3: [theta(bar) = -90 deg]
find: {w: omega(bar) @ 2, loss: KE(bar) @ 1 - KE(bar) @ 2, last: omega(bar) @ 3}
"""


@pytest.mark.parametrize("span", ["1->3", "2->3"])
def test_what_takes_hold_from_the_state_just_after_a_blow_makes_the_blow(span: str) -> None:
    """About A the momentum stays: m v l/2 = m l^2/3 ω; then m l^2/6 (ω_3^2 - ω^2) = m g l/2."""
    found = answers(HOOK % span)
    speed = 1.5 * (2 * 9.81 * 0.8) ** 0.5
    numbers = [found[n].values[0] for n in ("w", "loss", "last")]
    assert numbers == pytest.approx([-speed, 9.81 * 0.8, -((speed**2 + 3 * 9.81) ** 0.5)])
