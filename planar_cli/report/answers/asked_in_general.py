"""Velocities and accelerations that are asked at states of a motion, as vector equations of its general position."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Heading, Name, line
from planar_cli.report.equations.steps import EQUILIBRIUM, KINETICS
from planar_cli.report.instant.on_circle import is_told_on_circle
from planar_cli.report.instant.telling import Telling
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.names import index_of
from planar_cli.solve.between.trace.trace import MotionTrace, Request

LONGEST = 16
"""A component of more operations is not told."""
AXES = ("x", "y")


def with_asked(blocks: Sequence[Block], telling: Telling, motion: MotionTrace) -> list[Block]:
    """The blocks of a general position, and at the end of its first step the points whose motion is asked."""
    if len(motion.regimes) > 1 or not blocks:
        return list(blocks)
    added = [*_relative(telling, motion), *(b for r in motion.requests for b in _asked(r, telling, motion))]
    end = next(
        (i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text in (KINETICS, EQUILIBRIUM)), len(blocks)
    )
    told = [b.sides for b in blocks if isinstance(b, Equation)]
    own = [b for i, b in enumerate(added) if b.sides not in told and b not in added[:i]]
    return [*blocks[:end], *own, *blocks[end:]]


def _relative(telling: Telling, motion: MotionTrace) -> Iterator[Equation]:
    """v_B/A = v_B - v_A of bodies and points that do not turn, where the file states it at states."""
    stated = [n for s in motion.problem.states for r in s.relations for n in walk(r) if isinstance(n, Quantity)]
    for q in stated:
        if q.word != "v" or len(q.things) != 2 or any(_turns(thing, telling) for thing in q.things):
            continue
        one, other = (index_of(thing) for thing in q.things)
        vector = telling.system.quantities().any(replace(q, parts=(), at=None))
        if not isinstance(vector, Vec):
            continue
        parts = [
            sp.sympify(p.value).xreplace(dict.fromkeys(telling.vectors.zero, sp.S.Zero)) for p in (vector.x, vector.y)
        ]
        if any(longer(p, LONGEST) for p in parts):
            continue
        x, y = map(telling.phrases.math, parts)
        difference = line(Name(f"v_{one}"), " - ", Name(f"v_{other}"))
        yield Equation((line(Name(f"v_{one}/{other}")), difference, line("[", x, ", ", y, "]")))


def _turns(thing: str, telling: Telling) -> bool:
    """Is it a body that turns, or a point of one?"""
    body = thing if thing in telling.scene.bodies else telling.scene.owner(thing)
    return body == GROUND or telling.scene.rigid(body)


def _solved(expr: sp.Expr, telling: Telling) -> sp.Expr:
    """With the unknowns that the lines of the general position give put in."""
    found = (x for s in telling.stages for b in s.blocks for x in b.lines)
    lines = {x.symbol: x.formula for x in found if not x.formula.is_number}
    for _ in range(len(lines)):
        expr = expr.xreplace(lines)
    return expr


def _asked(r: Request, telling: Telling, motion: MotionTrace) -> Iterator[Equation]:
    q, scene, moving = r.find.found.what, telling.scene, telling.vectors.motion
    if not isinstance(q, Quantity) or q.word not in ("v", "a") or len(q.things) != 1 or q.things[0] not in scene.points:
        return
    point, kinds = q.things[0], [p.kind for p in q.parts]
    body = scene.owner(point)
    if body == GROUND or not scene.rigid(body) or kinds not in ([], ["x"], ["y"]) or all(p.is_Symbol for p in r.parts):
        return
    if is_told_on_circle(q, body, telling, motion):
        return
    level = "velocity" if q.word == "v" else "acceleration"
    at = scene.point(point)
    found = telling.vectors.formula(telling.vectors.carrier(body), at, point, level)
    if found is None:
        return
    edge, sides, arm = found
    yield Equation(sides, None, note=telling.vectors.arm_once(point, edge, arm))
    vector = moving.velocity(at, body) if level == "velocity" else moving.acceleration(at, body)
    for axis, part in zip(kinds or AXES, r.parts, strict=True):
        own = getattr(vector, axis).xreplace(dict.fromkeys(telling.vectors.zero, sp.S.Zero))
        last = part.xreplace(dict(motion.general))
        if longer(own, LONGEST) or own == 0 or not is_clean(telling.phrases.ledger, own):
            continue
        made: list[Any] = [telling.phrases.math(own)]
        if last != own and not longer(last, LONGEST) and identically_zero(_solved(own, telling) - last):
            made.append(telling.phrases.math(last))
        yield Equation((line(Name(f"{q.word}_{point}{axis}")), *made))
