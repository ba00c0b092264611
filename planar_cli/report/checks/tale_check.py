"""Checks that a person can make of a page of kinematics that is told in derivatives of places.

at φ = 0, where r_P = [0, 0]: v_P = 0;  at φ = π, where r_P = [π r, 2 r]: v_P = [2 r ω, 0]      special places
√(v_Pr² + v_Pθ²) = √(0.08256² + 0.1544²) = 0.1751 m/s, √(ẋ_P² + ẏ_P²) = 0.1751 m/s                 the same size twice
v_P²/R = 11.78²/15 = 9.253 m/s² = a_P                                            a circle with a constant speed
"""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.problem.language.expression import Quantity
from planar_cli.report.document.blocks import Line, Math, Name, line
from planar_cli.report.in_numbers.sums import agree
from planar_cli.report.words.words import Phrases
from planar_cli.solve.passages import Tale, sides_of
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import LENGTH, PURE, TIME

SHORT = 10
"""What a vector is at a special place has at most so many operations."""
RATES = ("v", "a", "omega", "alpha")
PLACES = ((sp.S.Zero, "0"), (sp.pi, "π"))
Values = dict[str, tuple[Decimal, int]]
"""Of the letters of a tale: their values, and how often they are lengths differentiated."""


def tale_check(part: PartSolution, phrases: Phrases) -> Line:
    """The first that the page allows; empty where it tells no places over time."""
    if part.tale is None or not part.tale.whole or part.case:
        return ()
    numeric = replace(phrases, symbolic=False, lettered=frozenset())
    values = _values(part.tale)
    ways = (
        _by_components(values, numeric),
        _on_circle(part, values, numeric),
        _special(part, phrases),
        _rates(part, phrases),
    )
    return next(filter(None, ways), ())


def _values(tale: Tale) -> Values:
    found: Values = {}
    for row in (r for p in tale.passages for r in p.rows):
        letter = sides_of(row)[0]
        order = next((n for n in range(3) if row.dimension == LENGTH / TIME**n), None)
        if row.value is not None and order is not None and getattr(letter, "is_Symbol", False):
            found[letter.name] = (row.value, order)
    return found


# --- the same size by polar and by Cartesian components ------------------------------------------------------------


def _by_components(values: Values, phrases: Phrases) -> Line:
    """√(v_r² + v_θ²) against √(ẋ² + ẏ²) of a point of which the page tells both."""
    for name in values:
        point = name.removeprefix("v_").removesuffix("_r")
        polar, plane = (f"v_{point}_r", f"v_{point}_theta"), (f"x_{point}_dot", f"y_{point}_dot")
        if name != polar[0] or polar[1] not in values or plane[0] not in values:
            continue
        pairs = [[values.get(n, (Decimal(0), 1))[0] for n in names] for names in (polar, plane)]
        sizes = [(a * a + b * b).sqrt() for a, b in pairs]
        if not agree([sizes[0]], [sizes[1]]) or not sizes[0]:
            return ()
        one, other = (_root(names, pair, phrases) for names, pair in zip((polar, plane), pairs, strict=True))
        shown = phrases.of_dimension(sizes[0], LENGTH / TIME)
        return line(*one, " = ", shown, "; ", *other, " = ", shown)
    return ()


def _root(names: tuple[str, str], pair: list[Decimal], phrases: Phrases) -> Line:
    """√(a² + b²) in letters and with numbers."""
    letters = [sp.Symbol(n, real=True) for n in names]
    if 0 in pair:
        return line("|", Math(letters[0] if pair[1] == 0 else letters[1]), "|")
    formula = sp.sqrt(letters[0] ** 2 + letters[1] ** 2)
    put = phrases.numbers(formula, dict(zip(letters, pair, strict=True)), turns=False)
    return line(Math(formula), *((" = ", put) if put is not None else ()))


# --- a circle with a constant speed ----------------------------------------------------------------------------------


def _on_circle(part: PartSolution, values: Values, phrases: Phrases) -> Line:
    """v²/R against the acceleration, where its point has a constant speed on a circle."""
    for answer in part.found:
        what = answer.find.found.what if answer.find is not None else None
        if answer.curve is None or answer.curve.radius is None or not isinstance(what, Quantity) or phrases.letters:
            continue
        v, a = (values.get(f"{kind}_{what.things[0]}") for kind in "va")
        if what.word != "path" or len(what.things) > 1 or v is None or a is None:
            continue
        radius = phrases.value(answer.curve.radius)
        if not agree([v[0] ** 2 / radius], [a[0]]):
            continue
        speed, size, reach = (sp.Symbol(n, real=True) for n in (f"v_{what.things[0]}", f"a_{what.things[0]}", "R"))
        put = phrases.numbers(speed**2 / reach, {speed: v[0], reach: radius}, turns=False)
        if put is not None:
            told = phrases.of_dimension(a[0], LENGTH / TIME**2)
            return line(
                "constant speed on a circle: ", Math(size), " = ", Math(speed**2 / reach), " = ", put, " = ", told
            )
    return ()


# --- special places --------------------------------------------------------------------------------------------------


def _special(part: PartSolution, phrases: Phrases) -> Line:
    """What the last vector that is asked comes to at two positions of the only angle in it."""
    for answer in reversed(part.found):
        angle = _angle(answer, phrases)
        if angle is None or answer.find is None:
            continue
        told: list[Any] = []
        for number, words in PLACES:
            parts = [simplified(e.xreplace({angle: number})) for e in answer.expressions or ()]
            if any(longer(e, SHORT) or not e.is_finite or e.has(sp.nan, sp.zoo) for e in parts):
                return ()
            place = _place(answer, part, angle, number, phrases)
            told += ["; " if told else "", "at ", Math(angle), f" = {words}", *place, Name(answer.name), " = "]
            told += _vector(parts, phrases, answer)
        return line(*told)
    return ()


def _rates(part: PartSolution, phrases: Phrases) -> Line:
    """What velocities and accelerations that are asked as single numbers come to at the same positions."""
    told: list[Any] = []
    for number, words in PLACES:
        found: list[Any] = []
        for answer in part.found:
            what = answer.find.found.what if answer.find is not None else None
            angle = _angle(answer, phrases, "number")
            if angle is None or not isinstance(what, Quantity) or what.word not in RATES:
                continue
            value = sp.factor_terms(
                sp.radsimp(simplified((answer.expressions or (sp.nan,))[0].xreplace({angle: number})))
            )
            if longer(value, SHORT) or value.has(sp.nan, sp.zoo, sp.oo):
                return ()
            found += [", " if found else "", Name(answer.name), " = ", phrases.math(value)]
            head = ["; " if told else "", "at ", Math(angle), f" = {words}: "]
        told += [*head, *found] if found else []
    return line(*told)


def _angle(answer: Found, phrases: Phrases, kind: str = "vector") -> sp.Symbol | None:
    """The only coordinate in a vector, or a number, in letters, where that is an angle."""
    ledger = phrases.ledger
    inside = {s for e in answer.expressions or () for s in e.free_symbols}
    own = inside & set(ledger.coordinates)
    if answer.kind != kind or answer.values is not None or len(own) != 1 or ledger.symbols.get("t") in inside:
        return None
    (angle,) = own
    return angle if ledger.units[angle].dimension == PURE else None


def _place(answer: Found, part: PartSolution, angle: sp.Symbol, number: sp.Expr, phrases: Phrases) -> Line:
    """Where the point is then; of a place that is asked nothing more."""
    what = answer.find.found.what if answer.find is not None else None
    scene = part.instants[-1].instant.scene
    if not isinstance(what, Quantity) or what.word == "r" or len(what.things) > 1:
        return line(": ")
    if what.things[0] not in scene.points:
        return line(": ")
    at = scene.point(what.things[0])
    parts = [simplified(e.xreplace({angle: number})) for e in (at.x, at.y)]
    if any(longer(e, SHORT) for e in parts):
        return line(": ")
    return line(f", {what.things[0]} at [", phrases.math(parts[0]), ", ", phrases.math(parts[1]), "]: ")


def _vector(parts: list[sp.Expr], phrases: Phrases, answer: Found) -> list[Any]:
    what = answer.find.found.what if answer.find is not None else None
    if all(p == 0 for p in parts) and isinstance(what, Quantity) and what.word != "r":
        return ["0"]
    return ["[", phrases.math(parts[0]), ", ", phrases.math(parts[1]), "]"]
