"""A velocity that is asked and of which an energy is made that is asked too: its components by their letters, in that
energy as well.

v_Bx,3 = v_Ax,3 - v_B/A,3 sin β,   v_By,3 = v_Ay,3 + v_B/A,3 cos β
loss = 1/2 m_B (v_Bx,2² + v_By,2²) - 1/2 m_A (v_Ax,3² + v_Ay,3²) - 1/2 m_B (v_Bx,3² + v_By,3²)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import with_article
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Request, Result, RouteStep
from planar_cli.solve.solved_problem import PartSolution

HANDED = "handed"
"""The kind of a relation that says what a velocity is in other letters."""
AXES = 2
NEAR = Decimal("1e-8")
"""What an integration in numbers gives is off by less."""


def with_asked_velocities(part: PartSolution) -> PartSolution:
    """The part with such components on its way; the same where there are none."""
    motion = part.motion
    if motion is None or motion.symbolic or len(motion.requests) == 1:
        return part
    for request in motion.requests:
        if (letters := _letters(request, motion)) and _is_in_another(request, motion):
            motion = _told(motion, dict(zip(request.parts, letters, strict=True)), request)
    return part if motion is part.motion else replace(part, motion=motion)


def _letters(request: Request, motion: MotionTrace) -> tuple[sp.Symbol, ...]:
    """The letters of both components of a velocity that is asked by a formula in others; empty of anything else."""
    what = request.find.found.what
    if not isinstance(what, Quantity) or what.word != "v" or what.parts or len(what.things) != 1:
        return ()
    if len(request.parts) != AXES or not all(p.is_Add for p in request.parts):
        return ()
    here = {g: own for own, g in motion.general.items() if motion.ledger.roles[own].at == what.at}
    for edge in _free_edges(motion, what.things[0]):
        ways = ((edge.slide, edge.rightward), (edge.rise, edge.upward))
        found = tuple(here[s] for s, way in ways if s in here and way > 0)
        pairs = zip(found, request.parts, strict=False)
        same = len(found) == AXES and all(_is_near(motion.value.known(s), motion.value.known(p)) for s, p in pairs)
        if same and not {*found} & motion.route.formulas.keys():
            return found
    return ()


def _is_near(one: Decimal | None, other: Decimal | None) -> bool:
    return one is not None and other is not None and abs(one - other) <= NEAR * (1 + abs(other))


def _free_edges(motion: MotionTrace, body: str) -> Iterator[Edge]:
    """How a body hangs on nothing, in the parts of the motion in which it does."""
    edges = (e for r in motion.regimes for e in r.solution.trial.system.tree.edges)
    yield from (e for e in edges if e.body == body and e.joining is None and e.slide is not None and e.rise is not None)


def _is_in_another(request: Request, motion: MotionTrace) -> bool:
    """Do both components stand in something else that is asked?"""
    others = [p for r in motion.requests if r is not request and len(r.parts) == 1 for p in r.parts]
    return any(all(p.has(own) for own in request.parts) for p in others)


def _told(motion: MotionTrace, letters: Mapping[sp.Expr, sp.Symbol], request: Request) -> MotionTrace:
    """The motion with the steps to both components, before what is integrated in numbers."""
    what = request.find.found.what
    assert isinstance(what, Quantity)
    words, state = f"the velocity of {with_article(what.things[0])}", str(what.at)
    numbers = {s: motion.value(f) for f, s in letters.items()}
    steps = motion.route.steps
    known = {x: i for i, leg in enumerate(steps) for x in leg.unknowns}
    made = []
    for formula, symbol in letters.items():
        relation = Relation(symbol - formula, HANDED, words, state)
        needs = frozenset(formula.free_symbols & (motion.unknowns | known.keys()))
        made.append(RouteStep((relation,), (symbol,), needs, (Result(symbol, formula, numbers[symbol]),), False))
    at = 1 + max((known[s] for leg in made for s in leg.needs if s in known), default=-1)
    route = replace(
        motion.route,
        steps=(*steps[:at], *made, *steps[at:]),
        formulas={**motion.route.formulas, **{s: f for f, s in letters.items()}},
        settled=motion.route.settled | numbers.keys(),
    )
    requests = tuple(replace(r, parts=tuple(p.xreplace(dict(letters)) for p in r.parts)) for r in motion.requests)
    return replace(
        motion,
        route=route,
        requests=requests,
        value=motion.value.extended(numbers),
        guessed=motion.guessed - numbers.keys(),
    )
