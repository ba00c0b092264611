"""A check that a person can make of several bodies: they together, so that what they do to each other drops out.

block, bar together:  ↑ ΣF_y = 18.80 - 9.81 - 29.43 = -20.44 N,  Σ m a_y = -8.175 - 12.26 = -20.44 N

The solution took the bodies one by one, or by moments; the sum along an axis of which every body has its own equation
already would only repeat these.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.in_numbers.sums import agree, chain, counting
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import FORCE, default_unit

MOST = 6
"""Terms of a side that fits the line."""
MOST_BODIES = 3
"""More bodies are not named one by one."""


def system_sum(instant: InstantSolution, phrases: Phrases) -> Line:
    """The first axis along which all that acts from outside has its number on the page; empty where there is none."""
    system = instant.trial.system
    if phrases.symbolic or not instant.trial.outcomes or system.reactions is None or system.motion is None:
        return ()
    heavy = tuple(name for name, body in system.scene.bodies.items() if body.mass != 0)
    written = [w for s in instant.stages if s.level == "acceleration" for b in s.blocks for w in b.equations]
    if len(heavy) < 2 or any(b.varies for b in system.scene.bodies.values()):
        return ()
    if not any(w.law in ("force", "moment") for w in written):
        return ()
    for axis, arrow in (("x", "→"), ("y", "↑")):
        if _is_used(written, heavy, axis):
            continue
        try:
            told = _told(instant, heavy, (axis, arrow), phrases)
        except Unvalued:
            continue
        if told:
            return told
    return ()


def _is_used(written: list[Written], heavy: tuple[str, ...], axis: str) -> bool:
    """Is the sum in the solution, or the equation of every single body?"""
    sums = [w.bodies for w in written if w.law == "force" and w.lead == axis]
    return any(set(heavy) <= set(bodies) for bodies in sums) or all((name,) in sums for name in heavy)


def _told(instant: InstantSolution, heavy: tuple[str, ...], along: tuple[str, str], phrases: Phrases) -> Line:
    axis, arrow = along
    system = instant.trial.system
    assert system.motion is not None
    acting = list(_from_outside(instant, axis, phrases))
    if None in acting:
        return ()
    forces = counting([f for f in acting if f is not None])
    moved = [
        phrases.certain(
            system.scene.bodies[n].mass * getattr(system.motion.acceleration(system.scene.center(n), n), axis)
        )
        for n in heavy
    ]
    changes = counting(moved)
    if not 2 <= len(forces) <= MOST or not changes or len(changes) > MOST or not agree(forces, changes):
        return ()
    unit = phrases.page_unit(default_unit(FORCE))
    who = ", ".join(heavy) if len(heavy) <= MOST_BODIES else "all bodies"
    head = line(f"{who} together: {arrow} ", Name(f"ΣF_{axis}"), " = ", *chain(forces, unit, phrases))
    return line(*head, ", ", Name(f"Σ m a_{axis}"), " = ", *chain(changes, unit, phrases))


def _from_outside(instant: InstantSolution, axis: str, phrases: Phrases) -> Iterator[Decimal | None]:
    """What acts on the bodies along an axis, N; None: a force whose size the page does not tell. Of two forces of one
    push between the bodies nothing is left.
    """
    system, value = instant.trial.system, phrases.value
    assert system.reactions is not None
    for push, expr in system.reactions.pushes:
        own = (a.force for a in push.actions if a.force is not None and a.body in system.scene.bodies)
        parts = [value(sp.sympify(getattr(force, axis))) for force in own]
        if counting(parts) and not agree(parts, []):
            size = value.known(expr)
            yield None if size is None else size * sum(parts, Decimal(0))
    by_load: dict[str, list[sp.Expr]] = {}
    for i, w in enumerate(system.wrenches):
        if w.force is not None:
            # Both ends of a spring or a damper belong to one load.
            name = w.name if sum(o.name == w.name for o in system.wrenches) == 2 else f"{w.name} {i}"
            by_load.setdefault(name, []).append(sp.sympify(getattr(w.force, axis)))
    for parts in by_load.values():
        numbers = [value.known(e) for e in parts]
        if None in numbers:
            yield None
        else:
            known = [n for n in numbers if n is not None]
            yield Decimal(0) if agree(known, []) else sum(known, Decimal(0))
