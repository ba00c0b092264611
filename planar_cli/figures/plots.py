"""Pictures of a motion that was followed: quantities over the time, ways of points, phase portraits, the ledger of
energy. Each is a list of graphs over each other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import zip_longest
from types import MappingProxyType

from planar_cli.errors import FileProblem, PlanarError
from planar_cli.figures.cut_off import cut_off
from planar_cli.figures.over_time import MOMENTS, Plotted, is_at, over_time, plotted, reached, unit_words, words_of
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import Part, Quantity, Side
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.document.graphs import Curve, Dot, Graph, Scaled, Spot
from planar_cli.report.document.marks import Figure, Panel
from planar_cli.simulate.answers import usual_unit
from planar_cli.simulate.energies import energies
from planar_cli.simulate.report import Motion
from planar_cli.simulate.run import Run
from planar_cli.simulate.table import HERE, Column, columns_of, places_of
from planar_cli.units import parse_unit

HIGH = 300.0
"""A portrait, a way and a ledger are so high."""
LOW = 190.0
THIN = 0.15
"""A way that is straight along an axis has a graph so broad, in parts of its length."""
SAME = 1e-9
"""Ways that differ by less than this part of their extent are one."""


def plot(motions: Sequence[Motion], kinds: Sequence[str], title: str) -> Figure:
    """One picture of all that is wanted, motion by motion. PlanarError: there is nothing to be drawn."""
    panels = tuple(panel for motion in motions for kind in kinds for panel in _panels(motion, kind))
    if not panels:
        raise PlanarError("nothing of this motion can be drawn: nothing moves, or it has no value")
    return Figure(panels, title, name="motion")


def _panels(motion: Motion, kind: str) -> Iterator[Panel]:
    graphs = KINDS[kind](motion)
    if graphs:
        yield Panel(graphs, line(motion.case.replace("_", " ")) if motion.case else ())


# --- over the time ----------------------------------------------------------------------------------------------------


def _time(motion: Motion) -> tuple[Graph, ...]:
    """The columns of the table that change; all of them, where none does."""
    every = plotted(motion.run, columns_of(motion.run.problem, motion.asked))
    shown = [q for q in every if q.pieces and not q.constant] or [q for q in every if q.pieces]
    graphs = over_time(motion.run, _bounded(motion, shown))
    if motion.other is None:
        return graphs
    others = plotted(motion.other, [q.column for q in shown])
    return _beside(graphs, over_time(motion.other, _bounded(motion, others)))


def changing_graphs(motion: Motion) -> tuple[Graph, ...]:
    """The quantities that change, without another motion beside them."""
    columns = columns_of(motion.run.problem, motion.asked)
    changing = [q for q in plotted(motion.run, columns) if q.pieces and not q.constant]
    return over_time(motion.run, _bounded(motion, changing))


def _bounded(motion: Motion, quantities: Sequence[Plotted]) -> Sequence[Plotted]:
    """The quantities, without peaks where the motion comes through positions in which forces grow without bound."""
    return [cut_off(q) for q in quantities] if any(p.unbounded for p in motion.singular) else quantities


def _beside(graphs: Sequence[Graph], others: Sequence[Graph]) -> tuple[Graph, ...]:
    """Graphs with the curves of another motion, dashed."""
    return tuple(_with(own, other) if other is not None else own for own, other in zip_longest(graphs, others) if own)


def _with(own: Graph, other: Graph) -> Graph:
    return replace(
        own,
        across=_both(own.across, other.across),
        up=_both(own.up, other.up),
        curves=(*own.curves, *(replace(c, faint=True, words=()) for c in other.curves)),
    )


def _both(one: Scaled, other: Scaled) -> Scaled:
    return replace(one, low=min(one.low, other.low), high=max(one.high, other.high))


# --- ways -------------------------------------------------------------------------------------------------------------


def _path(motion: Motion) -> tuple[Graph, ...]:
    """The ways of points in one graph with equal axes."""
    asked = _places_asked(motion)
    wanted = plotted(motion.run, asked) if asked else tuple(_places(motion.run))
    graph = _ways(motion.run, wanted)
    if graph is None:
        return ()
    columns = [q.column for q in wanted]
    other = _ways(motion.other, plotted(motion.other, columns)) if motion.other is not None else None
    return (graph,) if other is None else (_with(graph, other),)


def _places_asked(motion: Motion) -> list[Column]:
    return [c for c in columns_of(motion.run.problem, motion.asked) if motion.asked and _is_place(c.side)]


def _is_place(side: Side) -> bool:
    return isinstance(side, Quantity) and side.word == "r" and not side.parts


def _places(run: Run) -> Iterator[Plotted]:
    """The mass centres of all bodies, then the points of the file."""
    problem = run.problem
    metre = usual_unit(_place("O"), Kinds(Scope(problem, ())), problem.us)
    for name in (*(b.name for b in problem.bodies), *(p.name for p in problem.points if not p.unnamed)):
        try:
            yield from plotted(run, [Column(name, metre, _place(name))])
        except (FileProblem, KeyError):
            # A point that belongs to no body, or to several, has no way of its own.
            continue


def _place(name: str) -> Quantity:
    return Quantity("r", (name,), None, (), None, HERE)


def _ways(run: Run, places: Sequence[Plotted]) -> Graph | None:
    found: list[tuple[Line, Plotted]] = []
    for q in places:
        if len(q.pieces) == 2 and not q.constant and not any(_alike(q, old) for _, old in found):
            side = q.column.side
            assert isinstance(side, Quantity)
            found.append((line(Name("/".join(side.things))), q))
    if not found:
        return None
    curves = [Curve(tuple(_way(q)), words) for words, q in found]
    spots = [s for c in curves for piece in c.pieces for s in piece]
    xs, ys = zip(*spots, strict=True)
    least = THIN * max(max(xs) - min(xs), max(ys) - min(ys))
    unit = unit_words(found[0][1].column.unit)
    across, up = (Scaled(line(Name(n)), unit, *_widened(v, least)) for n, v in (("x", xs), ("y", ys)))
    dots = tuple(d for _, q in found for d in _passed(run, q))
    return Graph(across, up, tuple(curves), dots, equal=True, size=(380.0, HIGH))


def _widened(values: Sequence[float], least: float) -> Spot:
    """From the smallest to the largest value, or as much more on both sides as makes it `least`."""
    low, high = min(values), max(values)
    more = max(least - (high - low), 0.0) / 2
    return low - more, high + more


def _way(quantity: Plotted) -> Iterator[tuple[Spot, ...]]:
    for xs, ys in zip(*quantity.pieces, strict=True):
        yield tuple((x, y) for (_, x), (_, y) in zip(xs, ys, strict=True))


def _alike(one: Plotted, other: Plotted) -> bool:
    """Do two points go the same way at the same time?"""
    pairs = [
        (a[1], b[1])
        for p, q in zip(one.pieces, other.pieces, strict=False)
        for r, s in zip(p, q, strict=False)
        for a, b in zip(r, s, strict=False)
    ]
    size = max(max(abs(a), abs(b)) for a, b in pairs)
    return all(abs(a - b) <= SAME * size for a, b in pairs)


def _passed(run: Run, quantity: Plotted) -> Iterator[Dot]:
    """Where a point is in each state of the file."""
    xs, ys = ([s for piece in pieces for s in piece] for pieces in quantity.pieces)
    seen: dict[Spot, list[str]] = {}
    for state, moment in reached(run):
        near = [(x, y) for (t, x), (_, y) in zip(xs, ys, strict=True) if is_at(moment, t)]
        for spot in near[:1]:
            seen.setdefault(spot, []).append(state.replace("_", " "))
    yield from (Dot(spot, line(", ".join(names))) for spot, names in seen.items())


# --- phase portraits --------------------------------------------------------------------------------------------------


def _phase(motion: Motion) -> tuple[Graph, ...]:
    """The rate of every coordinate that changes over the coordinate."""
    graphs = tuple(_portraits(motion.run, _scalars(motion)))
    if motion.other is None:
        return graphs
    return _beside(graphs, tuple(_portraits(motion.other, _scalars(motion))))


def _scalars(motion: Motion) -> list[Column]:
    """What was asked for, else the coordinates of the file, else of each body its angle where it turns, or x and y."""
    problem = motion.run.problem
    if motion.asked:
        return list(columns_of(problem, motion.asked))
    own = {c.name for c in problem.coordinates}
    every = places_of(problem)
    if own:
        return [c for c in every if c.name in own]
    turning = {q.column.name for q in plotted(motion.run, [c for c in every if _is_angle(c.side)]) if not q.constant}
    bodies = [b.name for b in problem.bodies if f"theta({b.name})" not in turning]
    places = {f"{axis}({name})" for name in bodies for axis in "xy"}
    return [c for c in every if c.name in turning or c.name in places]


def _is_angle(side: Side) -> bool:
    return isinstance(side, Quantity) and side.word == "theta"


def _portraits(run: Run, columns: Sequence[Column]) -> Iterator[Graph]:
    kinds = Kinds(Scope(run.problem, ()))
    row = 0
    for column in columns:
        place = replace(column, unit=usual_unit(column.side, kinds, run.problem.us))
        side = _rate(column.side)
        rate = Column(f"dot({column.name})", usual_unit(side, kinds, run.problem.us), side)
        one, other = plotted(run, [place, rate])
        if len(one.pieces) != 1 or one.constant:
            continue
        pieces = tuple(
            tuple((x, v) for (_, x), (_, v) in zip(xs, vs, strict=True))
            for xs, vs in zip(one.pieces[0], other.pieces[0], strict=True)
        )
        both = Plotted(column, (one.pieces[0], other.pieces[0]), one.size)
        yield Graph(
            _scaled(place, one), _scaled(rate, other), (Curve(pieces),), tuple(_passed(run, both)), row, size=(300, LOW)
        )
        row += 1


def _scaled(column: Column, quantity: Plotted) -> Scaled:
    values = [v for piece in quantity.pieces[0] for _, v in piece]
    return Scaled(words_of(column), unit_words(column.unit), min(values), max(values))


def _rate(side: Side) -> Side:
    """How fast something changes: the angular velocity of a body, the velocity of its mass centre, else dot( )."""
    if isinstance(side, Quantity) and side.word == "theta" and len(side.things) == 1 and not side.parts:
        return replace(side, word="omega")
    if isinstance(side, Quantity) and side.word in ("x", "y") and not side.parts:
        return replace(side, word="v", parts=(Part(side.word, None, HERE),))
    return Quantity("dot", (), side, (), None, HERE)


# --- energy -----------------------------------------------------------------------------------------------------------


def _energy(motion: Motion) -> tuple[Graph, ...]:
    """The accounts of energy and their sum, which stays the same."""
    run = motion.run
    accounts = energies(run, MOMENTS)
    if len(accounts) < 2:
        return ()
    values = [v for a in accounts for piece in a.pieces for _, v in piece]
    across = Scaled(line(Name("t")), "s", run.trajectory.t0, run.trajectory.t1)
    joule = parse_unit("ft*lb" if run.problem.us else "J")
    curves = tuple(Curve(a.pieces, line(a.name), total=a is accounts[-1]) for a in accounts)
    return (
        Graph(
            across,
            Scaled(line("energy"), unit_words(joule), min(values), max(values)),
            curves,
            size=(380.0, HIGH),
        ),
    )


KINDS: Mapping[str, Callable[[Motion], tuple[Graph, ...]]] = MappingProxyType(
    {"time": _time, "path": _path, "phase": _phase, "energy": _energy}
)
