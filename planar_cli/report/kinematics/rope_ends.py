"""The relation of a rope between the accelerations of its ends, where the equation has that of one of them through what
its body rolls on or turns about.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.system.system import System
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Explicit, Written


def named_end(w: Written, stage: Stage, system: System) -> tuple[Explicit, sp.Expr, sp.Expr] | None:
    """Of a rope tied to the mass centre of a body whose acceleration has a letter: the line of that letter, and both
    sides of what the rope itself says, a_B = -a_G; None: the equation is what the rope says.
    """
    rows = (row for mode in system.modes.values() for row in mode.facts.rows)
    own = next((row for row in rows if w.source == "row" and row.title == w.lead), None)
    sides = (w.left, w.right) if w.left.is_Symbol else (w.right, w.left)
    if own is None or not sides[0].is_Symbol:
        return None
    bodies = system.scene.bodies
    ends = (a for s in own.segments for a in (s.start, s.end) if a.body in bodies)
    tied = {a.body for a in ends if a.point == bodies[a.body].center}
    letters = {part for body in tied for _, part in stage.accelerations.get(body, ())}
    for x in stage.lines:
        factor = simplified(sides[1] / x.expression)
        if x.symbol in letters and factor.is_Rational:
            return x, sides[0], factor * x.symbol
    return None


def end_told(w: Written, found: tuple[Explicit, sp.Expr, sp.Expr], number: int, phrases: Phrases) -> Line:
    """`The cord keeps its length, a_B = -a_G, with (1):`"""
    _, left, right = found
    said = line(phrases.math(left), " = ", phrases.math(right))
    return line(f"{w.lead[:1].upper()}{w.lead[1:]}, ", *said, f", with ({number}):")
