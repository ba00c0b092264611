"""What is asked as the rate of another quantity, in letters of a general position: the derivative by the chain rule.

θ̈ = dθ̇/dt = 2 v θ̇ sin θ cos θ / h = 2 v² sin³ θ cos θ / h²
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.errors import FileProblem
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Line, Name, line
from planar_cli.report.notation.sizes import on_one_side
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found, InstantSolution

LONGEST = 30
"""A derivative of more operations is not told."""
STEPS = 40
"""So often formulas are put into each other at most."""
LOWER = {"omega": "theta", "alpha": "omega", "a": "v"}
DOT, DDOT = "_dot", "_ddot"


def rate_in_turn(
    answer: Found, what: Quantity, others: Iterable[Found], instant: InstantSolution, phrases: Phrases
) -> list[Block]:
    """name = d/dt of what it is the rate of = its formula. Empty: it is no rate, or it depends on no coordinate.
    `others`: all that is asked.
    """
    closed = (answer.expressions or (None,))[0]
    lower = _lower(what)
    if not phrases.symbolic or lower is None or closed is None or len(answer.asked) != 1:
        return []
    own = next((f for f in others if f.find is not None and _is(f.find.found.what, lower)), None)
    formula = _formula(lower, own, instant)
    if formula is None:
        return []
    rates = _rates(instant, formula)
    if not rates or formula.free_symbols & set(rates.values()):
        return []
    found = _shortest(sp.Add(*(sp.diff(formula, q) * rate for q, rate in rates.items())))
    plain = _on_that_side(closed, instant)
    whole = found.xreplace({rate: _closed(rate, instant) for rate in rates.values()})
    own_letter = found.is_Symbol and what.word != "omega"
    if longer(found, LONGEST) or own_letter or found == plain:
        return []
    if not instant.value.vanishes(_on_that_side(simplified(whole - plain), instant)):
        return []
    head = phrases.math(answer.asked[0]) if answer.asked[0].is_Symbol else line(Name(answer.name))
    before = list(_placed(answer, lower, formula, phrases))
    of = line(Name(own.name)) if own is not None else _name_of_lower(answer, what, instant)
    between = [line("d", of, "/dt")] if of is not None and not before else []
    return [*before, Equation((head, *between, phrases.math(found), phrases.math(plain)))]


def _lower(what: Quantity) -> Side | None:
    """The quantity whose rate is asked."""
    if what.word == "dot":
        return None if isinstance(what.argument, Relation) else what.argument
    if what.word == "ddot":
        return replace(what, word="dot")
    plain = all(p.kind in ("x", "y") for p in what.parts)
    return replace(what, word=LOWER[what.word]) if what.word in LOWER and plain else None


def _shortest(expr: sp.Expr) -> sp.Expr:
    """A derivative as it comes or in its plainest form, whichever is shorter; no angle is doubled."""
    plainer = factored(simplified(expr))
    doubled = any(f.args[0].is_Mul for f in plainer.atoms(sp.sin, sp.cos))
    return expr if doubled or sp.count_ops(expr) <= sp.count_ops(plainer) else plainer


def _is(asked: object, quantity: Side) -> bool:
    """Is it the same quantity?"""
    if not isinstance(asked, Quantity) or not isinstance(quantity, Quantity) or not asked.things:
        return False
    one, other = ((q.word, q.things, [p.kind for p in q.parts]) for q in (asked, quantity))
    return one == other


def _formula(lower: Side, answer: Found | None, instant: InstantSolution) -> sp.Expr | None:
    """What it is in letters of the file and coordinates. `answer`: to the find that it is."""
    if answer is not None and answer.expressions:
        return _on_that_side(answer.expressions[0], instant)
    quantities = instant.trial.system.quantities()
    try:
        jet = quantities.any(lower) if isinstance(lower, Quantity) else quantities.evaluator.jet(lower)
    except FileProblem:
        return None
    if isinstance(jet, Vec):
        return None
    return _on_that_side(_closed(jet.value, instant), instant)


def _rates(instant: InstantSolution, formula: sp.Expr) -> Mapping[sp.Symbol, sp.Symbol]:
    """The coordinates in a formula, with the letters of their rates."""
    motions = instant.trial.system.quantities().evaluator.motions
    inside = sorted(formula.free_symbols & set(instant.instant.scene.ledger.coordinates), key=str)
    found = {q: motions[q][0] for q in inside if q in motions}
    return {q: rate for q, rate in found.items() if isinstance(rate, sp.Symbol)} if len(found) == len(inside) else {}


def _closed(expr: sp.Expr, instant: InstantSolution) -> sp.Expr:
    """An expression with the formulas of all unknowns put in."""
    formulas: dict[sp.Symbol, sp.Expr] = {}
    for stage in instant.stages:
        formulas |= {**stage.algebra.explicit, **stage.algebra.formulas}
    for _ in range(STEPS):
        inside = {s: formulas[s] for s in expr.free_symbols if s in formulas}
        if not inside:
            break
        expr = expr.xreplace(inside)
    return simplified(expr)


def _on_that_side(expr: sp.Expr, instant: InstantSolution) -> sp.Expr:
    """A formula without the bars, as the answers have none."""
    scene = instant.instant.scene
    return on_one_side(expr, scene.ledger.coordinates, scene.valuations[0])


def _placed(answer: Found, lower: Side, formula: sp.Expr, phrases: Phrases) -> Iterator[Block]:
    """Of a place that is differentiated: its formula, under the name of the answer without its dot."""
    if isinstance(lower, Quantity) and lower.word in ("r", "x", "y") and answer.name.endswith(DOT):
        yield Equation((line(Name(answer.name.removesuffix(DOT))), phrases.math(formula)))


def _name_of_lower(answer: Found, what: Quantity, instant: InstantSolution) -> Line | None:
    """How the page calls the quantity whose rate is asked; None: it has no name."""
    if what.word == "ddot" and answer.name.endswith(DDOT):
        return line(Name(answer.name.removesuffix(DDOT) + DOT))
    if what.word == "alpha" and len(what.things) == 1:
        spin = instant.trial.system.motion.velocities[what.things[0]].angular if instant.trial.system.motion else 0
        return line(Name(spin.name)) if isinstance(spin, sp.Symbol) else None
    return None
