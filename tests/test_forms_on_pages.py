"""Forms of formulas as a person writes them: minus signs inside differences, times between two states; which unknown
is carried through the others; what an extreme rests on.
"""

from __future__ import annotations

import re

import pytest
import sympy as sp

from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load_text
from planar_cli.report.document import blocks as doc
from planar_cli.report.notation.durations import over_durations
from planar_cli.report.notation.notation import plain
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.instant.pivots import easiest
from planar_cli.solve.run import solve_problem

NAMES = m, g, k, mu, v, x, phi = sp.symbols("m g k mu v x phi")
LONG, SHORT = sp.symbols("R r")
TIMES = t_3, t_2 = sp.symbols("t_3 t_2")


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (-(m * g * mu - k) / m, "(k - μ m g)/m"),
        (-m * g * (sp.sin(phi) - mu * sp.cos(phi)), "m g (μ cos φ - sin φ)"),
        (-(-m * g - k * x) / k, "(m g + k x)/k"),
        (sp.Mul(-1, LONG - SHORT, v, evaluate=False), "-(R - r) v"),
        (x - (m * g - k) / m, "x - (m g - k)/m"),
    ],
)
def test_a_minus_sign_goes_into_a_difference(expr: sp.Expr, text: str) -> None:
    assert plain(expr) == text


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (x + v * t_3 - v * t_2, "x + v (t_3 - t_2)"),
        ((v + sp.sqrt(g * x) + g * t_2) / g, "(v + √(g x))/g + t_2"),
        (t_3 - t_2, "t_3 - t_2"),
        (x - g * t_3**2 / 2 - g * t_2**2 / 2 + g * t_2 * t_3, "x - 1/2 g (t_3 - t_2)²"),
        ((2 * v + g * t_2) / (2 * g), "(2 v + g t_2) / (2 g)"),
    ],
)
def test_the_time_between_two_states_is_one_bracket(expr: sp.Expr, text: str) -> None:
    assert plain(over_durations(expr, TIMES)) == text


THROWN = """
title: Thrown up from a cliff, and back down past it
plane: vertical
bodies: {P: {particle: [0, 0], mass: any}}
states:
  1: [v(P).x = 4 m/s, v(P).y = 3 m/s]
  2: [y(P) = -5 m]
  3: [y(P) = -20 m]
find: {t: t @ 2, v: v(P).y @ 2, later: t @ 3, x: x(P) @ 3 - x(P) @ 2}
"""


def page_of(text: str) -> str:
    problem, _ = load_text(text)
    assert problem is not None
    return Terminal(width=110).render(narrate(solve_problem(problem)))


def test_a_root_is_left_out_by_what_rules_it_out() -> None:
    page = page_of(THROWN)
    assert "the positive root: t_3 > 0" in page
    assert "the negative root: y_P,2 < 0 is passed only on the way down" in page
    assert "not -" not in page


ON_A_SPRING = """
title: Down past a place that is passed again on the way up
plane: vertical
given: {m: 2 kg, k: 200 N/m, L: 0.5 m}
points: {P: [0, 0.5 m], O: [0, 0]}
bodies: {block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 90 deg}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: L}
states:
  1: [v(P).y = 3 m/s]
  2: [y(P) = 0.4 m]
find: {v: v(P).y @ 2}
"""


@pytest.mark.parametrize("plane", ["vertical", "horizontal"])
def test_what_comes_back_passes_a_place_more_than_once(plane: str) -> None:
    page = page_of(ON_A_SPRING.replace("plane: vertical", f"plane: {plane}"))
    assert "the negative root: it moves downward" in page
    assert "passed only" not in page
    # Nor does the size of its speed, which is that letter, have a line of its own.
    assert not [row for row in page.splitlines() if row.strip().startswith(("v_2", "|v_2|"))]
    assert page.count("v_2 = ") == 2


def test_what_others_are_divided_by_least_is_carried() -> None:
    a, alpha, length = sp.symbols("a alpha l")
    relation, moments = a - length * alpha * sp.sin(phi), m * a * length * sp.sin(phi) + m * alpha - g
    found = easiest([relation, moments], [alpha, a], [a], lambda _: False)
    assert (found.unknowns, found.letters, found.equations) == ((a, alpha), (alpha,), (0, 1))


YO_YO = """
title: Disk that unwinds from a cord
plane: vertical
given: {m: 2 kg, r: 0.1 m}
points: {G: [0, 0], T: [r, 0], H: [r, 1 m]}
bodies: {disk: {disk: G, radius: r, mass: m}}
joints:
  - rope: {path: [H, T on disk], name: cord}
instant: [at rest]
find: {a: a(G).y, T: tension(cord)}
"""


def test_an_equation_that_gives_an_unknown_is_put_into_the_next() -> None:
    page = page_of(YO_YO)
    assert re.search(r"\(1\) in \(\d\): +α = ", page)
    assert "together" not in page


HAULED = """
title: Least force on a floor
plane: vertical
symbols: {m: kg, mu: 1}
unknowns: {P: N, alpha: deg}
points: {C: [0, 0]}
surfaces: {floor: {through: C, angle: 0 deg}}
bodies: {crate: {particle: C, mass: m}}
joints:
  - contact: {between: [crate, floor], at: C, mu: mu}
loads:
  - force: {body: crate, magnitude: P, angle: alpha}
instant: [v(crate).x > 0, a(crate).x = 0, P is smallest]
find: {alpha: alpha}
"""


def test_an_extreme_stands_behind_the_equations_that_it_rests_on() -> None:
    page = page_of(HAULED)
    assert "Kinematic analysis" not in page
    assert "Newton's second law." in page
    sums, extreme = page.index("ΣF_x"), page.index("its derivative with respect to α is zero:")
    assert sums < extreme < page.index("Solving the equations")
    assert re.search(r"\(3\) +μ cos α - sin α = 0", page)


BRAKED_DRUM = """
title: Drum braked by a block, its place in numbers and its radius by name
plane: vertical
given: {R: 200 mm, I: 3 kg*m^2, P: 150 N, mu: 0.35}
points: {A: [0, 50 mm], B: [800 mm, 50 mm], D: [300 mm, 0], O: [300 mm, -200 mm]}
bodies:
  drum: {disk: O, radius: R, mass: 60 kg, inertia: I}
  lever: {points: [A, B, D]}
joints:
  - pin: {at: O, between: [ground, drum]}
  - pin: {at: A, between: [ground, lever]}
  - contact: {between: [lever, drum], at: D, mu_k: mu}
loads:
  - force: {body: lever, at: B, magnitude: P, angle: -90 deg}
states: {1: [t = 0, omega(drum) = 20 rad/s cw], 2: [omega(drum) = 0]}
find: {t: t @ 2}
"""


def test_arms_of_a_rim_are_lengths() -> None:
    """Not 1/(25 R), which has the value of the arm 0.2 m, and not its dimension."""
    problem, _ = load_text(BRAKED_DRUM)
    assert problem is not None
    page = Terminal(200).render(narrate(solve_problem(problem)))
    assert "μ N_D (0.2 m) = I α_drum" in page


def test_a_place_that_is_differentiated_loses_the_sine_of_all_its_terms() -> None:
    page = page_of(PENDULUM.replace("{from: O, distance: l, angle: theta - 90 deg}", "[l*sin(theta), -l*cos(theta)]"))
    assert "x_P = l sin θ and y_P = -l cos θ differentiated, along the path:" in page
    assert re.search(r"\(1\)  v_P = l θ̇", page)
    assert "differentiated" not in page_of(PENDULUM)


PENDULUM = """
title: Pendulum
plane: vertical
given: {l: 2 m, m: 3 kg}
coordinates: {theta: deg}
points: {O: [0, 0], P: {from: O, distance: l, angle: theta - 90 deg}}
bodies: {bob: {particle: P, mass: m}}
joints:
  - link: {between: [O, P], name: rod}
states:
  1: [theta = 40 deg, at rest]
  2: [theta = 0]
find: {S: tension(rod) @ 2}
"""


def test_a_unit_stays_beside_its_equation() -> None:
    sides = tuple(doc.Math(sp.Symbol(letter * 30)) for letter in "abc")
    document = doc.Document("Units", (doc.Equation(sides, None, (), doc.line("in kg m²/s²")),))
    (last,) = Terminal(width=110).render(document).splitlines()[-1:]
    assert re.fullmatch(r" +.*c{30} +in kg m²/s²", last)
