"""The graphs of a motion that was integrated in closed form: the acceleration of each coordinate over its velocity over
its place, with one axis of time, the states on them and what was found there.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from itertools import pairwise

import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.figures.laws_traced import Instant, Traced, traced
from planar_cli.figures.letters_on_axes import SOME, in_letters, places_of, rests_on_letters, times_of
from planar_cli.figures.over_time import FIGURES, LOW, NEAR, NOISE, WIDE, unit_words
from planar_cli.report.document.blocks import Block, Line, Name, Value, line
from planar_cli.report.document.graphs import Curve, Dot, Graph, Scaled, Spot
from planar_cli.report.document.marks import Figure, Panel
from planar_cli.report.document.mentioned import names_in
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.law import Law
from planar_cli.solve.solution import Found
from planar_cli.units import Unit, parse_unit

MOST = 3
"""So many curves in one graph."""
TURNS, DENSE = 16, 48
"""A vibration that turns round more often is drawn from there on: before that its curve would be a dark band. With
states on the way it is drawn whole, as long as its turns can be told apart.
"""
SHOWN = 720
"""Places of a curve, about."""
RATES = {"v": "a", "omega": "alpha"}
"""The letters of speeds, and of their rates."""
GIVEN = "motion"
"""The kind of a relation by which the file gives a motion."""
LEVELS: Mapping[str, tuple[Callable[[Instant], float], str]] = {
    "a": (lambda i: i.a, "/s^2"),
    "v": (lambda i: i.v, "/s"),
    "q": (lambda i: i.q, ""),
}
"""What is drawn of a coordinate, from the top down, and what that is measured in beside its own unit."""
Names = Mapping[str, str]


def course_figures(motion: MotionTrace, found: Sequence[Found], page: Sequence[Block]) -> Iterator[Figure]:
    """The graphs of one part: of lengths and of angles apart. `found`: its answers; `page`: what stands above."""
    coordinates = dict.fromkeys(law.coordinate.symbol for law in _laws(motion))
    ways = [c for q in coordinates if (c := traced(motion, q)) is not None]
    for unit in dict.fromkeys(c.law.coordinate.unit for c in ways):
        alike = [_last_turns(c) for c in ways if c.law.coordinate.unit == unit][:MOST]
        if not _says_something(alike):
            continue
        names = frozenset(name for block in page for name in names_in(block))
        graphs, note = _graphs(motion, alike, found, names), line(SOME) if rests_on_letters(motion, alike) else ()
        yield Figure((Panel(tuple(graphs)),), f"The motion of {motion.problem.title}", name="motion", note=note)


def _laws(motion: MotionTrace) -> Iterator[Law]:
    """The laws that the page integrates, in formulas or in numbers, and those of what is given over the time."""
    if motion.guessed:
        yield from (law for _, _, own in motion.stretches for law in own)
    relations = [r for step in motion.route.steps for r in step.relations]
    yield from (r.law for r in relations if r.law is not None)
    if any(r.kind == GIVEN for r in relations):
        clock = next((g for g in motion.general.values() if g.name == "t"), None)
        laws = [law for _, _, own in motion.stretches for law in own]
        yield from (law for law in laws if law.order == 1 and clock in law.f.free_symbols)


def _says_something(ways: Sequence[Traced]) -> bool:
    """Is it more than one constant acceleration or velocity of one body?"""
    bodies = {c.law.coordinate.body for c in ways}
    return any(_varies([c], "a") for c in ways) or (len(bodies) > 1 and _varies(ways, "v"))


def _varies(ways: Sequence[Traced], level: str) -> bool:
    """Does something change in time?"""
    of, _ = LEVELS[level]
    for c in ways:
        values = [of(i) for piece in c.pieces for i in piece]
        usual = max(map(abs, values)) if level != "q" else max(abs(i.q) for p in c.pieces for i in p)
        if max(values) - min(values) > max(NOISE * usual, 1e-12):
            return True
    return False


def _last_turns(way: Traced) -> Traced:
    """The end of a long vibration, in as many places as a picture needs."""
    every = [i for piece in way.pieces for i in piece]
    turns = [b.t for a, b in pairwise(every) if a.v * b.v < 0]
    since = turns[-TURNS] if len(turns) > TURNS else every[0].t
    if len(turns) <= DENSE and any(every[0].t < i.t < since for _, i in way.states):
        since = every[0].t
    kept = [[i for i in piece if i.t >= since] for piece in way.pieces]
    each = 1 + sum(map(len, kept)) // SHOWN
    pieces = tuple((*p[:-1:each], p[-1]) for p in kept if p)
    return replace(way, pieces=pieces, states=tuple(s for s in way.states if s[1].t >= since))


# --- graphs -----------------------------------------------------------------------------------------------------------


def _graphs(motion: MotionTrace, ways: Sequence[Traced], found: Sequence[Found], names: frozenset[str]) -> list[Graph]:
    letters = frozenset(name.split("__", 1)[0] for name in names)
    lettered = rests_on_letters(motion, ways)
    drawn = [level for level in LEVELS if _varies(ways, level) and (level != "q" or _places_matter(motion, ways))]
    times = [i.t for c in ways for piece in c.pieces for i in piece]
    across = Scaled(line(Name("t")), "s", min(times), max(times))
    across = in_letters(across, times_of(motion, ways, names)) if lettered else across
    graphs: list[Graph] = []
    for row, level in enumerate(drawn):
        last = row == len(drawn) - 1
        unit, one = _unit(motion, ways[0].law, level, found)
        curves, dots = list[Curve](), list[tuple[str, Spot, Line]]()
        for c in ways:
            named = line(Name(_letter(c.law, level, letters, len(ways) > 1)))
            curves.append(Curve(tuple(_pieces(c, level, one)), named))
            values = _values(motion, c.law, level, found, last and c is ways[0])
            dots += _dots(c, level, one, values)
        spots = [y for curve in curves for piece in curve.pieces for _, y in piece]
        words = curves[0].words if len(curves) == 1 else line(Name({"a": "a", "v": "v"}.get(level, _stem(ways[0].law))))
        up = Scaled(words, unit_words(unit), min(spots), max(spots))
        if lettered:
            called = {c: _letter(c.law, level, letters, len(ways) > 1) for c in ways}
            up = in_letters(up, (m for c, x in called.items() for m in places_of(motion, c, level, x, names, one)))
        near = (NEAR * (across.high - across.low), 3 * NEAR * (up.high - up.low))
        graphs.append(Graph(across, up, tuple(curves), tuple(_marked(dots, near)), row, size=(WIDE, LOW)))
    return graphs


def _stem(law: Law) -> str:
    return str(law.coordinate.symbol.name).split("_", 1)[0]


def _unit(motion: MotionTrace, law: Law, level: str, found: Sequence[Found]) -> tuple[Unit, float]:
    """In which it is drawn, with how many base units one of it is: angles in that of the answers."""
    us = motion.problem.us
    own = "rad" if law.coordinate.unit == "rad" else "ft" if us else "m"
    own = law.coordinate.shown if level == "q" and law.coordinate.shown not in ("", "m") else own
    own = "deg" if level == "q" and own == "rad" and any(f.unit.text == "deg" for f in found) else own
    unit = parse_unit(f"{own}{LEVELS[level][1]}")
    return unit, in_base(unit, us)


def _places_matter(motion: MotionTrace, ways: Sequence[Traced]) -> bool:
    """Is there a way or an angle in what is asked, or on the way to it?"""
    own = {c.law.coordinate.symbol for c in ways}
    used = {s for step in motion.route.steps for s in (*step.unknowns, *step.needs) if not step.is_datum}
    used |= {s for r in motion.requests for e in r.parts for s in sp.sympify(e).free_symbols}
    return any(motion.general.get(s, s) in own for s in used)


def _pieces(way: Traced, level: str, one: float) -> Iterator[tuple[Spot, ...]]:
    """What goes on without a jump in one piece."""
    of, _ = LEVELS[level]
    pieces = [[(i.t, of(i) / one) for i in piece] for piece in way.pieces]
    size = max(abs(y) for piece in pieces for _, y in piece)
    joined: list[list[Spot]] = []
    for piece in pieces:
        if joined and abs(joined[-1][-1][1] - piece[0][1]) <= 1e-6 * size:
            joined[-1] += piece[1:]
        else:
            joined.append(piece)
    return (tuple(p) for p in joined)


def _dots(way: Traced, level: str, one: float, values: Mapping[str, Line]) -> Iterator[tuple[str, Spot, Line]]:
    """The states on a curve, each with its words: what was found in it stands behind its name."""
    of, _ = LEVELS[level]
    for name, i in way.states:
        told = values.get(name, ())
        yield name, (i.t, of(i) / one), line(name.replace("_", " "), *((": ", *told) if told else ()))


def _marked(dots: Sequence[tuple[str, Spot, Line]], near: Spot) -> Iterator[Dot]:
    """Dots of which those at nearly one place are one; where a curve has its name already, it has none on another one,
    unless something was found there. `near`: how far that is along both axes.
    """
    told: dict[str, Line] = {}
    places: list[tuple[Spot, list[Line]]] = []
    for name, (t, y), words in dots:
        again = told.setdefault(name, words) is not words
        if again and (len(words) == 1 or words == told[name]):
            continue
        here = next((p for p in places if abs(p[0][0] - t) <= near[0] and abs(p[0][1] - y) <= near[1]), None)
        if here is None:
            places.append(((t, y), [words]))
        elif again and told[name] in here[1]:
            here[1][here[1].index(told[name])] += words[1:] if len(told[name]) == 1 else line(", ", *words[2:])
        else:
            here[1].append(words)
    for spot, several in places:
        yield Dot(spot, line(*(p for w in several for p in (", ", *w)))[1:])


def _values(motion: MotionTrace, law: Law, level: str, found: Sequence[Found], times: bool) -> dict[str, Line]:
    """What the page answers of it, by the state: a place, a velocity; `times`: when it comes there, too."""
    answers, told, dates = {f.name: f for f in found}, dict[str, Line](), dict[str, Line]()
    for request in motion.requests:
        answer = answers.get(request.find.name)
        if answer is None or answer.values is None or len(request.parts) != 1 or len(answer.values) != 1:
            continue
        asked = sp.sympify(request.parts[0])
        # Since a state at t = 0, or from a place at 0, it is as long or far as the other state is.
        begun = {x: sp.S.Zero for x in asked.free_symbols if motion.value.known(x) == 0}
        for sign in (1, -1):
            x = sign * asked.xreplace(begun)
            general = motion.general.get(x) if x.is_Symbol else None
            state = motion.ledger.roles[x].at if general is not None else None
            if general is None or not state:
                continue
            own = (level == "q" and general == law.coordinate.symbol) or (level == "v" and general == _speed(law))
            turned = sign * (int(law.coordinate.factor) if own and level == "v" else 1)
            value = turned * answer.values[0] / Decimal(repr(in_base(answer.unit, motion.problem.us)))
            number = Value(value, answer.unit.text, FIGURES)
            if own:
                told.setdefault(state, line(number))
            elif times and sign == 1 and general.name == "t":
                dates.setdefault(state, line(Name("t"), " = ", number))
    return told | {s: line(*told[s], ", ", *date) if s in told else date for s, date in dates.items()}


def _speed(law: Law) -> sp.Symbol | None:
    """The speed that its rate is, but for the sign."""
    same = law.coordinate.extra == 0 and abs(law.coordinate.factor) == 1
    return law.coordinate.speed if same else None


# --- letters ----------------------------------------------------------------------------------------------------------


def _letter(law: Law, level: str, letters: frozenset[str], several: bool) -> str:
    """The name of a coordinate, of its rate or second rate, as the page has it."""
    q, own = str(law.coordinate.symbol.name), _speed(law)
    speed = str(own.name) if own is not None and law.coordinate.factor == 1 else ""
    rate = next((new + speed.removeprefix(old) for old, new in RATES.items() if speed.startswith(old)), "")
    wished = {"q": (q,), "v": (speed, f"{q}_dot"), "a": (rate, f"{q}_ddot")}[level]
    names = [name for name in wished if name]
    for name in names:
        if name in letters:
            return name
    if several:
        return names[0]
    # On a page of one body its letters have no index.
    short = [re.sub("_(?!dot|ddot).*?(?=_dot|_ddot|$)", "", name) for name in names]
    usual = names[0] if q in letters else short[0]
    return next((name for name in short if name in letters), usual)
