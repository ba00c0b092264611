"""Pages of several states, in a sample of the problem files: what is printed is true, no unknown is a bare number."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from decimal import Decimal
from itertools import pairwise

import pytest
import sympy as sp
from conftest import ROOT
from printed import Page, equations
from worked import worked

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.values.ledger import display
from planar_cli.formats.terminal import Terminal
from planar_cli.report.document.blocks import Block, Equation, Heading, Math, Paragraph, Text, Value, line
from planar_cli.report.motion.motion import MotionTelling
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.notation import plain
from planar_cli.report.page.narrate import narrate
from planar_cli.report.words.motion_phrases import motion_phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.units import Unit, parse_unit

FILES = (
    "textbook/ex-1-07",
    "textbook/ex-1-10",
    "textbook/ex-4-10",
    "textbook/ex-4-17",
    "energy/slider-crank-with-a-spring",
    "energy/block-down-a-slope-onto-a-buffer",
    "energy/bob-on-a-thread-that-goes-slack",
    "energy/exercise-4-35",
    "energy/yo-yo",
    "oscillations/weight-on-a-cord-held-by-a-spring",
    "friction/disk-that-screws-itself-up-a-slope",
    "impact/pendulum-set-swinging",
    "momentum/ball-with-backspin",
    "momentum/winch-with-counterweight",
    "motion/ball-up-with-drag",
    "motion/crane-truck",
)
FIGURES, ROUNDED, TINY = 6, 1e-3, 1e-12


def motions(name: str) -> list[MotionTrace]:
    """The motions of a file."""
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    return [part.motion for part in solution.parts if part.motion is not None]


def told(motion: MotionTrace, figures: int = 4) -> tuple[Block, ...]:
    """What is printed of a motion, without the general position of its regimes."""
    return tuple(MotionTelling(motion, motion_phrases(motion, figures), 1).blocks(1))


@pytest.mark.parametrize("name", FILES)
def test_printed_equations_are_true(name: str) -> None:
    for motion in motions(name):
        page = Page(motion.value, motion.ledger.us)
        wrong = [w for e in equations(told(motion, FIGURES)) for w in page.wrong(e, ROUNDED)]
        assert not wrong


@pytest.mark.parametrize("name", FILES)
def test_no_unknown_is_a_bare_number(name: str) -> None:
    for motion in motions(name):
        assert not [e for e, before in _results(told(motion)) if _is_bare(e) and not _put_in(before)]


def _results(blocks: tuple[Block, ...]) -> Iterator[tuple[Equation, list[Equation]]]:
    """The lines that follow from numbered equations, with what was printed for them under the last headings."""
    before: list[Equation] = []
    fresh = False
    for block in blocks:
        if isinstance(block, Paragraph):
            before = [] if fresh else before
            fresh = False
        elif isinstance(block, Equation):
            if block.lead and isinstance(block.lead[0], Text) and block.lead[0].text.endswith((":", "together:")):
                yield block, before
                fresh = True
            before.append(block)


def _is_bare(e: Equation) -> bool:
    """Is it unknown = value, a value that is not zero?"""
    known = [s for s in e.sides[1:] if not isinstance(s, Value)]
    last = e.sides[-1]
    return (
        isinstance(e.sides[0], Math)
        and not known
        and isinstance(last, Value)
        and last.number != 0
        and e.number is None
        and bool(e.lead)
        and isinstance(e.lead[0], Text)
        and e.lead[0].text.startswith("(")
    )


def _put_in(before: list[Equation]) -> bool:
    """Does an equation with numbers alone beside its unknowns stand there?"""
    return any(
        all(isinstance(s, Math) for s in e.sides)
        and (any(s.values for s in e.sides if isinstance(s, Math)) or bool(e.note) or _only_unknown(e))
        for e in before
    )


def _only_unknown(e: Equation) -> bool:
    symbols = {x for s in e.sides if isinstance(s, Math) for x in s.expr.free_symbols}
    return len(symbols) == 1


@pytest.mark.parametrize("name", FILES)
def test_no_step_is_told_twice(name: str) -> None:
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    blocks = narrate(solution).blocks
    starts = [i for i, b in enumerate(blocks) if _is_step(b) or (isinstance(b, Heading) and b.label == "CASE")]
    said: set[str] = set()
    for i, j in pairwise([*starts, len(blocks)]):
        heading = blocks[i]
        assert isinstance(heading, Heading)
        own = [b for b in blocks[i + 1 : j] if isinstance(b, Equation | Paragraph)]
        if heading.label == "CASE":
            said = set()
        elif any(isinstance(b, Equation) for b in own):
            text = repr([replace(b, number=None, lead=()) if isinstance(b, Equation) else b for b in own])
            assert text not in said
            said.add(text)


@pytest.mark.parametrize("name", FILES)
def test_every_answer_with_a_number_has_a_line(name: str) -> None:
    solution, _ = worked(ROOT / "problems" / f"{name}.yaml")
    lines = list(equations(narrate(solution).blocks))
    shown = {_size(s.number, parse_unit(s.unit or "1")) for e in lines for s in e.sides if isinstance(s, Value)}
    for found in (f for part in solution.parts for f in part.found if f.kind == "number" and f.values is not None):
        assert _size(display(found.values[0], found.unit, solution.problem.us), found.unit) in shown | {"0"}, found.name


@pytest.mark.parametrize("name", ["textbook/ex-1-09", "textbook/ex-1-10", "motion/crane-truck", "motion/polar-motion"])
def test_results_are_in_letters_or_in_numbers(name: str) -> None:
    """Where a number of the file with a unit stands among letters, no letter is left."""
    for motion in motions(name):
        for e in (e for e in equations(told(motion)) if isinstance(e.sides[-1], Value)):
            formulas = [s for s in e.sides if isinstance(s, Math) and s.expr.free_symbols - set(s.values or ())]
            # θ̇ on the left of a law is a name of the page alone.
            known = [s.expr for s in formulas if s.expr.free_symbols <= motion.ledger.units.keys()]
            assert is_clean(motion.ledger, *known), formulas


def test_a_law_whose_numbers_hide_units_is_in_numbers() -> None:
    (motion,) = motions("motion/body-wheel-rim-point")
    theta = next(e for e in equations(told(motion)) if e.note == line("in rad/s"))
    assert [plain(s.expr, s.values) for s in theta.sides if isinstance(s, Math)] == ["θ̇", "-2.5 - 1.25 t"]


def test_what_a_blow_leaves_has_no_number_and_vectors_have_a_line() -> None:
    (first, *_) = motions("impact/ball-off-a-smooth-wall")
    lines = list(equations(told(first)))
    kept = [e for e in lines if e.note in (line("a blow takes no time"), line("nothing moves during a blow"))]
    assert kept
    assert not [e for e in kept if e.number is not None]
    assert "v_rebound" in [e.sides[0][0].name for e in lines if isinstance(e.sides[0], tuple)]


def test_numerical_integration_says_of_what_and_from_where() -> None:
    (light, *_) = motions("oscillations/bar-with-spring-and-damper")
    blocks = told(light)
    first = next(i for i, b in enumerate(blocks) if isinstance(b, Equation) and b.lead == line("At 2:"))
    said = blocks[first - 1]
    assert isinstance(said, Paragraph)
    words = "".join(p.text for p in said.line if isinstance(p, Text))
    assert "found by numerical integration" in words
    assert "are integrated (by a Runge–Kutta method) from state 1 on" in words
    assert [p.number for p in said.line if isinstance(p, Value)] == [12, 0]


def test_forces_at_a_state_are_solved_with_its_numbers() -> None:
    solution, _ = worked(ROOT / "problems/energy/slider-crank-with-a-spring.yaml")
    blocks = narrate(solution).blocks
    start = next(i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.label == "STATE")
    there = [b for b in blocks[start:] if isinstance(b, Equation)]
    assert sum(bool(b.note) for b in there) > 3
    # What stood in general letters before took four pages.
    assert all(operations(s.expr) < 40 for b in there for s in b.sides if isinstance(s, Math))


def _is_step(block: Block) -> bool:
    return isinstance(block, Heading) and block.label.startswith("STEP")


def _size(number: Decimal, unit: Unit) -> str:
    """The size of a number in SI units, as it is printed to some digits."""
    size = abs(float(number)) * float(unit.factor) * float(sp.pi) ** unit.pi_power
    return f"{size:.8g}" if size > TINY else "0"


def test_what_is_zero_goes_and_an_extreme_is_told_by_what_vanishes() -> None:
    """A block let go on a spring: its speed is no factor where it is largest, which is in the place of rest."""
    solution, _ = worked(ROOT / "problems" / "oscillations" / "block-hung-on-a-spring.yaml")
    page = " ".join(Terminal(width=110).render(narrate(solution)).split())
    assert (
        "where the acceleration along the path is zero: s_fastest = s_eq (2) cos(ω_n t_fastest) = 0 ω_n t_fastest = π/2"
        in page
    )
    assert "s_lowest = s_eq + (l_0 - s_eq) cos π = 2 s_eq - l_0 = 2 · 0.34905 - 0.3 = 0.3981 m" in page
    assert "simple harmonic motion:" in page


def test_what_holds_throughout_has_its_line_and_its_way_once() -> None:
    """The tension of a pendulum from the speed that was just found, both where the sense of the motion is kept."""
    solution, _ = worked(ROOT / "problems" / "oscillations" / "simple-pendulum.yaml")
    page = " ".join(Terminal(width=110).render(narrate(solution)).split())
    assert "θ̇ dθ̇ = θ̈ dθ from θ = θ_0, θ̇ = 0 to any θ:" in page
    assert "S from 1 to 2, as a function of θ: S = m (g cos θ + l" in page


def test_forces_that_last_are_told_once() -> None:
    """A brake presses all the time as at its first state: no section of that state tells it once more."""
    path = ROOT / "problems" / "friction" / "drum-braked-by-a-lever.yaml"
    page = Terminal(200).render(narrate(worked(path)[0]))
    assert "STATE" not in page
    assert page.count("↺ ΣM_C:") == 1
    assert page.count("= 56.69 lbf") == 2


def test_what_lasts_has_numbers_where_letters_would_hide_units() -> None:
    """An arm of 5 in that no letter names: moments in lbf·ft, none in twelfths of a mass."""
    page = Terminal(200).render(narrate(worked(ROOT / "problems" / "systems" / "hoist-with-gears-in-us-units.yaml")[0]))
    assert "-90 - 0.3333 F_C = 0.01943 α_gear,A   in lbf·ft" in page
    assert "5/12" not in page
    assert "STATE" not in page
