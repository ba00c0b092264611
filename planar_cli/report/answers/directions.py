"""A direction that is found from its two components, as it is written by hand: tan φ = v_y/v_x, then φ; of a rod whose
length is known from its sine.

An angle that the components only repeat is told by the angle itself: 180° - β for a rod at l (-cos β), l sin β.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from decimal import Decimal
from math import isclose, radians, sin, tan

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Value, line
from planar_cli.report.energy.few_lines import breaks
from planar_cli.report.notation.numbers import significant

STEEP = 1e4
"""A tangent beyond tells nothing."""
RIGHT = 90
CLOSE = 1e-3
"""Angles in degrees nearer to each other are the same on the page."""
RATIO = sp.Symbol("tangent", real=True)


def with_tangents(blocks: Iterable[Block]) -> Iterator[Block]:
    """All blocks, the angles of components found by their tangents."""
    for block in blocks:
        yield from _told(block) if isinstance(block, Equation) else (block,)


def _told(equation: Equation) -> Iterator[Block]:
    sides, value = equation.sides, equation.sides[-1]
    at = next((i for i, s in enumerate(sides) if i and isinstance(s, Math) and _parts(s.expr) is not None), None)
    formulas = [s for s in sides[at:] if isinstance(s, Math)]
    shown = [_quotient(f) for f in formulas]
    if at is None or equation.relation != "=" or any(q is None for q in shown):
        yield equation
    elif formulas == list(sides[at:]):
        # Of letters alone: which of the two angles of a tangent is meant, the drawing says.
        yield replace(equation, sides=(_tangent(sides[0]), *(q for q in shown if q is not None)))
    elif not isinstance(value, Value) or value.unit != "deg" or len(formulas) != len(sides) - at - 1:
        yield equation
    elif (repeated := _repeated(formulas[-1], value)) is not None:
        yield replace(equation, sides=(*sides[:at], *repeated, value))
    elif sines := _sines(formulas, value):
        arcs = (Math(sp.asin(f.expr, evaluate=False), f.values) for f in sines)
        if equation.lead and not breaks(whole := replace(equation, sides=(sides[0], *arcs, value))):
            yield whole
            return
        told = Value(Decimal(sin(radians(value.number))), "1", value.figures)
        yield replace(equation, sides=(line("sin ", sides[0]), *sines, told), note=())
        arc = Math(sp.asin(RATIO), {RATIO: significant(told.number, told.figures)})
        yield Equation((sides[0], arc, value), note=equation.note)
    elif abs(number := tan(radians(value.number))) > STEEP:
        yield equation
    else:
        told = Value(Decimal(number), "1", value.figures)
        tangent = line("tan ", sides[0])
        plain = [q for q in shown if q is not None and not q.expr.doit().is_Rational]
        yield replace(equation, sides=(tangent, *plain, told), note=())
        arc = Math(sp.atan(RATIO), {RATIO: significant(told.number, told.figures)})
        turn = "" if abs(value.number) < RIGHT else " + 180°" if value.number > 0 else " - 180°"
        yield Equation((sides[0], line(arc, turn), value), note=equation.note or _quadrant(formulas[0], value))


def _sines(formulas: list[Math], value: Value) -> list[Math]:
    """The sine of an acute angle, y/r, where that is plainer than y/x, as x is the root of r² - y²; else none."""
    found = []
    for f in formulas:
        y, x = _parts(f.expr) or (sp.S.Zero, sp.S.One)
        rooted = x.is_Pow and x.exp == sp.Rational(1, 2) and x.base.is_Add
        r = sp.sqrt(sp.expand(y**2 + x**2)) if rooted else x
        if not rooted or r.atoms(sp.Pow) or abs(value.number) >= RIGHT:
            return []
        found.append(Math(sp.Mul(y, sp.Pow(r, -1), evaluate=False), f.values))
    return found


def _quadrant(formula: Math, value: Value) -> Line:
    """Which of the two angles of a tangent it is, by the sign of the component along x; nothing of an acute one."""
    parts = _parts(formula.expr) if formula.values is None else None
    if parts is None or not parts[1].is_Symbol or 0 <= value.number <= RIGHT:
        return ()
    return line("as ", Math(parts[1]), " > 0" if abs(value.number) < RIGHT else " < 0")


def _tangent(angle: Inline | Line) -> Line:
    """tan φ; of a number with its unit, in brackets."""
    texts = list((angle.values or {}).values()) if isinstance(angle, Math) else []
    if not texts:
        return line("tan ", angle)
    return line("tan(", angle, ")" if all(t.endswith("°") for t in texts) else " rad)")


def _parts(expr: object) -> tuple[sp.Expr, sp.Expr] | None:
    """y and x of an angle ±atan2(y, x), or of one by whole turns more; None of any other formula."""
    if not isinstance(expr, sp.Expr) or not expr.has(sp.atan2):
        return None
    turns, angle = expr.as_independent(sp.atan2, as_Add=True)
    sign, angle = (1, angle) if isinstance(angle, sp.atan2) else (-1, -angle)
    if not isinstance(angle, sp.atan2) or not (turns / (2 * sp.pi)).is_integer or 0 in angle.args:
        return None
    return sign * angle.args[0], angle.args[1]


def _quotient(angle: Math) -> Math | None:
    """The tangent of an angle, y/x without what both have."""
    parts = _parts(angle.expr)
    if parts is None:
        return None
    y, x = parts
    common = sp.gcd(y, x)
    y, x = (y, x) if common == 1 else (sp.cancel(y / common), sp.cancel(x / common))
    y, x = (-y, -x) if x.could_extract_minus_sign() else (y, x)
    return Math(sp.Mul(y, sp.Pow(x, -1), evaluate=False), angle.values)


def _repeated(shown: Math, value: Value) -> tuple[Line, ...] | None:
    """The formula of an angle that is a letter's angle, a right one or two more or less: 180° - β, with its number."""
    y, x = _parts(shown.expr) or (sp.S.Zero, sp.S.One)
    letters = sorted((y / x).free_symbols, key=str)
    text = (shown.values or {}).get(letters[0], "") if len(letters) == 1 else ""
    if not text.endswith("°") or sp.trigsimp(sp.cancel(y / x)) not in _tangents(letters[0]):
        return None
    for quarters in (0, 1, -1, 2, -2):
        for sign in (1, -1):
            if isclose(RIGHT * quarters + sign * float(text[:-1]), float(value.number), abs_tol=CLOSE):
                if not quarters and sign > 0:
                    return (line(Math(letters[0])),)
                head = f"{RIGHT * quarters}° {'+' if sign > 0 else '-'} " if quarters else "-"
                return line(head, Math(letters[0])), line(head, text)
    return None


def _tangents(letter: sp.Symbol) -> tuple[sp.Expr, ...]:
    """What the tangent of a letter's angle may be, a number of right angles added."""
    sine, cosine, tangent = sp.sin(letter), sp.cos(letter), sp.tan(letter)
    found = (tangent, 1 / tangent, sp.cot(letter), sine / cosine, cosine / sine)
    return (*found, *(-f for f in found))
