"""Which road a problem takes: one instant, formulas that hold throughout, curves, or a motion from state to state.

Only the file is looked at, so that what is not needed is never imported.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.language.expression import AtRest, Equilibrium, Extreme, JustAfter, Name, Quantity, Relation
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.problem.language.walk import walk
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.problem.scene.scene import Find, Problem, State
from planar_cli.solve.instant.asked import FORCES, has_mass
from planar_cli.solve.regimes.mode_dates import told_by_modes

CURVES = ("path", "hodograph")
SPANNED = ("reached", *OF_SWINGS, "stable", "count")
REACTIONS = frozenset(("N", "friction", "reaction", "tension"))
MOTIONS = frozenset(("v", "omega", "dot", "KE", "momentum", "H", "a", "alpha", "ddot"))


def in_general(problem: Problem) -> bool:
    """Are its finds formulas in time, or curves only? Then no drawn position answers them."""
    if problem.instant is not None or problem.states:
        return False
    if all(is_curve(f.found.what) for f in problem.find):
        return True
    return any(isinstance(n, Name) and n.name == "t" for f in formulas(problem) for n in walk(f.tree))


def is_kinematic(problem: Problem) -> bool:
    """Is it all about places that are written with coordinates, without masses, loads and forces?"""
    if problem.instant is not None or problem.states or not problem.coordinates or problem.loads:
        return False
    return not has_mass(problem) and not any(asks_forces(f) for f in problem.find)


def asks_forces(find: Find) -> bool:
    """Does a find need more than places and motion?"""
    return any(q.word in FORCES for q in quantities_in(find.found.what))


def without(problem: Problem, finds: Iterable[Find]) -> Problem:
    """The problem with fewer finds."""
    left = {id(f) for f in finds}
    return replace(problem, find=tuple(f for f in problem.find if id(f) not in left))


def is_curve(what: object) -> bool:
    """Does a find ask for a curve?"""
    return isinstance(what, Quantity) and what.word in CURVES


def runs_in_time(problem: Problem) -> bool:
    """Does the file speak of time, of spans, or of what only a motion tells?"""
    if not problem.states and not any(_says_time(s) for s in problem.instant or ()):
        return False
    if any(isinstance(s, JustAfter) for state in problem.states for s in state.relations):
        return True
    if any(law.during for law in problem.motion) or any(_is_event(state) for state in problem.states[1:]):
        return True
    if told_by_modes(problem) or _flies_along_a_curve(problem):
        return True
    return any(_timed(node) for formula in formulas(problem) for node in walk(formula.tree))


def _flies_along_a_curve(problem: Problem) -> bool:
    """Is the curve asked of what no joint, law or coordinate leads? Its start and the time alone tell it."""
    led = problem.joints or problem.motion or problem.coordinates
    return bool(problem.states[1:]) and not led and any(is_curve(f.found.what) for f in problem.find)


def _is_event(state: State) -> bool:
    """Does a state only say what is extreme, or what a force has become? Then a motion must lead there."""
    if all(isinstance(s, Extreme) for s in state.relations):
        return True
    if any(isinstance(s, AtRest | Equilibrium) for s in state.relations):
        return False
    words = {n.word for s in state.relations for n in walk(s) if isinstance(n, Quantity)}
    equal = [s for s in state.relations if isinstance(s, Relation) and s.operator == "="]
    forces = any(isinstance(n, Quantity) and n.word in REACTIONS for s in equal for n in walk(s))
    return forces and not words & MOTIONS


def _says_time(statement: Any) -> bool:
    return isinstance(statement, Relation) and any(isinstance(n, Name) and n.name == "t" for n in walk(statement))


def _timed(node: Any) -> bool:
    if isinstance(node, Name):
        return node.name == "t"
    return isinstance(node, Quantity) and (isinstance(node.at, tuple) or node.word in SPANNED)
