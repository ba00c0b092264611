"""Free-body diagram = kinetic diagram, in words: the force list of each body that the equations use."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.guided import does_nothing
from planar_cli.equation.values.ledger import display
from planar_cli.equation.values.one_way import one_way
from planar_cli.loads.base import Load
from planar_cli.problem.scene.acting import kind_of
from planar_cli.problem.scene.facts import Push, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Forces, Line, Math, Name, Text, Value, line
from planar_cli.report.equations.numeric import vanishing
from planar_cli.report.friction.impending import impending
from planar_cli.report.friction.offsets import offsets
from planar_cli.report.in_numbers.in_numbers import amount_in_numbers
from planar_cli.report.kinematics.about_fixed_point import about_fixed_point, acceleration_of_centre
from planar_cli.report.kinematics.drawn_lengths import SHORT, distance_drawn, drawn_length
from planar_cli.report.kinematics.grooves import normal_to
from planar_cli.report.kinematics.own_paths import across_the_path, straight_path
from planar_cli.report.kinematics.rolled_parts import along_and_across
from planar_cli.report.kinematics.rolled_points import in_plain_lengths
from planar_cli.report.kinetics.entries import ASSUMED, BETWEEN, listed
from planar_cli.report.kinetics.found_senses import acts_backward, is_drawn_as_found
from planar_cli.report.kinetics.open_lines import NOT_NEEDED, no_couples, open_line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.counted import as_given, clockwise_letter, positive
from planar_cli.report.words.pointing import pointing
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import (
    ANGULAR_MOMENTUM,
    ENERGY,
    FORCE,
    MOMENTUM,
    PURE,
    TIME,
    Dimension,
    default_unit,
    pretty_unit,
)

MOMENTA = "momentum"
SUDDEN = (MOMENTA, "impulse")
"""Kinds of wrenches that are momenta or impulses."""
LONGEST = 30
"""Of an acceleration with more operations only the name is told: the equations say what it is."""


def force_rows(
    instant: InstantSolution,
    stage: Stage,
    phrases: Phrases,
    inertia_as_force: bool,
    impulsive: bool = False,
    nil: Collection[sp.Symbol] = (),
    bodies: Collection[str] = (),
) -> list[Forces]:
    """One row for each body that takes part in the kinetic equations; with D'Alembert's inertial forces among the
    forces. `impulsive`: impulses and momenta; `nil`: those of which the page says that they are zero;
    `bodies`: of these alone.
    """
    kinds = (MOMENTUM, ANGULAR_MOMENTUM) if impulsive else (FORCE, ENERGY)
    nil = {*nil, *no_couples(instant.trial)} if impulsive else nil
    rows = []
    for body in bodies or drawn_bodies(instant, stage):
        acting = _acting(instant, stage, body, phrases, nil)
        inertia = _inertia(instant, stage, body, phrases, inertia_as_force, kinds)
        if inertia_as_force:
            acting, inertia = (*acting, BETWEEN, *inertia) if inertia else acting, ()
        rows.append(Forces(body, acting or (Text("0"),), inertia or (Text("0"),), scene=instant.instant.scene))
    return rows


def drawn_bodies(instant: InstantSolution, stage: Stage) -> list[str]:
    """The bodies that take part in the kinetic equations, in the order of the file."""
    bodies = {b for block in stage.blocks for w in block.equations for b in w.bodies}
    return [b for b in instant.instant.scene.bodies if b in bodies]


def _acting(instant: InstantSolution, stage: Stage, body: str, phrases: Phrases, nil: Collection[sp.Symbol]) -> Line:
    """What acts on a body; on a rigid one with where it acts. Couples of guides only where an equation has them, or
    where what they guide turns.
    """
    system = instant.trial.system
    used = _used(stage)
    rigid = instant.instant.scene.bodies[body].rigid
    parts: list[list[Any]] = []
    for w in system.wrenches:
        if w.body == body and not _is_nought(w, instant.instant.scene, phrases):
            named = f" at {w.place}" if w.place and w.place != body else _at(instant, w.point, body)
            where = named if rigid else ""
            lasting = PURE if w.kind not in SUDDEN else TIME
            if w.force is not None:
                back = sp.sympify(w.magnitude).could_extract_minus_sign()
                size = -w.magnitude if back else w.magnitude
                plain = replace(phrases, ways={})
                # A letter that no equation has stands for the size of its force.
                idle = sp.sympify(size).is_Symbol and size not in used
                told = f" {_sense(w, phrases, back, idle)}{where}"
                parts.append(
                    [
                        _amount(size, FORCE * lasting, plain),
                        pointing(phrases, told, w.point, w.force, w.kind == MOMENTA, w.kind),
                    ]
                )
            elif w.couple != 0:
                back = sp.sympify(w.couple).could_extract_minus_sign()
                sense = pointing(phrases, " ↻" if back else " ↺", w.point, before=w.kind == MOMENTA)
                parts.append([_amount(-w.couple if back else w.couple, ENERGY * lasting, phrases), sense])
    assert system.reactions is not None
    absent, at_limit = _absent(instant, stage), impending(stage)
    beside = {o.normal: o for o in offsets(instant.trial, instant.value)} if rigid else {}
    couples = {o.couple for o in beside.values()}
    for push, expr in system.reactions.pushes:
        idle = not expr.free_symbols & used and does_nothing(system, push, phrases.value.known(expr))
        if push.name in absent or expr in nil or idle or expr in couples:
            continue
        guide = any(j.kind == "guide" and j.name == push.joint for j in instant.instant.scene.problem.joints)
        turning = any(_turns(instant, stage, a.body) != 0 for a in push.actions if a.body != GROUND)
        idle = guide and not expr.free_symbols & used and not turning
        backward = acts_backward(instant, push, expr, used, phrases)
        known = {*at_limit, *phrases.ledger.values}
        certain = expr in known or is_drawn_as_found(instant, push, expr, used, phrases)
        for a in (a for a in push.actions if a.body == body and (a.force is not None or not idle)):
            named = _end(instant, push, a, body) if push.kind == "tension" else _place(instant, push, a.point, body)
            beside_it = named if rigid and push.kind != "drive" else normal_to(instant.instant.scene, push)
            where = beside_it
            there: Line = ()
            acting = replace(a, force=-a.force) if backward and a.force is not None else a
            if (offset := beside.get(expr)) is not None:
                where, there = "", offset.told(phrases.arrow(offset.way.x, offset.way.y))
                acting = replace(a, point=offset.beside(a.point))
            if rigid and (unplaced := open_line(instant.trial, push, body, used, instant.value)) is not None:
                where, acting = NOT_NEEDED, replace(acting, point=unplaced.place(a))
            parts.append([*_push(push, expr, acting, phrases, where, certain), *there])
    return listed(parts)


def _is_nought(w: Wrench, scene: Scene, phrases: Phrases) -> bool:
    """Is it no force: a momentum of what is at rest, or a force that the file gives as zero?"""
    size = sp.sympify(w.magnitude)
    given = bool(size.free_symbols) and all(s in scene.ledger.values for s in size.free_symbols)
    return (w.kind == MOMENTA or (given and w.force is not None)) and phrases.value.is_zero(size)


def _end(instant: InstantSolution, push: Push, action: Any, body: str) -> str:
    """Where a tie pulls, as " at B"; nothing where its two parts leave the rim of a pulley: the axle stands for it."""
    here = [a.point for a in push.actions if a.body == body]
    return "" if sum(p == action.point for p in here) > 1 else _at(instant, action.point, body)


def _place(instant: InstantSolution, push: Push, point: Any, body: str) -> str:
    """Where a reaction acts, as " at P". A joint that is called by no point has the name of a point there, if any; what
    tips presses with its edge alone.
    """
    mode = instant.trial.system.modes.get(push.joint)
    if mode is not None and mode.name == "tip":
        return " at the edge"
    return f" at {push.place}" if push.place in instant.instant.scene.points else _at(instant, point, body)


def _used(stage: Stage) -> set[sp.Symbol]:
    """The letters in the equations of a stage."""
    return {s for block in stage.blocks for w in block.equations for s in w.residual.free_symbols}


def _idle(instant: InstantSolution, stage: Stage) -> set[sp.Symbol]:
    """Accelerations that no equation of a stage has, and which are zero: nothing acts along them."""
    if not instant.trial.outcomes:
        return set()
    numbers = unknowns_of(instant.trial.system, instant.trial.outcomes[0])
    return {s for s, number in numbers.items() if number == 0} - _used(stage)


def _absent(instant: InstantSolution, stage: Stage) -> set[str]:
    """The names of reactions of which the page says that they are zero: at a contact that is about to part there is
    neither a normal force nor friction.
    """
    reactions = instant.trial.system.reactions
    assert reactions is not None
    gone = dict.fromkeys(vanishing(stage), sp.S.Zero)
    told = {u for block in stage.blocks for u in block.unknowns if u in gone}
    parting = {push.joint for push, expr in reactions.pushes if push.kind == "normal" and expr in told}
    return {
        push.name
        for push, expr in reactions.pushes
        if push.joint in parting or expr in told or (push.kind == "friction" and sp.sympify(expr).xreplace(gone) == 0)
    }


def _amount(size: sp.Expr, dimension: Dimension, phrases: Phrases) -> Math | Value:
    """A force or couple: a number has its unit."""
    size = sp.sympify(size)
    if not size.is_number or size == 0:
        return phrases.math(size)
    unit = phrases.page_unit(default_unit(dimension))
    return Value(display(phrases.value(size), unit, phrases.ledger.us), unit.text, phrases.figures)


def _sense(w: Wrench, phrases: Phrases, back: bool, idle: bool = False) -> str:
    """The direction in which a positive magnitude acts, or its opposite; the sense of a velocity that it opposes may be
    open. `idle`: no equation has it; that of the force itself.
    """
    assert w.force is not None
    if (kind_of(w) or Load).opposes and phrases.symbolic:
        # A speed of size one in its way tells the sense.
        x, y = (one_way(sp.sympify(p), phrases.ways).xreplace(dict(phrases.ways)) for p in (w.force.x, w.force.y))
        open_ = x.has(sp.Abs, sp.sign) or y.has(sp.Abs, sp.sign)
        return "against its velocity" if open_ or not phrases.ways else phrases.arrow(x, y)
    reversed_sense = not idle and ((phrases.drawn or phrases.value)(sp.sympify(w.magnitude)) < 0) != back
    x, y = w.force.x, w.force.y
    if not phrases.arrow(x, y) and w.magnitude != 0:
        # Nought in the position that is drawn, as a damper at rest is: the sense in which its size counts.
        x, y = (simplified(p / w.magnitude) for p in (x, y))
    return phrases.arrow(-x, -y) if reversed_sense else phrases.arrow(x, y)


def _push(push: Push, expr: sp.Expr, action: Any, phrases: Phrases, where: str, sure: bool) -> list[Any]:
    """One reaction on a body. `where`: " at P" where its point has a name. `sure`: its sense is known. A belt is drawn
    by what it turns: its two parts pull at the rim, and nobody asks how much they press the disks together.
    """
    if push.kind == "tension" and action.couple != 0:
        turning = sp.sympify(expr * action.couple)
        back = turning.could_extract_minus_sign()
        size = _amount(-turning if back else turning, ENERGY, phrases)
        return [size, pointing(phrases, f" {'↻' if back else '↺'} by the belt", action.point)]
    if action.force is None:
        back = expr.could_extract_minus_sign()
        counterclockwise = (phrases.value(sp.sympify(action.couple)) > 0) != back
        turning = pointing(phrases, " ↺" if counterclockwise else " ↻", action.point)
        return [_amount(-expr if back else expr, ENERGY, phrases), turning]
    if expr.could_extract_minus_sign():
        told = f" {phrases.arrow(-action.force.x, -action.force.y)}{where}"
        return [phrases.math(-expr), pointing(phrases, told, action.point, action.force, kind=push.kind)]
    assumed = ASSUMED if push.kind == "friction" and expr.is_Symbol and not sure else ""
    told = f" {phrases.arrow(action.force.x, action.force.y)}{where}{assumed}"
    return [Math(expr), pointing(phrases, told, action.point, action.force, kind=push.kind)]


def _at(instant: InstantSolution, point: Any, body: str) -> str:
    """The name of a place as " at P": a point, of the body itself if there is one, or a mass centre."""
    scene, value = instant.instant.scene, instant.value
    points = sorted(scene.points.items(), key=lambda item: body not in scene.owners.get(item[0], ()))
    places = [(f" at {name}", place) for name, place in points]
    places += [(_centre(scene, b), scene.center(b)) for b in scene.bodies]
    # A point with the same formula comes before one that these data lay there, as H(0, h) on G for h = R.
    for is_zero in (lambda e: e == 0, value.is_zero):
        for words, place in places:
            if all(is_zero(getattr(place, a) - getattr(point, a)) for a in ("x", "y")):
                return words
    return ""


def _centre(scene: Scene, body: str) -> str:
    """Where the mass centre of a body is, as " at G"."""
    return f" at {plain_name(centre_of(scene, body))}"


def _inertia(
    instant: InstantSolution,
    stage: Stage,
    body: str,
    phrases: Phrases,
    reversed_sense: bool,
    kinds: tuple[Dimension, Dimension],
) -> Line:
    """m a_G and I α of a body; reversed they are the inertial force and couple. In equilibrium there is none."""
    if instant.trial.system.balanced(body):
        return ()
    model = instant.instant.scene.bodies[body]
    parts: list[Any] = []
    place, at = centre_of(instant.instant.scene, body), _centre(instant.instant.scene, body) if model.rigid else ""
    forces: list[tuple[sp.Expr, Text]] = []
    still = vanishing(stage)
    idle = _idle(instant, stage)
    components = stage.accelerations.get(body) or about_fixed_point(instant, body)
    apart = [positive(p) for direction, component in components for p in _apart(direction, component, instant, body)]
    apart = [as_given(p, (w for block in stage.blocks for w in block.equations)) for p in apart]
    for direction, component in apart if model.mass != 0 else ():
        if sp.sympify(component).xreplace(dict.fromkeys(still, sp.S.Zero)) == 0:
            continue
        if component in idle:
            continue
        v = -direction if reversed_sense else direction
        size = drawn_length(direction, instant, body, phrases)
        hidden = size.is_number and not is_clean(phrases.ledger, model.mass * component, dimension=kinds[0])
        if hidden or longer(size, SHORT):
            size = distance_drawn(direction, component, instant, body) or size
        force = (
            sp.Mul(model.mass, size, component, evaluate=False)
            if size != 1
            else sp.Mul(model.mass, component, evaluate=False)
        )
        forces.append((force, pointing(phrases, f" {phrases.arrow(v.x, v.y)}{at}", model.center, v)))
    along = straight_path(instant, body) if len(forces) > 1 else None
    if along is not None and not reversed_sense:
        straight = pointing(phrases, f" {phrases.arrow(along.x, along.y)}{at}", model.center, along)
        parts += [phrases.math(model.mass), Text(" "), Name(f"a_{place.replace('_', ',')}"), straight]
    elif any(longer(force, LONGEST) for force, _ in forces) or (not forces and _moves(instant, stage, body, phrases)):
        sign = "-" if reversed_sense else ""
        moves = acceleration_of_centre(instant, body, reversed_sense)
        where = Text(at) if moves is None else pointing(phrases, at, model.center, moves)
        parts += [Text(sign), phrases.math(model.mass), Text(" "), Name(f"a_{place.replace('_', ',')}"), where]
    else:
        for force, arrow in forces:
            told = _clean(force, stage, phrases, kinds[0])
            parts += [BETWEEN] * bool(parts) + [*told, arrow]
    alpha = _turns(instant, stage, body)
    if model.inertia != 0 and alpha != 0:
        back = clockwise_letter(alpha, instant) is not None
        told = _clean(model.inertia * (-alpha if back else alpha), stage, phrases, kinds[1])
        turning = " ↻" if reversed_sense != back else " ↺"
        parts += [BETWEEN] * bool(parts) + [*told, pointing(phrases, turning, model.center)]
    return tuple(parts)


def _turns(instant: InstantSolution, stage: Stage, body: str) -> sp.Expr:
    """The angular acceleration of a body, or what it turns with just after a blow; zero where an equation says so."""
    motion = instant.trial.system.motion
    alpha = motion.accelerations[body].angular if motion and instant.instant.scene.bodies[body].rigid else sp.S.Zero
    return sp.S.Zero if alpha in vanishing(stage) else sp.sympify(alpha)


def _moves(instant: InstantSolution, stage: Stage, body: str, phrases: Phrases) -> bool:
    """Has the mass centre an acceleration that no equation of the plan has, as about a fixed axis?"""
    system = instant.trial.system
    model = instant.instant.scene.bodies[body]
    if model.mass == 0 or body in stage.accelerations or system.motion is None:
        return False
    a = system.motion.acceleration(model.center, body)
    gone = dict.fromkeys(vanishing(stage), sp.S.Zero)
    return any(sp.sympify(p).xreplace(gone) != 0 and phrases.value.known(p) != 0 for p in (a.x, a.y))


def _clean(amount: sp.Expr, stage: Stage, phrases: Phrases, dimension: Dimension) -> Line:
    """m a or I α in letters; with its numbers where a number would hide a length."""
    if phrases.symbolic or is_clean(phrases.ledger, amount, dimension=dimension):
        return (phrases.math(amount),)
    if any(s not in phrases.ledger.units for s in amount.free_symbols):
        return (Math(amount),)
    found = amount_in_numbers(amount, stage.algebra.unknowns, phrases)
    if found is None:
        return (phrases.math(amount),)
    unit = coherent_unit(dimension, us=phrases.ledger.us).text
    number = found.expr.free_symbols <= set(found.values or ())
    return line(found, f" {pretty_unit(unit)}" if number else "")


def _apart(direction: Vec, turning: sp.Expr, instant: InstantSolution, body: str) -> list[tuple[Vec, sp.Expr]]:
    """A vector in plain lengths, but as one where it is an arm of the file, whose distance has the name OG, or lies
    across the path of a particle.
    """
    parts = in_plain_lengths(direction, turning, instant.value)
    if len(parts) > 1 and (across := across_the_path(direction, instant, body)) is not None:
        return [(across[0], turning * across[1])]
    turned = sp.sympify(direction.x).has(sp.sin, sp.cos) or sp.sympify(direction.y).has(sp.sin, sp.cos)
    if len(parts) == 1 or turned or distance_drawn(direction, turning, instant, body) is None:
        return parts
    return along_and_across(direction, turning, instant.trial.system, body) or [(direction, turning)]
