"""Laws of coordinates and their integrals: in letters, or with numbers where letters are many or would hide units."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import longer
from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, Value, line
from planar_cli.report.in_numbers.put_in import partly
from planar_cli.report.notation.clean import dimension_of, is_clean
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.notation import plain
from planar_cli.report.oscillation.free_motions import motion_blocks
from planar_cli.report.oscillation.vibrations import free_blocks, vibration_blocks
from planar_cli.report.words.origins import is_vibration
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import RegimeTrace, Relation, RouteTrace
from planar_cli.solve.law import FROM_REST, Law

FEW, SWINGING, INTEGRATED = 12, 36, 24
"""A law of more operations is told with its numbers; one of a vibration, whose letters follow from its own; what an
integral is over.
"""
FOR = "For "
"""How the heading of a law begins."""
PER_TIME = {"v(t)": "{}/s", "q(t)": "{}", "t(q)": "s", "v(q)": "{}²/s²"}
"""The unit of an integral, by its kind; {} is that of the coordinate."""


def law_blocks(law: Law, phrases: Phrases, varying: Collection[sp.Symbol], since: str = "") -> Iterator[Block]:
    """q̇ or q̈ as a formula. `since`: from which state on, where it is another one elsewhere."""
    q = law.coordinate.symbol
    v = law.speed if law.speed is not None and law.factor == 1 else sp.Symbol(f"{q.name}_dot", real=True)
    name = f"{q.name}_{'ddot' if law.order == 2 else 'dot'}"
    # Where there are several laws the rate is another quantity in each.
    rate = sp.Dummy(name, real=True) if since else sp.Symbol(name, real=True)
    of = counted(law.coordinate.words) if law.coordinate.words != q.name else f"the coordinate {plain_name(q.name)}"
    yield Paragraph(line(f"{FOR}{of}{f' from {since} on' if since else ''}:"))
    if law.constant is not None:
        value = _constant_value(law, law.constant[0], phrases)
        put = () if law.f.is_Symbol else phrases.substituted(law.f, value)
        formula = () if law.f.is_Symbol and law.f.name == rate.name else (phrases.math(law.f),)
        yield Equation((phrases.math(rate), *formula, *put, value))
        return
    shown = running(law.f.xreplace({law.v: v}), {*varying, v}, phrases, law)
    unit = f"{_unit(law, phrases)}/s{'²' if law.order == 2 else ''}"
    yield Equation((phrases.math(rate), shown), None, (), line(f"in {unit}") if hides_units(shown) else ())


def swings(e: Relation) -> bool:
    """Is it of a vibration?"""
    return e.kind in FROM_REST or (e.span is not None and EQUATION in e.span.words)


def counted(words: str) -> str:
    """What a coordinate counts, in a sentence: the angle of the wheel, x of P, the way of C along its path; of one that
    the file declares its name alone, x_B.
    """
    what, _, thing = words.partition(" of ")
    thing, _, rest = thing.partition(" ")
    if not thing:
        return plain_name(what)
    told = f"{what} of {with_article(thing)}{' ' if rest else ''}{rest}"
    return told if what in ("x", "y") else f"the {told}"


class LawTelling:
    """Tells each law of a motion once, and the letters of its vibration before they are used."""

    def __init__(self, phrases: Phrases, varying: Collection[sp.Symbol], regimes: Sequence[RegimeTrace]) -> None:
        self.phrases, self.varying, self.regimes = phrases, varying, regimes
        self._told: set[tuple[sp.Symbol, sp.Expr]] = set()
        self.natural: set[sp.Symbol] = set()
        """The natural frequencies that were told."""
        self.places: set[tuple[sp.Symbol, str]] = set()
        """Coordinates that were told as functions of the time, with the states from which."""
        self._moved: set[tuple[sp.Symbol, str]] = set()
        self._by_terminal: set[tuple[sp.Symbol, sp.Expr]] = set()

    def blocks(self, e: Relation, route: RouteTrace, unknown: Collection[sp.Symbol]) -> Iterator[Block]:
        """The law of which a relation is an integral. `unknown`: letters that are not known yet."""
        law = e.law
        if law is None or law.f == 0:
            return
        if said_by(law) not in self._told:
            self._told.add(said_by(law))
            every = (r.law for leg in route.steps for r in leg.relations if r.law is not None)
            changes = len({said_by(x) for x in every if x.coordinate == law.coordinate and x.f != 0}) > 1
            yield from law_blocks(law, self.phrases, {*self.varying, *unknown}, e.since if changes else "")
        yield from self.terminal_speed(law)
        if law.terminal is not None and said_by(law) not in self._by_terminal:
            self._by_terminal.add(said_by(law))
            yield self._with_terminal(law, law.terminal[0], law.terminal[2])
        own = law.vibration
        if own is not None and swings(e) and (new := {own.natural, *own.rest} - self.natural):
            self.natural |= new
            yield from vibration_blocks(own, law, self.phrases, new)
        if own is not None and own.begun and own.begun[0][0] not in self.natural:
            self.natural.add(own.begun[0][0])
            yield from free_blocks(own, law, self.phrases, e.since)
        if own is not None and not own.begun and is_vibration(e) and (own.natural, e.since) not in self._moved:
            self._moved.add((own.natural, e.since))
            yield from motion_blocks(e, route, self.phrases, self.regimes)

    def terminal_speed(self, law: Law | None) -> Iterator[Block]:
        """The speed at which a drag balances what drives, once."""
        if law is None or law.terminal is None or law.terminal[0] in self.natural:
            return
        self.natural.add(law.terminal[0])
        letter, formula, _ = law.terminal
        value = self.phrases.shown(letter)
        put = () if formula.is_Symbol else self.phrases.substituted(formula, value)
        sides: tuple[Any, ...] = (Math(letter), self.phrases.math(formula), *put, value)
        yield Equation(sides, None, line("terminal speed:"))

    def _with_terminal(self, law: Law, letter: sp.Symbol, told: sp.Expr) -> Equation:
        """ÿ = -g (v_t² + v²)/v_t²: the law by its terminal speed, as it is integrated."""
        q = law.coordinate.symbol
        v = law.speed if law.speed is not None and law.factor == 1 else sp.Symbol(f"{q.name}_dot", real=True)
        rate = sp.Symbol(f"{q.name}_ddot", real=True)
        shown = running(factor_terms(told.xreplace({law.v: v})), {*self.varying, v}, self.phrases, law)
        return Equation((self.phrases.math(rate), shown), None, line("with ", Math(letter), ":"))


def without_given(moving: Sequence[Block], before: Sequence[Block]) -> list[Block]:
    """What is told of a motion without the laws that stand word for word among the data, or as the solution of the
    equations. `before`: where these are.
    """
    data = (line("given:"), line("differentiated:"))
    told = [b for b in before if isinstance(b, Equation)]
    given = {_text(b) for b in told if b.lead in data} - {""}
    tables = _tables(told)
    solved = [_opened(b, tables) for b in told if b.lead and b.number is None]
    found: list[Block] = []
    for block in moving:
        heading = found[-1] if found else None
        law = isinstance(heading, Paragraph) and str(getattr(heading.line[0], "text", "")).startswith(FOR)
        if not law or not isinstance(block, Equation) or block.number is not None:
            found.append(block)
        elif (
            _text(block) in given
            or _is_last(block, solved)
            or (not _changes(heading) and any(_same_rate(block, b) for b in solved))
        ):
            found.pop()
        else:
            found.append(block)
    return found


def _tables(told: Iterable[Equation]) -> dict[sp.Expr, sp.Expr]:
    """The pieces of what has a letter: M_rotor = 10 for t < 1; 15 - 5 t for t > 1."""
    found: dict[sp.Expr, sp.Expr] = {}
    for equation in told:
        match equation.sides[:2]:
            case (Math(expr=letter), Math(expr=pieces)) if letter.is_Symbol and pieces.has(sp.Piecewise):
                found[letter] = pieces
    return found


def _opened(told: Equation, tables: Mapping[sp.Expr, sp.Expr]) -> Equation:
    """The same with the pieces of a table for its letter."""
    if not tables:
        return told
    sides = (replace(s, expr=s.expr.xreplace(tables)) if isinstance(s, Math) else s for s in told.sides[1:])
    return replace(told, sides=(told.sides[0], *sides))


def _is_last(law: Equation, solved: Sequence[Equation]) -> bool:
    """Is it what the equations gave last for this letter?"""
    name = getattr(getattr(law.sides[0], "expr", None), "name", "")
    same = [
        b
        for b in solved
        if isinstance(own := b.sides[0], Math) and own.expr.is_Symbol and is_rate_of(own.expr.name, name)
    ]
    return bool(same) and _same_rate(law, same[-1])


def is_law_heading(heading: Paragraph) -> bool:
    """Does a law follow, which holds all the time?"""
    return str(getattr(heading.line[0], "text", "")).startswith(FOR) and not _changes(heading)


def _changes(heading: Any) -> bool:
    """Does a law hold from one state on, and not before?"""
    return str(getattr(heading.line[-1], "text", "")).endswith(" on:")


def is_rate_of(letter: str, rate: str) -> bool:
    """Is a_Gx or α_rod the second derivative x_G_ddot or theta_rod_ddot?"""
    kind, *index = letter.split("_")
    coordinate = rate.removesuffix("_ddot").split("_")
    axis, *body = coordinate
    along = sorted(index) in (sorted(coordinate), sorted(body)) or index == ["".join((*body, axis))]
    return {"a": along, "alpha": index == coordinate[1:]}.get(kind, False) or rate == letter


def _same_rate(law: Equation, result: Equation) -> bool:
    """Is a law ÿ = … what the equations gave as a_y = …, with as much of numbers?"""
    own, other = law.sides[0], result.sides[0]
    if not all(isinstance(s, Math) and s.expr.is_Symbol for s in (own, other)) or law.note:
        return False
    assert isinstance(own, Math)
    assert isinstance(other, Math)
    same = is_rate_of(other.expr.name, own.expr.name)
    sides = zip(law.sides[1:], result.sides[1:], strict=False)
    return same and len(law.sides) <= len(result.sides) and all(_alike(a, b) for a, b in sides)


def _alike(one: object, other: object) -> bool:
    """Do two sides read alike? Pieces of a table are compared term by term, 5 (3 - t) with 15 - 5 t."""
    if str(one) == str(other):
        return True
    pieces = [s.expr for s in (one, other) if isinstance(s, Math) and not s.values and s.expr.has(sp.Piecewise)]
    return len(pieces) == 2 and sp.expand(pieces[0]) == sp.expand(pieces[1])


def _text(equation: Equation) -> str:
    """The sides of an equation as they are printed; "" where they are more than formulas."""
    maths = [side for side in equation.sides if isinstance(side, Math)]
    return " = ".join(plain(m.expr, m.values) for m in maths) if len(maths) == len(equation.sides) else ""


def said_by(law: Law) -> tuple[sp.Symbol, sp.Expr]:
    """What a law says, whatever stands for the own speed in it."""
    return law.coordinate.symbol, law.f.xreplace({law.v: sp.Symbol("v", real=True)})


def _constant_value(law: Law, letter: sp.Symbol, phrases: Phrases) -> Any:
    """The number of a rate that does not change."""
    if law.f == letter:
        return phrases.shown(letter, phrases.value(letter))
    return rate_value(law, phrases.value(law.f), phrases)


def rate_value(law: Law, number: Decimal, phrases: Phrases) -> Value:
    """The number of a velocity or acceleration of a coordinate with its unit."""
    return Value(number, f"{_unit(law, phrases)}/s{'^2' if law.order == 2 else ''}", phrases.figures)


def running(expr: sp.Expr, letters: Collection[sp.Symbol], phrases: Phrases, law: Law | None) -> Math:
    """A law or its integral. `letters`: those that run."""
    integrals = [i.function for i in expr.atoms(sp.Integral)]
    inside = integrals or [expr]
    most = SWINGING if law is not None and law.vibration is not None else INTEGRATED if integrals else FEW
    short = all(not longer(e, most) and is_clean(phrases.ledger, e) for e in inside)
    short = short and (law is None or _is_lettered(law, phrases))
    numbers = None if phrases.symbolic or short else partly(expr, letters, phrases, constant=True)
    return phrases.math(expr) if numbers is None else numbers


def _is_lettered(law: Law, phrases: Phrases) -> bool:
    """Do the letters of a law make the unit of its rate, so that no number in it hides one?"""
    q, t = law.coordinate.symbol, phrases.ledger.symbols["t"]
    f = law.f.xreplace({law.v: q / t})
    return law.f == 0 or is_clean(phrases.ledger, f, dimension=dimension_of(q / t**law.order, phrases.ledger))


def integral_note(law: Law | None, kind: str, sides: Collection[Math], phrases: Phrases) -> Line:
    """The unit of an integral that is told with numbers."""
    if law is None or kind not in PER_TIME or not any(hides_units(s) and not s.expr.is_Symbol for s in sides):
        return ()
    unit = "s" if _separated([s.expr for s in sides]) else PER_TIME[kind].format(_unit(law, phrases))
    return line(f"in {unit}")


def hides_units(side: Math) -> bool:
    """Are there numbers with units in a side: some that are rounded, or no other letter than the time?"""
    return bool(side.values) or (not side.expr.has(sp.Integral) and {s.name for s in side.expr.free_symbols} <= {"t"})


def _separated(sides: Collection[sp.Expr]) -> bool:
    """Does the time alone stand on one side, and a law on the other?"""
    whole = [s for s in sides if isinstance(s, sp.Integral) and s.function == 1]
    return len(whole) == 1 and len(sides) == 2 and whole[0].variables[0].name == "t"


def _unit(law: Law, phrases: Phrases) -> str:
    """The unit of a coordinate on the page."""
    return "rad" if law.coordinate.unit == "rad" else "ft" if phrases.ledger.us else "m"
