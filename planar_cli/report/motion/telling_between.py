"""What tells the balances and blows of a motion, with what they need to know of all of it."""

from __future__ import annotations

from collections import Counter

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.report.energy.earlier_balances import EarlierBalances
from planar_cli.report.given.spring_lengths import spring_lengths
from planar_cli.report.momentum.heads_of_blows import told_alone
from planar_cli.report.momentum.idle_zeros import idle_zeros
from planar_cli.report.momentum.negligible import FiniteForces
from planar_cli.report.momentum.nil_impulses import said_nil
from planar_cli.report.motion.between import BetweenTelling
from planar_cli.report.words.origins import inertias_of_blows, letters_of_blows
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace, ImpactEquation, MotionTrace

FEW = 12
"""An angle by a longer formula is not put into a height."""


def telling_between(found: MotionTrace, phrases: Phrases, numeric: Phrases) -> BetweenTelling:
    """`numeric`: for what rests on no letter without a number."""
    return BetweenTelling(
        phrases,
        {},
        numeric,
        used=letters_of_blows(found) - idle_zeros(found),
        axes=inertias_of_blows(found),
        nil={(symbol, since) for symbol, since, _ in said_nil(found)},
        drawn=_drawn(found),
        by_rule=_by_rule(found),
        balanced=_balanced(found),
        springs=spring_lengths(found),
        alone=told_alone(found),
        finite=FiniteForces(found.problem, found.states),
        earlier=EarlierBalances(starts=_starts(found)),
    )


def _starts(found: MotionTrace) -> set[str]:
    """The states from which several balances of energy go."""
    sources = (e.source for leg in found.route.steps for e in leg.relations)
    balances = {id(b): b.since for b in sources if isinstance(b, BalanceTrace) and b.law.letter}
    return {since for since, times in Counter(balances.values()).items() if times > 1}


def _by_rule(found: MotionTrace) -> list[str]:
    """The states before blows of which the route uses the law of restitution alone, and no impulse is asked."""
    blows = [e.source for leg in found.route.steps for e in leg.relations if isinstance(e.source, ImpactEquation)]
    balanced = {b.impact.since for b in blows if b.law != "relation" or b.impact.impacts > 1}
    balanced |= {p.since for span in found.spans for p in span.pieces if p.how == "blow"}
    return [since for since in dict.fromkeys(b.impact.since for b in blows) if since not in balanced]


def _balanced(found: MotionTrace) -> dict[str, list[tuple[str, ...]]]:
    """By the state before a blow, the groups of bodies whose momentum the route balances."""
    balanced: dict[str, list[tuple[str, ...]]] = {}
    for leg in found.route.steps:
        for e in leg.relations:
            if isinstance(e.source, ImpactEquation) and e.source.law != "relation":
                balanced.setdefault(e.source.impact.since, []).append(e.source.bodies)
    return balanced


def _drawn(found: MotionTrace) -> dict[sp.Symbol, sp.Expr]:
    """Where a state is the given position, its letters, with what they are in letters of the file; of any state angles
    of whole quarters of a turn, or of which the file gives the tangent, sine or cosine.
    """
    steps = (step for step in found.route.steps if step.is_datum and step.relations[0].kind == "drawn")
    results = (r for step in steps for r in step.results)
    drawn = {r.unknown: r.formula for r in results if r.formula is not None and not r.formula.has(*found.general)}
    for symbol, formula in found.route.formulas.items():
        known = drawn.get(formula, formula)
        turned = known.is_number and known != 0 and (2 * known / sp.pi).is_Integer
        if turned or (
            known.has(sp.atan, sp.asin, sp.acos) and not known.has(*found.general) and not longer(known, FEW)
        ):
            drawn.setdefault(symbol, known)
    return drawn
