"""The graph beside a motion that was integrated numerically: what was asked of it, over the time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.figures.over_time import over_time, plotted, without_state
from planar_cli.problem.check_dimensions import Kinds
from planar_cli.problem.expression import Quantity, Relation, Side
from planar_cli.problem.scope import Scope
from planar_cli.problem.walk import walk
from planar_cli.report.marks import Figure, Panel
from planar_cli.simulate.answers import usual_unit
from planar_cli.simulate.run import Simulation
from planar_cli.simulate.table import Column, places_of, varies
from planar_cli.units import Unit, parse_unit

MOST = 3
"""So many graphs over each other."""
DEGREE = parse_unit("deg")


def motion_figure(motion: Simulation) -> Figure | None:
    """What was asked, over the time, from the very run that was followed; None: nothing of it changes."""
    run = motion.run
    for columns in (_asked(motion), _told(motion), places_of(run.problem)):
        quantities = [q for q in plotted(run, columns) if q.pieces and not q.constant]
        if quantities:
            return Figure(
                (Panel(over_time(run, quantities[:MOST])),), f"The motion of {run.problem.title}", name="motion"
            )
    return None


def _asked(motion: Simulation) -> list[Column]:
    """The quantities of the finds, in the units of their answers."""
    problem = motion.run.problem
    units = {a.name: a.unit for a in motion.answers}
    found: list[Column] = []
    for find in problem.find:
        own = find.found.what
        for node in walk(own):
            unit = units.get(find.name) if node is own else None
            found += _column(motion, node, unit, found)
    return found


def _told(motion: Simulation) -> list[Column]:
    """The quantities by which the file tells its states."""
    found: list[Column] = []
    for state in motion.run.problem.states:
        for relation in state.relations:
            for node in walk(relation) if isinstance(relation, Relation) else ():
                found += _column(motion, node, None, found)
    return found


def _column(motion: Simulation, node: object, unit: Unit | None, before: Sequence[Column]) -> Iterator[Column]:
    """A quantity that goes on over the time, unless it has been told."""
    side = without_state(node)
    problem = motion.run.problem
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
