"""A velocity that the file states by a constant which it seeks and which is known first is called by that: m v ↓ for
m v_y,1 with v_y,1 = -v.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.solve.between.trace.trace import MotionTrace, RouteStep
from planar_cli.solve.solved_problem import PartSolution


def with_constants_for_speeds(part: PartSolution) -> PartSolution:
    """A part whose motion is told so."""
    motion = part.motion
    if motion is None or motion.symbolic:
        return part
    found: dict[sp.Symbol, sp.Expr] = {}
    known: set[sp.Symbol] = set()
    for step in motion.route.steps:
        found |= _stated(step, motion, known)
        known |= set(step.unknowns)
    if not found:
        return part
    route = motion.route
    kept = [s for s in route.steps if not set(s.unknowns) <= found.keys()]
    steps = tuple(
        replace(
            s,
            needs=frozenset(x for n in s.needs for x in found.get(n, n).free_symbols),
            results=tuple(
                replace(r, formula=None if r.formula is None else r.formula.xreplace(found)) for r in s.results
            ),
        )
        for s in kept
    )
    formulas = {s: None if f is None else f.xreplace(found) for s, f in route.formulas.items() if s not in found}
    told = replace(route, steps=steps, formulas=formulas, plain={**route.plain, **found})
    requests = tuple(replace(r, parts=tuple(p.xreplace(found) for p in r.parts)) for r in motion.requests)
    return replace(part, motion=replace(motion, route=told, requests=requests))


def _stated(step: RouteStep, motion: MotionTrace, known: set[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The velocity that a step says to be the opposite of a constant known before."""
    if len(step.relations) != 1 or len(step.results) != 1 or step.relations[0].kind != "given":
        return {}
    (r,) = step.results
    if r.formula is None or r.unknown not in motion.general or motion.general[r.unknown] not in motion.free:
        return {}
    constant = -r.formula
    sought = constant.is_Symbol and constant in known and constant not in motion.general
    return {r.unknown: r.formula} if sought else {}
