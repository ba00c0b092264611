"""An unknown constant that is found by following the motion, where the equations alone do not tell what happens."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

from planar_cli.equation.system.setup import Earlier, numbers_of
from planar_cli.equation.values.ledger import display
from planar_cli.errors import Diagnostic, NoSolution, PlanarError, Undecided
from planar_cli.problem.implied.not_negative import limits_of_friction
from planar_cli.problem.language.expression import Extreme, Name, Relation
from planar_cli.problem.language.walk import is_endless
from planar_cli.problem.scene.known_values import KnownValues
from planar_cli.problem.scene.scene import Problem, Symbol
from planar_cli.simulate.shooting import has_no_effect, shooting
from planar_cli.simulate.shooting_at_several import shooting_at_several
from planar_cli.simulate.shooting_of_extremes import Best
from planar_cli.simulate.timetable import is_time
from planar_cli.solve.bounds import Sought, at_bound, best_allowed
from planar_cli.solve.diagnosis.choosing import IN_GENERAL, hint_between
from planar_cli.solve.followed import can_be_followed, followed_part
from planar_cli.solve.near_misses import how_near
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.solve.within_a_turn import within_a_turn
from planar_cli.units import parse_unit

OPEN = "PL623"
"""The diagnostic of a constant that seems to be open."""


SEVERAL = "PL635"
"""That of several that fit: the file must choose, and trial finds only one of them."""
AT_LIMIT = 1e-5
"""By less than this part of their size an edge of reach, which is enclosed, differs from a limit that the file sets."""
TURNED = "PL638"
"""That of what is stationary, and not as the file says: trial would only find where the motion ends."""


def root_of(problem: Problem, earlier: Mapping[str, Earlier], error: Undecided | NoSolution) -> Sought:
    """The numbers of the unknowns [SI] with which the motion passes all states.

    Raises the `error` where shooting does not apply, NoSolution where no number is found, or several are.
    """
    if _says(error, SEVERAL) or _says(error, TURNED):
        raise error
    if len(problem.unknowns) > 1:
        return Sought(problem, _roots_of_several(problem, earlier, error))
    try:
        idle = has_no_effect(problem, numbers_of(earlier))
        best = None if idle else best_allowed(problem, numbers_of(earlier))
        roots = None if idle or best is not None else shooting(problem, numbers_of(earlier))
    except PlanarError:
        # What keeps the motion from being followed is not what is wrong with the file.
        idle, roots, best = False, None, None
    if best is not None:
        return _chosen(problem, best, numbers_of(earlier))
    if idle:
        unknown = problem.unknowns[0]
        text = f"{unknown.name} is open: what the states say is the same whatever it is"
        hint = "let it act on what they speak of: a joint that passes it on may be missing"
        raise NoSolution([Diagnostic(unknown.mark, OPEN, text, hint)]) from error
    if roots is None:
        is_open = isinstance(error, NoSolution) and all(d.code == OPEN for d in error.diagnostics)
        raise (_of_extreme(problem) if is_open else None) or error
    unknown = problem.unknowns[0]
    if roots and unknown.name in limits_of_friction(problem) and max(roots) < 0:
        text = f"the data make {unknown.name} negative, {max(roots):.4g}: friction would drive what slides"
        raise NoSolution([Diagnostic(unknown.mark, "PL620", text, "correct the data, or add the force that drives it")])
    if not roots:
        if isinstance(error, NoSolution) and any(d.code != OPEN for d in error.diagnostics):
            raise how_near(problem, numbers_of(earlier), error)
        text = f"no motion is found that passes through these states, with none of many values of {unknown.name}"
        hint = f"follow it with a value that you expect: `planar simulate --set {unknown.name}=…`"
        raise NoSolution([Diagnostic(unknown.mark, "PL620", text, _off_without_end(problem) or hint)]) from error
    fits = within_a_turn(problem, unknown.name, roots, roots)
    if len(fits) > 1:
        raise _ambiguous(problem, [{unknown.name: root} for root in fits])
    return Sought(problem, {unknown.name: fits[0]})


def _off_without_end(problem: Problem) -> str:
    """How to write a state that is only approached by its place: no motion comes to it; "": there is none that the time
    tells.
    """
    endless = (r for s in problem.states[1:] if is_endless(s.relations) for r in s.relations)
    dated = next((r for r in endless if isinstance(r, Relation) and is_time(r)), None)
    if dated is None or not problem.bodies:
        return ""
    return (
        f"what goes off without end is told by its place: `x({problem.bodies[0].name}) = infinity` for `{dated.text}`"
    )


def _says(error: Undecided | NoSolution, code: str) -> bool:
    """Is that what the equations told?"""
    return isinstance(error, NoSolution) and any(d.code == code for d in error.diagnostics)


def _chosen(problem: Problem, best: Best, known: Mapping[str, float]) -> Sought:
    """The number with which something is largest or smallest, unless that is where a state is only just reached."""
    unknown = problem.unknowns[0]
    if best.state:
        bounded = at_bound(problem, best, known)
        if bounded is not None:
            return bounded
        number = _number(unknown, best.value, problem.us, 3)
        state = next(s for s in problem.states if s.name == best.state)
        asked = next(r for r in state.relations if isinstance(r, Extreme))
        if (limit := _limit_at(problem, unknown, best.value)) is not None:
            text = f"`{asked.text}` at {number}, the end of what `{limit.text}` allows: beyond it would be more"
            text = text if asked.sense > 0 else text.removesuffix("more") + "less"
            end = limit.text.replace(limit.operator, "=", 1)
            hint = f"write `{end}` in its place, or allow more"
            raise NoSolution([Diagnostic(asked.mark, OPEN, text, hint)])
        text = f"`{asked.text}` at about {number}, the last value with which state {best.state} is reached"
        raise NoSolution([Diagnostic(unknown.mark, OPEN, text, _what_ceases(problem))])
    return Sought(problem, {unknown.name: best.value})


def _limit_at(problem: Problem, unknown: Symbol, value: float) -> Relation | None:
    """The inequality of the file that ends the range of a constant at this value [SI]; None: there is none."""
    numbers = KnownValues({s.name: s for s in problem.given})
    for relation in (*problem.assume, *(r for s in problem.states for r in s.relations)):
        if not isinstance(relation, Relation) or relation.operator == "=":
            continue
        sides = (relation.left, relation.right)
        bound = next((b for a, b in (sides, sides[::-1]) if isinstance(a, Name) and a.name == unknown.name), None)
        limit = None if bound is None else numbers.number(bound)
        if limit is not None and abs(limit - value) <= AT_LIMIT * max(abs(limit), abs(value)):
            return relation
    return None


def _roots_of_several(
    problem: Problem, earlier: Mapping[str, Earlier], error: Undecided | NoSolution
) -> dict[str, float]:
    """The same for more than one unknown. That none was found does not say that there is none."""
    try:
        found = shooting_at_several(problem, numbers_of(earlier))
    except PlanarError:
        # What keeps the motion from being followed is not what is wrong with the file.
        found = None
    if not found:
        raise error
    if len(found) > 1:
        raise _ambiguous(problem, found)
    return found[0]


def _ambiguous(problem: Problem, found: Sequence[Mapping[str, float]]) -> NoSolution:
    """Several numbers with which the motion passes all states."""
    told = "; or ".join(", ".join(_number(u, values[u.name], problem.us) for u in problem.unknowns) for values in found)
    text = f"{told}: with each of them the motion passes all states"
    numbers = {u: [_shown(u, values[u.name], problem.us) for values in found] for u in problem.unknowns}
    apart = next((u for u, shown in numbers.items() if len(set(shown)) > 1), None)
    hint = IN_GENERAL if apart is None else hint_between(apart.name, parse_unit(apart.unit or "1"), numbers[apart])
    return NoSolution([Diagnostic(problem.unknowns[0].mark, "PL635", text, hint)])


def _number(unknown: Symbol, value: float, us: bool, figures: int = 6) -> str:
    """A constant with its value in its own unit."""
    unit = parse_unit(unknown.unit or "1")
    measure = "" if unit.text == "1" else f" {unit.text}"
    return f"{unknown.name} = {_shown(unknown, value, us, figures):.6g}{measure}"


def _shown(unknown: Symbol, value: float, us: bool, figures: int = 6) -> float:
    """The number of a constant in its own unit."""
    return float(f"{display(Decimal(repr(value)), parse_unit(unknown.unit or '1'), us):.{figures}g}")


def _of_extreme(problem: Problem) -> NoSolution | None:
    """What is largest over the only unknown at a state that something else dates is not looked for in numbers."""
    extremes = [r for s in problem.states[1:] if len(s.relations) > 1 for r in s.relations if isinstance(r, Extreme)]
    if not extremes or len(problem.unknowns) != 1:
        return None
    name = problem.unknowns[0].name
    text = f"no formula tells for which {name} `{extremes[0].text}`"
    hint = _what_ceases(problem)
    if not problem.symbols:
        hint += f"; else compare motions with values of it: `planar simulate --set {name}=…`"
    return NoSolution([Diagnostic(extremes[0].mark, OPEN, text, hint)])


def _what_ceases(problem: Problem) -> str:
    """What to write in the place of an extreme that is the last value with which a state is reached."""
    contact = next((j.name for j in problem.joints if j.touches), "")
    rope = next((j.name for j in problem.joints if j.kind == "rope"), "")
    asked = [state.relations for state in problem.states if any(isinstance(r, Extreme) for r in state.relations)]
    stated = [r for relations in asked for r in relations if isinstance(r, Relation) and r.operator in ("<=", ">=")]
    kept = "".join(f"`{r.text.replace(r.operator, '=', 1)}` where that bounds it, " for r in stated)
    kept += f"`N({contact}) = 0` of a contact that is only just kept, " if contact else ""
    kept += f"`tension({rope}) = 0` of a rope that only just stays taut, " if rope else ""
    body = problem.bodies[0].name if problem.bodies else "P"
    kept += _about_to_slip(problem)
    moves = f"`v({body}).y = 0` of what only just comes so high"
    return f"write in its place what ceases to hold there: {kept}{moves}"


def _about_to_slip(problem: Problem) -> str:
    """The limit of friction at the first contact of which the coefficient is sought; "": of none."""
    bodies, sought = {body.name for body in problem.bodies}, {u.name for u in problem.unknowns}
    for joint in problem.joints:
        limit = getattr(joint, "mu_s", None) or getattr(joint, "mu", None)
        own = next((b for b in getattr(joint, "between", ()) if b in bodies), None)
        if joint.touches and isinstance(limit, Name) and limit.name in sought and own is not None:
            return f"`friction({joint.name}/{own}).mag = {limit.name}*N({joint.name})` of what is about to slip, "
    return ""


def by_motion(
    problem: Problem, case: str, units: Mapping[str, str], earlier: Mapping[str, Earlier], trial: Mapping[str, float]
) -> PartSolution | None:
    """All finds read off the motion with this number of the unknown; None where that does not answer all of them."""
    if not can_be_followed(replace(problem, unknowns=())):
        return None
    return followed_part(problem, case, {**numbers_of(earlier), **trial}, units)
