"""Blocks of a solution as steps of equations, opened up: with those names put in that hold one of their unknowns."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import sympy as sp

from planar_cli.equation.values.parts_of_accelerations import without_common_marks
from planar_cli.replay.equations import Step
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.written import Written


class NotWritten(LookupError):
    """The answers of a part do not all follow from equations on its page: a motion that is followed in numbers, a
    curve, a formula that holds throughout.
    """


def of_block(block: SolvedBlock, defined: Mapping[sp.Symbol, sp.Expr]) -> Step:
    """A block as a step. NotWritten: it has not as many equations as unknowns."""
    unknowns = tuple(block.unknowns)
    residuals = tuple(opened(without_common_marks(w.residual), unknowns, defined) for w in block.equations)
    if len(residuals) != len(unknowns):
        raise NotWritten("a block has not as many equations as unknowns")
    laws, bodies = tuple(w.law for w in block.equations), tuple(w.bodies for w in block.equations)
    return Step(unknowns, residuals, laws, bodies, ways=tuple(map(_way, block.equations)))


def _way(written: Written) -> str:
    """The direction or the point of an equation of forces or moments; "" of another, or where none is told."""
    if written.law == "moment":
        return f"about {written.lead}" if written.lead else ""
    told = written.words or written.lead
    if written.law != "force" or not told:
        return ""
    return told if told.startswith("along ") else f"along {told}" if told in ("x", "y") else ""


def opened(expr: sp.Expr, unknowns: Iterable[sp.Symbol], defined: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """An expression with those names put in that hold one of the unknowns."""
    wanted = set(unknowns)
    for _ in range(40):
        inside = {s: defined[s] for s in expr.free_symbols if s not in wanted and _holds(s, wanted, defined)}
        if not inside:
            return expr
        expr = sp.sympify(expr.xreplace(inside))
    raise NotWritten("names define each other")


def _holds(symbol: sp.Symbol, wanted: set[sp.Symbol], defined: Mapping[sp.Symbol, sp.Expr]) -> bool:
    seen: set[sp.Symbol] = set()
    waiting = [symbol]
    while waiting:
        expr = defined.get(waiting.pop())
        for inner in (expr.free_symbols if expr is not None else set()) - seen:
            if inner in wanted:
                return True
            seen.add(inner)
            waiting.append(inner)
    return False
