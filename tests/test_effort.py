"""Energy before Newton's law where several bodies move and only speeds and places are asked."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp
from worked import page_of_file, page_of_text

from planar_cli.solve.between.route.cheapest import cheapest
from planar_cli.solve.regimes.equations import Equation

BLOCKS_AND_DRUM = """
title: Block, drum and block with a spring
plane: vertical
given:
  {m_A: 15 kg, m_B: 20 kg, m_C: 30 kg, mu: 0.2, k: 20 N/m, s: 0.3 m, v_1: 2.5 m/s, h: 1 m, R: 0.3 m}
points:
  {B: [0, 0], U: [0, R], A: [R, -0.5 m], V: [R, 0], C: [-2 m, R], W: [-3.2 m, R]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {A: {particle: A, mass: m_A}, drum: {disk: B, radius: R, mass: m_B}, C: {particle: C, mass: m_C}}
joints:
  - pin: {at: B, between: [ground, drum]}
  - contact: {between: [C, floor], at: C, mu_k: mu, name: floorC}
  - rope: {path: [C, U on drum], name: upper}
  - rope: {path: [A, V on drum], name: lower}
loads:
  - spring: {between: [W, C], stiffness: k, natural_length: 1.2 m + s, name: spring}
states:
  1: [v(A).y = -v_1]
  2: [y(A) @ 1 - y(A) = h]
find: {v_2: v(A).mag @ 2FIND}
"""


def test_speed_and_way_of_several_bodies_follow_from_one_balance_of_energies() -> None:
    page = page_of_file("load-on-four-strands")
    assert "Principle Work and energy between the states." in page
    assert "ΣF" not in page
    assert "= 5.844 m/s², constant; 2 " in page, "Newton's law is the check"


def test_where_a_force_is_asked_newtons_law_stays() -> None:
    assert "ΣF_y" in page_of_file("gears-turned-by-a-load")


def test_with_newtons_law_a_constant_acceleration_is_shorter_than_energies() -> None:
    page = page_of_file("gears-turned-by-a-load")
    assert "Principle Newton's second law. Constant angular acceleration." in page
    assert "constant angular acceleration of the pinion" in page
    assert "= 392.4 - 200 = 192.4 J; T_2 = 29.6 + 88.8 + 74 = 192.4 J (pinion, gear, load)" in page


def test_a_way_between_given_places_is_in_letters() -> None:
    page = page_of_file("ex-4-09")
    assert "(2) θ_2 = h/R = 0.6/0.2 = 3 rad" in page
    assert "y_A,1" not in page, "the way alone counts, not the places"
    assert "F r θ_2 - M θ_2 - m_A g h = 1/2 m k_O² ω_2² + 1/2 m_A v²" in page


def test_a_constant_acceleration_that_is_needed_anyway_serves_for_speeds_and_heights_too() -> None:
    page = page_of_file("ex-1-06")
    assert "Principle Newton's second law. Constant acceleration." in page
    assert "(2): y_top = v0²/(2 g) + h" in page
    assert "From thrown to half, constant acceleration of the ball along y:" in page
    assert "(3) v_half² = v0² - 2 g (y_half - h)" in page
    assert "work and kinetic energy" not in page


def test_where_no_law_is_needed_energies_stay() -> None:
    """The push of the buffer is asked, and no time while the block slides freely."""
    assert "From 1 to meets, work and kinetic energy" in page_of_file("block-down-a-slope-onto-a-buffer")
    assert "From 1 to 2, work and kinetic energy" in page_of_file("falling-rod-caught-by-a-cord")


def test_a_velocity_that_stays_has_its_reason() -> None:
    """Constant velocity of the rolling ball has told its place already; of the free carriages that no force acts."""
    ball, carriages = page_of_file("body-ball-that-slides-then-rolls"), page_of_file("three-carriages")
    place = ball.index("From rolls to later, constant angular velocity of the ball: (9) θ_later = θ_rolls + ")
    assert place < ball.index("From rolls to later, no angular acceleration of the ball: (11) ω_later = ω_rolls = ")
    assert "T_rolls + U" not in ball
    assert "no acceleration, x of" not in carriages
    assert carriages.count("no resultant force acts on") == 5


def test_the_work_by_a_height_that_was_sought_has_its_number() -> None:
    page = page_of_file("ladder-leaving-the-wall")
    assert "y_G,2 = 1/2 l sin θ_2 U of the weight" in page
    assert "U of the weight of ladder = 1/2 m g l sin θ_2 = 1/2 · 15 · 9.81 · 4 sin 141.2° = 184.4 J" in page


@pytest.mark.parametrize("find", ["", ", Q: heat(floorC) @ 1->2"], ids=["speed", "speed and heat"])
def test_places_that_follow_from_one_angle_count_once(tmp_path: Path, find: str) -> None:
    """Energies take the places of both blocks and the angle of the drum, which one line tells all."""
    page = page_of_text(tmp_path, BLOCKS_AND_DRUM.replace("FIND", find))
    assert "From 1 to 2, work and kinetic energy" in page
    assert "ω dω = α dθ" not in page
    assert "v_2 = 3.052 m/s" in page


def test_a_way_costs_each_of_its_equations_once() -> None:
    a, b, c, x = sp.symbols("a b c x")
    by_three, by_one = Equation(x - a - b - c, "energy", "", ""), Equation(x - a, "v(q)", "", "")
    first, second, third = (Equation(s, "link", "", "") for s in (a, b - a, c - b))
    none = frozenset[sp.Symbol]()
    edges = [
        ((first,), (a,), none, 2.0),
        ((second,), (b,), frozenset({a}), 0.5),
        ((third,), (c,), frozenset({b}), 0.5),
        ((by_three,), (x,), frozenset({a, b, c}), 1.0),
        ((by_one,), (x,), frozenset({a}), 3.0),
    ]
    assert cheapest(edges)[x].equations == (by_three,)
    assert cheapest(edges)[x].cost == 4.0


def test_an_acceleration_that_a_force_needs_serves_for_its_stretch() -> None:
    page = page_of_file("load-wound-up-against-axle-friction")
    assert "From 2 to 3, constant angular acceleration of the wheel" in page
    assert "(12) ω_3² = -2 α_2 θ_2" in page
    # A given force needs none.
    assert "From 1 to mid, work and kinetic energy" in page_of_file("crate-winched-up-a-slope"), (
        "a given force needs none"
    )


def test_what_two_balances_tell_together_needs_no_law_of_motion() -> None:
    """Energy and momentum tell both speeds; the acceleration of the block on the carrier stays unwritten."""
    page = page_of_file("block-shot-along-a-carrier")
    assert "(5), (6) together: v_B,carrier,3" in page
    assert "From 2 to 3, constant acceleration" not in page
