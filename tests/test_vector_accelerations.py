"""Relations that give the size of an acceleration or of a reaction: every root, told apart by inequalities."""

from __future__ import annotations

from math import cos, radians, sin
from pathlib import Path

import pytest
from answered import solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.checking import read
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

CURVE = """
title: Size of an acceleration on a circle
points: {{O: [0, 0], P: [0, -200 m]}}
surfaces: {{road: {{center: O, radius: 200 m}}}}
bodies: {{car: {{particle: P}}}}
joints:
  - guide: {{point: car, along: road}}
instant: [{stated}]
find: {{a: a(car).t}}
"""
FORK = """
title: Sizes of velocity and acceleration, open speed and open rate
points: {O: [0, 0], P: [-1 m, 0]}
surfaces: {slot: {r: 0.5 m * (1 - cos(theta))}}
bodies: {fork: {rod: [O, 180 deg], length: 2 m}, ball: {particle: P}}
joints:
  - pin: {at: O, between: [ground, fork]}
  - guide: {point: ball, along: fork}
  - guide: {point: ball, along: slot, name: cam}
instant: [v(ball).mag = 4 m/s, a(ball).mag = 30 m/s^2, omega(fork) > 0, alpha(fork) > 0]
find: {a: alpha(fork)}
"""
PIN = """
title: Size of a reaction tells the speed
plane: vertical
points: {A: [0, 0], B: [1.2 m, 0]}
bodies: {rod: {rod: [A, B], mass: 4 kg}}
joints:
  - pin: {at: A, between: [ground, rod]}
instant: [reaction(A).mag = 50 N]
find: {a: abs(omega(rod))}
"""

BOB = """
title: Size of the acceleration of a bob
plane: vertical
points: {O: [0, 0], B: {from: O, distance: 1.5 m, angle: -50 deg}}
bodies: {bob: {particle: B, mass: any}}
joints:
  - link: {between: [O, B], name: cord}
instant: [a(bob).mag = 12 m/s^2]
find: {v: v(bob).mag}
"""


def answer(text: str, folder: Path) -> float:
    """The only find of a file."""
    path = folder / "file.yaml"
    path.write_text(text, encoding="utf-8")
    values = solve_problem(read(str(path))).parts[0].found[0].values
    assert values is not None
    return float(values[0])


@pytest.mark.parametrize(
    ("stated", "expected"),
    [
        # a_n = 20²/200 = 2; a_t² = 3² - 2².
        ("v(car).x = 20 m/s, a(car).mag = 3 m/s^2, a(car).t > 0", 5**0.5),
        ("v(car).x = 20 m/s, a(car).mag = 3 m/s^2, a(car).t < 0", -(5**0.5)),
        ("v(car).x = -20 m/s, a(car).mag = 3 m/s^2, a(car).x > 0", -(5**0.5)),
        # The speed is told by its size, and its direction by an inequality.
        ("v(car).mag = 20 m/s, v(car).x < 0, a(car).t = 1 m/s^2", 1.0),
    ],
)
def test_the_size_of_an_acceleration_is_a_datum(stated: str, expected: float, tmp_path: Path) -> None:
    assert answer(CURVE.format(stated=stated), tmp_path) == pytest.approx(expected)


def test_sizes_on_two_levels(tmp_path: Path) -> None:
    # r = 1, r' = 0, r'' = -0.5 ω², ω = 4: a_r = -24, a_θ = α.
    assert answer(FORK, tmp_path) == pytest.approx(18)


def test_the_size_of_a_reaction_is_a_datum(tmp_path: Path) -> None:
    # A_y = m g/4, A_x = m ω² l/2.
    assert answer(PIN, tmp_path) == pytest.approx(((50**2 - 9.81**2) ** 0.5 / 2.4) ** 0.5)


@pytest.mark.parametrize(("size", "code"), [(3, "PL618"), (1, "PL601")])
def test_both_ways_and_none(size: int, code: str, tmp_path: Path) -> None:
    with pytest.raises(NoSolution) as caught:
        answer(CURVE.format(stated=f"v(car).x = 20 m/s, a(car).mag = {size} m/s^2"), tmp_path)
    assert [d.code for d in caught.value.diagnostics] == [code]


def test_a_mass_that_cancels_is_no_letter_of_a_root(tmp_path: Path) -> None:
    # a² = g² sin²(40°) + (v²/l)²
    across = 9.81 * sin(radians(40))
    assert answer(BOB, tmp_path) == pytest.approx((1.5 * (144 - across**2) ** 0.5) ** 0.5)


SKIER = """
title: Skier on a parabola
points: {A: [10 m, 5 m]}
surfaces: {hill: {y: x^2/(20 m)}}
bodies: {skier: {particle: A}}
joints:
  - guide: {point: A, along: hill}
instant: [v(skier).mag = 6 m/s, v(skier).x < 0, a(skier).t = 2 m/s^2]
find: {phi: v(skier).angle in deg, rho: rho(skier), a: a(skier).mag, a_n: a(skier).n}
"""


def test_a_particle_that_has_another_name_than_its_point() -> None:
    """Its acceleration along and across the curve; the radius once, and no 1 = 1."""
    problem, wrong = load_text(SKIER)
    assert problem is not None, wrong
    page = Terminal(width=110).render(narrate(solve_problem(problem)))
    assert page.count("ρ = (1 + y′²)^(3/2)/y″ = (1 + 1²)^(3/2)/0.1 = 20 √2 m = 28.28 m") == 1
    flat = " ".join(page.split())
    assert "a_A = a_At e_t + v_A²/ρ e_n = [-0.70711 · 2 - 0.70711 · 6² / 28.284, " in flat
    assert "28.284] = [-2.314, -0.5142] m/s²" in flat
    assert "a_n = v_A²/ρ = 1.273 m/s²" in page
    assert "tan φ = 1\n" in page


AIRCRAFT = """
title: Aircraft in a turn
given: {v_P: 400 km/h, R: 3 km}
bodies: {P: {particle: [0, 1 km]}}
instant: [v(P).mag = v_P, v(P).angle = 60 deg, rho(P) = R, a(P).t = -2 m/s^2SIDE]
find: {a: a(P)}
"""


def test_a_radius_of_curvature_does_not_tell_to_which_side() -> None:
    with pytest.raises(NoSolution) as refused:
        solve(AIRCRAFT.replace("SIDE", ""))
    why = refused.value.diagnostics[0]
    assert why.code == "PL618"
    # The direction of the velocity is told: it is not its size that leaves two ways.
    assert why.message == "`rho(P) = R` holds both ways, and the answers differ"
    assert why.hint == "write `a(P).x > 0` or `a(P).x < 0`"


@pytest.mark.parametrize(("side", "turn"), [("<", 1), (">", -1)])
def test_an_inequality_tells_to_which_side(side: str, turn: int) -> None:
    found = solve(AIRCRAFT.replace("SIDE", f", a(P).x {side} 0"))["a"].values
    assert found is not None
    ahead, across = radians(60), radians(60 + 90 * turn)
    normal = (400 / 3.6) ** 2 / 3000
    assert float(found[0]) == pytest.approx(-2 * cos(ahead) + normal * cos(across))
    assert float(found[1]) == pytest.approx(-2 * sin(ahead) + normal * sin(across))
