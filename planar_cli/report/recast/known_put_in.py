"""What is the same but for its sign is one letter in the equations of forces, and with it moments of inertia are what
they are: of two equal rods that fold alike, α_BC = -α_AB and I_AB = I_BC = 1/12 m l² leave 1/6 m l² α_AB.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import in_factors, longer, simplified
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import INERTIA

LONGEST = 60
"""A longer equation or formula is left as it is."""
OF_FORCES = ("force", "moment")
Known = Mapping[sp.Symbol, sp.Expr]
Put = Callable[[sp.Expr, Known], sp.Expr]


def with_known_put_in(part: PartSolution) -> PartSolution:
    """The part with such equations; the same where there are none."""
    made = {id(instant): _instant(instant) for instant in part.instants}
    if all(made[id(instant)] is instant for instant in part.instants):
        return part
    motion = part.motion
    if motion is not None:
        regimes = tuple(replace(r, solution=made.get(id(r.solution), r.solution)) for r in motion.regimes)
        motion = replace(motion, regimes=regimes)
    return replace(part, instants=tuple(made[id(instant)] for instant in part.instants), motion=motion)


def _instant(instant: InstantSolution) -> InstantSolution:
    if not instant.stages or not instant.stages[-1].algebra.symbolic:
        return instant
    *first, last = instant.stages
    given = _given(last, instant)
    last = _stage(last, given, in_letters=True) if given else last
    known = _known(last, instant)
    if given and not known:
        return replace(instant, stages=(*first, last))
    return replace(instant, stages=(*first, _without_idle(_stage(last, known), known))) if known else instant


def _given(stage: Stage, instant: InstantSolution) -> Known:
    """a_D = a_0: accelerations that the file gives as a letter of its own."""
    letters = set(instant.instant.scene.ledger.letters)
    equations = (b.equations[0] for b in stage.blocks if len(b.equations) == 1 and b.equations[0].given)
    return {w.left: w.right for w in equations if w.left.is_Symbol and w.right in letters}


def _known(stage: Stage, instant: InstantSolution) -> Known:
    """α_BC = -α_AB, and the moments of inertia of the bodies in letters; empty: nothing is another one so."""
    ledger = instant.instant.scene.ledger
    lines = [x for b in stage.blocks for x in b.lines]
    alike = {x.symbol: x.formula for x in lines if x.formula.is_Symbol or (-x.formula).is_Symbol}
    rates = {s: f for s, f in alike.items() if s in ledger.units and ledger.units[s].angle}
    if not rates:
        return {}
    own = [(s, f) for s, f in ledger.definitions.items() if s in ledger.units and f.is_Mul]
    return {**_speeds(instant), **rates, **{s: f for s, f in own if ledger.units[s].dimension == INERTIA}}


def rates_alike(instant: InstantSolution) -> Known:
    """α_BC = -α_AB and ω_BC = -ω_AB alone, for what is drawn."""
    if not instant.stages or not instant.stages[-1].algebra.symbolic:
        return {}
    units = instant.instant.scene.ledger.units
    known = _known(instant.stages[-1], instant)
    return {s: f for s, f in known.items() if units[s].dimension != INERTIA}


def _speeds(instant: InstantSolution) -> Known:
    """ω_BC = -ω_AB, where both are one rate but for the sign."""
    first: dict[sp.Expr, tuple[sp.Symbol, int]] = {}
    found: dict[sp.Symbol, sp.Expr] = {}
    for x in (x for stage in instant.stages[:-1] for b in stage.blocks for x in b.lines):
        sign = -1 if (-x.formula).is_Symbol else 1
        if not (sign * x.formula).is_Symbol:
            continue
        one = first.setdefault(sign * x.formula, (x.symbol, sign))
        if one[0] != x.symbol:
            found[x.symbol] = sign * one[1] * one[0]
    return found


def _stage(stage: Stage, known: Known, in_letters: bool = False) -> Stage:
    """`in_letters`: each is put in as it is, and not only where that makes it shorter."""
    if not in_letters:
        return replace(stage, blocks=tuple(_block(b, known, _put) for b in stage.blocks))
    drawn = {b: [(v, _exactly(e, known)) for v, e in parts] for b, parts in stage.accelerations.items()}
    return replace(stage, blocks=tuple(_block(b, known, _exactly) for b in stage.blocks), accelerations=drawn)


def _without_idle(stage: Stage, known: Known) -> Stage:
    """A letter that no equation of forces has any more is told by its relation, α_BC = -α_AB, and not solved for."""
    held = {s for b in stage.blocks for w in b.equations if w.law in OF_FORCES for s in w.residual.free_symbols}
    held |= {s for x in stage.lines for s in x.expression.free_symbols}
    blocks = [own for b in stage.blocks for own in _parted(b, known.keys() - held)]
    return replace(stage, blocks=tuple(blocks))


def _parted(block: SolvedBlock, idle: Collection[sp.Symbol]) -> Iterator[SolvedBlock]:
    """The relations that tell such letters alone, then what is left to solve."""
    for x in (x for x in block.lines if x.symbol in idle and len(block.equations) > 1 and len(x.equations) == 1):
        own = next((w for w in block.equations if w.number == x.equations[0] and w.law == "relation"), None)
        others = [y for y in block.lines if y.symbol != x.symbol]
        if own is not None and not any(x.symbol in y.formula.free_symbols for y in others):
            told = replace(own, left=x.symbol, right=x.formula)
            yield SolvedBlock((told,), (x.symbol,), (), (replace(x, letters=()),))
            rest = tuple(w for w in block.equations if w is not own)
            unknowns = tuple(u for u in block.unknowns if u != x.symbol)
            block = SolvedBlock(rest, unknowns, block.letters, tuple(others))
    yield block


def _block(block: SolvedBlock, known: Known, put: Put) -> SolvedBlock:
    lines = tuple(x if x.symbol in known else replace(x, formula=put(x.formula, known)) for x in block.lines)
    return replace(block, equations=tuple(_equation(w, known, put) for w in block.equations), lines=lines)


def _equation(w: Written, known: Known, put: Put) -> Written:
    return replace(w, left=put(w.left, known), right=put(w.right, known)) if w.law in OF_FORCES else w


def _put(expr: sp.Expr, known: Known) -> sp.Expr:
    if not expr.free_symbols & known.keys() or longer(expr, LONGEST):
        return expr
    found = simplified(expr.xreplace(dict(known)))
    return found if operations(found) < operations(expr) else expr


def _exactly(expr: sp.Expr, known: Known) -> sp.Expr:
    return in_factors(expr.xreplace(dict(known))) if expr.free_symbols & known.keys() else expr
