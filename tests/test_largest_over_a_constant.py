"""What is largest over a sought constant: the one that the relations allow; where several fit, the file must choose."""

from __future__ import annotations

import math
from math import pi, sin
from pathlib import Path

import pytest
import sympy as sp
from answered import assert_close, first, solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read, solve_and_compare
from planar_cli.report.page.narrate import narrate

THROW = """
title: Longest throw along a slope
plane: vertical
unknowns: {beta: deg}
bodies: {P: {particle: [0, 0], mass: any}}
states:
  throw: [t = 0, v(P).mag = 10 m/s, v(P).angle = beta]
  lands: [y(P) = x(P)*tan(%s deg), r(P).mag is largest%s]
find: {d: r(P).mag @ lands, beta: beta}
"""


@pytest.mark.parametrize("slope", [30, 0, -30])
@pytest.mark.parametrize("way", [1, -1])
def test_the_side_that_is_stated(slope: float, way: int) -> None:
    """v²/(g (1 + sin)) along a slope that rises, at 45 deg + half of it; the other side is a slope that falls."""
    found = solve(THROW % (slope, f", x(P) {'>' if way > 0 else '<'} 0"))
    rise = way * slope * pi / 180
    assert first(found["d"]) == pytest.approx(100 / (9.81 * (1 + sin(rise))))
    assert first(found["beta"]) == pytest.approx(pi / 2 - way * (pi / 4 - rise / 2))


@pytest.mark.parametrize("slope", [30, 0, -30])
def test_two_sides_fit(slope: float) -> None:
    with pytest.raises(NoSolution, match=r"is largest` in several ways: beta = .*; beta = ") as wrong:
        solve(THROW % (slope, ""))
    assert "`x(P) > 0`" in (wrong.value.diagnostics[0].hint or "")


def test_a_smallest_value_is_no_other_way() -> None:
    """x is stationary on both sides, but largest only ahead: the throw behind is the smallest."""
    found = solve((THROW % (0, "")).replace("r(P).mag is", "x(P) is"))
    assert first(found["d"]) == pytest.approx(100 / 9.81)
    assert first(found["beta"]) == pytest.approx(pi / 4)


CARRIED = """
title: Block carried by an accelerated wedge
plane: vertical
given: {beta: 20 deg, mu: 0.5}
unknowns: {a: m/s^2}
points: {P: [0, 0], Q: {from: P, distance: 1 m, angle: beta}}
surfaces: {slope: {through: P, angle: beta, body: wedge}}
bodies: {wedge: {points: [Q]}, block: {particle: P, mass: 3 kg}}
joints:
  - guide: {body: wedge, along: 0 deg}
  - contact: {name: C, between: [block, slope], mu: mu}
motion: [a(wedge).x = -a]
instant: [at rest, mode(C) = stick, a is EXTREME]
find: {a: a}
"""


@pytest.mark.parametrize(("extreme", "sense"), [("largest", 1), ("smallest", -1)])
def test_a_prescribed_motion_is_driven_at_will(extreme: str, sense: int) -> None:
    """The wedge could stay alone, with a = 0; what drives it leaves a free up to the limits of friction."""
    found = solve(CARRIED.replace("EXTREME", extreme))
    beta = math.radians(20)
    assert_close(found["a"], 9.81 * math.tan(beta + sense * math.atan(0.5)))


def test_two_limits_in_letters() -> None:
    """A ladder between a rough floor and a rough wall; choices on the way have sin 2 beta for a factor."""
    found = solve(
        """
title: Flattest ladder
plane: vertical
symbols: {m: kg, l: m, mu_1: 1, mu_2: 1}
assume: [mu_1*mu_2 < 1]
coordinates: {beta: deg}
points: {A: [0, 0], B: {from: A, distance: l, angle: beta}}
surfaces: {floor: {through: A, angle: 0 deg}, wall: {through: B, angle: 90 deg}}
bodies: {ladder: {rod: [A, B], mass: m}}
joints:
  - contact: {between: [ladder, floor], at: A, mu: mu_1}
  - contact: {between: [ladder, wall], at: B, mu: mu_2}
instant: [at rest, mode(A) = stick, mode(B) = stick, beta is smallest]
find: {beta: beta}
"""
    )
    (expression,) = found["beta"].expressions or ()
    one, other = sorted(expression.free_symbols, key=lambda s: s.name)
    assert sp.simplify(sp.tan(expression) - (1 - one * other) / (2 * one)) == 0


OVER_A_WALL = """
title: Least speed over a wall
plane: vertical
unknowns: {{u: m/s, beta: deg}}
bodies: {{ball: {{particle: [0, 1.5 m], mass: any}}}}
states:
  throw: [t = 0, v(ball).mag = u, v(ball).angle = beta]
{before}  wall: [x(ball) = 12 m, y(ball) = 6 m, u is smallest]
  ground: [y(ball) = 0]
find: {{u: u, beta: beta, d: x(ball) @ ground{asked}}}
"""


@pytest.mark.parametrize(
    ("before", "asked"), [("", ""), ("  top: [v(ball).y = 0]\n", ", h: y(ball) @ top")], ids=["after", "before too"]
)
def test_other_states_do_not_bind_what_is_smallest(before: str, asked: str) -> None:
    """u² = g (h + √(d² + h²)) over a corner d away and h above, at 45 deg + half of its elevation."""
    u, beta = math.sqrt(9.81 * (4.5 + math.hypot(12, 4.5))), pi / 4 + math.atan2(4.5, 12) / 2
    across, up = u * math.cos(beta), u * sin(beta)
    found = solve(OVER_A_WALL.format(before=before, asked=asked))
    assert first(found["u"]) == pytest.approx(u)
    assert first(found["beta"]) == pytest.approx(beta)
    assert first(found["d"]) == pytest.approx(across * (up + math.sqrt(up**2 + 2 * 9.81 * 1.5)) / 9.81)
    if asked:
        assert first(found["h"]) == pytest.approx(1.5 + up**2 / (2 * 9.81))


PEBBLE = """
title: Pebble that leaves the rim of a wheel
plane: vertical
unknowns: {{t_1: s}}
{assume}
points: {{G: [0, 0.4 m], P: [-0.4 m, 0.4 m]}}
surfaces: {{road: {{through: [0, 0], angle: 0 deg}}}}
bodies:
  wheel: {{disk: G, radius: 0.4 m}}
  pebble: {{particle: P, mass: any}}
joints:
  - rolling: {{between: [wheel, road], at: [0, 0]}}
  - weld: {{at: P, between: [wheel, pebble], during: level->free}}
motion: [v(G).x = 5 m/s]
states:
  level: [t = 0]
  free: [t = t_1]
  top: [v(pebble).y = 0, y(pebble) is largest]
find: {{t_1: t_1, h: y(pebble) @ top}}
"""


def test_where_a_pebble_leaves_to_fly_highest() -> None:
    """sin φ = g R/v² above the level of the axle; what carries it hands its place and velocity over."""
    found = solve(PEBBLE.format(assume="assume: [t_1 > 0, t_1 < 0.1 s]"))
    assert first(found["t_1"]) == pytest.approx(0.08 * math.asin(9.81 * 0.4 / 25))
    assert first(found["h"]) == pytest.approx(0.4 + 25 / (2 * 9.81) + 9.81 * 0.4**2 / (2 * 25))


def test_of_several_turns_the_file_must_choose() -> None:
    """That the motion passes all states with some number makes nothing largest: no trial stands for the extreme."""
    with pytest.raises(NoSolution, match=r"is largest` in several ways: t_1 = 0.01261 s; t_1 = 0.515\d s"):
        solve(PEBBLE.format(assume=""))


PIVOT = """
title: Rod hung up where it swings fastest
plane: vertical
{given}
unknowns: {{e: m}}
assume: [e > 0]
points: {{O: [0, 0], A: [e - l/2, 0], B: [e + l/2, 0]}}
bodies: {{rod: {{rod: [A, B], mass: any, points: [O]}}}}
joints: [{{pin: {{at: O, between: [ground, rod]}}}}]
states:
  1: [at rest]
  2: [theta(rod) = -90 deg, {extreme}]
find: {{x: e, omega: omega(rod) @ 2}}
"""


@pytest.mark.parametrize("given", ["given: {l: 1.2 m}", "symbols: {l: m}"])
def test_a_speed_that_energy_tells_as_a_function_of_a_constant(tmp_path: Path, given: str) -> None:
    """ω² = 24 g e / (12 e² + l²), largest at e = l/√12."""
    file = tmp_path / "pivot.yaml"
    file.write_text(PIVOT.format(given=given, extreme="omega(rod) is smallest"))
    page = Terminal(width=110).render(narrate(solve_and_compare(read(str(file)), None)[0]))
    lines = [" ".join(row.split()) for row in page.splitlines()]
    assert "(1): ω_2² = 24 e g / (12 e² + l²)" in lines
    assert lines.index("(2) l² = 12 e²") > lines.index("(1): ω_2² = 24 e g / (12 e² + l²)")
    assert any(row.startswith("(2): e = √3 l/6") for row in lines)
    assert "numerical" not in page


def test_a_speed_of_a_point_that_energy_tells() -> None:
    """v_A² = (l/2 - e)² ω², largest where 48 e⁴ - 8 l³ e + l⁴ = 0."""
    found = solve(PIVOT.format(given="given: {l: 1.2 m}", extreme="v(A).mag is largest"))
    e = first(found["x"])
    assert 48 * e**4 - 8 * 1.2**3 * e + 1.2**4 == pytest.approx(0, abs=1e-9)
    assert e < 0.6
