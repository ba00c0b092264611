"""A solution for one find alone: of a motion the steps that lead to it, and of its forces and accelerations those on
which these rest, so that Newton's law stands before the acceleration that a time is found with.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.problem.language.walk import walk
from planar_cli.report.instant.wanted import letters_asked
from planar_cli.report.words.origins import needed_steps
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace, Relation, RouteTrace
from planar_cli.solve.solved_problem import PartSolution, Solution

FOLLOWED = "followed"


def for_one_find(solution: Solution, why: str | None) -> Solution:
    """`why`: the name of the find; None: everything stays."""
    if why is None:
        return solution
    own = (part for part in solution.parts if any(f.name == why for f in part.found))
    return replace(solution, parts=tuple(_part(part, why) for part in own))


def _part(part: PartSolution, why: str) -> PartSolution:
    found, asked = part.motion, letters_asked(part, why)
    if found is None or asked is None:
        return part
    requests = tuple(r for r in found.requests if r.find.name == why)
    route = _reduced(found.route, letters_of_find(found, why))
    passing = {name: way for name, way in found.passing.items() if name == why}
    steps = [x for way in (route, *passing.values()) for x in way.steps]
    relations = [e for x in steps for e in x.relations if not x.is_datum or e.kind == FOLLOWED]
    regimes = tuple(_regime(r, relations, found, asked, why) for r in found.regimes)
    quantities = [n for r in requests if r.find.found is not None for n in walk(r.find.found.what)]
    spans = tuple(x for x in found.spans if x.quantity in quantities)
    alone = replace(found, requests=requests, route=route, passing=passing, spans=spans, regimes=regimes)
    return replace(part, motion=alone)


def letters_of_find(found: MotionTrace, why: str) -> frozenset[str]:
    """The names of the letters in which something is asked, with those of its own state: T_2 by v_2, which is v_0."""
    requests = [r for r in found.requests if r.find.name == why]
    letters = {s for r in requests for e in (*r.parts, *(f for _, f in r.beside)) for s in e.free_symbols}
    letters |= {s for x in letters & found.route.plain.keys() for s in sp.sympify(found.route.plain[x]).free_symbols}
    return frozenset(s.name for s in letters)


def _reduced(route: RouteTrace, names: Collection[str]) -> RouteTrace:
    return replace(route, steps=tuple(needed_steps(route, names)))


def _regime(
    regime: RegimeTrace, relations: Iterable[Relation], found: MotionTrace, asked: frozenset[str], why: str
) -> RegimeTrace:
    """A regime with the unknowns on which the relations rest that act in it, and what is asked of it itself."""
    here = [e for e in relations if any(_acts(e, stretch, found.states) for stretch in regime.stretches)]
    # What no step leads to, as the period of a small oscillation, rests on the whole equation of motion.
    resting = frozenset(_unknowns(regime, here)) if relations else regime.resting or frozenset()
    at_states = {state: {why: parts[why]} for state, parts in regime.asked.items() if why in parts}
    names = {s.name for parts in at_states.values() for p in parts[why] for s in p.free_symbols}
    return replace(regime, wanted=resting | asked | names, resting=resting, asked=at_states)


def _acts(e: Relation, stretch: tuple[str, str], states: Sequence[str]) -> bool:
    """Does a relation speak of the motion along a stretch?"""
    if not {e.since, e.stop, *stretch} <= {*states}:
        return True
    (begin, end), (since, stop) = map(states.index, stretch), (states.index(e.since), states.index(e.stop))
    return begin < stop and since < end


def _unknowns(regime: RegimeTrace, relations: Iterable[Relation]) -> Iterator[str]:
    """The accelerations of the laws among some relations, and the forces in their balances, as far as the page of all
    finds tells them.
    """
    edges = regime.solution.trial.system.tree.edges
    pairs = [p for e in edges for p in ((e.slide, e.slide_rate), (e.rise, e.rise_rate), (e.spin, e.spin_rate))]
    rates = {speed: rate.name for speed, rate in pairs if speed is not None and rate is not None}
    moving = {*rates.values(), *(speed.name for speed in rates)}
    told = regime.resting if regime.resting is not None else frozenset()
    for e in relations:
        of_law = e.law is not None and e.law.speed in rates
        if of_law and e.kind != FOLLOWED:
            assert e.law is not None
            yield from told & {rates[e.law.speed]}
        elif e.is_of_motion or e.kind == FOLLOWED:
            yield from told
        elif e.source is not None:
            yield from told - moving
        else:
            # The end of a contact speaks of a force, which another find may ask for.
            yield from (regime.wanted or frozenset()) - moving
