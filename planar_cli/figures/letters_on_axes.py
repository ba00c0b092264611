"""Axes of graphs whose numbers rest on letters: at the states they have the letters of the page, such as v_0 and t_top,
and no numbers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.figures.laws_traced import Instant, Traced
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.document.graphs import Scaled
from planar_cli.solve.between.trace.trace import MotionTrace

SOME = "drawn for some values of the letters"
BEYOND, NEAR = 0.08, 1e-9
"""An axis goes on by this part of its length; what is as near to zero in parts of it is zero."""
Marked = tuple[float, Line]


def rests_on_letters(motion: MotionTrace, ways: Iterable[Traced]) -> bool:
    """Do the curves of some coordinates depend on letters without numbers?"""
    open_, route = {s.name for s in motion.problem.symbols}, motion.route
    told = [law.f for _, _, own in motion.stretches for law in own if any(law.f == w.law.f for w in ways)]
    own = {c for w in ways for c in (w.law.coordinate.symbol, w.law.coordinate.speed)}
    states = [x for x, g in motion.general.items() if g in own or g.name == "t"]
    told += [sp.sympify(route.plain.get(x, route.formulas.get(x, 0))) for x in states]
    return any(str(s.name) in open_ for f in told for s in f.free_symbols)


def in_letters(axis: Scaled, marks: Iterable[Marked]) -> Scaled:
    """An axis from zero on, with letters at these places."""
    low, high = min(axis.low, 0.0), max(axis.high, 0.0)
    span = (high - low) or 1.0
    told: dict[Line, float] = {line("0"): 0.0}
    for place, words in marks:
        if abs(place) > NEAR * span:
            told.setdefault(words, place)
    below = BEYOND * span if low < 0 else 0.0
    letters = tuple((place, words) for words, place in told.items())
    return replace(axis, unit="", low=low - below, high=high + BEYOND * span, letters=letters)


def times_of(motion: MotionTrace, ways: Iterable[Traced], names: frozenset[str]) -> Iterator[Marked]:
    """When the states come. `names`: those on the page."""
    clock = next((g for g in motion.general.values() if g.name == "t"), None)
    for way in ways:
        for state, i in way.states:
            if clock is not None and (words := _called(motion, clock, state, "t", names)):
                yield i.t, words


def places_of(
    motion: MotionTrace, way: Traced, level: str, letter: str, names: frozenset[str], one: float
) -> Iterator[Marked]:
    """Places (`level` q) or velocities (v) in the states. `letter`: its name on the page; `one`: a unit of it."""
    coordinate = way.law.coordinate
    general = coordinate.symbol if level == "q" else coordinate.speed if coordinate.extra == 0 else None
    same = level == "q" or abs(sp.sympify(coordinate.factor)) == 1
    for state, i in way.states if general is not None and same and level != "a" else ():
        sign = 1 if level == "q" else int(coordinate.factor)
        if words := _called(motion, general, state, letter, names):
            yield _value(i, level) * sign / one, words


def _value(i: Instant, level: str) -> float:
    return i.q if level == "q" else i.v


def _called(motion: MotionTrace, general: sp.Symbol | None, state: str, letter: str, names: frozenset[str]) -> Line:
    """A quantity in a state by its letter of the file, or by that of the page; empty: the page has none."""
    own = next((x for x, g in motion.general.items() if g == general and motion.ledger.roles[x].at == state), None)
    told = motion.route.plain.get(own, motion.route.formulas.get(own)) if own is not None else None
    if told is not None and told.is_Symbol and str(told.name) in {s.name for s in motion.problem.symbols}:
        return line(Name(str(told.name)))
    name = f"{letter}__{state}"
    return line(Name(name)) if name in names else ()
