"""Two principles, one answer: the same question by Newton's law, by work and energy, and by impulse and momentum.

The numbers that a solution prints are checked against each other already when they are found. So each way that is told
is walked here once more from its own equations alone, by Newton's method from a start beside the answer, and it is what
comes of that which has to agree: with the other methods, with the motion followed step by step, and with the formula.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import cache

import mpmath
import pytest
import sympy as sp
from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import FileProblem
from planar_cli.problem.structure import load_text
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution

FEW = settings(max_examples=3, deadline=None, derandomize=True, phases=[Phase.generate])
SEEDS = st.integers(0, 10**9)
METHODS = ("newton", "energy", "momentum")
TWELVE, FOLLOWED = Decimal("1e-12"), Decimal("1e-10")
BESIDE = Decimal("1.001")
"""How far beside the answer Newton's method starts."""
Draws = tuple[tuple[str, float, float, str], ...]
"""What a scene draws: name, smallest, largest, and the unit."""
NAMES = {n: sp.Symbol(n, positive=True) for n in ("M", "m", "l", "phi", "g", "m_A", "m_B", "k", "s")}


@dataclass(frozen=True, slots=True)
class Question:
    """A scene with what is asked of it. `applies`: the methods that lead there alone."""

    name: str
    draws: Draws
    text: str
    applies: tuple[str, ...]

    def written(self, rng: random.Random) -> str:
        given = ", ".join(f"{n}: {rng.uniform(low, high):.4g} {unit}" for n, low, high, unit in self.draws)
        return f"title: {self.name}\ngiven: {{{given}}}\n{self.text}"


PENDULUM = """
plane: vertical
points: {O: [0, 0], B: {from: O, distance: l, angle: -90 deg + phi}}
bodies: {rod: {rod: [O, B], mass: m}}
joints:
  - pin: {at: O, between: [ground, rod]}
states: {1: [at rest], 2: [theta(rod) = -90 deg - s*phi]}
find: {v: v(B).mag @ 2, omega: omega(rod) @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
DISC = """
plane: vertical
points: {C: [0, 0], G: {from: C, distance: R, angle: 90 deg - beta}}
surfaces: {slope: {through: C, angle: -beta}}
bodies: {disc: {disk: G, radius: R, mass: m}}
joints:
  - rolling: {between: [disc, slope], at: C}
"""
DISC_FAR = """
states: {1: [omega(disc) = -v_0/R], 2: [r(G).along(-beta) = d]}
find: {v: v(G).mag @ 2, omega: omega(disc) @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
DISC_LATER = """
states: {1: [t = 0, omega(disc) = -v_0/R], 2: [t = d/v_0]}
find: {v: v(G).mag @ 2, omega: omega(disc) @ 2}
"""
SPRING = """
plane: horizontal
points: {O: [0, 0], P: [l_0 + s, 0]}
bodies: {block: {particle: P, mass: m}}
joints:
  - guide: {point: P, along: 0 deg}
loads:
  - spring: {between: [O, P], stiffness: k, natural_length: l_0}
states: {1: [at rest], 2: [x(P) = l_0 - part*s]}
find: {v: v(P).x @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
ATWOOD = """
plane: vertical
points: {O: [0, 0], S: [-R, 0], T: [R, 0]}
bodies:
  pulley: {disk: O, radius: R, mass: m}
  A: {particle: [-R, -6 m], mass: m_A}
  B: {particle: [R, -6 m], mass: m_B}
joints:
  - pin: {at: O, between: [ground, pulley]}
  - rope: {path: [S on pulley, A], name: left}
  - rope: {path: [T on pulley, B], name: right}
"""
ATWOOD_FAR = """
states: {1: [at rest], 2: [y(A) = -6 m - h]}
find: {v: v(B).y @ 2, omega: omega(pulley) @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
ATWOOD_LATER = """
states: {1: [t = 0, at rest], 2: [t = h/(1 m/s)]}
find: {v: v(B).y @ 2, omega: omega(pulley) @ 2}
"""
WAGON = """
plane: vertical
points: {O: [0, 0], P: {from: O, distance: l, angle: -90 deg + phi}}
bodies: {wagon: {particle: O, mass: M}, bob: {particle: P, mass: m}}
joints:
  - guide: {body: wagon, along: 0 deg}
  - link: {between: [O, P], name: string}
states: {1: [t = 0, at rest], 2: [x(P) = x(O)]}
find: {v: v(O).x @ 2, u: v(P).x @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
LADDER = """
plane: vertical
coordinates: {beta: deg}
points: {A: [l*cos(beta), 0], B: [0, l*sin(beta)]}
bodies: {ladder: {rod: [A, B], mass: m}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 90 deg}
states: {1: [beta = phi, at rest], 2: [beta = s*phi]}
find: {omega: omega(ladder) @ 2, v: v(A).x @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
YOYO = """
plane: vertical
points: {K: [-r, 1 m], T: [-r, 0], G: [0, 0]}
bodies: {yoyo: {disk: G, radius: 5*r, hub: r, mass: m, radius_of_gyration: k*r}}
joints:
  - rope: {path: [K, T on yoyo], name: cord}
"""
YOYO_FAR = """
states: {1: [at rest], 2: [y(G) = -h]}
find: {v: v(G).y @ 2, omega: omega(yoyo) @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
YOYO_LATER = """
states: {1: [t = 0, at rest], 2: [t = h/(1 m/s)]}
find: {v: v(G).y @ 2, omega: omega(yoyo) @ 2}
"""
PAIR = """
plane: horizontal
points: {A: [0, 0], B: [l_0 + s, 0]}
bodies: {a: {particle: A, mass: m_A}, b: {particle: B, mass: m_B}}
joints:
  - guide: {point: A, along: 0 deg}
  - guide: {point: B, along: 0 deg}
loads:
  - spring: {between: [A, B], stiffness: k, natural_length: l_0}
states: {1: [t = 0, at rest], 2: [x(B) - x(A) = l_0]}
find: {v: v(A).x @ 2, u: v(B).x @ 2, gain: KE(all) @ 2 - KE(all) @ 1, work: work(all) @ 1->2}
"""
ROD: Draws = (("m", 0.2, 9, "kg"), ("l", 0.2, 3, "m"), ("phi", 10, 80, "deg"), ("s", 0, 0.9, ""))
ROLLING: Draws = (
    ("m", 0.2, 9, "kg"),
    ("R", 0.05, 0.6, "m"),
    ("beta", 3, 50, "deg"),
    ("v_0", 0.3, 3, "m/s"),
    ("d", 0.5, 4, "m"),
)
MACHINE: Draws = (
    ("m", 0.2, 9, "kg"),
    ("m_A", 4, 9, "kg"),
    ("m_B", 0.5, 3.5, "kg"),
    ("R", 0.05, 0.3, "m"),
    ("h", 0.2, 0.9, "m"),
)
WINDING: Draws = (("m", 0.1, 2, "kg"), ("r", 0.004, 0.03, "m"), ("k", 1, 5, ""), ("h", 0.2, 0.9, "m"))
BLOCK: Draws = (
    ("m", 0.2, 9, "kg"),
    ("k", 20, 900, "N/m"),
    ("l_0", 0.2, 0.9, "m"),
    ("s", 0.05, 0.15, "m"),
    ("part", -0.9, 0.9, ""),
)
COUPLED: Draws = (
    ("m_A", 0.3, 6, "kg"),
    ("m_B", 0.3, 6, "kg"),
    ("k", 20, 900, "N/m"),
    ("l_0", 0.2, 0.9, "m"),
    ("s", 0.05, 0.5, "m"),
)
SWAYING: Draws = (("M", 0.5, 9, "kg"), ("m", 0.2, 4, "kg"), ("l", 0.3, 2, "m"), ("phi", 10, 80, "deg"))

FAR, LATER = ("newton", "energy"), ("newton", "momentum")
QUESTIONS = [
    Question("pendulum of a rod", ROD, PENDULUM, FAR),
    Question("disc after a way", ROLLING, DISC + DISC_FAR, FAR),
    Question("disc after a time", ROLLING, DISC + DISC_LATER, LATER),
    Question("block on a spring", BLOCK, SPRING, FAR),
    Question("atwood after a way", MACHINE, ATWOOD + ATWOOD_FAR, FAR),
    Question("atwood after a time", MACHINE, ATWOOD + ATWOOD_LATER, LATER),
    Question("ladder", ROD, LADDER, FAR),
    Question("yoyo after a way", WINDING, YOYO + YOYO_FAR, FAR),
    Question("yoyo after a time", WINDING, YOYO + YOYO_LATER, LATER),
]
LONG = {"atwood after a way", "atwood after a time", "yoyo after a way", "block on a spring", "ladder"}
SHARED_OUT = [pytest.param(q, marks=pytest.mark.slow) if q.name in LONG else q for q in QUESTIONS]

# --- one method's own way --------------------------------------------------------------------------------------------


def by_newton(residuals: list[sp.Expr], unknowns: tuple[sp.Symbol, ...], known: Valuation) -> dict[sp.Symbol, Decimal]:
    """Unknowns of as many equations, from a start beside their `known` values."""
    slopes = [[sp.diff(r, x) for x in unknowns] for r in residuals]
    found = {x: known(x) * BESIDE for x in unknowns}
    for _ in range(30):
        here = known.extended(found)
        with mpmath.workdps(45):
            rows = mpmath.matrix([[str(here(s)) for s in row] for row in slopes])
            moves = [Decimal(str(d)) for d in mpmath.lu_solve(rows, mpmath.matrix([str(here(r)) for r in residuals]))]
        found = {x: found[x] - d for x, d in zip(unknowns, moves, strict=True)}
        if all(abs(d) <= Decimal("1e-30") * max(abs(found[x]), 1) for x, d in zip(unknowns, moves, strict=True)):
            return found
    raise AssertionError(f"no way to {unknowns} from beside the answer")


def walked(part: PartSolution) -> dict[str, Decimal]:
    """The finds from the equations of the way that is told, one leg after the other."""
    motion = part.motion
    route, letters = motion.route, motion.unknowns
    base = Valuation({s: v for s, v in motion.value.values.items() if s not in letters}, motion.value.definitions)
    done: dict[sp.Symbol, Decimal] = {s: base(e) for s, e in route.plain.items() if not e.free_symbols & letters}
    for step in route.steps:
        equations, unknowns = step.relations, step.unknowns
        beside = {x: motion.value(x) for x in unknowns}
        residuals = [e.residual.xreplace(route.plain) for e in equations]
        done |= by_newton(residuals, unknowns, base.extended(done | beside))
    own = base.extended(done)
    return {f.name: own(f.asked[0]) for f in part.found if f.name not in ("gain", "work")}


@cache
def solved(text: str, method: str | None) -> PartSolution | None:
    """The one part of a text by a method; None where it alone does not lead to the answers."""
    problem, wrong = load_text(text)
    assert problem is not None, wrong
    try:
        return solve_problem(problem, method).parts[0]
    except FileProblem as error:
        if [d.code for d in error.diagnostics] != ["PL570"]:
            raise
        return None


def assert_near(got: Mapping[str, Decimal], want: Mapping[str, Decimal], digits: Decimal) -> None:
    for name, value in got.items():
        assert abs(value - want[name]) <= digits * max(abs(want[name]), Decimal("1e-3")), (name, value, want[name])


def numbers(part: PartSolution) -> dict[str, Decimal]:
    return {f.name: f.values[0] for f in part.found if f.values is not None}


def followed(part: PartSolution) -> dict[str, Decimal]:
    """The finds with what came of following the equations of motion step by step."""
    motion = part.motion
    assert motion.followed is not None
    own = motion.value.extended({s: Decimal(repr(v)) for s, v in motion.followed.items()})
    return {f.name: own(f.asked[0]) for f in part.found if f.name not in ("gain", "work")}


# --- the properties --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("question", SHARED_OUT, ids=[q.name for q in QUESTIONS])
@FEW
@given(seed=SEEDS)
def test_methods_agree(question: Question, seed: int) -> None:
    """Those that apply lead to the same answer, each from its own equations; the others say that they do not."""
    text = question.written(random.Random(seed))
    ways = {method: part for method in METHODS if (part := solved(text, method)) is not None}
    assert tuple(ways) == question.applies
    plain = solved(text, None)
    assert plain is not None
    want = numbers(plain)
    for method, part in ways.items():
        laws = [e for step in part.motion.route.steps for e in step.relations if e.offered]
        assert laws
        assert all(method in e.offered for e in laws)
        assert_near(numbers(part), want, TWELVE)
        assert_near(walked(part), want, TWELVE)
    assert_near(followed(plain), want, FOLLOWED)
    if "work" in want:
        assert_near({"work": want["work"]}, {"work": want["gain"]}, TWELVE)


def wagon(given: Valuation) -> dict[str, Decimal]:
    """Speeds of the wagon and of the bob at its lowest place, from both conservation laws."""
    big, m, fall, g = (given(sp.sympify(e, NAMES)) for e in ("M", "m", "l*(1 - cos(phi))", "g"))
    relative = (2 * g * fall * (big + m) / big).sqrt()
    return {"v": m * relative / (m + big), "u": -big * relative / (m + big)}


def pair(given: Valuation) -> dict[str, Decimal]:
    """Speeds of both blocks where the spring is relaxed: its energy moves the reduced mass."""
    a, b, k, s = (given(sp.sympify(e, NAMES)) for e in ("m_A", "m_B", "k", "s"))
    relative = (k * s**2 * (a + b) / (a * b)).sqrt()
    return {"v": b * relative / (a + b), "u": -a * relative / (a + b)}


@pytest.mark.parametrize(
    ("question", "truth"),
    [
        (Question("wagon with a pendulum", SWAYING, WAGON, ()), wagon),
        (Question("two blocks and a spring", COUPLED, PAIR, ()), pair),
    ],
    ids=["wagon with a pendulum", "two blocks and a spring"],
)
@FEW
@given(seed=SEEDS)
def test_both_laws_together(question: Question, truth: Callable[[Valuation], dict[str, Decimal]], seed: int) -> None:
    """Of two freedoms no method leads there alone; both laws do, as do the motion followed and the formula."""
    text = question.written(random.Random(seed))
    assert solved(text, "energy") is None
    assert solved(text, "momentum") is None
    part = solved(text, None)
    assert part is not None
    want = numbers(part)
    assert_near(truth(part.motion.value), want, TWELVE)
    assert_near(walked(part), want, TWELVE)
    assert_near(followed(part), want, FOLLOWED)
    assert_near({"work": want["work"]}, {"work": want["gain"]}, TWELVE)
