"""A page with its figures: the arrangement at its top, each pair of diagrams beside its list of forces."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import takewhile

from planar_cli.figures.asked_curves import curve_figures
from planar_cli.figures.centres import Centres
from planar_cli.figures.courses import course_figures
from planar_cli.figures.diagrams import diagram
from planar_cli.figures.followed import asked_over_time, motion_figure
from planar_cli.figures.particle_vectors import vector_figures
from planar_cli.figures.polygons import polygons, polygons_of_states
from planar_cli.figures.scenes import Scenes
from planar_cli.report.document.blocks import (
    Answer,
    Block,
    Check,
    Document,
    Drawing,
    Equation,
    Forces,
    Heading,
    Paragraph,
    Table,
)
from planar_cli.report.document.graphs import Curve, Graph
from planar_cli.report.document.marks import Figure
from planar_cli.report.document.mentioned import names_in
from planar_cli.report.motion.read_off import INTEGRATED, UNIFORM_MOTION
from planar_cli.solve.solved_problem import Solution

POLYGONS = ("velocities", "accelerations")
CASE, STATE = "CASE", "STATE"
"""The labels over a case and over a state, whose name is the text."""


def illustrated(document: Document, solution: Solution) -> Document:
    """The worked solution of a file with what a lecturer would draw beside it."""
    return replace(document, blocks=tuple(_drawn_once(_blocks(document, solution))))


def _drawn_once(blocks: Iterable[Block]) -> Iterator[Block]:
    """Without figures that show again what stands above: a blow of which a case repeats all diagrams, a polygon that a
    later step tells with numbers.
    """
    seen = set[str]()
    for block in blocks:
        # Letters that are spelled alike look the same, whatever is known of them.
        looks = {repr(block.figure)} if isinstance(block, Drawing) else set[str]()
        parts = {repr(p) for p in block.figure.panels} if isinstance(block, Drawing) else set[str]()
        again = isinstance(block, Drawing) and block.figure.name in POLYGONS and parts <= seen
        if not (looks and looks <= seen) and not again:
            yield block
        seen |= looks | parts


def _blocks(document: Document, solution: Solution) -> Iterator[Block]:
    scenes = Scenes(solution)
    first = scenes.first
    instants = {
        part.case.replace("_", " "): part.instants for part in solution.parts if not part.motion and part.instants
    }
    case = instants.get("", ())
    instant, step = next(iter(case), None), list[Block]()
    graphs, centres, motions = _Graphs(solution), Centres(solution, document.blocks), _Motions(solution)
    vectors = _Vectors(solution, document.blocks)
    for place, block in enumerate(document.blocks):
        if first is not None and not isinstance(block, Paragraph):
            yield Drawing(first)
            first = None
        if isinstance(block, Heading | Answer):
            above = document.blocks[:place]
            yield from map(Drawing, centres.told(step, instant))
            yield from map(Drawing, polygons(step, instant) if instant is not None else motions.polygons(above, step))
            ended = isinstance(block, Answer) or block.label == CASE
            yield from map(Drawing, vectors.figures(above, step, ended))
            if ended:
                yield from map(Drawing, motions.graphs(above))
            if isinstance(block, Answer):
                yield from map(Drawing, centres.told(_checks(document.blocks[place:]), instant))
                yield from map(Drawing, centres.asked(instant))
            step = []
            if isinstance(block, Heading) and block.label == CASE:
                case = instants.get(block.text, ())
                instant = next(iter(case), None)
            if isinstance(block, Heading) and block.label == STATE:
                instant = next((i for i in case if i.state == block.text), instant)
        step.append(block)
        yield block
        if isinstance(block, Heading) and block.label == CASE:
            yield from map(Drawing, scenes.of_case(block.text))
        below = document.blocks[place + 1 :]
        if isinstance(block, Forces) and (figure := diagram(block, below, solution)) is not None:
            yield Drawing(figure)
        if (graph := graphs.after(block)) is not None:
            yield Drawing(graph)
    yield from map(Drawing, centres.told(step, instant))


def _checks(blocks: Sequence[Block]) -> list[Block]:
    """Those under the answer at which some blocks begin: what they reason with is drawn above it."""
    return [b for b in takewhile(lambda b: not isinstance(b, Heading), blocks) if isinstance(b, Check)]


class _Motions:
    """The polygons of each motion at their equations, in its states, and its graphs behind all that tells it."""

    def __init__(self, solution: Solution) -> None:
        self.motions = {p.case.replace("_", " "): p for p in solution.parts if p.motion is not None}
        self.waiting = dict(self.motions)
        """Those without graphs yet."""
        self.curves = set[tuple[Curve, ...]]()
        """Those of graphs that have been drawn."""

    def polygons(self, page: Sequence[Block], step: Sequence[Block]) -> Iterator[Figure]:
        """Of the vector equations of a step. `page`: what stands above, the step too."""
        case, begun, state = _headed(page)
        part = self.motions.get(case)
        if part is not None and part.motion is not None:
            yield from polygons_of_states(begun, step, part.motion, state)

    def graphs(self, page: Sequence[Block]) -> Iterator[Figure]:
        """`page`: what stands above."""
        part = self.waiting.pop(_headed(page)[0], None)
        if part is None or part.motion is None:
            return
        told = list(course_figures(part.motion, part.found, page))
        if not told and part.run is not None:
            asked = asked_over_time(part.motion, part.run, part.found)
            told += [asked] if asked is not None else []
        yield from filter(self._is_new, told)

    def _is_new(self, figure: Figure) -> bool:
        """Is a graph in it that no earlier case has?"""
        curves = {m.curves for panel in figure.panels for m in panel.marks if isinstance(m, Graph)}
        new = bool(curves - self.curves)
        self.curves |= curves
        return new


class _Vectors:
    """The vectors of points at the steps that find them, part by part."""

    def __init__(self, solution: Solution, page: Sequence[Block]) -> None:
        letters = frozenset(name for block in page for name in names_in(block))
        figures = {p.case.replace("_", " "): (*curve_figures(p), *vector_figures(p, letters)) for p in solution.parts}
        self.waiting = {case: list(told) for case, told in figures.items()}

    def figures(self, page: Sequence[Block], step: Sequence[Block], ended: bool) -> Iterator[Figure]:
        """Those whose answers a step has on the left of an equation. `page`: what stands above; `ended`: it is the last
        step, behind which stand those that no step has.
        """
        waiting = self.waiting.get(_headed(page)[0], [])
        found = {name for b in step if isinstance(b, Equation) for name in names_in(b.sides[0])}
        for told in list(waiting):
            if ended or told[0] & found:
                waiting.remove(told)
                yield told[1]


def _headed(page: Sequence[Block]) -> tuple[str, Sequence[Block], str]:
    """The case in which the end of some blocks stands, the blocks of it, and the state that they tell; "": none."""
    case, begun, state = "", page, ""
    for i, block in enumerate(page):
        if isinstance(block, Heading) and block.label == CASE:
            case, begun, state = block.text, page[i:], ""
        if isinstance(block, Heading) and block.label == STATE:
            state = block.text
    return case, begun, state


class _Graphs:
    """The graph behind the table of each motion that was followed, as the blocks of a page go by."""

    def __init__(self, solution: Solution) -> None:
        self.waiting = [part.followed for part in solution.parts if part.followed is not None]
        self.integrated = False

    def after(self, block: Block) -> Figure | None:
        if isinstance(block, Heading) and block.text in (INTEGRATED, UNIFORM_MOTION):
            self.integrated = block.text == INTEGRATED
            if not self.integrated:
                del self.waiting[:1]
        if not isinstance(block, Table) or not self.integrated or not self.waiting:
            return None
        self.integrated = False
        return motion_figure(self.waiting.pop(0))


def figures_of(document: Document) -> Iterator[tuple[str, Figure]]:
    """The figures of an illustrated page with names for files: scene, then the bodies of the diagrams."""
    seen: dict[str, int] = {}
    before: Block = Heading("", "")
    for block in document.blocks:
        if isinstance(block, Drawing):
            name = before.body if isinstance(before, Forces) else block.figure.name
            seen[name] = seen.get(name, 0) + 1
            yield name if seen[name] == 1 else f"{name}-{seen[name]}", block.figure
        before = block
