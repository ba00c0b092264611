"""Equilibrium in several coordinates, none of which the equations tell by the others: all roots that are found."""

from __future__ import annotations

from math import hypot, pi

import pytest
from answered import first, solve

from planar_cli.errors import NoSolution, Undecided
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

FREE = """title: Weight hung between two springs
plane: vertical
given: {m: 5 kg}
points: {A: [0, 0], B: [1 m, 0]}
bodies: {w: {particle: free, mass: m}}
loads:
  - spring: {between: [A, w], stiffness: 300 N/m, natural_length: 0.4 m}
  - spring: {between: [B, w], stiffness: 200 N/m, natural_length: 0.5 m}
WHEN
find: {x: x(w) AT, y: y(w) AT}
"""
WRITTEN = (
    FREE.replace("given:", "coordinates: {x: m, y: m}\ngiven:")
    .replace("B: [1 m, 0]", "B: [1 m, 0], P: [x, y]")
    .replace("particle: free", "particle: P")
)
ROD = """title: Rod hung by two springs
plane: vertical
coordinates: {x: m, y: m, phi: deg}
points: {A: [0, 0], B: [1.5 m, 0], P: [x, y], Q: {from: P, distance: 1 m, angle: phi}}
bodies: {rod: {rod: [P, Q], mass: 6 kg}}
loads:
  - spring: {between: [A, P], stiffness: 300 N/m, natural_length: 0.4 m, name: left}
  - spring: {between: [B, Q], stiffness: 200 N/m, natural_length: 0.5 m, name: right}
instant: [equilibrium, y < 0, phi > -30 deg, phi < 30 deg, x > 0]
find: {left: force(left).mag, right: force(right).mag, across: force(left).x + force(right).x}
"""
INSTANT, STATE = "instant: [equilibriumMORE]", "states: {e: [equilibriumMORE]}"


def left_over(x: float, y: float) -> tuple[float, float]:
    """Σ F of the weight."""
    a, b = hypot(x, y), hypot(x - 1, y)
    p, q = 300 * (a - 0.4) / a, 200 * (b - 0.5) / b
    return -p * x - q * (x - 1), -p * y - q * y - 5 * 9.81


@pytest.mark.parametrize("text", [FREE, WRITTEN])
@pytest.mark.parametrize("when", [INSTANT, STATE])
def test_a_weight_between_two_springs(text: str, when: str) -> None:
    """The lower position of the two: (0.40932, -0.36127) m."""
    below = ", y(w) < 0" if text is FREE else ", y < 0"
    text = text.replace("WHEN", when.replace("MORE", below)).replace(" AT", " @ e" if when is STATE else "")
    found = solve(text)
    x, y = first(found["x"]), first(found["y"])
    assert (x, y) == pytest.approx((0.40932, -0.36127), abs=1e-5)
    assert left_over(x, y) == pytest.approx((0, 0), abs=1e-9)
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    page = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    assert "other roots: -0.01612 m (given: y" in page


def test_both_positions_are_told() -> None:
    with pytest.raises(NoSolution) as error:
        solve(FREE.replace("WHEN", INSTANT.replace("MORE", "")).replace(" AT", ""))
    diagnostic = error.value.diagnostics[0]
    assert (diagnostic.code, diagnostic.mark.line) == ("PL635", 10)
    assert "-0.01612 m" in diagnostic.message
    assert "0.4093 m" in diagnostic.message


def test_letters_have_no_roots_to_look_for() -> None:
    text = FREE.replace("given: {m: 5 kg}", "symbols: {m: kg}").replace("WHEN", INSTANT.replace("MORE", ""))
    with pytest.raises(Undecided, match=r":10: not decided, the equations \(1\), \(2\) .*, and hold letters"):
        solve(text.replace(" AT", ""))


def test_a_rod_between_two_springs() -> None:
    """Its weight stands against the springs, and these against each other."""
    found = solve(ROD)
    assert first(found["across"]) == pytest.approx(0, abs=1e-9)
    assert first(found["left"]) + first(found["right"]) > 6 * 9.81


@pytest.mark.parametrize("asked", ["x: x(w) @ e", "a: a(w).mag @ e"])
def test_a_drawn_position_that_does_not_balance(asked: str) -> None:
    """It says `equilibrium`, so that an acceleration is no answer."""
    text = FREE.replace("B: [1 m, 0]", "B: [1 m, 0], P: [0.5 m, -0.5 m]").replace("particle: free", "particle: P")
    text = text.replace("WHEN", STATE.replace("MORE", "")).replace("x: x(w) AT, y: y(w) AT", asked)
    with pytest.raises(NoSolution, match="the forces do not balance as drawn") as error:
        solve(text)
    assert error.value.diagnostics[0].code == "PL630"


@pytest.mark.slow
def test_a_motion_beside_an_equilibrium_in_two_coordinates() -> None:
    text = WRITTEN.replace(
        "WHEN", "states: {e: [equilibrium, y < 0], 1: [x = 0.5 m, y = -0.3 m, at rest], 2: [t = 0.5 s]}"
    )
    found = solve(text.replace("x: x(w) AT, y: y(w) AT", "dy: y @ 1 - y @ e, v: v(w).mag @ 2"))
    assert first(found["dy"]) == pytest.approx(0.06127, abs=1e-5)
    assert first(found["v"]) == pytest.approx(0.5676, abs=1e-4)


KNOT = """title: Knot of two springs that is pulled down
plane: vertical
points: {A: [0, 0], B: [1 m, 0]}
bodies: {w: {particle: free}}
loads:
  - spring: {between: [A, w], stiffness: 300 N/m, natural_length: 0.4 m}
  - spring: {between: [B, w], stiffness: 200 N/m, natural_length: 0.5 m}
  - force: {body: w, magnitude: 5*9.81 N, angle: -90 deg}
WHEN
find: {x: x(w) AT, y: y(w) AT}
"""


@pytest.mark.parametrize("when", [INSTANT, STATE])
def test_a_knot_without_mass(when: str) -> None:
    text = KNOT.replace("WHEN", when.replace("MORE", ", y(w) < 0")).replace(" AT", " @ e" if when is STATE else "")
    found = solve(text.replace("5*9.81 N", "49.05 N"))
    assert (first(found["x"]), first(found["y"])) == pytest.approx((0.40932, -0.36127), abs=1e-5)


def test_a_free_particle_whose_guide_lies_anywhere() -> None:
    text = """title: Bead on a wire
plane: vertical
points: {T: [0, 1 m]}
bodies: {bead: {particle: free, mass: 2 kg}}
joints:
  - guide: {point: bead, along: 90 deg}
loads:
  - spring: {between: [T, bead], stiffness: 60 N/m, natural_length: 0.5 m}
states: {e: [equilibriumMORE]}
find: {y: y(bead) @ e}
"""
    with pytest.raises(NoSolution, match="bead is free, and nothing tells where its guide lies") as error:
        solve(text.replace("MORE", ""))
    assert error.value.diagnostics[0].code == "PL623"
    assert first(solve(text.replace("MORE", ", x(bead) = 0"))["y"]) == pytest.approx(1 - 0.5 - 19.62 / 60)


PENDULUM = """title: Pendulum that may hang or stand
plane: vertical
coordinates: {theta: deg}
points: {O: [0, 0], P: {from: O, distance: 1 m, angle: theta}}
bodies: {P: {particle: P, mass: 2 kg}}
joints:
  - link: {between: [O, P]}
instant: [equilibriumMORE]
find: {at: theta, across: x(P)}
"""


def test_positions_that_one_equation_tells_are_not_chosen_from() -> None:
    with pytest.raises(NoSolution) as error:
        solve(PENDULUM.replace("MORE", ""))
    (diagnostic,) = error.value.diagnostics
    assert diagnostic.code == "PL635"
    assert diagnostic.message.startswith("theta = 90 deg; or theta = -90 deg: ")


def test_the_file_chooses_a_position() -> None:
    assert first(solve(PENDULUM.replace("MORE", ", theta < 0"))["at"]) == pytest.approx(-pi / 2)
    assert first(solve(PENDULUM.replace("MORE", ", theta > 0"))["at"]) == pytest.approx(pi / 2)


def test_what_is_the_same_in_all_positions_is_told() -> None:
    text = PENDULUM.replace("MORE", "").replace("at: theta, ", "")
    assert first(solve(text)["across"]) == pytest.approx(0, abs=1e-12)
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    page = " ".join(Terminal().render(narrate(solve_problem(problem))).split())
    assert "other roots: -90° (it holds as well, and what is asked is the same)" in page


def test_a_knot_without_mass_that_is_pulled() -> None:
    """2 k (l - 0.8 m) y/l = 50 N with l² = 1 m² + y²; the digits that are left of it move no body without mass."""
    text = """plane: vertical
points: {A: [-1 m, 0], B: [1 m, 0]}
coordinates: {y: m}
bodies: {K: {particle: [0, -y]}}
loads:
  - spring: {between: [A, K], stiffness: 100 N/m, natural_length: 0.8 m}
  - spring: {between: [B, K], stiffness: 100 N/m, natural_length: 0.8 m}
  - force: {body: K, magnitude: 50 N, angle: -90 deg}
instant: [equilibrium, y > 0]
find: {y: y}
"""
    y = float(first(solve(text)["y"]))
    assert 200 * (hypot(1, y) - 0.8) * y / hypot(1, y) == pytest.approx(50)
