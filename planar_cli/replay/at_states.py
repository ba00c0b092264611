"""The equations of a motion at one of its states: those of the general position there, in the symbols of the state."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence

import numpy as np
import sympy as sp

from planar_cli.records import record
from planar_cli.replay.equations import Step
from planar_cli.replay.opened import NotWritten, of_block
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.solution import InstantSolution

Named = dict[sp.Symbol, sp.Expr]


@record
class AtState:
    """Steps, names that are defined, and what is asked; `general`: by a symbol that is new, that of the general
    position.
    """

    steps: tuple[Step, ...]
    defined: Mapping[sp.Symbol, sp.Expr]
    parts: tuple[sp.Expr, ...]
    general: Mapping[sp.Symbol, sp.Symbol]


def at_state(
    solution: InstantSolution,
    motion: MotionTrace,
    state: str,
    asked: Sequence[sp.Expr],
    constant: Collection[sp.Symbol],
) -> AtState:
    """A general position worked out, with the symbols of a state in place of those that vary or follow, but for what is
    `constant`. NotWritten: it has a block with too few equations.
    """
    defined, told = _defined(solution), _told(solution)
    blocks = _blocks(solution)
    unknowns = {u for b in blocks for u in b.unknowns}
    moving = _moving({*motion.varying, *told, *unknowns}.difference(constant), defined)
    known = {general: own for own, general in motion.general.items() if own.name.endswith(f"__{state}")}
    new = {s: sp.Symbol(f"{s.name}__{state}", real=True) for s in moving if s not in known}
    here = {**new, **known}
    return AtState(
        tuple(renamed(of_block(b, defined), here) for b in blocks),
        {here.get(s, s): sp.sympify(e).xreplace(here) for s, e in defined.items()},
        tuple(sp.sympify(e).xreplace(here) for e in asked),
        {own: general for general, own in new.items()},
    )


def constant_steps(solution: InstantSolution, motion: MotionTrace, left_open: Collection[sp.Symbol]) -> list[Step]:
    """The steps of a general position that are the same all the time and rest on none of the symbols that are
    `left_open`: forces and accelerations that are constant.
    """
    defined, found = _defined(solution), list[Step]()
    moving = {*motion.varying, *left_open}
    for block in _blocks(solution):
        moving = set(_moving(moving, {s: e for s, e in defined.items() if s not in block.unknowns}))
        step = of_block(block, defined)
        if any((r.free_symbols - set(step.unknowns)) & moving for r in step.residuals) or moving & set(step.unknowns):
            moving |= set(step.unknowns)
        else:
            found.append(step)
    return found


def _blocks(solution: InstantSolution) -> list[SolvedBlock]:
    return [b for stage in solution.stages for b in stage.blocks if b.equations]


def _told(solution: InstantSolution) -> Named:
    """What the lines of the solution say."""
    found: Named = {line.symbol: line.expression for line in solution.lines}
    for stage in solution.stages:
        found |= {line.symbol: line.expression for line in stage.lines}
        found |= dict.fromkeys(stage.zero, sp.S.Zero)
    return found


def _defined(solution: InstantSolution) -> Named:
    ledger = solution.instant.scene.ledger
    named = (*ledger.values.items(), *ledger.definitions.items(), *solution.value.definitions.items())
    return {s: sp.sympify(e) for s, e in named if sp.sympify(e).free_symbols} | _told(solution)


def _moving(varying: set[sp.Symbol], defined: Named) -> list[sp.Symbol]:
    """The symbols that are others at each state: those that vary, and what rests on them."""
    found = set(varying)
    for _ in defined:
        more = {s for s, e in defined.items() if s not in found and sp.sympify(e).free_symbols & found}
        if not more:
            break
        found |= more
    return sorted(found, key=lambda s: s.name)


def renamed(step: Step, here: Mapping[sp.Symbol, sp.Symbol]) -> Step:
    """A step in other symbols."""
    unknowns = tuple(here.get(u, u) for u in step.unknowns)
    residuals = tuple(sp.sympify(r.xreplace(dict(here))) for r in step.residuals)
    others = {here.get(u, u): roots for u, roots in step.others.items()}
    return Step(unknowns, residuals, step.kinds, step.bodies, others, step.ways)


class StateNumbers:
    """Numbers at a state. `known`: of a symbol, None where it has none; `defined`: formulas of names."""

    def __init__(self, known: Callable[[sp.Symbol], float | None], defined: Mapping[sp.Symbol, sp.Expr]) -> None:
        self.known, self.defined = known, defined
        self.found: dict[sp.Symbol, float] = {}

    def of(self, expr: sp.Expr) -> float:
        """Of an expression. NotWritten: something in it has none."""
        put_in = {s: sp.Float(self._value(s)) for s in sorted(expr.free_symbols, key=lambda s: s.name)}
        return float(sp.sympify(expr.xreplace(put_in)))

    def _value(self, symbol: sp.Symbol) -> float:
        if symbol not in self.found:
            number = self.known(symbol)
            if number is None and symbol not in self.defined:
                raise NotWritten(f"{symbol.name} has no number")
            self.found[symbol] = self.of(self.defined[symbol]) if number is None else number
        return self.found[symbol]

    def solve(self, step: Step) -> None:
        """The unknowns of a step whose equations are linear. NotWritten: they are not."""
        nothing = dict.fromkeys(step.unknowns, sp.S.Zero)
        slopes = [[sp.diff(r, u) for u in step.unknowns] for r in step.residuals]
        if any(s.free_symbols & set(step.unknowns) for row in slopes for s in row):
            raise NotWritten("equations at a state are not linear in their unknowns")
        matrix = np.array([[self.of(s) for s in row] for row in slopes])
        right = np.array([-self.of(sp.sympify(r.xreplace(nothing))) for r in step.residuals])
        solved = np.linalg.solve(matrix, right)
        self.found |= {u: float(v) for u, v in zip(step.unknowns, solved, strict=True)}
