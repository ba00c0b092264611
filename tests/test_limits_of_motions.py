"""Where a motion tends that goes on for ever: the limit is the one that it approaches, whatever else vanishes there."""

from __future__ import annotations

from math import log, sqrt, tanh

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

LAW = """
title: Particle under a law of motion
coordinates: {x: m}
bodies: {p: {particle: [x, 0]}}
motion: ["ddot(x) = %s"]
states: {1: [t = 0, x = %s, dot(x) = %s], 2: [%s]}
find: {v: dot(x) @ 2}
"""


@pytest.mark.parametrize("start", ["0", "3 m/s", "-20 m/s"])
def test_a_limit_reached_from_one_side_only(start: str) -> None:
    """a = v²/10 - 4 vanishes at both ±sqrt(40); only the negative one is approached, from above and from below."""
    found = solve(LAW % ("(0.1 1/m)*dot(x)^2 - 4 m/s^2", "0", start, "t = infinity"))
    assert first(found["v"]) == pytest.approx(-sqrt(40))


def test_a_limit_beyond_a_turning() -> None:
    """a = -(v² - 4)/10 from v = -1: it turns round and tends to 2, though -2 is nearer."""
    found = solve(LAW % ("-(0.1 1/m)*(dot(x)^2 - 4 m^2/s^2)", "0", "-1 m/s", "t = infinity"))
    assert first(found["v"]) == pytest.approx(2)


@pytest.mark.parametrize("way", [1, -1])
def test_far_away_on_either_side(way: int) -> None:
    """v dv = -2 e^x dx, mirrored for the other side: v² = 1 + 4."""
    law = f"({-2 * way} m/s^2)*exp(({way})*x/(1 m))"
    found = solve(LAW % (law, "0", f"{-way} m/s", f"x = {'-' if way > 0 else ''}infinity"))
    assert first(found["v"]) == pytest.approx(-way * sqrt(5))


def test_thrown_up_and_falling_through_air() -> None:
    found = solve("""
title: Ball thrown up in air
plane: vertical
bodies: {p: {particle: [0, 0], mass: 1 kg}}
joints:
  - guide: {point: p, along: 90 deg}
loads:
  - drag: {body: p, magnitude: (0.1 kg/m)*v(p).mag^2}
states: {1: [t = 0, v(p).y = 2 m/s], 2: [t = infinity]}
find: {v: v(p).y @ 2}
""")
    assert first(found["v"]) == pytest.approx(-sqrt(98.1))


@pytest.mark.parametrize(
    "states",
    [
        "end: [t = infinity], near: [dot(x) = 0.95*dot(x) @ end]",
        "near: [dot(x) = 0.95*dot(x) @ end], end: [t = infinity]",
    ],
)
def test_a_part_of_the_limit_is_reached(states: str) -> None:
    """v = 2 (1 - e^-t); wherever the limit stands among the states."""
    found = solve(f"""
title: Particle that is braked the more the faster it is
coordinates: {{x: m}}
bodies: {{p: {{particle: [x, 0]}}}}
motion: ["ddot(x) = 2 m/s^2 - 1 1/s * dot(x)"]
states: {{start: [t = 0, x = 0, dot(x) = 0], {states}}}
find: {{t: t @ near, v: dot(x) @ end, x: x @ near}}
""")
    assert [first(found[name]) for name in ("t", "v", "x")] == pytest.approx([log(20), 2, 2 * (log(20) - 0.95)])


DIVER = """
title: A diver whose terminal speed is known
plane: vertical
given: {m: 80 kg, v_t: 60 m/s}
unknowns: {c: kg/m}
points: {P: [0, 0]}
bodies: {diver: {particle: P, mass: m}}
loads: [{drag: {body: diver, magnitude: c*v(diver).mag^2}}]
states:
  0: [t = 0, at rest]
  far: [t = infinity, v(diver).mag = v_t]
  1: [t = 5 s]
find: {c: c, v: v(diver).mag @ 1}
"""


def test_a_constant_that_the_end_of_a_motion_tells() -> None:
    found = solve(DIVER)
    assert first(found["c"]) == pytest.approx(9.81 * 80 / 3600)
    assert first(found["v"]) == pytest.approx(60 * tanh(9.81 * 5 / 60))


TRUCK = """
title: Truck at constant power
plane: horizontal
given: {m: 16000 kg, P: 150 kW, c: 15 kg/m, R: 1500 N}
bodies: {truck: {particle: [0, 0], mass: m}}
joints:
  - guide: {point: truck, along: 0 deg}
loads:
  - force: {body: truck, magnitude: P/v(truck).x, angle: 0 deg}
  - drag: {body: truck, magnitude: R + c*v(truck).mag^2}
states: {slow: [t = 0, v(truck).x = 10 m/s], end: [t = infinity]}
find: {v: v(truck).x @ end}
"""


def test_a_speed_that_is_approached_is_not_given() -> None:
    """P = R v + c v³ has no short formula; the number follows from it all the same."""
    problem, _ = load_text(TRUCK)
    assert problem is not None
    page = Terminal().render(narrate(solve_problem(problem)))
    assert "At end the speed no longer changes" in page
    assert "end: given" not in page


SINKS = """
title: Ball of a given final speed
plane: vertical
symbols: {v_t: m/s, m: kg}
unknowns: {k: kg/s}
bodies: {ball: {particle: [0, 0], mass: m}}
states:
  let_go: [t = 0, at rest]
  fast: [v(ball).mag = 0.9*v_t]
  end: [t = infinity, v(ball).mag = v_t]
find: {k: k, t: t @ fast}
"""


@pytest.mark.slow
def test_a_constant_that_nothing_has_is_told() -> None:
    """Without resistance no coefficient can be found, and the ball has no final speed."""
    with pytest.raises(NoSolution) as told:
        solve(SINKS)
    assert {d.code for d in told.value.diagnostics} == {"PL623"}
