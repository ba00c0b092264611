"""What stands under a diagram whose letters count in directions that are assumed, or came out the other way.

dashed: direction assumed; found: F_C to the left
"""

from __future__ import annotations

import math
import re
from collections import ChainMap, Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

from sympy import Add, Expr, Integer, Rational, Symbol

from planar_cli.equation.scene.arrows import vector_arrow
from planar_cli.equation.values.exact import Valuation
from planar_cli.figures.written_out import formulas_of, sign_of, states_against, written_out
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Forces, Inline, Line, Math, line
from planar_cli.report.document.marks import Arrow, Mark, Panel, Turn
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.numbers import rotation_words
from planar_cli.solve.between.trace.trace import ImpactEquation, MotionTrace, RegimeTrace, RouteStep
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution, Solution

OPPOSITE = {
    "→": "to the left",
    "↗": "down to the left",
    "↑": "downward",
    "↖": "down to the right",
    "←": "to the right",
    "↙": "up to the right",
    "↓": "upward",
    "↘": "up to the left",
}
"""Of arrows, as lists of forces have them: what slants stands for its whole quadrant."""
FINE = 9
"""Decimals of a sine; what is smaller is nought."""
NUMBER = re.compile(r"-?\d+(\.\d+)?")
GIVEN = "given"
"""The kind of a relation of a motion that is a datum of the file."""
LEGEND = "dashed: direction assumed"


def given_turned(mark: Mark, row: Forces, solution: Solution) -> Mark:
    """What the file gives against its letter drawn the way it is: -m v_y downward, where v_y < 0 is given. `row`: the
    list of forces that the mark is of.
    """
    first = next((p for p in mark.words if isinstance(p, Math)), None) if isinstance(mark, Arrow | Turn) else None
    if first is None or not isinstance(mark, Arrow | Turn) or isinstance(first.expr, Add):
        return mark
    if not _size(mark.words).free_symbols <= _data(row, solution) or not _is_against(mark.words, row, solution):
        return mark
    words = tuple(replace(p, expr=-first.expr) if p is first else p for p in mark.words)
    if isinstance(mark, Turn):
        return replace(mark, words=words, sense=-mark.sense)
    return replace(mark, words=words, angle=mark.angle + math.pi)


def note_of(panels: Sequence[Panel], row: Forces, solution: Solution) -> Line:
    """Nothing where no direction is assumed and each is as drawn. `row`: the list of forces of these diagrams."""
    drawn = [m for p in panels for m in p.marks if isinstance(m, Arrow | Turn)]
    legend = [LEGEND] if any(isinstance(m, Arrow) and m.assumed for m in drawn) else []
    against = {repr((m.words, _opposite(m))): m for m in drawn if _is_against(m.words, row, solution)}
    found = [*against.values()]
    others = {repr(m.words): m for m in drawn if m not in found}
    # Where the sense of one is told, all are.
    here = [m for m in others.values() if against and _is_against_here(m.words, row, solution)]
    parts: list[list[Inline | str]] = [[*legend]]
    parts += [[head, *_told(own)] for head, own in (("found: ", found), ("as drawn here: ", here)) if own]
    parts += _by_states([m for m in others.values() if m not in here], row, solution)
    told = [piece for part in parts if part for piece in ("; ", *part)]
    return line(*told[1:])


def _told(marks: Sequence[Arrow | Turn]) -> list[Inline | str]:
    return [piece for m in marks for piece in (", ", *m.words, f" {_opposite(m)}")][1:]


def _by_states(marks: Sequence[Arrow | Turn], row: Forces, solution: Solution) -> Iterator[list[Inline | str]]:
    """What is against its arrow in states of a motion in numbers: at 1 opposite to its arrow: m a_t."""
    told: dict[tuple[str, ...], list[Arrow | Turn]] = {}
    for mark in marks:
        size = _size(mark.words)
        motions = (p.motion for p in solution.parts if p.motion is not None and not p.motion.value.drawn)
        states = next((found for m in motions if (found := states_against(size, row, m))), ())
        if states and size.free_symbols:
            told.setdefault(states, []).append(mark)
    for states, own in told.items():
        which = "its arrow" if len(own) == 1 else "their arrows"
        yield [f"at {' and '.join(states)} opposite to {which}: ", *[p for m in own for p in (", ", *m.words)][1:]]


def _is_against_here(words: Line, row: Forces, solution: Solution) -> bool:
    """Is a vector against its arrow with the numbers that are drawn for letters?"""
    size = _size(words)
    plain = (part for part in solution.parts if part.motion is None and size.free_symbols)
    drawn = [i for part in plain for i in part.instants if i.instant.scene is row.scene and i.value.drawn]
    outcomes = ((i, outcome) for i in drawn for outcome in i.trial.outcomes)
    numbers = [i.value.extended(unknowns_of(i.trial.system, outcome)).known(size) for i, outcome in outcomes]
    return bool(numbers) and all(n is not None and n < 0 for n in numbers)


def _data(row: Forces, solution: Solution) -> set[Symbol]:
    """The letters of which the file gives what they are."""
    given = set(row.scene.ledger.values) if row.scene is not None else set()
    for motion in (part.motion for part in solution.parts if part.motion is not None):
        given |= set(motion.route.plain)
        data = (step for step in motion.route.steps if step.is_datum and step.relations[0].kind == GIVEN)
        given |= {r.unknown for step in data for r in step.results}
    return given


def _opposite(mark: Arrow | Turn) -> str:
    if isinstance(mark, Turn):
        return rotation_words(-mark.sense)
    x, y = (Decimal(round(part, FINE)) for part in (math.cos(mark.angle), math.sin(mark.angle)))
    return OPPOSITE[vector_arrow(x, y)]


def _is_against(words: Line, row: Forces, solution: Solution) -> bool:
    """Does a vector come out against the direction in which its letters count, whenever its diagram holds?"""
    size = _size(words)
    found = [n for part in solution.parts for n in _numbers(size, row, part, solution)] if size.free_symbols else []
    return bool(found) and all(n is not None and n < 0 for n in found)


def _size(words: Line) -> Expr:
    return math.prod((_in_numbers(p) for p in words if isinstance(p, Math)), start=Integer(1))


def _in_numbers(told: Math) -> Expr:
    """A formula with the numbers that it is printed with."""
    texts = {s: t for s, t in (told.values or {}).items() if NUMBER.fullmatch(t)}
    return told.expr.xreplace({s: Rational(t) for s, t in texts.items()})


def _numbers(size: Expr, row: Forces, part: PartSolution, solution: Solution) -> Iterator[Decimal | None]:
    """What was found for it where the scene is that of the diagram, or its sign where numbers were drawn for letters;
    None: it changes in a motion, or nothing tells.
    """
    if part.motion is not None:
        drawn = bool(part.motion.value.drawn)
        for found in _of_motion(size.free_symbols, row, part, part.motion, solution):
            numbers = Valuation({s: n for s, (_, n) in found.items() if n is not None})
            known = ChainMap(_answers(part), _solved(part.motion))
            whole = size.xreplace({s: e for s, (e, _) in found.items()})
            if drawn:
                yield sign_of(written_out(whole, known), part.motion.value, part.motion.ledger)
            else:
                yield numbers.known(size)
        return
    formulas = _answers(part)
    for i in part.instants:
        if i.instant.scene is row.scene:
            size = size.xreplace(_by_other_names(size, i, solution))
            whole = written_out(size, ChainMap(formulas, dict(formulas_of(i))))
            number = i.value.known(size) or i.value.known(whole)
            yield (
                number
                if _letters(size, i).isdisjoint(i.value.drawn)
                else sign_of(whole, i.value, i.instant.scene.ledger)
            )


def _answers(part: PartSolution) -> dict[Symbol, Expr]:
    """The letters that are asked, by their formulas."""
    return {f.asked[0]: f.expressions[0] for f in part.found if len(f.asked) == 1 and f.expressions}


def _by_other_names(size: Expr, i: InstantSolution, solution: Solution) -> dict[Symbol, Symbol]:
    """The letters of an instant, where the page has shorter ones: those for which answers are asked, or of which an
    instant has no other one, N for N_rod.
    """
    asked = {plain_name(f.name): f.asked[0] for p in solution.parts for f in p.found if len(f.asked) == 1}
    own = {*formulas_of(i), *i.trial.system.symbols.values()}
    stems = Counter(s.name.partition("_")[0] for s in own)
    alone = {stem: s for s in own if stems[stem := s.name.partition("_")[0]] == 1}
    others = [s for s in size.free_symbols - own if i.value.known(s) is None]
    told = {s: asked.get(plain_name(s.name), alone.get(s.name)) for s in others}
    return {s: letter for s, letter in told.items() if letter in own}


def _letters(size: Expr, instant: InstantSolution) -> set[Symbol]:
    """All on which it rests, through what was solved."""
    formulas = formulas_of(instant)
    seen, left = set[Symbol](), set(size.free_symbols)
    while left:
        letter = left.pop()
        seen.add(letter)
        left |= (formulas[letter].free_symbols if letter in formulas else set()) - seen
    return seen


def _of_motion(
    letters: Collection[Symbol], row: Forces, part: PartSolution, motion: MotionTrace, solution: Solution
) -> Iterator[dict[Symbol, tuple[Expr, Decimal | None]]]:
    """Formulas and numbers on each stretch on which the scene is that of the diagram, and at each such blow."""
    data = {s: (s, motion.value.known(s)) for s in letters}
    for regime in motion.regimes:
        if regime.solution.instant.scene is row.scene:
            fixed = _constants(regime)
            yield {s: fixed.get(s.name) or (s, _asked(s, part) if n is None else n) for s, (_, n) in data.items()}
    for leg in motion.route.steps:
        if (blow := next((b for b in _blows(leg) if b.instant.scene is row.scene), None)) is not None:
            told = {s: _of_blow(s, leg, part, motion) if n is None else n for s, (_, n) in data.items()}
            others = _as_in_other_cases(blow, solution) if None in told.values() else {}
            yield {s: (s, motion.value.known(others.get(s, s)) if n is None else n) for s, n in told.items()}


def _blows(leg: RouteStep) -> Iterator[InstantSolution]:
    for e in leg.relations:
        if isinstance(e.source, ImpactEquation) and e.source.impact.solution is not None:
            yield e.source.impact.solution


def _as_in_other_cases(blow: InstantSolution, solution: Solution) -> dict[Symbol, Expr]:
    """What other cases solve of a blow with the same joints and loads: this one may have no need of an impulse."""
    own = blow.instant.scene.problem
    legs = (leg for p in solution.parts if p.motion is not None for leg in p.motion.route.steps)
    others = [b for leg in legs for b in _blows(leg) if b is not blow]
    alike = [b for b in others if _held(b.instant.scene.problem) == _held(own)]
    return {s: e for b in alike for s, e in formulas_of(b).items()}


def _held(problem: Problem) -> tuple[object, ...]:
    return problem.joints, problem.loads, problem.points, problem.bodies


def _constants(regime: RegimeTrace) -> dict[str, tuple[Expr, Decimal | None]]:
    """What does not change on a stretch, by its names: of the only body also by that without it, a_y for a_ball_y."""
    bodies = [*regime.solution.instant.scene.bodies]
    own = f"_{bodies[0]}_" if len(bodies) == 1 else ""
    short = {s.name.replace(own, "_", 1): told for s, told in regime.constants.items() if own and own in s.name}
    return short | {s.name: told for s, told in regime.constants.items()}


def _solved(motion: MotionTrace) -> dict[Symbol, Expr]:
    """What the way to the answers finds, by its formulas."""
    return {r.unknown: r.formula for step in motion.route.steps for r in step.results if r.formula is not None}


def _of_blow(letter: Symbol, leg: RouteStep, part: PartSolution, motion: MotionTrace) -> Decimal | None:
    """An impulse has a shorter name on the page, or that of the answer for which it is asked."""
    own = (r.unknown for r in leg.results if f"{r.unknown.name}_".startswith(f"{letter.name}_"))
    number = _asked(letter, part)
    return next(map(motion.value.known, own), None) if number is None else number


def _asked(letter: Symbol, part: PartSolution) -> Decimal | None:
    """The answer of this name, as of a force at one state of a motion."""
    for f in part.found:
        if f.name == letter.name and f.find is not None and isinstance(f.find.found.what, Quantity) and f.values:
            return f.values[0]
    return None
