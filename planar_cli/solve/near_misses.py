"""By how much what the states say can not be: how near a motion comes, with any value of the constant sought."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from planar_cli.base_units import in_base
from planar_cli.equation.system.setup import first_unit
from planar_cli.errors import NoSolution, PlanarError
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.answers import usual_unit
from planar_cli.simulate.nearest_miss import nearest
from planar_cli.units import Unit, parse_unit

CONTRADICTS = "PL624"


def how_near(problem: Problem, known: Mapping[str, float], error: NoSolution) -> NoSolution:
    """The same objection, and of a contradiction how near the motion comes. `known`: numbers of other names."""
    if len(error.diagnostics) != 1 or error.diagnostics[0].code != CONTRADICTS:
        return error
    (told,) = error.diagnostics
    try:
        found = nearest(problem, known, told.mark)
    except PlanarError:
        # What keeps the motion from being followed is not what is wrong with the file.
        found = None
    if found is None:
        return error
    unknown, relation = problem.unknowns[0], found.relation
    written = first_unit(relation.left) or first_unit(relation.right)
    unit = parse_unit(written) if written else usual_unit(relation.left, Kinds(Scope(problem, ())), problem.us)
    off = _shown(found.off, unit, problem.us)
    value = _shown(found.value, parse_unit(unknown.unit or "1"), problem.us)
    text = f"{told.message}; the motion comes nearest with {unknown.name} = {value}, where the sides differ by {off}"
    return NoSolution([replace(told, message=text)])


def _shown(value: float, unit: Unit, us: bool) -> str:
    return f"{value / in_base(unit, us):.4g} {unit.text}".removesuffix(" 1")
