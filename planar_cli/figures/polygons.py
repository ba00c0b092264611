"""Polygons of velocities and of accelerations: every vector equation of a page, to scale, from one pole.

Velocities and accelerations of points begin at the pole o; what they are made of lies between their tips, v_B/A, v_rel,
α × r and -ω² r, 2 ω × v_rel. Vectors along one line lie side by side. What is zero, or too short to be seen, is told.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from planar_cli.figures.drawn import Drawn
from planar_cli.figures.rings import off, way_of
from planar_cli.figures.vector_sums import vector_sums
from planar_cli.figures.vector_terms import Sum, Term
from planar_cli.figures.vector_values import Closed, Values
from planar_cli.report.document.blocks import Block, Inline, Line, Math, Name, Text, line
from planar_cli.report.document.marks import Figure, Mark, Panel, Span, Spot, Style, Symbol, Tag
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.solution import InstantSolution

STYLES: dict[str, Style] = {"v": "velocity", "a": "acceleration"}
KINDS = {"v": "velocities", "a": "accelerations"}
POLE: Spot = (0.0, 0.0)
SMALL, NIL = 0.03, 1e-9
"""A vector that is smaller than this part of the largest one is too short to be drawn, or is zero."""
BESIDE, LEVEL, UPRIGHT, LETTER = 6.0, 24.0, 16.0, 7.0
"""So far beside one another vectors along one line lie on paper, px; where all do, with room for what stands beside
each: for a row of letters, or for so much and the width of so many letters.
"""
TINY, LARGER = 0.2, "to a larger scale than the others"
"""So small beside the largest polygon of a figure another one is not read."""
TOUCH = 0.15
BETWEEN = re.compile(r"_rel$|_cor$|/")
"""What lies between the tips of others."""
CENTRE, MANY = re.compile(r"[va]_G(,|_|$)"), 9
"""A vector of a mass centre; more vectors than this are no single polygon if they can be told apart."""
ON = 1e-6
"""What is so near to a line, in parts of the largest vector, lies on it."""


def polygons(blocks: Sequence[Block], instant: InstantSolution) -> list[Figure]:
    """The polygons of the vector equations among some blocks, of velocities and of accelerations."""
    return _figures(closed_sums(blocks, with_all_numbers(instant)))


def with_all_numbers(instant: InstantSolution) -> InstantSolution:
    """Also with those that the page has no need of: α of a body whose equation is taken across it."""
    if not instant.trial.outcomes:
        return instant
    numbers = unknowns_of(instant.trial.system, instant.trial.outcomes[0])
    value = instant.value.extended({s: x for s, x in numbers.items() if instant.value.known(s) is None})
    return replace(instant, value=value)


def _figures(found: Sequence[Closed]) -> list[Figure]:
    made = ((letter, _panels(found, letter)) for letter in STYLES)
    return [_figure(panels, letter) for letter, panels in made if panels]


def _panels(found: Sequence[Closed], letter: str) -> list[Panel]:
    """One polygon; where it has so many vectors that none would be found, that of mass centres by itself."""
    whole = _panel(found, letter)
    if whole is None or sum(isinstance(m, Span) for m in whole.marks) <= MANY:
        return [whole] if whole is not None else []
    inner = [c for c in found if CENTRE.match(c.sum.name)]
    outer = _panel([c for c in found if c not in inner], letter)
    centres = _panel(inner, letter, " of mass centres")
    return [whole] if outer is None or centres is None else [outer, centres]


def polygons_of_states(
    page: Sequence[Block], step: Sequence[Block], motion: MotionTrace, state: str = ""
) -> Iterator[Figure]:
    """The polygons of the vector equations of a step in a state of a motion that it tells, or in the one that has no
    name; "": those in all its states, side by side to one scale, of accelerations where something moves along what
    turns. `page`: with the equations above, on which these may rest.
    """
    alone = bool(state) or motion.states == ("",)
    sums = vector_sums(step)
    moving = any(t.kind == "doubled" or t.name == "coriolis" for s in sums for t in s.terms)
    own = {repr(s): s.letter for s in sums if alone or moving or s.letter == "v"}
    if not any(len(s.terms) > 1 and repr(s) in own for s in sums):
        return
    names = [s for s in motion.states if s == state or not state]
    if alone:
        yield from next((f for name in names for c in _closed_in(page, own, motion, name) if (f := _figures(c))), [])
        return
    for letter in dict.fromkeys(own.values()):
        found = list[Panel]()
        for name in names:
            words = f" in state {name.replace('_', ' ')}"
            made = (_panel(c, letter, words) for c in _closed_in(page, own, motion, name))
            panel = next((p for p in made if p is not None), None)
            # What stays as it was is drawn once.
            found += [panel] if panel is not None and all(not _alike(panel, p) for p in found) else []
        yield from _by_scales(found, letter)


def _by_scales(panels: Sequence[Panel], letter: str) -> Iterator[Figure]:
    """Those of the states side by side; but what would be tiny beside the others in a figure of its own."""
    sizes = [max((_length(m) for m in p.marks if isinstance(m, Span)), default=0.0) for p in panels]
    large = [p for p, size in zip(panels, sizes, strict=True) if size >= TINY * max(sizes)]
    for panel in panels:
        if panel not in large:
            yield replace(_figure([panel], letter), note=line(LARGER))
        elif panel is large[0]:
            yield _figure(large, letter)


def _closed_in(page: Sequence[Block], own: Collection[str], motion: MotionTrace, state: str) -> Iterator[list[Closed]]:
    """The sums in a state, by each of the regimes that begin or end there."""
    # Few pages have them.
    from planar_cli.report.instant.at_state import placed

    for regime in motion.regimes:
        if any(state in stretch for stretch in regime.stretches):
            yield [*_of(own, closed_sums(page, placed(regime.solution, motion, state)))]


def _of(own: Collection[str], sums: Sequence[Closed]) -> Iterator[Closed]:
    return (c for c in sums if repr(c.sum) in own)


def _alike(one: Panel, other: Panel) -> bool:
    """Do two polygons have the same vectors?"""
    first, second = ([m for m in p.marks if isinstance(m, Span)] for p in (one, other))
    size = max(map(_length, first), default=0.0)
    pairs = list(zip(first, second, strict=False))
    return len(first) == len(second) and all(
        _key(a.words) == _key(b.words) and math.dist(a.end, b.end) <= ON * size for a, b in pairs
    )


def closed_sums(blocks: Sequence[Block], instant: InstantSolution) -> list[Closed]:
    """The vector equations among some blocks, in numbers."""
    system = instant.trial.system
    sums: list[Sum] = vector_sums(blocks) if system.motion is not None else []
    if not any(len(s.terms) > 1 for s in sums):
        return []
    drawn = Drawn(instant.instant.scene, instant.value, {})
    return Values(drawn, system.quantities(), blocks).closed(sums)


def _figure(panels: Sequence[Panel], letter: str) -> Figure:
    return Figure(tuple(panels), f"polygon of {KINDS[letter]}", name=KINDS[letter])


def _panel(found: Sequence[Closed], letter: str, at: str = "") -> Panel | None:
    """Nothing where no vector is a sum of others. `at`: in which state."""
    sums = [c for c in found if c.sum.letter == letter]
    spans = _once([s for c in sums for s in _spans(c, STYLES[letter])])
    largest = max((_length(s) for s in spans), default=0.0)
    seen = [s for s in spans if _length(s) > SMALL * largest]
    if not any(len([v for _, v in c.parts if math.hypot(*v) > SMALL * largest]) > 1 for c in sums):
        return None
    nil = [s.words for s in spans if _length(s) <= NIL * largest]
    short = [s.words for s in spans if NIL * largest < _length(s) <= SMALL * largest]
    marks: list[Mark] = [*_beside(seen, largest), Symbol("point", POLE), Tag(POLE, line("o"))]
    head = line(f"polygon of {KINDS[letter]}{at}, pole o", *_told(nil, " = 0"), *_told(short, ""))
    head += line(" too short to be seen") if short else ()
    return Panel(tuple(marks), head)


def _once(spans: Sequence[Span]) -> list[Span]:
    """Vectors of one place as one, with all their names: v_P′ = v_P/O."""
    found: dict[tuple[object, ...], dict[str, Span]] = {}
    size = max(map(_length, spans), default=0.0)
    for span in spans:
        found.setdefault((_round(span.start, size), _round(span.end, size)), {}).setdefault(_key(span.words), span)
    return [_named(list(alike.values())) for alike in found.values()]


def _named(alike: Sequence[Span]) -> Span:
    words = [piece for span in alike for piece in (" = ", *span.words)][1:]
    return replace(alike[0], words=line(*words))


def _told(words: Sequence[Line], end: str) -> Iterator[str | Inline]:
    """`, v_rel = 0`, once each."""
    for own in {_key(w): w for w in words}.values():
        yield from (", ", *own, end)


def _spans(c: Closed, style: Style) -> Iterator[Span]:
    """The vector itself from the pole, and what it is made of, tip to tail."""
    if len(c.parts) > 1 or not BETWEEN.search(c.sum.name):
        yield Span(POLE, c.whole, style, line(Name(c.sum.name)))
    if len(c.parts) == 1:
        return
    tip = POLE
    for term, (x, y) in c.parts:
        start, tip = tip, (tip[0] + x, tip[1] + y)
        yield Span(start, tip, style, _words(term, c.sum))


def _words(term: Term, whole: Sum) -> Line:
    """What a vector is called beside its arrow: v_B/A of ω × r_B/A on one body, and ω AB or α AB otherwise, for its
    size.
    """
    end, start = term.arm
    if term.kind == "named":
        return line(Name(term.name))
    if term.kind in ("cross", "square"):
        if whole.letter == "v" and _on_one_body(whole):
            return line(Name(f"v_{end}/{start}"))
        arm: Inline = Text(f"{start}{end}") if len(start) == len(end) == 1 else Name(f"r_{end}/{start}")
        return line(Math(term.rate), " ", arm)
    kept = [w for w in term.words if not (isinstance(w, Name) and w.name == term.unit)]
    apart = ("" if isinstance(w, Text) and w.text.startswith("/") else " " for w in kept)
    return line(*(p for pair in zip(apart, kept, strict=True) for p in pair))[1:]


def _on_one_body(whole: Sum) -> bool:
    """Is a velocity v_B = v_A + ω × r_B/A of a point B of the body, with no motion along the body besides?"""
    return "′" not in whole.name and all(
        t.kind == "cross" or (t.kind == "named" and not BETWEEN.search(t.name)) for t in whole.terms
    )


def _beside(spans: Sequence[Span], largest: float) -> Iterator[Span]:
    """Each vector beside those on which it would lie."""
    apart = _apart(spans, largest)
    lanes: list[tuple[Span, int]] = []
    for span in spans:
        wide = apart != BESIDE
        taken = {lane for other, lane in lanes if _overlap(span, other, largest, TOUCH if wide else 0.0)}
        lane = next(n for n in (0, 1, -1, *range(2, len(spans) + 2)) if n not in taken)
        lanes.append((span, lane))
        yield replace(span, aside=apart * (lane if _ahead(span) else 0 - lane))


def _apart(spans: Sequence[Span], largest: float) -> float:
    """How far vectors that would lie on each other are drawn apart, px."""
    first, *rest = spans
    if any(off(POLE, way_of(first.start, first.end), s) > ON * largest for one in rest for s in (one.start, one.end)):
        return BESIDE
    if sum(_overlap(first, other, largest) for other in rest) < 1:
        return BESIDE
    slope = abs(math.sin(way_of(first.start, first.end)))
    longest = max(len("".join(map(_letters, s.words))) for s in spans)
    return max(LEVEL * (1 - slope), slope * (UPRIGHT + LETTER * longest), LEVEL / 2)


def _letters(piece: Inline) -> str:
    """About what stands on paper of a piece."""
    match piece:
        case Name(name=name):
            return name.replace("_", "")
        case Math(expr=expr):
            return re.sub(r"[\W_]|omega|alpha", "", str(expr)) + "."
        case _:
            return str(getattr(piece, "text", ""))


def _ahead(span: Span) -> bool:
    """One of both senses of a line."""
    x, y = span.end[0] - span.start[0], span.end[1] - span.start[1]
    return x > ON * abs(y) or (abs(x) <= ON * abs(y) and y > 0)


def _overlap(one: Span, other: Span, largest: float, touch: float = 0.0) -> bool:
    """Do two vectors lie on each other? One that is shorter than `touch`, in parts of the largest, is lost already
    where another one begins.
    """
    if min(_length(one), _length(other)) < touch * largest:
        largest *= -1
    length = _length(one)
    ux, uy = (one.end[0] - one.start[0]) / length, (one.end[1] - one.start[1]) / length
    along, across = [], []
    for x, y in (other.start, other.end):
        dx, dy = x - one.start[0], y - one.start[1]
        along.append(dx * ux + dy * uy)
        across.append(abs(dy * ux - dx * uy))
    on = max(across) <= ON * abs(largest)
    return on and min(max(along), length) - max(min(along), 0.0) > ON * largest


def _length(span: Span) -> float:
    return math.dist(span.start, span.end)


def _key(words: Line) -> str:
    return " ".join(map(repr, words))


def _round(spot: Spot, size: float) -> tuple[str, str]:
    x, y = (f"{0.0 if abs(part) < ON * size else part:.6g}" for part in spot)
    return x, y
