"""What goes one way along a straight line through a whole motion counts so: s and v downward, m g - c v² = m a."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import page_of_file, page_of_text

THROWN = """\
title: Ball
plane: vertical
given: {h: 3 m, v_0: 4 m/s}
bodies: {ball: {particle: [0, h], mass: 2 kg}}
states:
  1: [t = 0, v(ball).x = 0, v(ball).y = v_0]
  2: [y(ball) = 0]
find: {v: v(ball).mag @ 2}
"""
DROPPED = THROWN.replace("v(ball).x = 0, v(ball).y = v_0", "at rest").replace(", v_0: 4 m/s", "")
DRAWN = """\
title: Block drawn to the left
plane: vertical
given: {F: 12 N, m: 3 kg}
points: {A: [0, 0]}
surfaces: {table: {through: A, angle: 0 deg}}
bodies: {block: {particle: A, mass: m}}
joints: [contact: {between: [block, table], mu: 0.2}]
loads: [force: {body: block, magnitude: F, angle: 180 deg}]
states: {1: [t = 0, at rest], 2: [t = 2 s]}
find: {v: v(block).mag @ 2, d: -x(block) @ 2}
"""


@pytest.mark.parametrize(("name", "lines"), [
    ("parachutist", [
        "P: m g ↓, c v² ↑ = m a ↓ (1) ↓ ΣF_y: m g - c v² = m a",
        "s: the way of P downward, s = -y",
        "v_after_5 = v_t tanh(g t_after_5/v_t)",
        "s_after_5 = v_t² ln(cosh(g t_after_5/v_t))/g",
        "d_5 = s_after_5 = 110.0 m",
    ]),
    ("weight-dropped-on-a-spring", [
        "P: m g ↓, k s_P ↑ = m a_P ↓",
        "v_P,meets = √(2 g h)",
        "U of the weight of P = m g (h + s_P,lowest)",
        "v_max = v_P,fastest = √(m g²/k + 2 g h)",
        "c = s_P,lowest = m g (1 + √(1 + 2 k h/(m g))) / k",
        "With h → 0: v_max = g √(m/k); c = 2 m g/k.",
    ]),
    ("pile-driven-into-soil-of-constant-resistance", [
        "v_Q,2 = √(2 g h) = √(2 · 9.81 · 2) = 6.264 m/s",
        "ram: m_1 v_Q,2 ↓, J ↑ = m_1 v_P,3 ↓",
        "↓ m_1 v_Q,2 = (m_1 + m_2) v_P,3",
        # The earlier place less the later one is how far it went against the axis.
        "d = s_P,4 = 0.04703 m downward",
    ]),
    # What the author counts upward is turned back in the answer.
    ("pile-driver", ["v_3 = -v_A,3 = -11.79 ft/s, that is 11.79 ft/s downward", "d = s_B,4 = 0.1543 ft downward"]),
    ("stone-in-well", ["a = g = 9.81 m/s²", "v_splash = g t_splash = 9.81 · 3.7925 = 37.20 m/s"]),
    ("bungee-jump", ["man: m g ↓, k_c (s - l) ↑ = m a ↓", "U of the weight of man = m g s_fast"]),
    # A momentum that varies in time counts so too, and what hangs on a rope with what goes up.
    ("drop-that-grows-in-mist", ["impulse = ∫[0 → T] (M g + g q t) dt", "↓ T g (M + 1/2 T q) = v_A,2 (M + T q)"]),
    ("atwood-let-go", ["a_A = a_By", "s_A: the way of A downward, s_A = -1 - y_A"]),
    # So does the centre of what unwinds from a cord, and a load on a drum, which turns the way it is counted.
    ("yo-yo", ["v_G = r ω", "= m a_G ↓ at G, I_G α ↺", "m g r = m a_G r + I_G α", "T_thread = m (g - a_G)"]),
    ("body-atwood-with-heavy-pulley", ["a_A = r α", "s_A: the way of A downward", "Δs_A = r Δθ"]),
    ("gears-turned-by-a-load", ["R_2 ω_gear = R_1 ω_pinion", "a_L = r α_gear", "speed = v_L,2 = 2.720 m/s"]),
    ("winch-with-counterweight", [
        "Angular impulse and momentum.",
        "v_Ay = R ω",
        "v_B = R ω",
        "= I_drum α ↻",
        "H_O = 106.4 kg·m²/s clockwise",
    ]),
    ("load-of-a-movable-pulley-that-lands", ["x_A + 2 y_B = const., differentiated twice: (2) a_A = 2 a_B"]),
])  # fmt: skip
def test_what_goes_one_way_counts_so(name: str, lines: list[str]) -> None:
    page = page_of_file(name)
    assert [said for said in lines if said not in page] == []
    assert "negative root" not in page


def test_a_spool_that_unwinds_clockwise_counts_so(tmp_path: Path) -> None:
    (path,) = (p for p in PROBLEMS if p.stem == "yo-yo")
    left = path.read_text().replace("T: [r, 0], A: [r,", "T: [-r, 0], A: [-r,")
    page = page_of_text(tmp_path, left)
    assert "ω is counted clockwise" in page
    assert "= m a_G ↓ at G, I_G α ↻" in page
    assert "ω_2 = 96.09 rad/s clockwise" in page


def test_a_way_is_counted_from_where_it_starts_or_the_origin_that_it_passes(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, DROPPED)
    assert "m g h = 1/2 m v_2² (1): v_2 = √(2 g h)" in page
    assert "the negative root" not in page
    below = page_of_text(tmp_path, DROPPED.replace("y(ball) = 0", "y(ball) = -1 m").replace("v(ball).mag", "-y(ball)"))
    assert "s: the way of the ball downward, s = -y At 2, as given: s_2 = 1 m" in below


def test_to_the_left(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, DRAWN)
    assert "F ←, N_block ↑, μ N_block → = m a ←" in page
    assert "← ΣF_x: F - μ N_block = m a" in page
    assert "s: the way of A to the left, s = -x" in page
    assert "d = s_2 = 4.076 m" in page


def test_what_goes_both_ways_keeps_the_axes(tmp_path: Path) -> None:
    page = page_of_text(tmp_path, THROWN)
    assert "v_y,2 = -√(2 g h + v_0²)" in page
    assert "downward" not in page


@pytest.mark.parametrize(
    "name", ["ball-bouncing-twice", "block-falling-through-oil", "weight-dropped-on-nested-springs"]
)
def test_what_is_asked_along_the_axis_or_has_its_place_on_it_keeps_the_axes(name: str) -> None:
    assert "downward, s" not in page_of_file(name)


def test_a_balance_of_momenta_counts_so_too(tmp_path: Path) -> None:
    text = DROPPED.replace("states:", "loads: [force: {body: ball, magnitude: (4 N/s)*t, angle: 90 deg}]\nstates:")
    page = page_of_text(tmp_path, text.replace("y(ball) = 0", "t = 0.5 s"))
    assert "impulse = ∫[0 → t_2] (m g - 4 t) dt = 9.31 N·s t in s" in page
    assert "(1) ↓ 9.31 = 2 v_2 in N·s (1): v_2 = 9.31/2 = 4.655 m/s" in page
    assert "Not used" not in page
    # Without a weight no letter of the mass is on the page, and yet its number.
    level = text.replace("plane: vertical", "plane: horizontal").replace("y(ball) = 0", "t = 0.5 s")
    page = page_of_text(tmp_path, level)
    assert "m = 2 kg, force = 4 N/s · t; ball(0, h); 1: at rest; 2: t = 0.5 s Find v" in page
    assert "Not used" not in page


def test_down_a_slope_to_the_left_forces_are_summed_that_way(tmp_path: Path) -> None:
    text = page_of_text(
        tmp_path,
        """
title: Block that slides down to the left
plane: vertical
given: {m: 2 kg, mu: 0.2, h: 2 m, beta: 30 deg}
points: {O: [0, 0], P: {from: O, distance: h/sin(beta), angle: beta}}
bodies: {block: {particle: P, mass: m}}
surfaces: {slope: {through: O, angle: beta}}
joints: [{contact: {between: [block, slope], at: P, mu: mu}}]
states: {a: [t = 0, at rest], b: [y(block) = 0]}
find: {v: v(block).mag @ b, t: t @ b}
""",
    )
    assert "↙ ΣF: m g sin β - μ N_P = m a" in text
