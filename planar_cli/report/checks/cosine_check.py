"""A check that a person can make of the vector between two points: its length by the law of cosines.

law of cosines:  √(r² + r² - 2 r r cos 90°) = √2 r = |r_A2/A|
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import Polar
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

SHORT = 8
"""Operations of the length."""


def cosine_check(part: PartSolution, phrases: Phrases) -> Line:
    """In letters, of the first two points that the file puts at distances and angles from one and the same third;
    empty where none are asked.
    """
    if part.motion is not None or not part.instants:
        return ()
    return next((told for f in part.found if (told := _told(f, part, phrases))), ())


def _told(found: Found, part: PartSolution, phrases: Phrases) -> Line:
    what = found.find.found.what if found.find is not None else None
    if not isinstance(what, Quantity) or what.word != "r" or what.parts or len(what.things) != 2:
        return ()
    scene = part.instants[-1].instant.scene
    ways = [p.place for name in what.things for p in scene.problem.points if p.name == name]
    if found.values is not None or len(ways) != 2 or not all(isinstance(w, Polar) for w in ways):
        return ()
    one, other = (w for w in ways if isinstance(w, Polar))
    if one.origin != other.origin:
        return ()
    a, b = scene.value(one.distance), scene.value(other.distance)
    angle = simplified(scene.value(one.angle) - scene.value(other.angle))
    angle = -angle if angle.is_number and angle.is_negative else angle
    length = simplified(sp.sqrt(simplified(a**2 + b**2 - 2 * a * b * sp.cos(angle))))
    x, y = found.expressions or (sp.nan, sp.nan)
    if not angle.is_number or longer(length, SHORT) or not identically_zero(x**2 + y**2 - length**2):
        return ()
    corner, turn = phrases.math, sp.cos(angle, evaluate=False)
    inside = line("√(", corner(a), "² + ", corner(b), "² - 2 ", corner(a), " ", corner(b), " ", corner(turn), ")")
    ends = Name(f"r_{what.things[0]}/{what.things[1]}")
    return line("law of cosines: ", *inside, " = ", corner(length), " = |", ends, "|")
