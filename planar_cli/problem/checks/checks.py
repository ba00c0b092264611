"""The checks of a problem that has been read: one visible tuple of functions, scope to diagnostics."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.chains import long_chains
from planar_cli.problem.checks.check_answers import check_answers
from planar_cli.problem.checks.check_dimensions import dimensions_agree
from planar_cli.problem.checks.check_flows import flows_are_dated
from planar_cli.problem.checks.check_formulas import formulas_name_known_things
from planar_cli.problem.checks.check_loads import (
    coordinates_move_something,
    moments_act_on_bodies_with_size,
    particles_have_one_point,
    particles_move_with_their_points,
    pins_hold_particles_where_they_are,
)
from planar_cli.problem.checks.check_names import distinct_names, members_found, points_found, reserved_names
from planar_cli.problem.checks.check_physics import (
    coefficients,
    masses_come_from_somewhere,
    members_act,
    particles_move,
    partners_fit,
    places_on_surfaces,
    plane_is_given,
    points_held_are_carried,
)
from planar_cli.problem.checks.check_sizes import magnitudes_are_not_negative, sizes_are_positive
from planar_cli.problem.checks.check_times import (
    blows_have_spans,
    finds_say_when,
    instant_or_states,
    lengths_taken_up,
    no_circles,
    one_mode_at_a_time,
    sides_differ,
    spans_in_order,
    statements_in_place,
    states_of_what_varies,
)
from planar_cli.problem.checks.check_values import answers_are_numbers, letters_grow_slowly, values_are_numbers
from planar_cli.problem.checks.check_vectors import vectors_are_vectors
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.checks.shared_points import shared_points_are_held
from planar_cli.problem.checks.unused import check_unknowns
from planar_cli.problem.scene.scene import Problem

Check = Callable[[Scope], Iterator[Diagnostic]]

CHECKS: tuple[Check, ...] = (
    reserved_names,
    distinct_names,
    points_found,
    members_found,
    formulas_name_known_things,
    plane_is_given,
    flows_are_dated,
    masses_come_from_somewhere,
    particles_move,
    coefficients,
    sizes_are_positive,
    magnitudes_are_not_negative,
    partners_fit,
    places_on_surfaces,
    members_act,
    particles_have_one_point,
    particles_move_with_their_points,
    pins_hold_particles_where_they_are,
    moments_act_on_bodies_with_size,
    coordinates_move_something,
    points_held_are_carried,
    shared_points_are_held,
    instant_or_states,
    statements_in_place,
    blows_have_spans,
    spans_in_order,
    lengths_taken_up,
    one_mode_at_a_time,
    sides_differ,
    finds_say_when,
    states_of_what_varies,
    no_circles,
    dimensions_agree,
    vectors_are_vectors,
    values_are_numbers,
    letters_grow_slowly,
)


OF_ABSENCE: tuple[Check, ...] = (particles_move,)
"""What these miss may stand in a line that could not be read."""


def check(problem: Problem, unread: bool = False) -> list[Diagnostic]:
    """All that is wrong with a problem and its cases, each once. `unread`: some lines of the file could not be read."""
    if chained := list(
        dict.fromkeys(d for scope in scopes(problem) for d in long_chains(scope.problem.given, scope.problem.points))
    ):
        # Whatever follows the names of a formula would go as deep.
        return chained
    checks = [run for run in CHECKS if not (unread and run in OF_ABSENCE)]
    found = {d: None for scope in scopes(problem) for run in checks for d in run(scope)}
    found.update(dict.fromkeys((*check_answers(problem), *answers_are_numbers(problem))))
    # What uses a name may be just what is wrong.
    return list(found) if found or unread else list(check_unknowns(problem))


def scopes(problem: Problem) -> Iterator[Scope]:
    """The file as it stands, then each case with the cases before it.

    A file that asks nothing itself may be incomplete: then only its cases are looked at.
    """
    if problem.find or not problem.cases:
        yield Scope(problem, ())
    finds = frozenset(find.name for find in problem.find)
    for index, case in enumerate(problem.cases):
        yield Scope(case.problem, problem.cases[:index], case.name, finds)
