"""Several modes of small oscillation: each has its period, the longest first."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from answered import solve

from planar_cli.errors import NoSolution
from planar_cli.formats.terminal import Terminal
from planar_cli.homework.checking.answers import compare
from planar_cli.problem.structure import load_text
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.run import solve_problem

ROW = """
title: Blocks in a row between springs of one stiffness
plane: horizontal
given: {m: 1 kg, k: 100 N/m}
points: {W: [-1 m, 0], P: [0, 0], Q: [1 m, 0], R: [2 m, 0], V: [3 m, 0]}
bodies: {p: {particle: P, mass: m}, q: {particle: Q, mass: m}, r: {particle: R, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
  - guide: {point: Q, along: 0 deg}
  - guide: {point: R, along: 0 deg}
loads:
  - spring: {between: [W, P], stiffness: k, natural_length: 1 m}
  - spring: {between: [P, Q], stiffness: k, natural_length: 1 m}
  - spring: {between: [Q, R], stiffness: k, natural_length: 1 m}
  - spring: {between: [R, V], stiffness: k, natural_length: 1 m}
states: {rest: [equilibrium]}
find: {T: period(rest)}
"""

TWO = """
title: Two masses in a row
plane: horizontal
NAMES
points: {W: [-1 m, 0], P: [0, 0], Q: [1 m, 0]}
bodies: {p: {particle: P, mass: m}, q: {particle: Q, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
  - guide: {point: Q, along: 0 deg}
loads:
  - spring: {between: [W, P], stiffness: k, natural_length: 1 m}
  - spring: {between: [P, Q], stiffness: k, natural_length: 1 m}
MORE
states: {rest: [equilibrium]}
find: {FIND}
"""
NUMBERS = "given: {m: 1 kg, k: 100 N/m}"


def two(find: str, names: str = NUMBERS, more: str = "") -> str:
    return TWO.replace("NAMES", names).replace("MORE", more).replace("FIND", find)


def test_three_modes() -> None:
    """w^2 = (2 - sqrt 2, 2, 2 + sqrt 2) k/m."""
    told = solve(ROW)["T"].values
    assert told is not None
    roots = (2 - math.sqrt(2), 2, 2 + math.sqrt(2))
    assert [float(v) for v in told] == pytest.approx([2 * math.pi / math.sqrt(100 * x) for x in roots])


def test_two_modes_in_letters() -> None:
    """w^2 = (3 -+ sqrt 5)/2 k/m."""
    found = solve(two("f: frequency(rest), w: frequency(rest) in rad/s", "symbols: {m: kg, k: N/m}"))
    k, m = sp.symbols("k m", positive=True)
    roots = [sp.sqrt((3 + s * sp.sqrt(5)) / 2 * k / m) for s in (-1, 1)]
    for name, factor in (("f", 2 * sp.pi), ("w", 1)):
        formulas = found[name].expressions or ()
        assert [sp.simplify(factor**2 * e**2 - w**2) for e, w in zip(formulas, roots, strict=True)] == [0, 0]


def test_damped_modes() -> None:
    """Each damper lies beside a spring, c = 0.02 k: of each mode w^2 is less by the part (0.01 w)^2."""
    dampers = [f"  - damper: {{between: [{pair}], coefficient: 2 N*s/m}}" for pair in ("W, P", "P, Q")]
    told = solve(two("T: period(rest)", more="\n".join(dampers)))["T"].values
    assert told is not None
    squares = [100 * (3 + s * math.sqrt(5)) / 2 for s in (-1, 1)]
    assert [float(v) for v in told] == pytest.approx([2 * math.pi / math.sqrt(x * (1 - 1e-4 * x)) for x in squares])


def test_a_mode_that_creeps_is_told() -> None:
    with pytest.raises(NoSolution, match="not every one of the 2 freedoms") as raised:
        solve(two("T: period(rest)", more="  - damper: {between: [W, P], coefficient: 500 N*s/m}"))
    assert [d.code for d in raised.value.diagnostics] == ["PL632"]


@pytest.mark.parametrize("find", ["T: 2*period(rest)", "T: period(rest), r: period(rest)*frequency(rest)"])
def test_inside_a_formula_a_period_is_the_only_one(find: str) -> None:
    with pytest.raises(NoSolution, match="no single period"):
        solve(two(find))


@pytest.mark.parametrize(
    ("answer", "agrees"),
    [
        ("[1.01664 s, 0.38832 s]", True),
        ("[0.38832 s, 1.01664 s]", False),
        ("[1.01664 s, 0.394 s]", False),
        ("1.01664 s", False),
        ("[1.01664 s, 0.38832 s, 0.1 s]", False),
    ],
)
def test_a_key_lists_them_in_order(answer: str, agrees: bool) -> None:
    """Each number is compared with its own: 1.5 per cent of the smaller one are less than one of the larger one."""
    problem, wrong = load_text(two("T: period(rest)") + f"answers: {{T: {answer}}}\n")
    assert problem is not None, wrong
    (verdict,) = compare(solve_problem(problem))
    assert verdict.agrees == agrees


def test_more_than_two_parts_answer_no_vector() -> None:
    _, wrong = load_text(two("v: v(p) @ rest") + "answers: {v: [1 m/s, 2 m/s, 3 m/s]}\n")
    assert "PL341" in [d.code for d in wrong]


def test_the_page_tells_each_mode() -> None:
    problem, _ = load_text(two("T: period(rest)"))
    assert problem is not None
    page = Terminal(120).render(narrate(solve_problem(problem)))
    assert "ω⁴ - 300 ω² + 10000 = 0" in page
    assert "T_1 = 2 π/ω_1 = 1.017 s" in page
    assert "T_2 = 2 π/ω_2 = 0.3883 s" in page
    assert "A_2/A_1 = 1.618" in page
    assert "T = 1.017 s, 0.3883 s" in page


DAMPERS = """  - damper: {between: [W, P], coefficient: c}
  - damper: {between: [P, Q], coefficient: d}"""


def test_damping_ratios_and_decrements_of_each_mode() -> None:
    """With c/k the same everywhere ζ = c ω_0/(2 k), δ = 2 π ζ/√(1 - ζ²)."""
    names = "given: {m: 1 kg, k: 100 N/m, c: 0.5 N*s/m, d: 0.5 N*s/m}"
    found = solve(two("z: damping_ratio(rest), d: decrement(rest)", names, DAMPERS))
    ratios = [0.0025 * 10 * (math.sqrt(5) + s) / 2 for s in (-1, 1)]
    assert [float(v) for v in found["z"].values or ()] == pytest.approx(ratios)
    decrements = [2 * math.pi * z / math.sqrt(1 - z**2) for z in ratios]
    assert [float(v) for v in found["d"].values or ()] == pytest.approx(decrements)


def test_dampers_that_share_the_modes_in_letters() -> None:
    """ω_0² = (3 ∓ √5)/2 k/m, c = (3 ∓ √5)/2 c/m."""
    names = "symbols: {m: kg, k: N/m, c: N*s/m}"
    text = two("w: frequency(rest) in rad/s, z: damping_ratio(rest)", names, DAMPERS.replace("d}", "c}"))
    found = solve(text)
    numbers = {"m": 2, "k": 7, "c": sp.Rational(1, 3)}
    for k, part in enumerate((3 - sp.sqrt(5), 3 + sp.sqrt(5))):
        natural, damping = sp.sqrt(part / 2 * sp.Rational(7, 2)), part / 2 / 6
        for name, factor, truth in (
            ("w", 2 * sp.pi, sp.sqrt(natural**2 - damping**2 / 4)),
            ("z", 1, damping / (2 * natural)),
        ):
            formula = (found[name].expressions or ())[k]
            value = formula.subs({s: numbers[s.name] for s in formula.free_symbols})
            assert float(value) in (pytest.approx(float(truth)), pytest.approx(float(truth / factor)))


def test_dampers_that_couple_the_modes_have_no_formula() -> None:
    with pytest.raises(NoSolution) as error:
        solve(two("z: damping_ratio(rest)", "symbols: {m: kg, k: N/m, c: N*s/m, d: N*s/m}", DAMPERS))
    assert "no short formula in letters" in error.value.diagnostics[0].message
    assert "give numbers for the letters" in (error.value.diagnostics[0].hint or "")
