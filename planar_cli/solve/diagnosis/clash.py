"""Givens that contradict each other, or the drawing: which, and by how much, in the units of the file."""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.system.conditions import POSITION, gap, order, vector_or_jet
from planar_cli.equation.system.setup import Setup
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.equation.values.jets import Jet
from planar_cli.errors import NOWHERE, Diagnostic, Mark, NoSolution, NoValue, PlanarError
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.polar import TOGETHER
from planar_cli.problem.scene.residuals import Residual
from planar_cli.solve.diagnosis.words import false_words, in_unit, left_of, listed, unit_of
from planar_cli.solve.instant.asked import names_anywhere
from planar_cli.solve.instant.inequalities import holds
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.study import solve_velocities
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.multibody.poses import NearPoses
from planar_cli.units import LENGTH, Unit, default_unit, parse_unit

NEGLIGIBLE = Decimal("1e-6")
DRIVEN = ("a", "alpha", "ddot")
"""Quantities that a drive can prescribe."""
BLAMED = ("velocities", "contradiction")


def sources(trial: Trial) -> list[str]:
    """What takes part in the contradiction: texts of the file's relations, names of joints, equations of bodies."""
    if trial.objection == "velocities":
        found = next(v.conflict for v in trial.velocities if v.conflict is not None)
        return list(dict.fromkeys(t for c, f in found[0] if f for t in c.text.split(TOGETHER)))
    outcome = next(o for o in trial.outcomes if o.solved.conflict is not None)
    assert outcome.solved.conflict is not None
    factors, _ = outcome.solved.conflict
    blamed = (s for s, f in zip(outcome.assembly.sources, factors, strict=True) if f)
    return list(dict.fromkeys(t for s in blamed for t in s.split(TOGETHER)))


def clash(instant: Instant, trial: Trial, mark: Mark) -> Diagnostic:
    """The contradiction of one choice of modes."""
    texts = sources(trial)
    given = [r for r, _ in instant.statements.relations if r.text in texts]
    for relation in reversed(given):
        found = _left_out(instant, trial, relation, [r.text for r in given if r is not relation])
        if found is not None:
            return found
    bodies, joints = parts_of(instant, texts)
    laws = [f"the equations of motion of {listed(bodies)}"] if bodies else []
    held = [f"the joints {listed(joints)}" if len(joints) > 1 else f"the joint {joints[0]}"] if joints else []
    rests = [t for t in texts if t.endswith("at rest")]
    words = [*laws, *held, *(f"`{t}`" for t in (*(r.text for r in given), *rests))]
    at = next((r.mark for r in given if r.mark != NOWHERE), mark)
    hint = "leave one of these out, or make its value an unknown" if given else "a support or a load may be missing"
    if not given and bodies and _light(instant, bodies):
        text = f"the forces on {listed(bodies)} cannot balance, and without mass nothing else can hold them"
        return Diagnostic(
            _body_mark(instant, bodies[0], mark), "PL602", text, f"give {listed(bodies)} a mass, or a support"
        )
    return Diagnostic(at, "PL602", f"these contradict each other: {'; '.join(words or texts)}", hint)


class OffBalance(NoSolution):
    """Loads on bodies without mass that balance in some positions only."""

    def __init__(self, diagnostics: list[Diagnostic], bodies: list[str]) -> None:
        super().__init__(diagnostics)
        self.bodies = bodies


def off_balance(instant: Instant, trial: Trial) -> OffBalance | None:
    """What to say where forces on bodies without mass balance in some positions only; None: nothing of that kind."""
    if trial.objection == "velocities" or not _contradicted(trial):
        return None
    texts = sources(trial)
    bodies, _ = parts_of(instant, texts)
    if not bodies or not _light(instant, bodies) or any(r.text in texts for r, _ in instant.statements.relations):
        return None
    names, balance = listed(bodies), "balances" if len(bodies) == 1 else "balance"
    text = f"the loads on {names} balance in some positions only, and without mass forces tell no motion"
    guided = {getattr(j, "body", None) or getattr(j, "point", None) for j in instant.joints if j.kind == "guide"}
    own = {b: {b, instant.scene.bodies[b].center_name} for b in bodies}
    guide = "" if all(own[b] & guided for b in bodies) else " a `guide` along the line on which it moves,"
    hint = (
        f"give {names} a mass,{guide} or write under `motion` the relation "
        f"between places in which it {balance}; springs in series are one, 1/k = 1/k_1 + 1/k_2"
    )
    return OffBalance([Diagnostic(_body_mark(instant, bodies[0], NOWHERE), "PL602", text, hint)], bodies)


def _contradicted(trial: Trial) -> bool:
    return any(o.solved.conflict is not None for o in trial.outcomes)


def _light(instant: Instant, bodies: list[str]) -> bool:
    """Do all of them have no mass?"""
    return all(instant.scene.bodies[b].mass == 0 for b in bodies)


def _body_mark(instant: Instant, name: str, otherwise: Mark) -> Mark:
    return next((b.mark for b in instant.scene.problem.bodies if b.name == name), otherwise)


def parts_of(instant: Instant, texts: list[str]) -> tuple[list[str], list[str]]:
    """The bodies whose equations take part, and the joints."""
    bodies = [b for b in instant.scene.bodies if any(t.startswith(f"{b}, a") for t in texts)]
    return bodies, list(dict.fromkeys(instant.aliases[t] for t in texts if t in instant.aliases))


def _left_out(instant: Instant, trial: Trial, relation: Relation, others: list[str]) -> Diagnostic | None:
    """What the rest says about the left side of a relation, when it is left out."""
    level = trial.objection == "velocities"
    statements = replace(
        instant.statements, relations=tuple(p for p in instant.statements.relations if p[0] is not relation)
    )
    try:
        twin = Instant(Setup(instant.scene.problem, statements, instant.setup.earlier, False))
        twin.drivers = instant.drivers
        found = _by_velocities(twin, trial, relation) if level else _by_motion(twin, trial, relation)
    except (PlanarError, Unvalued, NoValue):
        return None
    if found is None:
        return None
    left, right = found
    code = "PL607" if level else "PL608"
    against = listed(f"`{t}`" for t in others)
    if not level:
        against = f"{against} and the equations of motion" if others else "the equations of motion"
    reason = against or "the joints"
    verb = "make" if len(others) > 1 or not level or not others else "makes"
    hint = _or_now(instant, relation, "leave one of them out, or declare its value under `unknowns`")
    if not level and not _always(instant, relation) and any(q.word in DRIVEN for q in quantities_in(relation)):
        hint = f"{hint}; where something drives it, write it under `motion`"
    if instant.scene.ledger.symbolic:
        return Diagnostic(
            relation.mark, code, f"`{relation.text}` contradicts what {reason} {verb} of {left_of(relation)}", hint
        )
    unit, us = unit_of(instant, relation.right, relation.left), instant.scene.ledger.us
    off = f"they differ by {in_unit(abs(left - right), unit, us)}"
    return Diagnostic(
        relation.mark,
        code,
        f"`{relation.text}`, but {reason} {verb} {left_of(relation)} = {in_unit(left, unit, us)}; {off}",
        hint,
    )


def _by_velocities(instant: Instant, trial: Trial, relation: Relation) -> tuple[Decimal, Decimal] | None:
    """Both sides by the velocities alone; None when these leave them open."""
    system, value = instant.system(trial.choice), instant.scene.valuations[0]
    quantities = system.quantities_of(system.first, None)
    first = solve_velocities(system, value, False)
    found = []
    for moving in ({}, *({x: Decimal("1.37")} for x in first.free)):
        velocities = solve_velocities(system, value, True, True, moving)
        if velocities.conflict is not None:
            return None
        found.append(_sides(relation, quantities, value.extended(velocities.values)))
    steady = all(abs(a - b) < NEGLIGIBLE for other in found for a, b in zip(found[0], other, strict=True))
    return found[0] if steady else None


def _by_motion(instant: Instant, trial: Trial, relation: Relation) -> tuple[Decimal, Decimal] | None:
    """Both sides by velocities, accelerations and forces; None when these leave them open."""
    again = instant.try_choice(trial.choice, instant.scene.valuations[:1])
    if not again.outcomes or again.outcomes[0].solved.conflict is not None:
        return None
    outcome = again.outcomes[0]
    numbers = outcome.value.extended(unknowns_of(again.system, outcome))
    return _sides(relation, again.system.quantities(), numbers)


def _sides(relation: Relation, quantities: Quantities, numbers: Valuation) -> tuple[Decimal, Decimal]:
    """Both sides in numbers; of vectors the size."""
    found = []
    for side in (relation.left, relation.right):
        value = vector_or_jet(side, quantities, quantities.evaluator)
        if isinstance(value, Vec):
            x, y = numbers(value.x.value), numbers(value.y.value)
            found.append((x * x + y * y).sqrt())
        else:
            found.append(numbers(value.value))
    return found[0], found[1]


# --- positions -------------------------------------------------------------------------------------------------------


def check_positions(instant: Instant) -> None:
    """Raise where a relation about places, or between known numbers, does not hold."""
    names = {s.name for s in instant.scene.ledger.coordinates}
    sought = {s.name for s in instant.scene.ledger.sought}
    stated = [r for r, _ in instant.statements.relations if r not in instant.setup.settled]
    wrong = []
    for relation in (*stated, *instant.statements.inequalities):
        level = order(relation, names)
        if level > POSITION or (names_anywhere(relation.left) | names_anywhere(relation.right)) & sought:
            continue
        equation = relation.operator == "="
        found = _as_drawn(instant, relation) if level == POSITION and equation else _known(instant, relation)
        if found is not None:
            wrong.append(found)
    if wrong:
        raise NoSolution(wrong)


def _known(instant: Instant, relation: Relation) -> Diagnostic | None:
    """What is wrong with a relation between numbers that are known; one between letters is an assumption."""
    system = instant.system(tuple(0 for _ in instant.modes))
    evaluator = system.quantities_of(system.first, None).evaluator
    left, right = (sp.sympify(evaluator.value(s)) for s in (relation.left, relation.right))
    ledger, value = instant.scene.ledger, instant.scene.valuations[0]
    both = left - right
    if instant.scene.rests_on_sought(both) or (ledger.symbolic and not value.is_zero(both) and not both.is_number):
        return None
    if holds(relation.operator, both, value):
        return None
    text = false_words(instant, relation, value(left), value(right))
    return Diagnostic(relation.mark, "PL616", text, "both sides are known: correct one, or declare it under `unknowns`")


def _as_drawn(instant: Instant, relation: Relation) -> Diagnostic | None:
    """What is wrong with one relation about places."""
    system = instant.system(tuple(0 for _ in instant.modes))
    quantities = system.quantities_of(system.first, None)
    value = instant.scene.valuations[0]
    try:
        sides = [vector_or_jet(s, quantities, quantities.evaluator) for s in (relation.left, relation.right)]
        if any(isinstance(s, Vec) for s in sides):
            return _vectors_off(instant, relation, gap(sides[0], sides[1])) if relation.operator == "=" else None
        if any(instant.scene.rests_on_sought(sp.sympify(s.value)) for s in sides):
            return None
    except PlanarError:
        return None
    left, right = (value.known(sp.sympify(s.value)) for s in sides)
    if left is None or right is None:
        return None
    if abs(left - right) <= NEGLIGIBLE * max(abs(left), abs(right), Decimal("1e-3")):
        return None
    hint = _or_now(instant, relation, "draw the points at this instant, or write one of them with a coordinate")
    if instant.scene.ledger.symbolic:
        return Diagnostic(relation.mark, "PL609", f"`{relation.text}` does not hold in the drawn position", hint)
    unit, us = unit_of(instant, relation.right, relation.left), instant.scene.ledger.us
    off = f"it is off by {in_unit(abs(left - right), unit, us)}"
    return Diagnostic(
        relation.mark,
        "PL609",
        f"`{relation.text}`, but as drawn {left_of(relation)} = {in_unit(left, unit, us)}; {off}",
        hint,
    )


def _or_now(instant: Instant, relation: Relation, hint: str) -> str:
    """What to write, where the relation is said to hold at all times."""
    more = f"{hint}; `motion` holds all the time, what holds now stands under `instant:`"
    return more if _always(instant, relation) else hint


def _always(instant: Instant, relation: Relation) -> bool:
    return any(known is relation for known, holds in instant.statements.relations if holds)


def _vectors_off(instant: Instant, relation: Relation, apart: Jet | Vec) -> Diagnostic | None:
    """What is wrong with a relation between places as vectors."""
    assert isinstance(apart, Vec)
    parts = [sp.sympify(p.value) for p in (apart.x, apart.y)]
    value = instant.scene.valuations[0]
    if any(instant.scene.rests_on_sought(p) for p in parts):
        return None
    if all(abs(value(p)) <= NEGLIGIBLE * max(value.size(p), Decimal("1e-3")) for p in parts):
        return None
    hint = "draw the points at this instant, or write one of them with a coordinate"
    return Diagnostic(relation.mark, "PL609", f"`{relation.text}` does not hold in the drawn position", hint)


def demand_drawn(instant: Instant, trial: Trial) -> None:
    """Raise where a joint does not fit the drawn position: a link of another length, a contact that does not touch."""
    poses = NearPoses(instant.scene.valuations[0], {})
    wrong = []
    for joint in instant.joints:
        for residual in joint.residuals(instant.scene, trial.system.modes[joint.name]):
            found = residual.of(poses)
            parts = (found.x, found.y) if isinstance(found, Vec) else (found,)
            off = max((abs(p.value) for p in parts), default=Decimal(0))
            if off > NEGLIGIBLE:
                ledger = instant.scene.ledger
                gap = "" if ledger.symbolic else f" by {in_unit(off, _measure(residual, ledger.us), ledger.us)}"
                name = f"the {joint.kind} {instant.aliases[joint.name]}"
                text = f"{name} does not fit the drawing: {residual.title} is off{gap}"
                hint = "correct the length or a point, or leave the length out"
                wrong.append(Diagnostic(joint.mark, "PL615", text, hint))
    if wrong:
        raise NoSolution(wrong)


def _measure(residual: Residual, us: bool) -> Unit:
    """The unit in which it is told by how much a joint does not fit."""
    return parse_unit("rad") if residual.turns else default_unit(LENGTH, us=us)


__all__ = ["check_positions", "clash", "demand_drawn", "parts_of", "sources"]
