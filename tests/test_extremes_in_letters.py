"""What is largest or smallest before friction gives way, or a body tips: bounded there, and told with its condition."""

from __future__ import annotations

import math

import pytest
from answered import solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

CABINET = """
title: Cabinet on a floor that is tilted
plane: vertical
symbols: {{b: m, h: m, mu: 1, m: kg}}
unknowns: {{beta: deg}}
points: {{O: [0, 0], G: {{from: O, distance: h/2, angle: 90 deg + beta}}}}
surfaces: {{floor: {{through: O, angle: beta}}}}
bodies: {{cabinet: {{plate: G, width: b, height: h, angle: beta, mass: m}}}}
joints:
  - contact: {{between: [cabinet, floor], mu: mu, name: C}}
{assume}
instant: [at rest, mode(C) = stick, beta is largest, beta > 0]
find: {{beta: beta}}
"""
CRATE = """
title: Crate that is pushed at a height
plane: vertical
symbols: {b: m, h: m, mu: 1, m: kg, d: m}
unknowns: {P: N}
points: {C: [0, 0], G: [0, h/2], A: [-b/2, d]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {crate: {plate: G, width: b, height: h, angle: 0 deg, mass: m}}
joints:
  - contact: {between: [crate, floor], mu: mu, name: F}
loads:
  - force: {body: crate, at: A, magnitude: P, angle: 0 deg}
instant: [at rest, mode(F) = stick, P is largest]
find: {P: P}
"""
WEDGED = """
title: Block on a slope that a level force holds
plane: vertical
{data}
unknowns: {{P: N}}
points: {{C: [0, 0]}}
surfaces: {{slope: {{through: C, angle: beta}}}}
bodies: {{block: {{particle: C, mass: m}}}}
joints:
  - contact: {{between: [block, slope], mu: mu, name: F}}
loads:
  - force: {{body: block, magnitude: P, angle: 0 deg}}
instant: [at rest, mode(F) = stick, P is {extreme}]
find: {{P: P}}
"""
LADDER = """
title: Flattest ladder at a rough wall
plane: vertical
{data}
coordinates: {{beta: deg}}
points: {{A: [0, 0], B: {{from: A, distance: l, angle: beta}}}}
surfaces: {{floor: {{through: A, angle: 0 deg}}, wall: {{through: B, angle: 90 deg}}}}
bodies: {{ladder: {{rod: [A, B], mass: m}}}}
joints:
  - contact: {{between: [ladder, floor], at: A, mu: mu}}
  - contact: {{between: [ladder, wall], at: B, mu: nu}}
instant: [at rest, mode(A) = stick, beta is smallest]
find: {{beta: beta in deg}}
"""
LETTERS = "symbols: {m: kg, mu: 1, beta: deg}"
STEEP, GENTLE = (f"given: {{m: 2 kg, mu: 0.9, beta: {angle} deg}}" for angle in (60, 20))


def page(text: str) -> str:
    """The page with single spaces."""
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    return " ".join(Terminal(400).render(narrate(solve_problem(problem))).split())


@pytest.mark.parametrize(("text", "condition", "answer"), [
    (CABINET.format(assume=""), "Assume b > μ h", "β = arctan(μ); beyond it the cabinet slips"),
    (CABINET.format(assume="assume: [b > mu*h]"), "Assume b > μ h", "β = arctan(μ); beyond it the cabinet slips"),
    (CABINET.format(assume="assume: [b < mu*h]"), "Assume b < μ h", "β = arctan(b/h); beyond it the cabinet tips"),
    (CRATE, "Assume b > 2 μ d", "P = μ m g; beyond it the crate slips"),
    (WEDGED.format(data=LETTERS, extreme="largest"), "Assume cos β > μ sin β",
     "P = m g (μ cos β + sin β) / (cos β - μ sin β)"),
    (LADDER.format(data="symbols: {l: m, mu: 1, nu: 1, m: kg}"), "Assume 1 > μ ν",
     "β = arctan((1 - μ ν) / (2 μ)); below it the ladder slips"),
])  # fmt: skip
def test_an_extreme_in_letters_is_told_with_its_condition(text: str, condition: str, answer: str) -> None:
    told = page(text)
    assert condition in told
    assert told.count(condition) == 1, "once"
    assert f"{answer} Check" in told


@pytest.mark.parametrize(("text", "message"), [
    (WEDGED.format(data=STEEP, extreme="largest"), "P has no largest value"),
    (LADDER.format(data="given: {l: 3 m, mu: 2, nu: 0.9, m: 10 kg}"), "beta has no smallest value"),
])  # fmt: skip
def test_a_limit_beyond_which_it_still_holds_is_no_bound(text: str, message: str) -> None:
    """Friction wedges it in: what was the smallest push before is not the largest as well."""
    with pytest.raises(NoSolution) as caught:
        solve(text)
    (why,) = caught.value.diagnostics
    assert (why.code, message in why.message) == ("PL613", True)


def test_both_ends_where_there_are_two() -> None:
    """P = m g tan(β ± φ), with tan φ = μ."""
    ends = [solve(WEDGED.format(data=GENTLE, extreme=e))["P"].values for e in ("smallest", "largest")]
    assert [round(float(values[0]), 2) for values in ends if values] == [-7.92, 36.88]


WEDGE = """
title: Wedge without mass that is driven under a block
plane: vertical
symbols: {W: N, beta: deg, mu: 1}
unknowns: {P: N}
points: {A: [0, 0], B: [0.2 m, 0.2 m]}
surfaces: {floor: {through: A, angle: 0 deg}, face: {through: B, angle: -beta, body: wedge}}
bodies: {wedge: {particle: A}, block: {particle: B, weight: W}}
joints:
  - contact: {between: [wedge, floor], mu: mu, name: F}
  - contact: {between: [block, face], mu: mu, name: S}
  - guide: {point: block, along: 90 deg, name: G}
loads:
  - force: {body: wedge, magnitude: P, angle: 0 deg}
instant: [at rest, mode(F) = stick, P is largest]
find: {P: P}
"""


def test_both_faces_of_a_wedge_reach_their_limit_at_once() -> None:
    """P = W (tan(β + φ) + tan φ): what sticking leaves open, such as the push of the guide, goes with the limits."""
    (found,) = solve(WEDGE)["P"].expressions or ()
    numbers = {"W": 1000, "beta": math.radians(10), "mu": 0.2}
    value = found.subs({s: numbers[s.name] for s in found.free_symbols})
    friction = math.atan(0.2)
    assert float(value) == pytest.approx(1000 * (math.tan(numbers["beta"] + friction) + 0.2), rel=1e-9)
    assert "Assume cos β > μ sin β" in page(WEDGE)


BACK = """
title: Block that is sent up a rough slope and slides back
plane: vertical
symbols: {m: kg, beta: deg, mu: 1, v_0: m/s}
points: {C: [0, 0]}
surfaces: {slope: {through: C, angle: beta}}
bodies: {block: {particle: C, mass: m}}
joints:
  - contact: {between: [block, slope], mu: mu, name: F}
states: {1: [t = 0, v(block).along(beta) = v_0], top: [v(block).along(beta) = 0], back: [x(block) = 0]}
find: {v: v(block).mag @ back}
"""


def test_a_motion_that_happens_for_some_letters_says_for_which() -> None:
    """v = v_0 √((sin β - μ cos β)/(sin β + μ cos β)): with more friction the block stays at the top."""
    assert page(BACK).count("Assume sin β > μ cos β") == 1
