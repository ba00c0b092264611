"""What a motion does over the time, as graphs: quantities, one over the other, with the states of the file on them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby

from planar_cli.base_units import in_base
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.expression import Part, Quantity, Side
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Name, Text, line
from planar_cli.report.document.graphs import Curve, Dot, Graph, Scaled, Spot
from planar_cli.report.words.sides import said
from planar_cli.report.words.spoken import spoken
from planar_cli.simulate.measures import LATER
from planar_cli.simulate.run import Run
from planar_cli.simulate.sampled import Sampled, sampled
from planar_cli.simulate.table import Column
from planar_cli.simulate.timetable import Timetable
from planar_cli.units import Unit, pretty_unit

MOMENTS = 360
"""A curve has so many places at least."""
FIGURES = 4
NOISE = 1e-7
"""A quantity that varies by no more than this part of its usual size is constant."""
HIGH, LOW = 190.0, 120.0
"""How high a graph is that stands alone, and one of several."""
WIDE = 380.0
CALLED = {
    "KE": "kinetic energy",
    "PE": "potential energy",
    "H": "angular momentum",
    "force": "force",
    "power": "power",
    "moment": "moment",
    "rho": "radius of curvature",
}
"""Quantities that a page tells in sentences alone."""
OF = {"force": "in", "moment": "at", "power": "of"}
CUT = ", peaks cut off,"
NEAR = 0.012
"""States that are reached within this part of the motion have one dot."""


@record
class Plotted:
    """One quantity over the time: its pieces, in the unit of its column, component by component."""

    column: Column
    pieces: tuple[tuple[tuple[Spot, ...], ...], ...]
    """Of each component."""
    size: float
    """Its usual size in the scene, in the unit."""
    cut: bool = False
    """Are its peaks cut off?"""

    @property
    def constant(self) -> bool:
        """Does nothing of it change?"""
        spans = [_span([y for piece in pieces for _, y in piece]) for pieces in self.pieces]
        return all(high - low <= NOISE * max(self.size, abs(high), abs(low)) for low, high in spans)


def plotted(run: Run, columns: Sequence[Column]) -> tuple[Plotted, ...]:
    """The quantities of some columns over the whole motion."""
    found = sampled(run, [c.side for c in columns], MOMENTS)
    scales = Timetable(run.problem, run.measures)
    made = []
    for k, column in enumerate(columns):
        one = in_base(column.unit, run.problem.us)
        count = len(found[0].values[0][k]) if found else 0
        pieces = tuple(tuple(_piece(s, k, i, one) for s in found) for i in range(count))
        made.append(Plotted(column, pieces, scales.scale(column.side) / one))
    return tuple(made)


def _piece(part: Sampled, k: int, i: int, one: float) -> tuple[Spot, ...]:
    return tuple((t, values[k][i] / one) for t, values in zip(part.times, part.values, strict=True))


def over_time(run: Run, quantities: Sequence[Plotted]) -> tuple[Graph, ...]:
    """A graph for each quantity that has a value anywhere."""
    shown = [q for q in quantities if q.pieces]
    trajectory = run.trajectory
    across = Scaled(line(Name("t")), "s", trajectory.t0, trajectory.t1)
    size = (WIDE, HIGH if len(shown) == 1 else LOW)
    return tuple(
        Graph(across, _up(q), tuple(_curves(q)), tuple(_dots(run, q)), row, size=size) for row, q in enumerate(shown)
    )


def _up(quantity: Plotted) -> Scaled:
    values = [y for pieces in quantity.pieces for piece in pieces for _, y in piece]
    low, high = _span(values)
    noise = NOISE * quantity.size
    if high - low <= noise:
        # What is only rounding is drawn as what it is.
        low = high = 0.0 if abs(low) <= noise else low
    words = line(*words_of(quantity.column), CUT) if quantity.cut else words_of(quantity.column)
    return Scaled(words, unit_words(quantity.column.unit), low, high)


def unit_words(unit: Unit) -> str:
    """A unit behind an axis; nothing for a number."""
    return "" if unit.text == "1" else pretty_unit(unit.text)


def _curves(quantity: Plotted) -> Iterator[Curve]:
    if len(quantity.pieces) == 1:
        yield Curve(quantity.pieces[0])
        return
    for part, pieces in zip("xy", quantity.pieces, strict=True):
        yield Curve(pieces, _component(quantity.column, part))


def _dots(run: Run, quantity: Plotted) -> Iterator[Dot]:
    """The states of the file, in order; several that are reached at nearly one moment share a dot."""
    later = isinstance(quantity.column.side, Quantity) and quantity.column.side.word in LATER
    near = NEAR * (run.trajectory.t1 - run.trajectory.t0)
    spots = [
        (name, s) for name, t in sorted(reached(run), key=lambda s: s[1]) if (s := _at(quantity, t, later)) is not None
    ]
    for (t, y), together in _together(spots, near):
        yield Dot((t, y), line(", ".join(name.replace("_", " ") for name in together)))


def reached(run: Run) -> list[tuple[str, float]]:
    """The states of the file to which a motion comes, with their times [s]."""
    return [(s.name, m.t) for s in run.problem.states if (m := run.measures.moments.get(s.name)) is not None]


def is_at(moment: float, t: float) -> bool:
    """Is a time that of a state, but for rounding?"""
    return abs(t - moment) <= 1e-12 * max(abs(moment), 1.0)


def _together(spots: Sequence[tuple[str, Spot]], near: float) -> Iterator[tuple[Spot, list[str]]]:
    first: Spot | None = None
    groups: list[tuple[Spot, str]] = []
    for name, spot in spots:
        first = spot if first is None or spot[0] - first[0] > near else first
        groups.append((first, name))
    for spot, group in groupby(groups, key=lambda g: g[0]):
        yield spot, [name for _, name in group]


def _at(quantity: Plotted, t: float, later: bool) -> Spot | None:
    """The place of its first curve at a moment; `later`: where it jumps, just after."""
    found = [s for piece in quantity.pieces[0] for s in piece if is_at(t, s[0])]
    return None if not found else found[-1] if later else found[0]


def words_of(column: Column) -> Line:
    """A quantity as a page calls it."""
    side = column.side
    told = said(side, FIGURES)
    if told is not None or not isinstance(side, Quantity):
        return told or line(Name(column.name))
    if side.word in CALLED and not side.parts:
        body, *about = (t.replace("_", " ") for t in side.things or ("",))
        of = f" {OF.get(side.word, 'of')} {body}" if body else ""
        return line(CALLED[side.word], of, *(f" about {p}" for p in about))
    parts = "".join(f".{p.kind}" for p in side.parts if p.direction is None)
    words = spoken(f"{side.word}({'/'.join(side.things)}){parts}", ())
    first, *others = (p for p in words if p != Text(""))
    # The title of an axis has no article.
    first = replace(first, text=first.text.removeprefix("the ")) if isinstance(first, Text) else first
    return line(first, *others)


def _component(column: Column, part: str) -> Line:
    side = column.side
    if isinstance(side, Quantity):
        told = said(replace(side, parts=(*side.parts, Part(part, None, side.mark))), FIGURES)
        if told is not None:
            return told
    return line(part)


def without_state(node: object) -> Side | None:
    """What is asked at a state, as something that goes on over the time; None: it is no such thing."""
    if isinstance(node, Quantity) and not isinstance(node.at, tuple):
        return replace(node, at=None)
    if isinstance(node, Letter):
        return replace(node, at=None)
    return None


def _span(values: Sequence[float]) -> Spot:
    return (min(values), max(values)) if values else (0.0, 0.0)
