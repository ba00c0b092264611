"""A result keeps the form of its own equation where one denominator has numbers that nobody would write."""

from __future__ import annotations

import sympy as sp
from worked import page_of_file

from planar_cli.report.equations.isolated import at_sight
from planar_cli.solve.instant.algebra import Line
from planar_cli.solve.instant.written import Written

a, f, k, m = sp.symbols("a F k m", positive=True)
LEFT = sp.Rational(12, 13) * f - sp.Rational(4, 5) * k
WRITTEN = Written(2, "force", ("P",), "x", "", LEFT, m * a, "kinetics")
RESULT = Line(a, 4 * (15 * f - 13 * k) / (65 * m), None, (2,))


def test_a_formula_that_is_readable_stays() -> None:
    assert at_sight(RESULT, [WRITTEN], lambda _: True) is RESULT


def test_else_the_equation_gives_it() -> None:
    found = at_sight(RESULT, [WRITTEN], lambda e: all(n.q <= 60 for n in e.atoms(sp.Rational)))
    assert found.formula == sp.Mul(LEFT, 1 / m, evaluate=False)
    assert sp.simplify(found.formula - RESULT.formula) == 0


def test_a_slanting_damper_shows_the_rate_of_its_length_before_its_force() -> None:
    page = page_of_file("slider-spring-damper")
    assert "length of the dashpot: √(1.2² + 0.5²) = 1.3 m" in page
    assert "rate of its length, v along WP: -12 v/13 = -12 · 1.5 / 13 = -1.385 m/s it pushes" in page
    assert page.index("rate of its length") < page.index("F_dashpot = -12/13 c_d v")
    assert "(1): a_P = (12 F_dashpot/13 - 4/5 k_s (l_coil - l_0))/m = (12 (-41.54)/13" in page


def test_a_spring_without_a_name_is_called_by_its_ends() -> None:
    page = page_of_file("flat-faced-follower-about-to-lift")
    assert "push of the spring from T to H: F_T = k (2 e + d)" in page
