"""A motion whose answers are read off: what is integrated, from where, what happened on the way, and a table."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from decimal import Decimal

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import (
    Block,
    Bullet,
    Check,
    Equation,
    Heading,
    Line,
    Name,
    Paragraph,
    Table,
    Value,
    line,
)
from planar_cli.report.document.mentioned import FOR_EVERY_BODY
from planar_cli.report.given.compared import OTHERWISE, SIGNS
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.sides import said
from planar_cli.report.words.words import Phrases
from planar_cli.simulate.report import transition_words
from planar_cli.simulate.run import Simulation
from planar_cli.simulate.table import table_of
from planar_cli.units import pretty_unit

INTEGRATED, UNIFORM_MOTION = "Numerical integration", "Uniform motion"
"""The headings of such a motion."""
ROWS = 9
MOST_COLUMNS = 7
"""A table of more columns is too wide to be read."""
NOISE = 10.0
"""What is below so many tolerances beside the usual size of its column is the rounding of zero."""
UNIFORM = 1e-8
"""Places that differ by less than this part of the usual size of their column lie on a straight line over the time."""
_POINT = re.compile(r"\((.*)\)")


def phrases_without_letters(figures: int, us: bool) -> Phrases:
    """How numbers are told that rest on no letter. `us`: they are in feet, slugs and seconds."""
    return Phrases(Ledger(us=us), Valuation({}), figures, False)


def read_off_blocks(motion: Simulation, figures: int) -> Iterator[Block]:
    """How the answers came about."""
    run = motion.run
    trajectory = run.trajectory
    constant = list(_constant(motion, figures)) if is_prescribed(run.problem) else []
    yield from constant or _integrated(motion)
    sought = [s.name for s in run.problem.unknowns if s.name in run.settings.values]
    if sought:
        names = " and ".join(sought)
        yield Paragraph(line(f"{names} is found by trial: with this number alone the motion passes all states."))
    yield from () if constant else (_table(motion, figures),)
    happened = [(e.t, f"state {e.name}") for e in trajectory.events]
    happened += [(x.t, transition_words(x)) for x in trajectory.transitions if x.words]
    for t, words in sorted(happened, key=lambda e: e[0]):
        yield Bullet(line(Value(Decimal(repr(t)), "s", figures), f": {words}"))
    for note in trajectory.notes:
        yield Paragraph(line(note))
    yield from _compared(motion, figures)


def _compared(motion: Simulation, figures: int) -> Iterator[Block]:
    """For each relation that is asked: its two sides, with the sign that is true."""
    finds = {f.name: f.found.what for f in motion.run.problem.find}
    for answer in motion.answers:
        what = finds.get(answer.name)
        if isinstance(what, Relation) and len(answer.sides) == 2:
            sign = (SIGNS if answer.word == "true" else OTHERWISE)[what.operator]
            values = (Value(Decimal(repr(v)), answer.unit.text, figures) for v in answer.sides)
            shown = [_named(side, v, figures) for side, v in zip((what.left, what.right), values, strict=True)]
            yield Equation((line(*shown[0], f" {sign} ", *shown[1]),), None, line(Name(answer.name), ":"))


def _named(side: Side, value: Value, figures: int) -> Line:
    """v_2 = 3 m/s; of a number its value alone."""
    named = said(side, figures) if any(isinstance(n, Quantity | Letter) for n in walk(side)) else ()
    return line(*named, " = ", value) if named else line(value)


def _integrated(motion: Simulation) -> Iterator[Block]:
    """What is integrated."""
    trajectory, count = motion.run.trajectory, motion.run.model.layout.count
    rows = sum(len(s.regime.parts.constraints) for s in trajectory.segments[:1] if hasattr(s.regime, "parts"))
    relations = f", together with {rows} relations of the joints between them," if rows else ""
    law = f"{FOR_EVERY_BODY}, {count} equations for {count} accelerations{relations} is"
    if is_prescribed(motion.run.problem):
        law = "What is prescribed gives the velocities at every instant, with no forces in it; they are"
    yield Heading("STEP 1", INTEGRATED)
    yield Paragraph(line(f"{law} integrated numerically from the first state on; the answers are read off."))


def is_prescribed(problem: Problem) -> bool:
    """Does `motion` alone drive it, so that there is no Newton's law to write?"""
    massless = all(b.mass is None and b.weight is None and not b.any_mass for b in problem.bodies)
    return massless and bool(problem.motion) and not problem.loads


def _constant(motion: Simulation, figures: int) -> Iterator[Block]:
    """The places over time of a uniform motion, x = x_0 + v t; nothing of any other."""
    found = table_of(motion.run, (), (), ROWS)
    first, last = found.rows[0], found.rows[-1]
    duration = last[0] - first[0]
    if len(found.rows) < ROWS or not duration:
        return
    kept = range(1, len(found.names))
    rates = {j: (last[j] - first[j]) / duration for j in kept}
    for j in kept:
        straight = [first[j] + rates[j] * (row[0] - first[0]) for row in found.rows]
        off = max(abs(row[j] - place) for row, place in zip(found.rows, straight, strict=True))
        if off > UNIFORM * found.sizes[j]:
            return
    yield Heading("STEP 1", UNIFORM_MOTION)
    yield Paragraph(line("What is prescribed gives the velocities, which are constant all the time:"))
    for j in (j for j in kept if abs(rates[j]) * duration > UNIFORM * found.sizes[j]):
        name, unit = Name(_POINT.sub(r"_\1", found.names[j])), pretty_unit(found.units[j])
        start = significant(Decimal(repr(first[j])), figures) if abs(first[j]) > UNIFORM * found.sizes[j] else ""
        rate = significant(Decimal(repr(abs(rates[j]))), figures)
        sign = ("+ " if rates[j] > 0 else "- ") if start else "" if rates[j] > 0 else "-"
        shown = line(f"{start} {sign}{rate} ".lstrip(), Name("t"))
        yield Equation((line(name), shown), None, (), line(f"in {unit}, t in s"))


def _table(motion: Simulation, figures: int) -> Table:
    found = table_of(motion.run, (), (), ROWS)
    heads = [f"{n} in {pretty_unit(u)}" if u != "1" else n for n, u in zip(found.names, found.units, strict=True)]
    least = [NOISE * motion.run.settings.tolerance * size for size in found.sizes]
    kept = _columns(motion, found.names, found.rows, least)
    rows = [tuple(_cell(row[j], least[j], figures) for j in kept) for row in found.rows]
    return Table(tuple(line(heads[j]) for j in kept), tuple(rows))


def _columns(
    motion: Simulation, names: Sequence[str], rows: Sequence[Sequence[float]], least: Sequence[float]
) -> list[int]:
    """The columns that say something: the time, and what changes; of many those of what is asked."""
    ranges = [max(column) - min(column) for column in zip(*rows, strict=True)]
    changing = [j for j, size in enumerate(ranges) if j == 0 or size > least[j]]
    finds = [f.found.what for f in motion.run.problem.find]
    things = {t for what in finds for n in walk(what) if isinstance(n, Quantity) for t in n.things}
    asked = [j for j in changing if j == 0 or any(f"({t})" in names[j] for t in things)]
    return asked if len(changing) > MOST_COLUMNS and len(asked) > 1 else changing


def _cell(value: float, least: float, figures: int) -> Line:
    return line(Value(Decimal(repr(value)) if abs(value) > least else Decimal(0), "", figures))


def read_off_checks(motion: Simulation) -> Iterator[Check]:
    """How good the numbers are."""
    errors = [(a.error / a.one, a) for a in motion.answers if a.error is not None and a.values]
    if errors:
        words = ", ".join(f"{a.name} {e:.0e} {pretty_unit(a.unit.text)}".rstrip() for e, a in errors)
        yield Check(line(f"estimated errors, by a second run with finer steps: {words}"))
    balances = [s.balance.off for s in motion.run.trajectory.segments if s.balance is not None]
    if balances:
        yield Check(line(f"energy adds up to {max(balances):.0e} of its size over every part of the motion"))
