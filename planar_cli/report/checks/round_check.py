"""A check that a person can make of a point that goes round a fixed pin: its distance, and its velocity across that.

OB = √(0.4715² + 0.3710²) = 0.6 m;  v_B · r_B/O = 0.4715 (-0.1237) + 0.3710 · 0.1572 = 0, at right angles
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Unvalued
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Line, Name, Text, line
from planar_cli.report.given.given_vectors import size_of
from planar_cli.report.in_numbers.sums import agree
from planar_cli.report.kinematics.component_sums import sum_of_products
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import LENGTH, VELOCITY


def round_check(part: PartSolution, phrases: Phrases) -> Line:
    """Of the first point of which place and velocity are asked at the same state; empty where there is none."""
    if phrases.symbolic or not part.instants:
        return ()
    places, speeds = (_vectors(part.found, word) for word in "rv")
    for (point, state), place in places.items():
        if (point, state) in speeds:
            try:
                told = _told(part, point, (place, speeds[(point, state)]), phrases)
            except Unvalued:
                continue
            if told:
                return told
    return ()


def _vectors(found: Sequence[Found], word: str) -> dict[tuple[str, str], Vec]:
    """The vectors of points that are asked, in numbers, by point and state."""
    vectors: dict[tuple[str, str], Vec] = {}
    for f in found:
        what = f.find.found.what if f.find is not None else None
        if isinstance(what, Quantity) and what.word == word and not what.parts and len(what.things) == 1:
            state = what.at if isinstance(what.at, str) else ""
            if f.kind == "vector" and f.values is not None:
                vectors[(what.things[0], state)] = Vec(*map(Decimal, f.values))
    return vectors


def _told(part: PartSolution, point: str, found: tuple[Vec, Vec], phrases: Phrases) -> Line:
    trial, scene = part.instants[-1].trial, part.instants[-1].instant.scene
    place, speed = found
    if point not in scene.points:
        return ()
    body = scene.owner(point)
    pins = [
        j.place
        for mode in trial.system.modes.values()
        for j in mode.facts.joinings
        if {j.mover, j.base} == {body, GROUND} and j.path is None and j.rolling is None and j.drift is None
    ]
    pin = next((p for p in pins if p in scene.points and p != point), None)
    if pin is None:
        return ()
    centre, apart = scene.point(pin), scene.point(point) - scene.point(pin)
    arm = place - Vec(*(phrases.certain(e) for e in (centre.x, centre.y)))
    reach = phrases.value(simplified(apart.dot(apart))).sqrt()
    if not all((arm.x, arm.y, speed.x, speed.y)) or not agree([arm.dot(arm)], [reach**2]):
        return ()
    if abs(arm.dot(speed)) > abs(arm.x * speed.x) * Decimal("1e-9"):
        return ()
    numbers = [phrases.of_dimension(p, d).number for p, d in ((arm.x, LENGTH), (speed.x, VELOCITY))]
    others = [phrases.of_dimension(p, d).number for p, d in ((arm.y, LENGTH), (speed.y, VELOCITY))]
    # Each by itself: a sum that comes to nothing would be told as that.
    along, across = (sum_of_products([(1, ((a, 1), (b, 1)))], phrases.figures) for a, b in (numbers, others))
    name = Text(f"{pin}{point}") if len(pin) == len(point) == 1 else Name(f"r_{point}/{pin}")
    size = line(name, " = ", size_of((arm.x, arm.y), LENGTH, phrases), " = ", phrases.of_dimension(reach, LENGTH))
    both = line("; ", Name(f"r_{point}/{pin}"), " · ", Name(f"v_{point}"), " = ")
    return line(*size, *both, along, " + ", across, " = 0, at right angles")
