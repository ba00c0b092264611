"""The graph beside a motion that was integrated numerically: what was asked of it, over the time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from planar_cli.figures.over_time import over_time, plotted, without_state
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.marks import Figure, Panel
from planar_cli.simulate.answers import usual_unit
from planar_cli.simulate.run import Run, Simulation
from planar_cli.simulate.table import Column, places_of, varies
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import Found
from planar_cli.units import Unit, parse_unit

MOST = 3
"""So many graphs over each other."""
DEGREE = parse_unit("deg")
MOTION = ("x", "y", "r", "v", "a", "omega", "alpha", "theta")
"""Quantities of a motion alone."""


def motion_figure(motion: Simulation) -> Figure | None:
    """What was asked, over the time, from the very run that was followed; None: nothing of it changes."""
    run, units = motion.run, {a.name: a.unit for a in motion.answers}
    return _figure(run, (_asked(run, run.problem, units), _told(run.problem), places_of(run.problem)))


def asked_over_time(motion: MotionTrace, run: Run, found: Sequence[Found]) -> Figure | None:
    """What is asked in the states of a motion that the file gives, over the time, from the run by which it was
    confirmed; None: the forces lead it, it changes not, or it is a constant.
    """
    laws = [law for _, _, own in motion.stretches for law in own]
    if not laws or any(law.order != 1 for law in laws):
        return None
    asked = _asked(run, motion.problem, {f.name: f.unit for f in found})
    return _figure(run, ([c for c in asked if isinstance(c.side, Quantity) and c.side.word in MOTION],))


def _figure(run: Run, wishes: Sequence[Sequence[Column]]) -> Figure | None:
    """The first quantities of which any changes."""
    for columns in wishes:
        quantities = [q for q in plotted(run, columns) if q.pieces and not q.constant]
        if quantities:
            return Figure(
                (Panel(over_time(run, quantities[:MOST])),), f"The motion of {run.problem.title}", name="motion"
            )
    return None


def _asked(run: Run, problem: Problem, units: Mapping[str, Unit]) -> list[Column]:
    """The quantities of the finds, in the units of their answers."""
    found: list[Column] = []
    for find in problem.find:
        own = find.found.what
        for node in walk(own):
            unit = units.get(find.name) if node is own else None
            found += _column(run.problem, node, unit, found)
    return found


def _told(problem: Problem) -> list[Column]:
    """The quantities by which the file tells its states."""
    found: list[Column] = []
    for state in problem.states:
        for relation in state.relations:
            for node in walk(relation) if isinstance(relation, Relation) else ():
                found += _column(problem, node, None, found)
    return found


def _column(problem: Problem, node: object, unit: Unit | None, before: Sequence[Column]) -> Iterator[Column]:
    """A quantity that goes on over the time, unless it has been told."""
    side = without_state(node)
    names = {c.name for c in problem.coordinates}
    if side is None or not varies(side, names) or any(_same(c.side, side) for c in before):
        return
    turned = isinstance(side, Quantity) and side.word == "theta"
    usual = DEGREE if turned else usual_unit(side, Kinds(Scope(problem, ())), problem.us)
    yield Column(str(getattr(side, "name", getattr(side, "word", ""))), unit or usual, side)


def _same(a: Side, b: Side) -> bool:
    """Do two quantities ask the same, wherever they stand in the file?"""
    if isinstance(a, Quantity) and isinstance(b, Quantity):
        kinds = [[p.kind for p in q.parts] for q in (a, b)]
        return (a.word, a.things, a.argument) == (b.word, b.things, b.argument) and kinds[0] == kinds[1]
    return getattr(a, "name", 0) == getattr(b, "name", 1)
