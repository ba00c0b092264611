"""The figure of a sheet: the scene as the file gives it, with the motion that it gives and nothing that is to be found.

No solution is asked: the scene is set up from the file alone. What stands where something sought would tell is left
out, as is every direction that is sought; later states and paths are not drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.system.setup import Setup
from planar_cli.equation.system.system import Statements
from planar_cli.errors import PlanarError
from planar_cli.figures.arrangement import arranged
from planar_cli.figures.broken import scene
from planar_cli.figures.drawn import Drawn, words_of
from planar_cli.problem.language import expression
from planar_cli.problem.language.walk import walk
from planar_cli.problem.nodes.placeholders import PLACEHOLDER
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.report.document.blocks import Inline, Line, Math, Name, Text
from planar_cli.report.document.marks import Arrow, Axes, Dimension, Figure, Mark, Panel, Symbol, Tag, Turn

MOTION = ("velocity", "acceleration")


@record
class GivenDrawn(Drawn):
    """A scene in numbers as far as the file gives them."""

    def number(self, expr: Any) -> float | None:
        placed = sp.sympify(expr)
        return None if _rests_on_sought(self.scene.ledger, placed) else Drawn.number(self, placed)


@record
class _Given:
    """A scene on paper; `placed`: it is given where all bodies are, and how they are turned; `seen`: there is more to
    be seen than one thing at its place, and how that moves.
    """

    panel: Panel
    placed: bool
    seen: bool


def handed_out(problem: Problem) -> Figure | None:
    """What a sheet shows of a problem, in the position of a case where the file itself does not give all places; None:
    hardly anything can be drawn of what is given.
    """
    own, *cases = (_given(part) for part in (problem, *(c.problem for c in problem.cases)))
    found = [one for one in (own, *cases) if one is not None and one.seen]
    if found:
        # The first of those that show as much.
        best = max(found, key=lambda one: (one.placed, 0 if one.placed else len(one.panel.marks)))
        panel = _with_shared(best.panel, cases) if best is own else best.panel
    else:
        # A body alone is seen by the motion that it is given at first.
        first = next((one for one in (own, *cases) if one is not None), None)
        if first is None or not _moves(first.panel):
            return None
        panel = first.panel
    return scene(panel, problem.title)


def _with_shared(panel: Panel, cases: Sequence[_Given | None]) -> Panel:
    """The scene of the file, with what moves alike in all its cases; one in which a place is sought cannot tell."""
    panels = [case.panel for case in cases if case is not None and case.placed]
    if not panels or None in cases:
        return panel
    shared = [m for m in _moves(panels[0]) if m not in panel.marks and all(m in other.marks for other in panels)]
    return replace(panel, marks=(*panel.marks, *shared))


def _moves(panel: Panel) -> list[Mark]:
    """Velocities, accelerations and rotations."""
    return [m for m in panel.marks if isinstance(m, Arrow | Turn) and m.style in MOTION]


def _given(problem: Problem) -> _Given | None:
    """The scene of a problem, or of a case, as it is given."""
    # What is told by the time is open here, as any place is that is sought.
    laws = (law.statement for law in problem.motion)
    always = tuple(s for s in laws if not any(isinstance(n, expression.Name) and n.name == "t" for n in walk(s)))
    now = problem.instant or (problem.states[0].relations if problem.states else ())
    try:
        scene = Setup(problem, Statements.of(always, now), {}, open_form=False).scene
        drawn = GivenDrawn(scene, scene.valuations[0], {})
        panel = arranged(drawn)
    except PlanarError:
        # Where places rest on what an earlier case finds, the text has to tell the scene.
        return None
    placed = all(
        drawn.number(part) is not None for b in scene.bodies.values() for part in (b.center.x, b.center.y, b.theta)
    )
    return _Given(panel, placed, _is_seen(panel))


def letters_told(figure: Figure, problem: Problem) -> Line:
    """The letters of a figure with their values, of those that the text of the sheet tells by their values alone."""
    said = set(PLACEHOLDER.findall(problem.text))
    drawn = {n for panel in figure.panels for m in panel.marks for p in getattr(m, "words", ()) for n in _names(p)}
    told: list[Inline] = []
    for one in problem.given:
        words = words_of(one.value) if one.value is not None else ()
        if one.name in said & drawn and words:
            told += [Text(", " if told else "In the figure: "), Name(one.name), Text(" = "), *words]
    return tuple(told)


def _names(piece: Inline) -> Iterator[str]:
    match piece:
        case Name(name):
            yield name
        case Math(expr):
            yield from (str(s) for s in expr.free_symbols)


def _is_seen(panel: Panel) -> bool:
    """Is there more to be seen than one thing at its place, and how that moves?"""
    still = [m for m in panel.marks if not isinstance(m, Axes | Tag | Dimension)]
    moves = _moves(panel)
    told = [m for m in still if m not in moves]
    return len({m.at for m in told if isinstance(m, Symbol)}) > 1 or any(not isinstance(m, Symbol) for m in told)


def _rests_on_sought(ledger: Any, expr: Any) -> bool:
    """Does an expression rest on something that is sought, or on what has no value at all?"""
    known = {**ledger.values, **ledger.definitions}
    open_, seen = list(expr.free_symbols), set()
    while open_:
        symbol = open_.pop()
        if symbol in seen:
            continue
        seen.add(symbol)
        if symbol in known:
            open_ += known[symbol].free_symbols
        elif symbol not in ledger.letters:
            return True
    return False
