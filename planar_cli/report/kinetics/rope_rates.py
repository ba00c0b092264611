"""The accelerations along a rope of which free parts turn, in numbers: l̈ = a·e + v_⊥²/l of each part.

A page of numbers would hide the lengths of the parts in its factors: with their names, AC = 5 ft, the line is one that
can be followed.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Anchor, Row, Segment
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, line
from planar_cli.report.equations.numeric import NumericTelling
from planar_cli.report.kinematics.rope_lengths import KEEPS
from planar_cli.report.notation.clean import is_clean
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.units import LENGTH

LONGEST = 24
"""Longer rates are told by their numbers alone."""

Part = tuple[sp.Symbol, sp.Expr]
"""The name of a length with what it is."""


def rope_told(
    w: Written, stage: Stage, numeric: NumericTelling, system: System, number: int, zero: Collection[sp.Symbol]
) -> list[Block]:
    """What the rope demands of the accelerations and the one that follows; nothing where another rate is told.
    `zero`: what vanishes.
    """
    rows = [row for mode in system.modes.values() for row in mode.facts.rows if row.title == w.lead]
    found = next((x for b in stage.blocks for x in b.lines if x.equations == (w.number,) and not x.letters), None)
    if w.source != "row" or stage.level == "velocity" or len(rows) != 1 or not w.lead.endswith(KEEPS) or found is None:
        return []
    if not numeric.put_whole(w, stage) or any(s.length is None for s in rows[0].segments):
        return []
    parts = dict(_named(rows[0], system))
    rate = _rate(rows[0], parts, system)
    rest = None if rate is None else _rest(rate.xreplace(dict.fromkeys(zero, sp.S.Zero)), parts, found, w, numeric)
    return [] if rest is None else list(_lines(rest, parts, found, w, numeric, stage, number))


def _named(row: Row, system: System) -> Iterator[Part]:
    """The lengths of the free parts that turn, by the names of their ends."""
    for segment in row.segments:
        if _across(segment, system) != 0:
            names = [_name(end, system) for end in (segment.start, segment.end)]
            yield sp.Symbol("".join(names) if all(names) else "", positive=True), sp.sympify(segment.length)


def _name(end: Anchor, system: System) -> str:
    """The name of a point where a part of the rope ends; empty: it has none, or a long one."""
    scene, is_zero = system.scene, system.scene.is_zero
    here = (n for n, p in scene.points.items() if is_zero(p.x - end.point.x) and is_zero(p.y - end.point.y))
    return next((n for n in here if "_" not in n and len(n) == 1), "")


def _across(segment: Segment, system: System) -> sp.Expr:
    """The velocity of one end of a part as seen from the other, across it."""
    motion = system.motion or system.first
    start, end = (motion.velocity(a.point, a.body) for a in (segment.start, segment.end))
    found = sp.sympify((end - start).dot(segment.direction.turned()))
    return -found if found.could_extract_minus_sign() else found


def _rate(row: Row, parts: dict[sp.Symbol, sp.Expr], system: System) -> sp.Expr | None:
    """The second derivative of the length of the rope, with the names of lengths; None: a part has none."""
    motion, turning = system.motion, sum(_across(s, system) != 0 for s in row.segments)
    if motion is None or row.pulls or row.spins or row.slides or not turning or len(parts) < turning:
        return None
    names, total = iter(parts), sp.S.Zero
    for segment in row.segments:
        start, end = (motion.acceleration(a.point, a.body) for a in (segment.start, segment.end))
        across = _across(segment, system)
        total += sp.expand((end - start).dot(segment.direction))
        if across != 0:
            name = next(names)
            if not name.name:
                return None
            total += sp.Pow(across, 2, evaluate=False) / name
    return sp.sympify(total)


def _rest(
    rate: sp.Expr, parts: dict[sp.Symbol, sp.Expr], found: SolvedLine, w: Written, numeric: NumericTelling
) -> tuple[sp.Expr, sp.Expr] | None:
    """c and r of c · letter = r, with c > 0; None: it is not the equation, or its numbers are no plain ones."""
    value, factor = numeric.phrases.value, rate.coeff(found.symbol, 1)
    rest = factor * found.symbol - rate
    whole = rate.xreplace(parts)
    same = any(value.vanishes(whole - sign * w.residual) for sign in (1, -1))
    if factor == 0 or not factor.is_Rational or found.symbol in rest.free_symbols or not same or longer(rest, LONGEST):
        return None
    if not is_clean(numeric.phrases.ledger, rest.subs(dict.fromkeys(parts, 1))):
        return None
    return abs(factor), rest if factor > 0 else -rest


def _lines(
    equation: tuple[sp.Expr, sp.Expr],
    parts: dict[sp.Symbol, sp.Expr],
    found: SolvedLine,
    w: Written,
    numeric: NumericTelling,
    stage: Stage,
    number: int,
) -> Iterator[Block]:
    """The equation, and what follows from it."""
    phrases, (factor, rest) = numeric.phrases, equation
    lengths = {name: phrases.of_dimension(phrases.value(size), LENGTH) for name, size in parts.items()}
    told = [piece for name, size in lengths.items() for piece in (", ", Name(name.name), " = ", size)]
    numeric.told(w, stage)
    called = f"{w.lead[:1].upper()}{w.lead[1:]}"
    rate = line("l̈ = a·e + v", Name("_⊥"), "²/l")
    yield Paragraph(line(f"{called}; of a part that turns ", *rate, ", e along it, v_⊥ across it", *told, ":"))
    sizes = {name: value.number for name, value in lengths.items()}
    if factor != 1:
        yield Equation((Math(factor * found.symbol), Math(rest)), number)
    solved = rest / factor
    put = phrases.numbers(solved, sizes, turns=False)
    sides = (phrases.math(found.symbol), Math(solved), *([] if put is None else [put]))
    lead = line(f"({number}):") if factor != 1 else ()
    yield Equation((*sides, phrases.shown(found.symbol, found.value)), None if lead else number, lead)
