"""An unknown constant that is found by following the motion, where the equations alone do not tell what happens."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal

from planar_cli.equation.ledger import display
from planar_cli.equation.setup import Earlier, numbers_of
from planar_cli.errors import Diagnostic, NoSolution, PlanarError, Undecided
from planar_cli.problem.not_negative import limits_of_friction
from planar_cli.problem.scene import Problem
from planar_cli.simulate.shooting import has_no_effect, shooting
from planar_cli.solve.followed import can_be_followed, followed_part
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit

OPEN = "PL623"
"""The diagnostic of a constant that seems to be open."""


def root_of(problem: Problem, earlier: Mapping[str, Earlier], error: Undecided | NoSolution) -> dict[str, float]:
    """The number of the unknown [SI] with which the motion passes all states, by its name.

    Raises the `error` where shooting does not apply, NoSolution where no number is found, or several are.
    """
    try:
        idle = has_no_effect(problem, numbers_of(earlier))
        roots = None if idle else shooting(problem, numbers_of(earlier))
    except PlanarError:
        # What keeps the motion from being followed is not what is wrong with the file.
        idle, roots = False, None
    if idle:
        unknown = problem.unknowns[0]
        text = f"{unknown.name} is open: what the states say is the same whatever it is"
        hint = "let it act on what they speak of: a joint that passes it on may be missing"
        raise NoSolution([Diagnostic(unknown.mark, OPEN, text, hint)]) from error
    if roots is None:
        raise error
    unknown = problem.unknowns[0]
    if roots and unknown.name in limits_of_friction(problem) and max(roots) < 0:
        text = f"the data make {unknown.name} negative, {max(roots):.4g}: friction would drive what slides"
        raise NoSolution([Diagnostic(unknown.mark, "PL620", text, "correct the data, or add the force that drives it")])
    if not roots:
        if isinstance(error, NoSolution) and any(d.code != OPEN for d in error.diagnostics):
            raise error
        text = f"no motion passes through these states, whatever {unknown.name} is"
        raise NoSolution([Diagnostic(unknown.mark, "PL620", text, "follow it with `planar simulate --set`")]) from error
    if len(roots) > 1:
        unit = parse_unit(unknown.unit or "1")
        listed = ", ".join(f"{display(Decimal(repr(root)), unit):.6g}" for root in roots)
        measure = "" if unit.text == "1" else f" {unit.text}"
        text = f"{unknown.name} may be {listed}{measure}: with each of them the motion passes all states"
        raise NoSolution([Diagnostic(unknown.mark, "PL635", text, "write an inequality that tells which is meant")])
    return {unknown.name: roots[0]}


def by_motion(
    problem: Problem, case: str, units: Mapping[str, str], earlier: Mapping[str, Earlier], trial: Mapping[str, float]
) -> PartSolution | None:
    """All finds read off the motion with this number of the unknown; None where that does not answer all of them."""
    if not can_be_followed(replace(problem, unknowns=())):
        return None
    return followed_part(problem, case, {**numbers_of(earlier), **trial}, units)
