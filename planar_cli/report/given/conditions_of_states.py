"""What picks a state, as a line before it is used: the cord is about to break, S = S_max."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, longer
from planar_cli.problem.language.expression import Binary, Quantity
from planar_cli.problem.language.expression import Relation as RelationOfFile
from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, line
from planar_cli.report.given.as_stated import Stated, in_base, root_of_size, stated_in
from planar_cli.report.given.driving_speed import by_driving_speed
from planar_cli.report.notation.clean import common_dimension, is_clean
from planar_cli.report.notation.names import plain_name
from planar_cli.report.words.origins import head, sides_of
from planar_cli.report.words.sides import number_of, said
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteStep
from planar_cli.solve.law import IN_THE_END

FEW_LETTERS, SAME = 8, Decimal("1e-20")
FEW, SHORT = 2, 24
"""Letters of a condition that only gives a value, and operations of a side that is printed."""

TIME = "t__"
"""Begins the letter of the time of a state."""


def condition_blocks(leg: RouteStep, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The condition of a state from which a datum is worked out, in the letters of the state; nothing where it gives
    the datum plainly.
    """
    (e, *more), (r, *others) = leg.relations, leg.results
    formula = r.formula
    if e.words == IN_THE_END:
        yield Paragraph(line(at(e.stop, e.words)))
        yield Equation(tuple(phrases.math(side) for side in sides_of(e, found.route)))
        return
    if more or others or e.kind != "given" or formula is None or not e.words or formula.is_Symbol or formula.is_number:
        return
    rate = derivative(e.residual, r.unknown)
    sides = sides_of(e, found.route)
    inside = set().union(*(side.free_symbols for side in sides))
    if (
        rate.is_number
        or len(inside) <= FEW
        or any(longer(side, SHORT) for side in sides)
        or not is_clean(found.ledger, *sides)
    ):
        return
    yield Paragraph(head(e, found.ledger.symbols))
    yield Equation(tuple(phrases.math(sp.sympify(side)) for side in sides))


def asked_here(leg: RouteStep, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """What is asked and is solved for, in letters of the states."""
    for x in leg.unknowns:
        if x in found.named:
            made = _difference(x, found) or phrases.math(found.named[x])
            if ends := _duration(made.expr):
                yield Paragraph(line(Math(x), f": the time from {ends[0]} to {ends[1]}"))
                continue
            yield Equation((phrases.math(x), made), None, line("to be found:"))


def _difference(x: sp.Symbol, found: MotionTrace) -> Math | None:
    """y_D,1 - y_D,2 as the file asks for it, where the letters of the states are others; None: it is no such one."""
    what = next((f.found.what for f in found.problem.find if f.name == x.name), None)
    if all(abs(t).is_Symbol for t in sp.Add.make_args(found.named[x])) or not isinstance(what, Binary):
        return None
    ends = [q for q in (what.left, what.right) if isinstance(q, Quantity) and q.word in ("x", "y") and not q.parts]
    if what.operator != "-" or len(ends) < 2 or any(len(q.things) != 1 or not isinstance(q.at, str) for q in ends):
        return None
    one, two = (sp.Symbol(f"{q.word}_{q.things[0]}__{q.at}", real=True) for q in ends)
    return Math(sp.Add(one, -two, evaluate=False))


def is_own_name(leg: RouteStep) -> bool:
    """Is a letter of a state only the constant of the file whose name it has in print: φ in state 0 and φ_0?"""
    (r, *more) = leg.results
    if more or r.formula is None or not r.formula.is_Symbol:
        return False
    return plain_name(r.unknown.name.replace("__", "_")) == plain_name(r.formula.name)


def followed_from(
    e: Relation, r: Result, stated: Stated, found: MotionTrace, phrases: tuple[Phrases, Phrases]
) -> Iterator[Block]:
    """The condition from which a datum follows that the file does not give itself. `phrases`: of the motion, and of
    what has numbers.
    """
    yield Paragraph(head(e, found.ledger.symbols))
    if (sized := root_of_size(stated, e.residual, phrases[1])) is not None:
        yield Equation((Math(sized[0]), phrases[1].shown(r.unknown, sized[1])))
        return
    if (driven := by_driving_speed(stated, e, found)) is not None:
        left, number, dimension = driven
        yield Equation((phrases[0].math(left), phrases[1].of_dimension(number, dimension)))
        return
    sides = tuple(sp.sympify(side) for side in sides_of(e, found.route))
    plain = derivative(e.residual, r.unknown).is_number
    if not plain and not any(longer(side, SHORT) for side in sides) and is_clean(found.ledger, *sides):
        yield Equation(tuple(phrases[0].math(side) for side in sides))


def given_by_another(e: Relation, r: Result, found: MotionTrace, phrases: tuple[Phrases, Phrases]) -> Iterator[Block]:
    """What the file gives of a state, by the letter that follows from it: v_Ax = -r ω_1 = -0.1 m/s. Nothing where this
    letter itself is given, or more letters of the state stand in it. `phrases`: of the motion, and of what has numbers.
    """
    stated = stated_in(found.problem, e.stop, e.words)
    number = number_of(stated.right) if isinstance(stated, RelationOfFile) and stated.operator == "=" else None
    value = in_base(number, found.ledger.us)
    if not isinstance(stated, RelationOfFile) or value is None or r.formula is None or r.formula.is_Symbol:
        return
    residual = e.residual.xreplace(dict(found.route.plain))
    known = sp.Add(*(t for t in sp.Add.make_args(residual) if t.is_number))
    size = abs(phrases[1].value(known)) if known != 0 else None
    others = {s for s in residual.free_symbols if s in found.general} - {r.unknown}
    if size is None or others or r.formula.is_number or residual.has(sp.Abs, sp.atan2):
        return
    if abs(size - abs(value)) > SAME * size:
        return
    expr = (residual - known) * (-1 if (known > 0) == (value > 0) else 1)
    dimension = common_dimension(found.ledger, expr)
    if dimension is None or longer(expr, FEW_LETTERS) or not (name := said(stated.left, 1)):
        return
    shown = phrases[1].of_dimension(value, dimension)
    yield Equation((line(*name), phrases[0].math(expr), shown), None, line(at(e.stop)))


def _duration(made: sp.Expr) -> tuple[str, ...]:
    """The two states between which a difference of times lies, the first one first; () of anything else."""
    times = {c: s.name.removeprefix(TIME) for s, c in made.as_coefficients_dict().items() if str(s).startswith(TIME)}
    return (times[-1], times[1]) if len(made.args) == 2 and set(times) == {-1, 1} else ()
