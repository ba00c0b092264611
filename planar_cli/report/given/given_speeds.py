"""A speed that the file gives as the size of a velocity, of what moves along a curve: it is told as the speed, not as a
square, and where it does not change there is no tangential acceleration.

    v_P = v             constant speed
    a_Pt = 0            v_P constant
"""

from __future__ import annotations

import re

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.document.blocks import Equation, line
from planar_cli.report.given.data import lower_name
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written

SPEEDS = (line("constant speed:"), line("speed:"))


def speed_told(
    w: Written, stage: Stage, phrases: Phrases, number: int, moving: frozenset[sp.Symbol]
) -> tuple[Equation, SolvedLine] | None:
    """The line that tells a relation v² = c² or its derivative, and what it solves; None: it is another relation.
    `moving`: the velocity unknowns.
    """
    found = next((x for b in stage.blocks for x in b.lines if x.equations == (w.number,) and not x.letters), None)
    if w.source != "given" or found is None:
        return None
    x = found.symbol
    letter = phrases.math(x)
    if w.times:
        speeds = [s for s in w.residual.free_symbols & moving if lower_name(x.name).startswith(s.name)]
        if found.formula != 0 or len(speeds) != 1:
            return None
        return Equation((letter, line("0")), number, line(phrases.math(speeds[0]), " constant:")), found
    size = simplified(x**2 - w.residual) if w.residual.coeff(x, 2) == 1 else simplified(x**2 + w.residual)
    if x not in moving or x in size.free_symbols or phrases.value(found.formula) <= 0:
        return None
    root = simplified(sp.sqrt(size))
    if not root.is_Symbol and not root.is_Rational:
        return None
    number_of = found.value if found.value is not None else phrases.value(found.formula)
    value = (phrases.math(root),) if phrases.symbolic else (phrases.shown(x, number_of),)
    lasting = any(v.times and v.lead == w.lead for b in stage.blocks for v in b.equations)
    return Equation((letter, *value), number, SPEEDS[not lasting]), found


def turned(w: Written) -> str:
    """`; a_van counts downward`, where the letter of a component that the file states has the other sign than it; else
    empty.
    """
    stated = re.match(r"[va]\(\w+\)\.([xy]) = (-?)[\d.]", w.words or w.lead)
    letters = w.residual.free_symbols
    if stated is None or w.times or len(letters) != 1:
        return ""
    (letter,) = letters
    slope = w.residual.coeff(letter, 1)
    size = sp.simplify(letter - w.residual / slope) if abs(slope) == 1 else letter
    if not size.is_number or size == 0 or bool(size < 0) == bool(stated[2]):
        return ""
    return f"; {letter.name} counts {'to the left' if stated[1] == 'x' else 'downward'}"
