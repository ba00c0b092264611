"""A check that a person can make of one body: moments about another point than those of the solution.

spool:  ↻ ΣM_C = 75 N·m;  I α and the moment of m a_G: 8.889 + 66.11 = 75 N·m
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.checks.another_equation import acting_on, moment_of, product_of
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.in_numbers.sums import agree, chain, counting
from planar_cli.report.words.counted import sense_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ENERGY, default_unit

MOST = 5
"""Terms of a side that fits the line."""


def another_point(instant: InstantSolution, phrases: Phrases) -> Line:
    """The first point of a body where something presses, apart from its mass centre; empty where there is none, or
    the body has no equation of moments on the page.
    """
    system = instant.trial.system
    if phrases.symbolic or not instant.trial.outcomes or system.reactions is None or system.motion is None:
        return ()
    written = [w for s in instant.stages if s.level == "acceleration" for b in s.blocks for w in b.equations]
    for name, body in system.scene.bodies.items():
        own = [w for w in written if w.law == "moment" and w.bodies == (name,)]
        if body.mass == 0 or not body.rigid or body.varies or system.balanced(name) or not own:
            continue
        used = {w.lead for w in own}
        for place, point in _places(instant, name):
            if place in used or phrases.value.is_zero((point - body.center).dot(point - body.center)):
                continue
            try:
                told = _told(instant, name, (place, point), phrases)
            except Unvalued:
                continue
            if told:
                return told
    return ()


def _places(instant: InstantSolution, name: str) -> Iterator[tuple[str, Vec]]:
    """The named points of a body at which other bodies act on it, each once."""
    system, seen = instant.trial.system, set[str]()
    assert system.reactions is not None
    for push, _ in system.reactions.pushes:
        if push.place in system.scene.points and push.place not in seen:
            seen.add(push.place)
            yield from ((push.place, a.point) for a in push.actions if a.body == name)


def _told(instant: InstantSolution, name: str, about: tuple[str, Vec], phrases: Phrases) -> Line:
    system = instant.trial.system
    body, motion, (place, point) = system.scene.bodies[name], system.motion, about
    assert motion is not None
    acting = acting_on(instant, name, phrases)
    turned = [product_of(moment_of(a.point - point, a.force, phrases) + a.couple, a.size) for a in acting]
    if None in turned:
        return ()
    turn = system.tree.turn((name,))
    moments = counting([turn * t for t in turned if t is not None])
    accelerated = (body.center - point).cross(motion.acceleration(body.center, name)) * body.mass
    changes = [
        turn * phrases.certain(sp.sympify(e)) for e in (body.inertia * motion.accelerations[name].angular, accelerated)
    ]
    if not 1 <= len(moments) <= MOST or not counting(changes) or not agree(moments, changes):
        return ()
    unit, centre = phrases.page_unit(default_unit(ENERGY)), body.center_name
    centre = centre if centre and centre != name else "G"
    names = (line("I α"), line("the moment of m ", Name(f"a_{centre}")))
    first, *others = (told for told, size in zip(names, changes, strict=True) if size)
    both = line(*first, *(p for told in others for p in (" and ", *told)))
    head = line(f"{name}: {sense_of(turn)} ", Name(f"ΣM_{place}"), " = ", *chain(moments, unit, phrases))
    return line(*head, "; ", *both, ": ", *chain(counting(changes), unit, phrases))
