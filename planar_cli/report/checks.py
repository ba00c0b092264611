"""What was checked, in short phrases: residuals, the independent road, the assumptions of contacts."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import ZERO
from planar_cli.equation.system import System
from planar_cli.problem.facts import Test
from planar_cli.report.blocks import Check, Line, Math, Relation, Value, line
from planar_cli.report.words import Phrases
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.solution import InstantSolution

MOST_PRESSES = 4
TINY = Decimal("1e-30")


def check_blocks(instant: InstantSolution, phrases: Phrases) -> list[Check]:
    """The checks of one instant, each a phrase."""
    found = [Check(line(text)) for text in instant.checks.get("lines", ())]
    return [*found, *(Check(p) for p in _presses(instant, phrases))] if found else []


def _presses(instant: InstantSolution, phrases: Phrases) -> list[Line]:
    """N > 0 of each contact, and |F| against its limit where a contact sticks."""
    if not instant.trial.outcomes:
        return []
    system, outcome = instant.trial.system, instant.trial.outcomes[0]
    if phrases.symbolic or not any(b.mass != 0 for b in system.scene.bodies.values()):
        return []
    values = {**unknowns_of(system, outcome), **instant.value.values}
    found: list[Line] = []
    for mode in system.modes.values():
        rolling = any(j.rolling is not None for j in mode.facts.joinings)
        for push in mode.facts.pushes:
            symbol = system.symbols.get(push.name)
            if symbol is None or symbol not in values or not (mode.tests or rolling):
                continue
            column = outcome.assembly.columns.get(push.name)
            if column is None or not outcome.solved.unique(column):
                continue
            if push.kind == "normal" and values[symbol] > 0:
                found.append(
                    line(Relation(Math(symbol), "=", Value(values[symbol], push.unit, phrases.figures)), " > 0")
                )
    return [*found[:MOST_PRESSES], *_friction(instant, phrases)]


def _friction(instant: InstantSolution, phrases: Phrases) -> list[Line]:
    """|F| against its limit where a contact sticks: the decision of the exercise."""
    outcome, found = instant.trial.outcomes[0], []
    for mode in instant.trial.system.modes.values():
        limits = [t for t in mode.tests if not t.strict and friction_in(instant.trial.system, t) is not None]
        if mode.name == "stick" and limits:
            compared = friction_against_limit(instant.trial, limits[0], phrases)
            if compared and outcome.value is not None:
                found.append(compared)
    return found


def friction_in(system: System, test: Test) -> str | None:
    """The name of the friction that a test is about; None: it is about something else."""
    frictions = {p.name for p in system.pushes if p.kind == "friction"}
    return next((n for n, _ in test.pushes if n in frictions), None)


def friction_against_limit(trial: Trial, test: Test, phrases: Phrases) -> Line:
    """|F| = 29 N ≤ μ_s N = 76 N, with the sign that the numbers have; nothing where they are not unique."""
    outcome = trial.outcomes[0]
    values = {name: outcome.push(name) for name, _ in test.pushes}
    if any(v is None for v in values.values()):
        return ()
    name = friction_in(trial.system, test)
    if name is None:
        return ()
    size = abs(values[name] or ZERO)
    limit = outcome.value(sp.sympify(test.constant))
    formula = sp.sympify(test.constant)
    for other, factor in test.pushes:
        if other != name:
            limit += outcome.value(factor) * (values[other] or ZERO)
            formula += factor * trial.system.symbols[other]
    relation = "≤" if size <= limit * (1 + TINY) else ">"
    shown = abs(limit)
    return line(
        "|",
        Math(trial.system.symbols[name]),
        "| = ",
        Value(size, "N", phrases.figures),
        f" {relation} ",
        phrases.math(formula),
        " = ",
        Value(shown, "N", phrases.figures),
    )
