"""A graph as a small plot in letters, for a terminal."""

from __future__ import annotations

from itertools import pairwise

from planar_cli.formats._canvas import ACROSS, DOWN, Canvas
from planar_cli.formats._graph import Field, in_unit, scaled_ticks
from planar_cli.formats._layout import settled, spans
from planar_cli.plain_letters import letters
from planar_cli.report.document.blocks import Line
from planar_cli.report.document.graphs import Graph, Scaled

WIDEST, FEWEST, ROWS = 66, 12, 8
"""Columns of the field at most and at least, and its rows."""
INDENT = 2
EACH = 9
"""So many columns a number on the axis of time has."""
NARROW = 60
"""In fewer columns what is measured stands below the axis, not behind it."""
POINT = "●"


def small_plot(graph: Graph, width: int) -> list[str]:
    """The lines of a plot that is no wider than `width`."""
    up = scaled_ticks(graph.up, ROWS // 2)
    told = {k: letters(_text(up.words(t)).replace("−", "-")) for k, t in enumerate(up.ticks)}
    beside = max(map(len, told.values()))
    # The power of ten is the same with any number of ticks.
    words = _measured(graph.across, scaled_ticks(graph.across, 1, tight=True).power)
    behind = len(words) + 1 if width >= NARROW else 0
    columns = max(min(WIDEST, width - INDENT - beside - 3 - behind), FEWEST)
    across = scaled_ticks(graph.across, max(1, columns // EACH), tight=True)
    canvas = Canvas(columns, ROWS)
    field = Field(across, up, columns * ACROSS - 1, ROWS * DOWN - 1)
    spot = field.spot
    for curve in graph.curves:
        for piece in curve.pieces:
            for start, end in pairwise((piece[0], *piece)):
                canvas.stroke(spot(start), spot(end))
    for curve in graph.curves if len(graph.curves) > 1 else ():
        if curve.pieces and curve.words:
            _label(canvas, spot(curve.pieces[-1][-1]), _text(curve.words))
    for dot in graph.dots:
        x, y = spot(dot.at)
        canvas.put(round(x) // ACROSS, round(y) // DOWN, POINT)
        _label(canvas, (x, y), _text(dot.words))
    marks = {round(spot((across.low, t))[1]) // DOWN: told[k] for k, t in enumerate(up.ticks)}
    lines = [" " * INDENT + _measured(graph.up, up.power)]
    for row, cells in enumerate(canvas.lines()):
        axis = "┤" if row in marks else "│"
        lines.append(" " * INDENT + marks.get(row, "").rjust(beside) + letters(f" {axis}") + cells)
    return [*lines, *_axis(words, field, columns, width, INDENT + beside + 1)]


def _label(canvas: Canvas, at: tuple[float, float], text: str) -> None:
    """Words beside a place, where nothing stands yet; else not at all, as the list of what happens has them."""
    column, row = round(at[0]) // ACROSS, round(at[1]) // DOWN
    left, right = column - len(text), column + 1
    around = ((right, row - 1), (left, row - 1), (right, row + 1), (left, row + 1), (right + 1, row), (left - 1, row))
    for place in around:
        if canvas.is_free(*place, len(text)):
            canvas.put(*place, text)
            return


def _axis(words: str, field: Field, columns: int, width: int, start: int) -> list[str]:
    """The line of the axis, its numbers below, and the words for what is measured along it."""
    across = field.across
    places = {round(field.spot((t, field.up.low))[0]) // ACROSS: t for t in across.ticks}
    line = "".join("┬" if k in places else "─" for k in range(columns))
    below = [" "] * (columns + EACH)
    for column, t in places.items():
        text = letters(_text(across.words(t)).replace("−", "-"))
        begin = max(min(column - (len(text) - 1) // 2, width - start - 1 - len(text)), 0)
        if all(c == " " for c in below[max(begin - 1, 0) : begin + len(text) + 1]):
            below[begin : begin + len(text)] = text
    whole = " " * start + letters("└" + line)
    last = " " * (start + 1) + "".join(below).rstrip()
    if width >= NARROW:
        return [f"{whole} {words}", last]
    return [whole, last, " " * (start + 1 + max(columns - len(words), 0)) + words]


def _measured(axis: Scaled, power: int) -> str:
    return _text(axis.words) + letters(in_unit(axis.unit, power))


def _text(words: Line) -> str:
    return "".join(s.text for s in settled(spans(words)))
