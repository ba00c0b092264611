"""A figure in letters, for a terminal: its strokes as dots, its small signs and its words as letters."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise, zip_longest
from textwrap import wrap

from planar_cli.formats._canvas import ACROSS, DOWN, Canvas, Place
from planar_cli.formats._labels import in_cells
from planar_cli.formats._paper import Box, Disc, Paper, Run, Stroke, Words, along, box_of, runs_of
from planar_cli.formats._signs import BREAK, HIDDEN
from planar_cli.formats._small_plot import small_plot
from planar_cli.formats._svg import unlabelled
from planar_cli.plain_letters import letters
from planar_cli.records import record
from planar_cli.report.document.graphs import Graph
from planar_cli.report.document.marks import Figure

CELL = (8.0, 16.0)
"""A letter in pixels."""
INDENT = 2
WIDE, HIGH, LEAST = 360.0, 240.0, 90.0
"""A panel to scale is so large at most; in a narrow terminal it is so wide at least."""
BESIDE = 150.0
"""What words and arrows beside it take, about."""
AROUND = 200.0
"""Farther than this from all strokes no words begin, px."""
WEIGHT = (0.2, 0.35, 0.5, 0.65, 0.8)
"""Where in its cell a sign counts, which words are to cover less than dots: so many times as much."""
SMALL = 7.0
"""A circle that is not larger is a letter."""
SIGNS = {"mass": "●", "pin": "○", "centre": "⊕", "dot": "·", "hidden": "○"}
BROKEN = "≈"
"""A line that is longer than it is drawn."""
ARROWS, PLAIN_ARROWS = "→↗↑↖←↙↓↘", "> ^ < v "
"""By eighths of a turn; where there are no others, along an axis."""
GAP = 3


def small_drawing(figure: Figure, width: int) -> list[str]:
    """The lines of a figure that is no wider than `width`; panels beside each other where there is room."""
    graphs = [m for p in figure.panels for m in p.marks if isinstance(m, Graph)]
    if graphs:
        return [line for k, graph in enumerate(graphs) for line in ([""] if k else []) + small_plot(graph, width)]
    room = (width - INDENT) * CELL[0]
    for size in (1.0, 0.75, 0.5, 0.35):
        wide = max(min(WIDE, room / len(figure.panels) - BESIDE), LEAST) * size
        panels = [_panel(paper, width - INDENT) for paper in unlabelled(figure, wide, HIGH * size)]
        if max(p.columns for p in panels) <= width - INDENT:
            break
    heads = [wrap(_text(runs_of(p.head)), width - INDENT) for p in figure.panels]
    blocks = [_headed(p, h) for p, h in zip(panels, heads, strict=True)]
    between = [f"   {sign}   " for sign in figure.between] or [" " * GAP] * (len(blocks) - 1)
    total = sum(b.columns for b in blocks) + sum(map(len, between))
    lines = _beside(blocks, between) if total <= width - INDENT else _stacked(blocks, figure.between)
    lines += ["", *wrap(_text(runs_of(figure.note)), width - INDENT)] if figure.note else []
    return [(" " * INDENT + line).rstrip() for line in lines]


@record
class _Block:
    """Lines, and how many columns they take."""

    lines: tuple[str, ...]
    columns: int
    middle: int
    """The line at which what stands between two blocks is written."""


def _panel(paper: Paper, width: int) -> _Block:
    """One panel, no wider than so many columns if that is possible."""
    told = [_in_cells(w) for w in paper.words]
    ink = box_of(spot for s in paper.strokes for spot in along(s, 4.0)) or Box(0.0, 0.0, 1.0, 1.0)
    # All words are on the canvas, wherever they come to stand; it is cut down at last.
    whole = ink.grown(max((w.width for w in told), default=0.0) + AROUND)
    left, top = math.floor(whole.left / CELL[0]), math.floor(whole.top / CELL[1])
    canvas = Canvas(math.ceil(whole.right / CELL[0]) - left, math.ceil(whole.bottom / CELL[1]) - top)

    def dots(spot: tuple[float, float]) -> tuple[float, float]:
        # A dot is in the middle of its part of a cell.
        return (spot[0] / CELL[0] - left) * ACROSS - 0.5, (spot[1] / CELL[1] - top) * DOWN - 0.5

    _draw(canvas, paper, dots)
    taken = [((left + i + 0.5) * CELL[0], (top + j + 0.5) * CELL[1]) for i, j in canvas.dots]
    signs = [((left + i + x) * CELL[0], (top + j + 0.5) * CELL[1]) for i, j in canvas.words for x in WEIGHT]
    spare = (width * CELL[0] - (ink.right - ink.left)) / 2
    boxes = in_cells(told, [*taken, *signs], CELL, (ink.left - spare, ink.right + spare))
    for words, box in zip(told, boxes, strict=True):
        column, row = (
            math.floor((box.left + box.right - words.width) / 2 / CELL[0] + 0.5),
            math.floor(box.top / CELL[1]),
        )
        canvas.put(column - left, row - top, words.runs[0].text)
    lines = _trimmed(canvas.lines())
    return _Block(tuple(lines), max(map(len, lines), default=0), len(lines) // 2)


def _draw(canvas: Canvas, paper: Paper, dots: Callable[[Place], Place]) -> None:
    """Strokes as dots, and small signs and heads of arrows as letters."""
    tips = [s for s in paper.strokes if isinstance(s, Stroke) and "head" in s.kind]
    for stroke in paper.strokes:
        if isinstance(stroke, Disc) and stroke.radius <= SMALL:
            _sign(canvas, dots(stroke.center), SIGNS.get(stroke.kind.split()[0], "·"))
        elif isinstance(stroke, Stroke) and stroke.kind == HIDDEN:
            _sign(canvas, dots(_middle(stroke)), BROKEN)
        elif stroke.kind != "hatch" and BREAK not in stroke.kind and stroke not in tips:
            spots = [dots(p) for p in along(stroke, 3.0)]
            for start, end in pairwise(spots):
                canvas.stroke(start, end)
    for tip in tips:
        _tip(canvas, [dots(p) for p in tip.places])


def _middle(stroke: Stroke) -> tuple[float, float]:
    """Of the corners of an area."""
    xs, ys = zip(*stroke.places, strict=True)
    return sum(xs) / len(xs), sum(ys) / len(ys)


def _trimmed(lines: list[str]) -> list[str]:
    """Without empty lines before and behind, and without columns that are empty before all else."""
    while lines and not lines[-1]:
        lines = lines[:-1]
    while lines and not lines[0]:
        lines = lines[1:]
    before = min((len(line) - len(line.lstrip(" ")) for line in lines if line), default=0)
    return [line[before:] for line in lines]


def _in_cells(words: Words) -> Words:
    """Words as wide as their letters are in a terminal."""
    text = letters(_text(words.runs))
    return replace(words, runs=(Run(text),), room=len(text) * CELL[0])


def _text(runs: Sequence[Run]) -> str:
    """a_G, with an index behind a stroke."""
    text, low = "", False
    for run in runs:
        text += ("_" if run.index and not low else "") + run.text
        low = run.index
    return letters(text)


def _tip(canvas: Canvas, places: Sequence[Place]) -> None:
    """The head of an arrow: its tip comes first."""
    tip, *back = places
    x = tip[0] - sum(p[0] for p in back) / len(back)
    # Dots are as far from each other upward as across.
    y = sum(p[1] for p in back) / len(back) - tip[1]
    eighth = round(math.atan2(y, x) / (math.pi / 4)) % len(ARROWS)
    fancy = letters(ARROWS[eighth]) == ARROWS[eighth]
    sign = ARROWS[eighth] if fancy else PLAIN_ARROWS[eighth]
    if sign.strip():
        _sign(canvas, (tip[0] - 0.4 * x, tip[1] + 0.4 * y), sign)
    else:
        canvas.stroke(places[1], tip)
        canvas.stroke(places[2], tip)


def _sign(canvas: Canvas, at: Place, sign: str) -> None:
    canvas.put(round(at[0]) // ACROSS, round(at[1]) // DOWN, sign)


def _headed(panel: _Block, head: Sequence[str]) -> _Block:
    wide = max(map(len, (*head, "")))
    return _Block((*head, *panel.lines), max(wide, panel.columns), panel.middle + len(head))


def _beside(blocks: Sequence[_Block], between: Sequence[str]) -> list[str]:
    """`between`: what stands between two of them, all as wide."""
    rows: list[str] = []
    middle = max(b.middle for b in blocks)
    for k, parts in enumerate(zip_longest(*(b.lines for b in blocks), fillvalue="")):
        gaps = between if k == middle else [" " * len(gap) for gap in between]
        padded = [part.ljust(b.columns) for part, b in zip(parts, blocks, strict=True)]
        rows.append("".join(gap + part for gap, part in zip(["", *gaps], padded, strict=True)).rstrip())
    return rows


def _stacked(blocks: Sequence[_Block], between: str) -> list[str]:
    lines = list(blocks[0].lines)
    for sign, block in zip_longest(between, blocks[1:]):
        lines += ["", *([sign, ""] if sign else []), *block.lines]
    return lines
