"""Reactions in words: a normal force and the sliding friction that follows it are one force, the total reaction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, longer, simplified
from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Line, Math, Name, Value, line
from planar_cli.report.kinetics.armless import with_lines_through
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.pointing import about
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.candidates import VIRTUAL_MOTION
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.units import LENGTH

MOST_NAMED = 3
"""Of more unknowns it is not told that they do not enter."""
LONGEST = 60
"""A coordinate of more operations is left as it is."""


def force_named(system: System, symbol: sp.Symbol) -> Line:
    """A reaction by its letter; where sliding friction has the same letter, the total reaction at its place."""
    name = next((n for n, s in system.symbols.items() if s == symbol), "")
    push = next((p for p in system.pushes if p.name == name), None)
    if push is not None and push.place and any(law.of == name for law in system.laws):
        return line(f"the total reaction at {push.place}")
    return (Math(symbol),)


def _vector_named(system: System, symbol: sp.Symbol, bodies: Sequence[str]) -> Line:
    """A reaction, or of an acceleration the vector m a of the only body."""
    mass = system.scene.bodies[bodies[0]].mass if len(bodies) == 1 else sp.S.One
    if symbol in system.symbols.values() or not sp.sympify(mass).is_Symbol:
        return force_named(system, symbol)
    return (Math(sp.Mul(mass, symbol, evaluate=False)),)


def perpendicular(system: System, words: str) -> Line:
    """`across N_A` as a direction in words; other words as they are."""
    symbol = system.symbols.get(words.removeprefix("across ")) if words.startswith("across ") else None
    return line(words) if symbol is None else line("perpendicular to ", *force_named(system, symbol))


def free_direction(w: Written, stage: Stage) -> Line:
    """Of one body the direction in which forces are summed is chosen for what does not enter; else nothing."""
    gone = _left_out(w, stage) if w.words == VIRTUAL_MOTION and len(w.bodies) == 1 else []
    listed = [piece for s in gone for piece in (", ", Math(s))][1:]
    return (
        line("in the direction in which ", *listed, " do not count" if len(gone) > 1 else " does not count")
        if gone
        else ()
    )


def moment_words(system: System, phrases: Phrases, w: Written, stage: Stage) -> Line:
    """About which point moments are taken, and why about this one."""
    group, centre = ", ".join(w.bodies), stage.centres.get(w.lead)
    told = f"{group}, moments about "
    if centre is None:
        at = about(phrases, told, system.scene.points.get(w.lead), w.bodies)
        return with_lines_through(line(at, Name(w.lead), ":"), w, phrases)
    place, through = centre
    parts: list[Any] = [
        about(phrases, told, place, w.bodies),
        Name(w.lead),
        " at (",
        _length(phrases, place.x),
        ", ",
        _length(phrases, place.y),
        ")",
    ]
    turning = _turns_about(system, phrases, w.bodies, place)
    parts += [f", the instantaneous centre of {with_article(turning)}"] if turning else []
    if through:
        one, other = (_vector_named(system, s, w.bodies) for s in through[:2])
        parts += [", where the lines of ", *one, " and ", *other, " meet, so that neither enters:"]
    elif gone := _left_out(w, stage) or _of_the_diagram(system, w, stage):
        listed = [piece for s in gone for piece in (", ", Math(s))][1:]
        parts += [", chosen so that ", *listed, " do not enter:" if len(gone) > 1 else " does not enter:"]
    else:
        parts += [":"]
    return with_lines_through(line(*parts), w, phrases)


def _turns_about(system: System, phrases: Phrases, bodies: Sequence[str], place: Vec) -> str:
    """The body of a group of which a place is the instantaneous centre, by velocities that are known; "": none is."""
    motion, value = system.motion, phrases.value
    for body in bodies if motion is not None else ():
        if system.scene.bodies[body].rigid and motion is not None:
            v, omega = motion.velocity(place, body), motion.velocities[body].angular
            known = [value.known(e) for e in (v.x, v.y, omega)]
            if None not in known and omega != 0 and value.is_zero(v.x) and value.is_zero(v.y):
                return body if value.known(omega) else ""
    return ""


def _left_out(w: Written, stage: Stage) -> list[sp.Symbol]:
    """The unknowns of the other equations of the same bodies that an equation has not."""
    others = [x for block in stage.blocks for x in block.equations if x.bodies == w.bodies and x.number != w.number]
    inside = set().union(*(x.residual.free_symbols for x in others)) & set(stage.algebra.unknowns)
    return by_name(inside - w.residual.free_symbols)


def _of_the_diagram(system: System, w: Written, stage: Stage) -> list[sp.Symbol]:
    """The unknowns in the diagram of its bodies that an equation has not, where it is their only one."""
    drawn = [sp.Add(*parts) for parts in zip(*(body_residuals(system, b) for b in w.bodies), strict=True)]
    inside = set().union(*(e.free_symbols for e in drawn)) & set(stage.algebra.unknowns)
    gone = by_name(inside - w.residual.free_symbols)
    return gone if len(gone) <= MOST_NAMED else []


def _length(phrases: Phrases, expr: sp.Expr) -> Math | Value:
    """A coordinate as a formula, or with its unit where numbers of the file without a name stand in it."""
    ledger = phrases.ledger
    expr = expr if longer(expr, LONGEST) else simplified(expr)
    clean = expr == 0 or (is_clean(ledger, expr, dimension=LENGTH) and not expr.is_number)
    if clean or phrases.letters or not expr.free_symbols <= set(ledger.values):
        return phrases.math(expr)
    return phrases.of_dimension(phrases.value(expr), LENGTH)


def onward(w: Written) -> Written:
    """A sum of forces along a slanting line in the sense in which its terms are positive, where all have the other."""
    terms = [t for side in (w.left, w.right) for t in sp.Add.make_args(side) if t != 0]
    if w.law != "force" or w.lead or w.along is None or not all(t.could_extract_minus_sign() for t in terms):
        return w
    return replace(
        w,
        left=sp.Add(*(-t for t in sp.Add.make_args(w.left))),
        right=sp.Add(*(-t for t in sp.Add.make_args(w.right))),
        along=(-w.along[0], -w.along[1]),
    )
