"""The picture of a study of accuracy: error over time, by powers of ten, a curve for every integrator."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from planar_cli.errors import PlanarError
from planar_cli.problem.nodes.show import harmless
from planar_cli.report.document.blocks import Text, line
from planar_cli.report.document.graphs import Curve, Graph, Scaled, Spot
from planar_cli.report.document.marks import Figure, Panel
from planar_cli.simulate.accuracy import Row, Study
from planar_cli.simulate.diagram import curves_of, lowest_of

SIZE = (460.0, 290.0)


def accuracy_plot(studies: Sequence[tuple[str, Study]]) -> Figure:
    """Error, and estimated error, over time, a graph for every study with its title. PlanarError: there is nothing to
    be drawn.
    """
    drawn = [(" ".join(harmless(title, kept="").split()), study) for title, study in studies if curves_of(study)]
    if not drawn:
        raise PlanarError("nothing can be drawn: no run of these files has an error")
    head = drawn[0][0] if len(drawn) == 1 else ""
    graphs = tuple(_graph(study, "" if head else title, row) for row, (title, study) in enumerate(drawn))
    words = f"what accuracy costs: {', '.join(title for title, _ in drawn)}"
    return Figure((Panel(graphs, line(head) if head else ()),), words, name="accuracy", note=line(_note(drawn)))


def _note(drawn: Sequence[tuple[str, Study]]) -> str:
    return "dashed: estimated error" if any(r.estimated is not None for _, s in drawn for r in s.rows) else ""


def _graph(study: Study, title: str, row: int) -> Graph:
    low = lowest_of(study)
    curves = [curve for kind, rows in curves_of(study).items() for curve in _curves(kind, rows, low)]
    spots = [spot for curve in curves for piece in curve.pieces for spot in piece]
    xs, ys = zip(*spots, strict=True)
    measured = f"{title}: error, in parts of the scales" if title else "error, in parts of the scales"
    across = Scaled(line(Text("time")), "s", min(xs), max(xs), powers=True)
    up = Scaled(line(Text(measured)), "", min(ys), max(ys), powers=True)
    return Graph(across, up, tuple(curves), row=row, size=SIZE)


def _curves(kind: str, rows: Sequence[Row], low: float) -> Iterator[Curve]:
    """Of one integrator. Whoever draws takes the colours by the place in the list: each has both curves."""
    own = tuple(_spot(r, r.error, low) for r in rows if r.error is not None)
    estimated = tuple(_spot(r, r.estimated, low) for r in rows if r.estimated is not None)
    yield Curve((own,), line(Text(kind.replace("_", " "))), marked=True)
    yield Curve((estimated,) if estimated else (), faint=True)


def _spot(row: Row, error: float, low: float) -> Spot:
    return math.log10(row.seconds), math.log10(max(error, low))
