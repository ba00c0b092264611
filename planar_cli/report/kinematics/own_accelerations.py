"""What slides on a moving body has its own acceleration by its own sum of forces, a_A = μ g, and not by what it has
relative to that body: a_A = a_A/B + a_B, of which nothing else rests on a_A/B.
"""

from __future__ import annotations

from copy import copy
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import simplified, tidy
from planar_cli.problem.scene.scene import GROUND
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Explicit
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution


def with_own_accelerations(part: PartSolution) -> PartSolution:
    """The part of single instants with such accelerations as unknowns; the same where there are none."""
    if part.motion is not None or not any(s.lines for i in part.instants for s in i.stages):
        return part
    instants: list[InstantSolution] = []
    found = part.found
    for instant in part.instants:
        own = instant
        for x in [x for s in instant.stages if s.level == "acceleration" for x in s.lines]:
            relative = _relative(x, own, found)
            if relative is not None:
                own = _instant(own, x, relative)
                found = tuple(replace(f, asked=tuple(_put(e, x, relative) for e in f.asked)) for f in found)
        instants.append(own)
    if all(a is b for a, b in zip(instants, part.instants, strict=True)):
        return part
    return replace(part, instants=tuple(instants), found=found)


def in_letters_found(expr: sp.Expr, instant: InstantSolution) -> sp.Expr:
    """An expression without what no line of the page finds, as an acceleration relative to a moving body."""
    formulas = {s: f for stage in instant.stages for s, f in stage.algebra.formulas.items()}
    unknowns = {u for stage in instant.stages for b in stage.blocks for u in b.unknowns}
    put = {s: formulas[s] for s in expr.free_symbols - unknowns if s in formulas}
    return simplified(expr.xreplace(put)) if put else expr


def _relative(x: Explicit, instant: InstantSolution, found: tuple[Found, ...]) -> sp.Symbol | None:
    """The acceleration along the way on a moving body of which a line tells the whole one, where one equation alone
    gives either; None: it is another line, or more rests on it.
    """
    if instant.value.known(x.expression) is None:
        return None
    slides = {e.slide_rate for e in instant.trial.system.tree.edges if e.joining is not None and e.parent != GROUND}
    for u in sorted(x.expression.free_symbols & slides, key=lambda s: s.name):
        rest = x.expression - u
        if rest == 0 or u in rest.free_symbols:
            continue
        blocks = [b for s in instant.stages for b in s.blocks]
        held = [w.residual for b in blocks for w in b.equations]
        held += [y.expression for s in instant.stages for y in s.lines if y != x]
        held += [y.formula for b in blocks for y in b.lines if y.symbol != u]
        own = [b for b in blocks if u in b.unknowns]
        alone = len(own) == 1 and len(own[0].unknowns) == len(own[0].equations) == 1
        asked = [e for f in found for e in f.asked if u in _put(e, x, u).free_symbols]
        if alone and not asked and not any(u in e.free_symbols for e in held) and _solved(x, own[0]) is not None:
            return u
    return None


def _put(expr: sp.Expr, x: Explicit, relative: sp.Symbol) -> sp.Expr:
    """The whole acceleration as its letter, where an expression is a multiple of it, as a component is."""
    factor = sp.diff(expr, relative)
    return factor * x.symbol if factor != 0 and sp.expand(expr - factor * x.expression) == 0 else expr


def _solved(x: Explicit, block: SolvedBlock) -> sp.Expr | None:
    """What the equation of a block makes of the whole acceleration."""
    (w,) = block.equations
    try:
        form = linear_form(w.residual, {x.symbol})
    except Nonlinear:
        return None
    factor = form.terms.get(x.symbol, sp.S.Zero)
    return tidy(-form.constant / factor) if factor != 0 else None


def _instant(instant: InstantSolution, x: Explicit, relative: sp.Symbol) -> InstantSolution:
    stages = tuple(_stage(s, x, relative, instant) if x in s.lines else s for s in instant.stages)
    value = instant.value.extended({x.symbol: instant.value(x.expression)})
    return replace(instant, stages=stages, lines=tuple(y for s in stages for y in s.lines), value=value)


def _stage(stage: Stage, x: Explicit, relative: sp.Symbol, instant: InstantSolution) -> Stage:
    """The stage with the whole acceleration as the unknown."""
    algebra = copy(stage.algebra)
    algebra.explicit = {s: e for s, e in algebra.explicit.items() if s != x.symbol}
    algebra.unknowns = algebra.unknowns - {relative} | {x.symbol}
    algebra.formulas = {s: e for s, e in algebra.formulas.items() if s != relative}
    blocks: list[SolvedBlock] = []
    for block in stage.blocks:
        formula = _solved(x, block) if relative in block.unknowns else None
        if formula is not None:
            algebra.formulas[x.symbol] = formula
            line = SolvedLine(x.symbol, formula, instant.value.known(x.expression), (block.equations[0].number,))
            blocks.append(replace(block, unknowns=(x.symbol,), lines=(line,)))
        else:
            blocks.append(block)
    algebra.formulas[relative] = x.symbol - (x.expression - relative)
    return replace(stage, algebra=algebra, blocks=tuple(blocks), lines=tuple(y for y in stage.lines if y != x))
