"""A link or a taut cord between two points on straight guides: its length in coordinates, and that differentiated.

x² + y² = AB²                                    differentiated:              x v_A + y v_B = 0
                                                 differentiated once more:    v_A² + x a_A + v_B² + y a_B = 0
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Paragraph, line
from planar_cli.report.kinematics.along_slots import distance_named
from planar_cli.report.notation.names import index_of, plain_name
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.led import OF_LENGTH, led_by_ground, reach_of
from planar_cli.solve.instant.written import Written
from planar_cli.units import LENGTH

LONGEST = 4
"""A fixed part of the distance with more operations is not written in coordinates."""


def between_led(
    j: Joining, w: Written, named: str, times: str, normal: Line, system: System, phrases: Phrases
) -> list[Block]:
    """What stands before the relation. `named`: what the tie is called; `times`: how often its length is
    differentiated here: `Differentiated`, `Differentiated twice`; `Differentiated once more` of a length that stands on
    the page; `normal`: |v_B - v_A|²/AB in numbers.
    """
    once = times.endswith("more")
    whole = line(*distance_named(j.far, j.place), "²")
    keeps = Paragraph(line(f"{named} keeps its length:"))
    coordinates = _coordinates(j, system) if w.words == OF_LENGTH else None
    if coordinates is not None:
        reach, put = coordinates
        length = Equation((phrases.math(reach.x**2 + reach.y**2), whole))
        rest = _derived(w, phrases) if once else _put(put, phrases)
        return [*(() if once else (keeps, length)), Paragraph(line(times, *rest, ":"))]
    arm, reach = Name(f"r_{index_of(j.place)}/{index_of(j.far)}"), reach_of(j, system)
    length = Equation((line(arm, " · ", arm), whole), None, (), line(arm, " = ", *_vector(reach, phrases)))
    ending = ":" if w.words == OF_LENGTH else ", divided by its length:"
    square = line("; ", *_square(j), "/", *distance_named(j.far, j.place), " = ", *normal) if normal else ()
    rates = _rates(j, arm, "v" if times == "Differentiated" else "a")
    return [*(() if once else (keeps, length)), Paragraph(line(times, ", ", *rates, *square, ending))]


def _vector(reach: Vec, phrases: Phrases) -> Line:
    if phrases.symbolic:
        return line("[", phrases.math(reach.x), ", ", phrases.math(reach.y), "]")
    return phrases.vector(phrases.certain(reach.x), phrases.certain(reach.y), LENGTH)


def _derived(w: Written, phrases: Phrases) -> Line:
    """, v_A² + x a_A + v_B² + y a_B = 0: with all its terms, before those of the speeds go to the other side."""
    return () if w.right == 0 else line(", ", phrases.math(w.left - w.right), " = 0")


def _put(put: Sequence[tuple[sp.Symbol, sp.Expr]], phrases: Phrases) -> Line:
    """, with x_A = a and y_B = b: of coordinates for which the file has no letters that vary. One that the page has
    found as y_B needs no word.
    """
    parts: list[Any] = []
    for letter, place in put:
        if place.is_Symbol and plain_name(place.name) == plain_name(letter.name):
            continue
        parts += [" and " if parts else ", with ", phrases.math(letter), " = ", phrases.math(place)]
    return line(*parts)


def _rates(j: Joining, arm: Name, rate: str) -> Line:
    """r_B/A · (v_B - v_A) = 0, or r_B/A · (a_B - a_A) + |v_B - v_A|² = 0."""
    one, other = index_of(j.place), index_of(j.far)
    product = line(arm, " · (", Name(f"{rate}_{one}"), " - ", Name(f"{rate}_{other}"), ")")
    return line(*product, *(() if rate == "v" else line(" + ", *_square(j))), " = 0")


def _square(j: Joining) -> Line:
    """|v_B - v_A|²"""
    return line("|", Name(f"v_{index_of(j.place)}"), " - ", Name(f"v_{index_of(j.far)}"), "|²")


def _coordinates(j: Joining, system: System) -> tuple[Vec, list[tuple[sp.Symbol, sp.Expr]]] | None:
    """The distance of the ends in coordinates, and what those are now that the file has no letter of its own for.
    None: an end is led along an oblique line.
    """
    own, put = set(system.scene.ledger.coordinates), list[tuple[sp.Symbol, sp.Expr]]()
    ends = list[list[sp.Expr]]()
    for body, name in ((j.base, j.far), (j.mover, j.place)):
        at, (way,) = system.scene.point(name) if name in system.scene.points else j.point, led_by_ground(system, body)
        if 0 not in (way.x, way.y):
            return None
        parts = [sp.sympify(at.x), sp.sympify(at.y)]
        moved = 0 if way.y == 0 else 1
        if parts[moved] not in own:
            letter = sp.Symbol(system.scene.ledger.apart(f"{'xy'[moved]}_{name}"), real=True)
            put.append((letter, parts[moved]))
            parts[moved] = letter
        fixed = parts[1 - moved]
        if longer(fixed, LONGEST) or (fixed.is_number and fixed != 0) or fixed.free_symbols & own:
            return None
        ends.append(parts)
    (x, y), (u, v) = ends
    return Vec(u - x, v - y), put
