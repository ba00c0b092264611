"""A motion as rows of numbers: the quantities that were asked for, or where every body is, at times in between."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from planar_cli.base_units import in_base
from planar_cli.errors import Mark
from planar_cli.motion.regime.regime import Regime
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import Found, Name, Quantity, Relation, Side
from planar_cli.problem.language.walk import Tree, walk
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.records import record
from planar_cli.simulate.answers import usual_unit
from planar_cli.simulate.measures import Several
from planar_cli.simulate.run import Run
from planar_cli.simulate.timetable import Timetable
from planar_cli.units import Unit, parse_unit

LATE = frozenset(
    (
        "path",
        "hodograph",
        *OF_SWINGS,
        "stable",
        "reached",
        "mode",
        "work",
        "impulse",
        "mean",
        "heat",
        "path_length",
        "count",
    )
)
"""What is no number at every moment."""
HERE = Mark("<table>", 1, 1)


@record
class Column:
    """One quantity over time."""

    name: str
    unit: Unit
    """In which its numbers are."""
    side: Side


@record
class Table:
    """Numbers over time; the first column is the time [s]."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: tuple[tuple[float, ...], ...]
    sizes: tuple[float, ...]
    """The size of usual values in each column: what is nothing beside it is rounding."""


def table_of(run: Run, asked: Sequence[Find], times: Sequence[float], count: int) -> Table:
    """The rows at these times, or `count` of them evenly spread over the motion."""
    columns = columns_of(run.problem, asked)
    trajectory = run.trajectory
    names, units, sizes = ["t"], ["s"], [trajectory.t1 or 1.0]
    scales = Timetable(run.problem, run.measures)
    t0, t1 = trajectory.t0, trajectory.t1
    chosen = [t for t in times if t0 <= t <= t1] or _spread(t0, t1, count)
    values: dict[Regime, Several] = {}
    rows = [tuple(_row(run, columns, t, values)) for t in chosen] if trajectory.segments else []
    first = next(iter(trajectory.segments), None)
    widths = [1] * len(columns)
    if first is not None and isinstance(first.regime, Regime):
        widths = [len(v) for v in _values(run, columns, first.regime, values)(first.t0, first.start)]
    for column, width in zip(columns, widths, strict=True):
        sizes += [scales.scale(column.side) / in_base(column.unit, run.problem.us)] * width
        names += [column.name] if width == 1 else [f"{column.name}.{part}" for part in "xy"]
        units += [column.unit.text] * width
    return Table(tuple(names), tuple(units), tuple(rows), tuple(sizes))


def _spread(t0: float, t1: float, count: int) -> list[float]:
    return [t0 + (t1 - t0) * i / (count - 1) for i in range(count - 1)] + [t1] if t1 > t0 else [t0]


def _values(run: Run, columns: Sequence[Column], regime: Regime, known: dict[Regime, Several]) -> Several:
    """What the columns are in one regime."""
    if regime not in known:
        known[regime] = run.measures.several([c.side for c in columns], regime)
    return known[regime]


def _row(run: Run, columns: Sequence[Column], t: float, known: dict[Regime, Several]) -> Iterator[float]:
    segment = run.trajectory.segment_at(t)
    y, regime = segment.at(t), segment.regime
    assert isinstance(regime, Regime)
    yield t
    values = _values(run, columns, regime, known)
    run.measures.wind(t)
    for column, found in zip(columns, values(t, y), strict=True):
        factor = in_base(column.unit, run.problem.us)
        yield from (v / factor for v in found)


def columns_of(problem: Problem, asked: Sequence[Find]) -> tuple[Column, ...]:
    """What is asked for; else the finds that hold throughout; else the coordinates of all bodies."""
    found = [(f.name, f.found) for f in asked] or [(f.name, f.found) for f in problem.find if _throughout(f.found)]
    return _as_columns(problem, found or list(_places(problem)))


def places_of(problem: Problem) -> tuple[Column, ...]:
    """The coordinates of the file and of all bodies."""
    return _as_columns(problem, list(_places(problem)))


def _as_columns(problem: Problem, found: Sequence[tuple[str, Found]]) -> tuple[Column, ...]:
    kinds = Kinds(Scope(problem, ()))
    made = []
    for name, what in found:
        if isinstance(what.what, Relation):
            continue
        unit = parse_unit(what.unit) if what.unit is not None else usual_unit(what.what, kinds, problem.us)
        made.append(Column(name, unit, what.what))
    return tuple(made)


def _throughout(found: Found) -> bool:
    """Does it vary and have a value at all times?"""
    return varies(found.what, ())


def varies(what: Tree, coordinates: Collection[str]) -> bool:
    """Is it something that has a value at all times and may change, such as these coordinates?"""
    nodes = list(walk(what))
    words = {n.word for n in nodes if isinstance(n, Quantity)}
    moving = words or any(isinstance(n, Name) and n.name in coordinates for n in nodes)
    return bool(moving) and words.isdisjoint(LATE) and not any(getattr(n, "at", None) for n in nodes)


def _places(problem: Problem) -> Iterator[tuple[str, Found]]:
    """The coordinates of the file, then x, y of every body's mass centre and its angle."""
    for symbol in problem.coordinates:
        yield symbol.name, Found(Name(symbol.name, None, HERE), symbol.unit, symbol.name, HERE)
    for body in problem.bodies:
        turns = type(body.shape).__name__ != "Particle"
        for word in ("x", "y", "theta") if turns else ("x", "y"):
            text = f"{word}({body.name})"
            unit = "deg" if word == "theta" else None
            yield text, Found(Quantity(word, (body.name,), None, (), None, HERE), unit, text, HERE)
