"""Work and energy of a part, from which the tension of a rope follows that pulls it: (T - m_A g) h = 1/2 m_A v²."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record
from planar_cli.solve.between.equations.balances import StateBalance
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.principled import every_principle, position_of
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.potential import potential
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.works_of_parts import PartWork, power_on, works_of_parts


@record
class PartEquations:
    """The balances of parts, and the tensions that follow from them."""

    equations: tuple[Equation, ...]
    tensions: Mapping[str, sp.Symbol]
    """By the names of the finds that ask for them."""
    numbers: Mapping[sp.Symbol, Decimal]


NO_PARTS = PartEquations((), {}, {})


def part_equations(course: MotionEquations, value: Valuation) -> PartEquations:
    """Of every force that is asked, where the work on parts tells them all. `value`: numbers of everything."""
    if len(course.states) != 2 or course.is_impulsive(0) or course.symbolic:
        return NO_PARTS
    regime = course.regimes[0]
    parts = works_of_parts(regime)
    equations = [e for part in parts if (e := _equation(course, regime, part, value)) is not None]
    if len(equations) < len(parts):
        return NO_PARTS
    numbers = {part.tension: value(regime.closed(part.tension)) for part in parts}
    scene = regime.general.instant.scene.ledger
    for letter in numbers:
        course.ledger.know(letter, scene.units[letter], scene.roles[letter])
    return PartEquations(tuple(equations), {part.find: part.tension for part in parts}, numbers)


def _equation(course: MotionEquations, regime: Regime, part: PartWork, value: Valuation) -> Equation | None:
    """The balance between the two states; None: what works on the part is no function of place, or the tension does
    no work, as where the body has come back.
    """
    general = regime.general
    position = position_of(general.trial.system, general.value, general.coordinates)
    rope = next(j for j in general.instant.scene.problem.joints if j.name == part.push.joint)
    pull, words = power_on(regime, part.push, part.body), f"tension in {rope.phrase(rope.name)}"
    for principle in every_principle():
        law = principle.of_part(position, part.body, words, part.tension * pull)
        if law is None:
            continue
        since, stop = (course.stops[s.name] for s in course.states)
        brought = []
        for source in law.sources:
            size, rate = (part.tension, pull) if source.words == words else (sp.S.One, source.rate)
            function = potential(regime.closed(rate), regime) if source.function is None else source.function
            if function is None or function.has(sp.Integral):
                return None
            closed = regime.closed(function)
            change = stop.at(closed) - since.at(closed)
            if source.words == words and value.is_zero(change):
                return None
            if (gain := simplified(size * change)) != 0:
                brought.append((source.words, gain))
        amounts = tuple((name, simplified(regime.closed(e))) for name, e in law.amounts)
        total = sp.Add(*(e for _, e in amounts))
        ends = tuple((name, stop.at(e)) for name, e in amounts)
        told = StateBalance(law, since, stop, since.at(total), stop.at(total), tuple(brought), ends)
        kind = principle.kind
        return Equation(
            told.after - told.before - told.gain,
            kind,
            law.words,
            stop.name,
            since.name,
            source=told,
            surcharge=law.cost,
            offered=frozenset((kind,)),
        )
    return None
