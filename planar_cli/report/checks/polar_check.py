"""A check that a person can make of an acceleration: polar coordinates about the pin of the body along which it slides.

    about O: a_r = r̈ - r ω² = -0.2 - 0.5 · 4² = -8.2, a_θ = r α + 2 ṙ ω = 0.5 (-3) + 2 · 0.6 · 4 = 3.3,
    √(a_r² + a_θ²) = 8.839 m/s² = |a_P|

The page works with the vectors of a turning frame, or with components along x and y. Where it has the polar components
itself, the place x = r cos θ differentiated twice gives the component along x once more.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Line, Math, Name, line
from planar_cli.report.in_numbers.sums import ROUNDING, agree
from planar_cli.report.kinematics.component_sums import Power, sum_of_products
from planar_cli.report.kinematics.polar_slides import polar_slide
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ACCELERATION, LENGTH, RATE, TIME, VELOCITY, Dimension

ANGULAR = RATE / TIME
Product = tuple[int, tuple[Power, ...]]


def polar_check(instant: InstantSolution, phrases: Phrases) -> Line:
    """Empty where nothing slides along a straight line through a fixed pin, or its acceleration is not told."""
    motion = instant.trial.system.motion
    if phrases.symbolic or motion is None:
        return ()
    joinings = [j for mode in instant.trial.system.modes.values() for j in mode.facts.joinings]
    pins = {
        body: j
        for j in joinings
        for body, other in ((j.mover, j.base), (j.base, j.mover))
        if other == GROUND and j.path is None and j.rolling is None and j.drift is None
    }
    for j in joinings:
        if j.base in pins and j.path is not None and j.path.curvature == 0 and j.place:
            try:
                told = _told(instant, phrases, j, pins[j.base])
            except Unvalued:
                continue
            if told:
                return told
    return ()


def _told(instant: InstantSolution, phrases: Phrases, j: Joining, pin: Joining) -> Line:
    system = instant.trial.system
    motion, scene = system.motion, system.scene
    assert motion is not None
    if j.place not in scene.points or j.path is None:
        return ()
    arm, way = _numbers(j.point - pin.point, phrases), _numbers(j.path.tangent, phrases)
    r = _size(arm)
    if not r or abs(arm.cross(way)) > r * ROUNDING:
        return ()
    way = arm * (1 / r)
    relative, beyond = (_numbers(v, phrases) for v in system.quantities().seen_from(j.place, j.base))
    own = _numbers(motion.acceleration(j.point, j.mover), phrases)
    omega, alpha = (phrases.certain(t[j.base].angular) for t in (motion.velocities, motion.accelerations))
    rate, second = relative.dot(way), beyond.dot(way)
    along, across = second - r * omega**2, r * alpha + 2 * rate * omega
    if not (rate and omega) or not along or not across or not agree([along**2, across**2], [_size(own) ** 2]):
        return ()
    sizes: list[tuple[Decimal, Dimension]] = [
        (second, ACCELERATION), (r, LENGTH), (omega, RATE), (alpha, ANGULAR), (rate, VELOCITY),
    ]  # fmt: skip
    numbers = [phrases.of_dimension(x, d, d in (RATE, ANGULAR)).number for x, d in sizes]
    outward, reach, turn, gain, slide = numbers
    if polar_slide(system, phrases, j.mover, j.place, j.base) is not None:
        return _along_x(numbers, way, own, j.place, phrases)
    first = _sum((1, ((outward, 1),)), (-1, ((reach, 1), (turn, 2))), figures=phrases.figures)
    last = _sum((1, ((reach, 1), (gain, 1))), (1, ((Decimal(2), 1), (slide, 1), (turn, 1))), figures=phrases.figures)
    results = [phrases.of_dimension(x, ACCELERATION) for x in (along, across, _size(own))]
    return line(
        f"polar coordinates about {pin.place}: ", Name("a_r"), " = r̈ - r ω² = ", first, " = ", results[0],
        ", ", Name("a_theta"), " = r α + 2 ṙ ω = ", last, " = ", results[1],
        "; √(", Name("a_r"), "² + ", Name("a_theta"), "²) = ", results[2],
        " = |", Name(f"a_{index_of(j.place)}"), "|",
    )  # fmt: skip


def _along_x(numbers: list[Decimal], way: Vec, own: Vec, place: str, phrases: Phrases) -> Line:
    """ẍ = r̈ cos θ - 2 ṙ ω sin θ - r α sin θ - r ω² cos θ, with its numbers; nothing for a line along an axis."""
    outward, reach, turn, gain, slide = numbers
    if not way.x or not way.y:
        return ()
    worked = _sum(
        (1, ((outward, 1), (way.x, 1))),
        (-1, ((Decimal(2), 1), (slide, 1), (turn, 1), (way.y, 1))),
        (-1, ((reach, 1), (gain, 1), (way.y, 1))),
        (-1, ((reach, 1), (turn, 2), (way.x, 1))),
        figures=phrases.figures,
    )
    letters = ["r̈ cos θ" if outward else "", "2 ṙ ω sin θ", "r α sin θ" if gain else "", "r ω² cos θ"]
    return line(
        "x = r cos θ, differentiated twice: ẍ = ", "" if outward else "-", " - ".join(x for x in letters if x),
        " = ", worked, " = ", phrases.of_dimension(own.x, ACCELERATION), " = ", Name(f"a_{index_of(place)}x"),
    )  # fmt: skip


def _sum(*terms: Product, figures: int) -> Math:
    return sum_of_products([t for t in terms if all(number for number, _ in t[1])], figures)


def _numbers(v: Vec, phrases: Phrases) -> Vec:
    return Vec(*(phrases.certain(sp.sympify(p)) for p in (v.x, v.y)))


def _size(v: Vec) -> Decimal:
    return Decimal(v.dot(v)).sqrt()
