"""Tensions that the work on a part tells: of a rope that pulls with a constant force on a body on which no other
reaction does work.

    (T - m_A g) h = 1/2 m_A v²

Where nothing else of kinetics is asked, work and energy then answer all: of the whole, in which T does no work, and of
the part.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import letters, simplified
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.facts import Action, Push
from planar_cli.problem.scene.scene import GROUND, Find
from planar_cli.records import record
from planar_cli.solve.regimes.asked_kinetics import asks_kinetics
from planar_cli.solve.regimes.regime import Regime

METHODS = (None, "energy")


@record
class PartWork:
    """A tension that is asked, and the body on which it alone of all reactions does work."""

    find: str
    """The name of the find."""
    push: Push
    tension: sp.Symbol
    """Its letter in the general position."""
    body: str


def works_of_parts(regime: Regime) -> tuple[PartWork, ...]:
    """Of every force that is asked; empty: one of them, an acceleration or a time is not told so."""
    problem = regime.general.instant.scene.problem
    if len(problem.states) != 2 or problem.method not in METHODS:
        return ()
    found: list[PartWork] = []
    for find in problem.find:
        if not asks_kinetics((find,)):
            continue
        part = next(_parts(regime, find, problem.states[1].name), None)
        if part is None:
            return ()
        found.append(part)
    return tuple(found)


def _parts(regime: Regime, find: Find, last: str) -> Iterator[PartWork]:
    """The bodies whose work tells the tension that a find asks for at the end, first that on which least acts."""
    what = find.found.what
    if not (isinstance(what, Quantity) and what.word == "tension" and what.at == last and not what.parts):
        return
    system = regime.general.trial.system
    push = next((p for p in system.pushes if p.joint == what.things[0] and p.kind == "tension"), None)
    if push is None or letters(regime.closed(system.symbols[push.name])) & set(regime.letters):
        return
    acting = Counter(a.body for p in system.pushes for a in p.actions) + Counter(w.body for w in system.wrenches)
    for body in sorted(dict.fromkeys(a.body for a in push.actions if a.body != GROUND), key=lambda b: acting[b]):
        others = (p for p in system.pushes if p.name != push.name)
        if _works(regime, push, body) and not any(_works(regime, p, body) for p in others):
            yield PartWork(find.name, push, system.symbols[push.name], body)


def _works(regime: Regime, push: Push, body: str) -> bool:
    return bool(simplified(regime.closed(expanded(power_on(regime, push, body)))) != 0)


def power_on(regime: Regime, push: Push, body: str) -> sp.Expr:
    """The power of a push of size 1 on one body, in the unknowns of the general position."""
    motion = regime.general.trial.system.motion
    assert motion is not None

    def power(a: Action) -> sp.Expr:
        moving = sp.S.Zero if a.force is None else a.force.dot(motion.velocity(a.point, a.body))
        return moving + a.couple * motion.velocities[a.body].angular

    return sp.Add(*(power(a) for a in push.actions if a.body == body))
