"""What was taken for granted: signs of letters as drawn, rounded corners, joints that take hold in a blow."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer
from planar_cli.problem.implied.knots import balanced_knots
from planar_cli.problem.language.expression import JustAfter, Name, Relation
from planar_cli.problem.scene.scene import Problem, Round
from planar_cli.report.document.blocks import Line, Math, Note, line
from planar_cli.report.given.light_bodies import heavy_bodies, light_bodies
from planar_cli.report.words.words import Phrases
from planar_cli.solve.diagnosis.words import in_unit
from planar_cli.solve.instant.conditions import without_factors
from planar_cli.solve.solved_problem import PartSolution

LONGEST = 30
SEVERAL, SAME = 3, Decimal("1e-20")
"""In so many draws at least two conditions are compared; a ratio that differs by less, as a part of it, is the same."""
SIGNS = {"<": sp.StrictLessThan, ">": sp.StrictGreaterThan, "<=": sp.LessThan, ">=": sp.GreaterThan}


def presumed_notes(part: PartSolution, phrases: Phrases, positive: tuple[sp.Expr, ...] = ()) -> Iterator[Note]:
    """One line for each sign: the file may `assume` it, or the other; `positive`: the side on which the answers hold.
    One for each corner, where a state `just after` would be a blow.
    """
    stated = dict.fromkeys(assumed_in_file(part))
    for relation in stated:
        yield Note("Assume", line(phrases.math(relation)))
    signs = list(positive)
    signs += [e for instant in part.instants for e in instant.instant.scene.presumed()]
    provisos = [p for instant in part.instants for p in instant.conditions]
    provisos += part.motion.provisos if part.motion is not None else ()
    signs += [p.positive for p in provisos if p.positive.free_symbols]
    if part.motion is not None:
        signs += [*part.motion.presumed, *_under_roots(part)]
    for expr in _once_each(part, list(dict.fromkeys(signs))):
        if not longer(expr, LONGEST) and (above := _above_zero(expr)) not in stated and above.reversed not in stated:
            yield Note("Assume", line(phrases.math(above)))
    for words in dict.fromkeys(p.words for p in provisos if p.words and _in_words(p.positive)):
        yield Note("Assume", line(f"{words}; whether it is so depends on the letters"))
    for put in _placed(part, phrases):
        yield Note("Assume", put)
    yield from _masses_together(part)
    if part.motion is None:
        return
    for knot in balanced_knots(part.motion.problem):
        yield Note("Assume", line(f"{knot} has no mass: the pulls of the springs at it balance all the time."))
    for state in part.motion.corners:
        yield Note("Assume", line(f"At {state} the corner is rounded and smooth: the speed is kept."))
    problem = part.motion.problem
    for told in (*_bounded(problem), *_steady(problem), *_taking_hold(problem), *_turning_with(part)):
        yield Note("Assume", line(told))


def _once_each(part: PartSolution, signs: list[sp.Expr]) -> list[sp.Expr]:
    """The shortest of those that are multiples of each other, as cos 30° is √3/2 where the file gives the angle;
    what is positive whatever the letters is no part of them.
    """
    if len(signs) < 2:
        return signs
    scene = part.instants[0].instant.scene
    draws = scene.everywhere()
    kept: list[sp.Expr] = []
    told: list[list[Decimal | None]] = []
    for expr in signs:
        bare = expr if longer(expr, LONGEST) else without_factors(scene, sp.factor(expr))
        numbers = [d.known(bare) for d in draws]
        same = next((i for i, others in enumerate(told) if _are_multiples(numbers, others)), None)
        if same is None:
            kept.append(expr)
            told.append(numbers)
        elif operations(expr) < operations(kept[same]):
            kept[same] = expr
    return kept


def _are_multiples(numbers: list[Decimal | None], others: list[Decimal | None]) -> bool:
    """Have they the same ratio, which is positive, in all of several draws?"""
    ratios = [a / b for a, b in zip(numbers, others, strict=True) if a is not None and b]
    if len(ratios) < SEVERAL or len(ratios) < len(numbers):
        return False
    return all(r > 0 and abs(r / ratios[0] - 1) < SAME for r in ratios)


def _in_words(expr: sp.Expr) -> bool:
    """Is there no formula that is short enough? A number stands for one that is not known."""
    return longer(expr, LONGEST) or not expr.free_symbols


def _under_roots(part: PartSolution) -> Iterator[sp.Expr]:
    """What stands under a root in an answer in letters, and is negative for some of them: there is no such motion."""
    scene = part.instants[0].instant.scene
    letters = scene.ledger.known_letters()
    told: list[sp.Expr] = []
    for answer in (e for f in part.found if f.values is None and f.curve is None for e in f.expressions or ()):
        roots = sorted((p for p in answer.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q == 2), key=sp.default_sort_key)
        told += [p.base for p in roots if p.base.free_symbols <= letters and not longer(p.base, LONGEST)]
    # Letters are drawn once for all of them.
    yield from (e for b in scene.not_always_positive(told) if (e := without_factors(scene, b)).free_symbols)


def assumed_in_file(part: PartSolution) -> Iterator[sp.Expr]:
    """What the file itself assumes of letters and of what is sought: the answers are those for which it holds."""
    scene = part.instants[0].instant.scene
    open_names = {*scene.ledger.letters, *scene.ledger.sought}
    for relation in scene.problem.assume:
        if isinstance(relation, Relation) and relation.operator in SIGNS:
            sides = [scene.value(side) for side in (relation.left, relation.right)]
            if open_names & (sides[0].free_symbols | sides[1].free_symbols):
                yield SIGNS[relation.operator](*sides, evaluate=False)


def _placed(part: PartSolution, phrases: Phrases) -> Iterator[Line]:
    """Where a coordinate was put that the file leaves open, and on which no answer rests."""
    scene = part.instants[0].instant.scene
    problem, ledger = scene.problem, scene.ledger
    begun = problem.states[0].relations if problem.instant is None and problem.states else problem.instant or ()
    for relation in begun:
        name = relation.left.name if isinstance(relation, Relation) and isinstance(relation.left, Name) else ""
        if name in problem.placed and isinstance(relation, Relation):
            symbol = ledger.symbols[name]
            place = in_unit(phrases.value(scene.value(relation.right)), ledger.units[symbol], problem.us)
            place = "0" if place.startswith("0 ") else place
            begins = "=" if problem.instant is not None else "begins at"
            yield line(
                phrases.math(symbol), f" {begins} {place}; the answers are the same in the other places that were tried"
            )


def _masses_together(part: PartSolution) -> Iterator[Note]:
    """Of bodies with a moment of inertia alone, in what their masses are counted."""
    light = list(dict.fromkeys(name for instant in part.instants for name in light_bodies(instant)))
    if not light:
        return
    heavy = heavy_bodies(part.instants)
    mass = part.instants[0].instant.scene.bodies[heavy[0]].mass if len(heavy) == 1 else sp.S.Zero
    if mass.is_Symbol:
        these = "it" if len(light) == 1 else "these"
        whole = (
            f" is the mass of {heavy[0]} together with {' and '.join(light)}; of {these} only the rotation is added."
        )
        yield Note("Assume", line(Math(mass), whole))
        return
    add = "only its rotation is added" if len(light) == 1 else "only their rotation is added"
    own = "its mass is" if len(light) == 1 else "their masses are"
    whose = f"that of {heavy[0]}" if len(heavy) == 1 else "that of another body"
    yield Note("Assume", line(f"Of {' and '.join(light)} {add}: {own} included in {whose}, or negligible."))


def _bounded(problem: Problem) -> Iterator[str]:
    """What is largest or smallest where an inequality only just holds."""
    for extreme, bound in problem.bounded:
        yield f"{extreme} where its bound is reached, {bound}; beyond that the inequality is false."


def _steady(problem: Problem) -> Iterator[str]:
    """A time that is put in for t = infinity."""
    for state in problem.states:
        dates = [r.text for r in state.relations if state.steady and isinstance(r, Relation)]
        yield from (f"At {date} ({state.name}) the start has died away." for date in dates)


def _taking_hold(problem: Problem) -> Iterator[str]:
    """Joints that the file lets act from just after a blow on: what makes parts move alike takes part in the blow."""
    blows = {s.name: r.state for s in problem.states for r in s.relations if isinstance(r, JustAfter)}
    for joint in problem.joints:
        if joint.during is not None and not joint.strikes and (before := blows.get(joint.during[0])) is not None:
            where = f"at {place}" if (place := getattr(joint, "at", "")) else joint.name
            yield f"The {joint.kind} {where} takes hold in the blow, so that it acts from {before} on."


def _turning_with(part: PartSolution) -> Iterator[str]:
    """Forces of a fixed direction at the rim or the hub of a wheel that turns between states, where a cord would pull
    otherwise.
    """
    for instant in part.instants[:1]:
        scene, turning = instant.instant.scene, instant.trial.system.motion
        wheels = {b.name: b.shape for b in scene.problem.bodies if isinstance(b.shape, Round)}
        for load in scene.problem.loads if turning is not None else ():
            at, body = getattr(load, "at", None), getattr(load, "body", "")
            fixed = getattr(load, "angle", None) is not None and getattr(load, "relative_to", None) is None
            if load.kind != "force" or not (at and fixed) or body not in wheels:
                continue
            arm, wheel = scene.point(at) - scene.point(wheels[body].center), wheels[body]
            radii = {"rim": wheel.radius} | ({} if wheel.hub is None else {"hub": wheel.hub})
            for where in (w for w, r in radii.items() if scene.is_zero(arm.dot(arm) - scene.value(r) ** 2)):
                told = f"a cord would go on pulling where it leaves the {where}"
                yield f"The force at {at} moves on with that point of {body}; {told}."


def _above_zero(expr: Any) -> sp.Expr:
    """A sum that is positive as one side greater than the other."""
    terms = sp.Add.make_args(expanded(expr))
    left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
    right = sp.Add(*(-t for t in terms if t.could_extract_minus_sign()))
    return sp.StrictGreaterThan(left, right, evaluate=False)
