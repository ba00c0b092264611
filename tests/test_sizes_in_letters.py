"""Magnitudes in letters: the sign of what stands between bars, and angles that are given a number."""

from __future__ import annotations

import random
import re
from decimal import Decimal
from pathlib import Path

import pytest
import sympy as sp
from worked import page_of_file

from planar_cli.equation.algebra.bounds import certain_sign, with_certain_signs
from planar_cli.formats.terminal import Terminal
from planar_cli.problem.structure import load
from planar_cli.report.notation.sizes import with_signs
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution

THETA, PHI = sp.Symbol("theta", real=True), sp.Symbol("phi", real=True)
B, C = sp.Symbol("b", positive=True), sp.Symbol("c", positive=True)

FILE = """title: A pin on a path
{known}
coordinates: {{theta: rad}}
points: {{O: [0, 0], A: [2*b, 0], P: [{place}]}}
bodies: {{pin: {{particle: P}}}}
motion: [dot(theta) = w]
{at}find:
  r: r(pin).mag
  v_r: v(pin).r
  v_th: v(pin).theta
  a_r: a(pin).r
  a_th: a(pin).theta
  v: v(pin).mag
  d: r(P/A).mag
"""
FORMS = [
    "2 - cos(theta)",
    "1 - cos(theta)",
    "1 - sin(theta)",
    "3 - 2*cos(theta)",
    "cos(theta) - 2",
    "1 - 2*cos(theta)",
    "2*cos(theta) - 1",
    "3/2 - cos(theta) - sin(theta)",
    "sin(theta)",
    "2*theta - sin(theta)",
    "sin(theta)^2 - 2",
]


def _part(tmp_path: Path, text: str) -> PartSolution:
    path = tmp_path / "pin.yaml"
    path.write_text(text)
    problem = load(str(path))[0]
    return solve_problem(problem).parts[0]


def _file(form: str, known: str, at: str = "") -> str:
    place = f"b*({form})*cos(theta), b*({form})*sin(theta)"
    return FILE.format(known=known, place=place, at=at)


def _page(tmp_path: Path, text: str) -> str:
    path = tmp_path / "pin.yaml"
    path.write_text(text)
    return Terminal(200).render(narrate(solve_problem(load(str(path))[0])))


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS)
def test_answers_in_letters_are_those_in_numbers(form: str, tmp_path: Path) -> None:
    """At numbers with which the page's assumptions hold, every formula is the answer to the file with these numbers."""
    part, positive = with_signs(_part(tmp_path, _file(form, "symbols: {b: m, w: rad/s}")))
    draw = random.Random(form)
    for _ in range(300):
        numbers = {"b": draw.randint(2, 9), "w": draw.randint(2, 9), "theta": sp.Rational(draw.randint(1, 620), 100)}
        places = [p.xreplace({s: numbers[s.name] for s in p.free_symbols}) for p in positive]
        if all(p > sp.Rational(1, 50) for p in places):
            break
    assert all(p > sp.Rational(1, 50) for p in places), f"nothing fulfils {positive}"
    given = f"given: {{b: {numbers['b']} m, w: {numbers['w']} rad/s}}"
    other = _part(tmp_path, _file(form, given, f"instant: [theta = {float(numbers['theta'])} rad]\n"))
    for ours, theirs in zip(part.found, other.found, strict=True):
        assert ours.expressions is not None
        assert theirs.values is not None
        one = ours.expressions[0].xreplace({s: numbers[s.name] for s in ours.expressions[0].free_symbols})
        assert not ours.expressions[0].has(sp.Abs, sp.sign)
        assert abs(Decimal(str(sp.N(one, 30))) - theirs.values[0]) < Decimal("1e-20"), ours.name


def test_rates_of_polar_coordinates_are_those_of_their_short_forms() -> None:
    page = page_of_file("pin-in-a-limacon-groove")
    rates = page.partition("and their rates:")[2].partition("Components")[0]
    assert "= b w² cos θ " in rates
    assert rates.strip().endswith("= 0")


def test_signs_that_ranges_decide() -> None:
    for expr, sign in {
        2 - sp.cos(THETA): 1,
        sp.cos(THETA) - 1: -1,
        B * C * (3 - 2 * sp.sin(PHI)): 1,
        2 * B - B * sp.cos(THETA): 1,
        sp.Rational(3, 2) - sp.cos(THETA) - sp.sin(THETA): 1,
        sp.Rational(4, 3) - sp.cos(THETA) - sp.sin(THETA): 0,
        5 - 4 * sp.sin(THETA) * sp.cos(PHI): 1,
        sp.cos(THETA) ** 2 - sp.cos(THETA) - 2: -1,
        sp.sin(THETA) ** 2 - 2: -1,
        sp.sin(THETA): 0,
        B - C * sp.cos(THETA): 0,
        2 * THETA - sp.sin(THETA): 0,
    }.items():
        assert certain_sign(expr) == sign, expr
    assert with_certain_signs(sp.Abs(sp.cos(THETA) - 2) + sp.sign(2 - sp.cos(THETA))) == 3 - sp.cos(THETA)


def test_nothing_is_assumed_that_never_holds(tmp_path: Path) -> None:
    known = "symbols: {b: m, w: rad/s}"
    for form in ("2 - cos(theta)", "1 - sin(theta)", "cos(theta) - 2"):
        assert "Assume" not in _page(tmp_path, _file(form, known))
    page = _page(tmp_path, _file("1 - 2*cos(theta)", known))
    assert "Assume 2 cos θ > 1 " in re.sub(r"\s+", " ", page)
    assert "r = b (2 cos θ - 1)" in page


@pytest.mark.parametrize(
    ("form", "angle", "told"),
    [
        ("1 + cos(theta)", "90 deg", {"a_r": "-b w²", "a_th": "-2 b w²", "v": "√2 b w"}),
        ("1 - cos(theta)", "60 deg", {"v": "b w", "a_r": "0", "a_th": "√3 b w²"}),
        (
            "theta",
            "pi",
            {"v_r": "b w", "v_th": "π b w", "a_r": "-π b w²", "a_th": "2 b w²", "v": "b w √(1 + π²) = 3.297 b w"},
        ),
        ("2 - cos(theta)", "-pi/2", {"r": "2 b", "v_r": "-b w", "a_r": "-2 b w²", "a_th": "-2 b w²"}),
        ("1", "20 deg", {"r": "b", "v": "b w", "d": "b √(5 - 4 cos 20°) = 1.114 b"}),
    ],
)
def test_an_angle_that_is_given_appears_with_its_number(
    form: str, angle: str, told: dict[str, str], tmp_path: Path
) -> None:
    at = f"instant: [theta = {angle}]\n"
    page = _page(tmp_path, _file(form, "symbols: {b: m, w: rad/s}", at))
    answers = page.partition("Answer")[2].partition("Check")[0]
    for name, formula in told.items():
        assert re.search(rf"\b{name} = (.* = )?{re.escape(formula)}\n", answers), answers
    assert "θ" not in answers
    assert "Assume" not in page


@pytest.mark.parametrize(
    ("size", "told"),
    [
        ("3 - 2*cos(w*t)", {"r": "b (3 - 2 cos(w t))", "v_th": "b w (3 - 2 cos(w t))", "a_r": "b w² (4 cos(w t) - 3)"}),
        ("2 - cos(w*t)", {"v_r": "b w sin(w t)", "a_r": "2 b w² (cos(w t) - 1)", "a_th": "2 b w² sin(w t)"}),
        ("1 - sin(w*t)", {"v_r": "-b w cos(w t)", "a_th": "-2 b w² cos(w t)"}),
    ],
)
def test_sizes_that_are_told_over_time(size: str, told: dict[str, str], tmp_path: Path) -> None:
    text = FILE.replace("coordinates: {{theta: rad}}\n", "").replace(FILE.splitlines(True)[3], "")
    text = text.replace("particle: P", "particle: free").replace("  d: r(P/A).mag", "")
    text = text.replace("[dot(theta) = w]", f"[r(pin).mag = b*({size}), r(pin).angle = w*t]")
    page = _page(tmp_path, text.format(known="symbols: {b: m, w: rad/s}", place="", at=""))
    answers = page.partition("Answer")[2]
    for name, formula in told.items():
        assert re.search(rf"\b{name} = {re.escape(formula)}\n", answers), answers
