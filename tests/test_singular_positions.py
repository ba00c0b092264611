"""States in which a speed vanishes by the position alone: they are told by one that does not."""

from __future__ import annotations

from decimal import Decimal

import pytest
import sympy as sp
from answered import Answers, assert_close, first, solve

from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.errors import FileProblem
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.instant.pivots import easiest
from planar_cli.solve.run import solve_problem

G, HALF_ROOT = Decimal("9.81"), Decimal(3).sqrt() / 2

# A rolling wheel at the foot of a rod whose top goes down a wall: x_B = -l cos θ, so that v_B = l ω sin θ.
WHEEL = """
title: Rod on a wall and a wheel
plane: vertical
given: {{m: 12 kg, m_w: 4 kg, l: 1.2 m, R: 0.15 m}}
points:
  B: [0, R]
  A: {{from: B, distance: l, angle: 120 deg}}
  C: [0, 0]
surfaces:
  floor: {{through: C, angle: 0 deg}}
bodies:
  AB: {{rod: [B, A], mass: m}}
  wheel: {{disk: B, radius: R, mass: m_w}}
joints:
  - guide: {{point: A, along: 90 deg}}
  - pin: {{at: B, between: [AB, wheel]}}
  - rolling: {{between: [wheel, floor], at: C}}
states: {{1: [at rest], {states}}}
find: {{{find}}}
"""
LADDER = """
title: Rod between two guides
plane: vertical
symbols: {m: kg, m_B: kg, l: m, theta_0: deg}
points:
  B: [0, 0]
  A: {from: B, distance: l, angle: 180 deg - theta_0}
bodies:
  AB: {rod: [B, A], mass: m}
  slider: {particle: B, mass: m_B}
joints:
  - guide: {point: B, along: 0 deg}
  - guide: {point: A, along: 90 deg}
  - pin: {at: B, between: [AB, slider]}
states: {1: [at rest], 2: [theta(AB) = 180 deg]}
find: {omega: omega(AB) @ 2, v_B: v(B).x @ 2}
"""
CRANK = """
title: Slider-crank pushed to its dead centre
plane: horizontal
given: {r: 0.2 m, l: 0.6 m, m_1: 2 kg, m_2: 3 kg, m_3: 4 kg, F: 200 N}
points:
  O: [0, 0]
  A: {from: O, distance: r, angle: 60 deg}
  B: {distances: {A: l}, line: [O, 0 deg], side: right}
bodies:
  piston: {particle: B, mass: m_3}
  rod: {rod: [B, A], mass: m_2}
  crank: {rod: [O, A], mass: m_1}
joints:
  - guide: {point: piston, along: 0 deg}
  - pin: {at: B, between: [piston, rod]}
  - pin: {at: A, between: [rod, crank]}
  - pin: {at: O, between: [ground, crank]}
loads:
  - force: {body: piston, magnitude: F, angle: 180 deg}
states: {1: [at rest], 2: [theta(crank) = 90 deg], 3: [theta(crank) = 180 deg]}
find: {up: omega(crank) @ 2, still: omega(rod) @ 2, omega: omega(crank) @ 3, v_B: v(B).x @ 3}
"""


def told(text: str) -> tuple[Answers, str]:
    """The answers and the page, with single spaces."""
    problem, wrong = load_text(text)
    assert problem is not None
    assert not wrong
    solved = solve_problem(problem)
    found = {f.name: f for part in solved.parts for f in part.found}
    return found, " ".join(Terminal(400).render(narrate(solved)).split())


def test_a_rod_that_falls_flat_is_told_by_its_own_speed() -> None:
    """m g l (sin 60° - sin θ)/2 = m l² ω²/6 + 3 m_w v_B²/4."""
    states = "2: [theta(AB) = 150 deg], 3: [theta(AB) = 180 deg]"
    find = "steep: omega(AB) @ 2, flat: omega(AB) @ 3, v_B: v(B).x @ 3"
    found, page = told(WHEEL.format(states=states, find=find))
    assert_close(found["steep"], (Decimal("7.2") * G * (HALF_ROOT - Decimal("0.5")) / Decimal("3.96")).sqrt())
    assert_close(found["flat"], (3 * G * HALF_ROOT / Decimal("1.2")).sqrt())
    assert first(found["v_B"]) == 0
    assert "g = 9.81 m/s²" in page
    assert "v_B,3 = l ω_AB,3 sin θ_AB,3 = 0 wheel has no kinetic energy there" in page
    assert "v_G,AB,3 = 1/2 l ω_AB,3 B is the instantaneous centre of AB" in page
    assert "1/2 m g l sin θ_AB,1 = 1/6 m l² ω_AB,3²" in page
    assert "10⁻" not in page


def test_what_stands_still_needs_no_moment_of_inertia() -> None:
    found, page = told(WHEEL.format(states="3: [theta(AB) = 180 deg]", find="v_B: v(B).x @ 3"))
    assert first(found["v_B"]) == 0
    assert "moment of inertia of AB: I_AB = 1/12 m l²" in page
    assert "I_wheel" not in page


def test_nothing_is_divided_by_what_vanishes_there() -> None:
    """m l² α/3 = m g l/2;  a_B = -l ω²;  N_A = m l ω²/2 + 3 m_w l ω²/2."""
    find = "alpha: alpha(AB) @ 3, a_B: a(B).x @ 3, N_A: N(A) @ 3"
    found, page = told(WHEEL.format(states="3: [theta(AB) = 180 deg]", find=find))
    assert_close(found["alpha"], G * 3 / Decimal("2.4"))
    assert_close(found["a_B"], -3 * G * HALF_ROOT)
    assert_close(found["N_A"], (6 + 6) * 3 * G * HALF_ROOT)
    assert "(l sin θ_AB)" not in page


def test_a_rod_that_falls_flat_in_letters() -> None:
    found, page = told(LADDER)
    assert "ω = √(3 g sin θ_0 / l) counterclockwise" in page
    assert first(found["v_B"]) == 0
    assert "v_B,2 = l ω_2 sin θ_2 = 0 slider has no kinetic energy there" in page
    assert "sin² θ_2" not in page


def test_a_crank_upright_and_at_its_dead_centre() -> None:
    """Upright the rod moves without turning; at the dead centre the piston stands still, and the rod turns about it."""
    found, page = told(CRANK)
    r, length, push = Decimal("0.2"), Decimal("0.6"), Decimal(200)
    begin = (r + (4 * length**2 - 3 * r**2).sqrt()) / 2
    upright, dead = (length**2 - r**2).sqrt(), length - r
    assert_close(found["up"], (push * (begin - upright) / (r**2 * (Decimal(2) / 6 + Decimal(7) / 2))).sqrt())
    assert first(found["still"]) == 0
    assert_close(found["omega"], (push * (begin - dead) / (r**2 * Decimal(5) / 6)).sqrt())
    assert first(found["v_B"]) == 0
    assert "= 0 piston has no kinetic energy there" in page


@pytest.mark.parametrize("expr", [sp.sin, sp.tan, lambda x: sp.cos(x / 2), lambda x: sp.cot(3 * x / 2)])
def test_a_sine_that_vanishes_is_zero(expr: type[sp.Function]) -> None:
    theta = sp.Symbol("theta", real=True)
    assert Valuation({theta: +PI})(expr(theta)) == 0
    assert Valuation({theta: PI - Decimal("1e-30")})(expr(theta)) != 0
    assert Valuation({theta: Decimal("1e-50")})(sp.sin(theta)) != 0


def test_a_pivot_that_vanishes_at_a_state_is_no_pivot() -> None:
    x, y, s = sp.symbols("x y s")
    residuals = [s * x + y - 1, (s + 2) * x - (s + 3) * y + 2]
    easy = easiest(residuals, (x, y), (x,), lambda _: False)
    assert (easy.equations, easy.unknowns, easy.letters) == ((0, 1), (y, x), (x,))
    residuals = [s * x + (s + 1) * y - 1, (s + 2) * x - (s + 3) * y + 2]
    assert easiest(residuals, (x, y), (y,), lambda _: False).unknowns == (x, y)
    assert easiest(residuals, (x, y), (y,), lambda factor: factor == s).unknowns == (y, x)


def test_a_position_that_is_told_by_plain_zeros() -> None:
    """θ_crank = θ_AB = 0 are put in at once; the speed keeps its letters."""
    text = CRANK.replace("angle: 60 deg", "angle: -60 deg").replace("F, angle: 180 deg", "F, angle: 0 deg")
    found, page = told(
        text.partition("states:")[0] + "states: {1: [at rest], 2: [theta(crank) = 0]}\nfind: {v: v(B).x @ 2}"
    )
    assert first(found["v"]) == 0
    assert "= 0 piston has no kinetic energy there" in page


def test_what_is_integrated_in_numbers_was_given() -> None:
    _, page = told(WHEEL.format(states="3: [omega(wheel) = 0]", find="flat: omega(AB) @ 3"))
    assert "is integrated numerically" in page
    assert "g = 9.81 m/s²; B(0, R)" in page


# A ladder that only leans on the wall leaves it, as its foot is held back by the wheel: 149.3° here, before 150°.
LEANING = WHEEL.replace("guide: {{point: A, along: 90 deg}}", "contact: {{between: [AB, wall], at: A, mu: 0}}").replace(
    "surfaces:", "surfaces:\n  wall: {{through: A, angle: 90 deg}}"
)


def test_a_rod_that_leaves_the_wall_is_solved_beyond_it() -> None:
    found = solve(LEANING.format(states="2: [theta(AB) = 150 deg]", find="omega: omega(AB) @ 2"))
    assert_close(found["omega"], "2.5544103213", 9)  # followed in numbers to eleven digits


def test_energy_alone_does_not_reach_beyond_the_wall() -> None:
    text = LEANING.format(states="3: [theta(AB) = 180 deg]", find="omega: omega(AB) @ 3, v_B: v(B).x @ 3")
    with pytest.raises(FileProblem) as refused:
        solve(text.replace("states:", "method: energy\nstates:"))
    said = refused.value.diagnostics[0].message
    assert said.startswith("AB at A lifts off on the way, and from there on method energy gives one equation for ")
