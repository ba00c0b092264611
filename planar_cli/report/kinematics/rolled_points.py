"""Where bodies touch that the file gives no name to, and how what rolls there moves: a_C, then a_G from it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.algebra.bounds import certain_sign
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.kinematics.motion import Twist
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Paragraph, line
from planar_cli.report.kinematics.rolled_parts import told_by_axes
from planar_cli.report.words.counted import as_vector
from planar_cli.report.words.words import Phrases

OWN_NAME = re.compile(r"C_\d+$")
LONGEST = 12
"""A component of an arm of more operations is not told."""


def touching(system: System, kinetic: bool) -> list[Paragraph]:
    """C_1: where plank touches trunk; nothing where no forces are told."""
    found: list[Paragraph] = []
    for name, mode in system.modes.items() if kinetic else ():
        joint = next((j for j in system.scene.problem.joints if j.name == name), None)
        between = [str(b) for b in getattr(joint, "between", ())]
        places = {j.place for j in mode.facts.joinings} | {p.place for p in mode.facts.pushes}
        faces = mode.name == "tip" or any(p.kind == "couple" for p in mode.facts.pushes)
        if len(between) == 2 and not faces:
            words = f": the point where {between[0]} touches {between[1]}"
            found += [Paragraph(line(Name(p), words)) for p in sorted(places) if OWN_NAME.match(p)]
    return found


def is_named(parts: Sequence[tuple[Vec, sp.Expr]], twist: Twist) -> bool:
    """Is the acceleration of a mass centre one letter, of which a line tells what it is? α of its body is none."""
    return len(parts) == 1 and parts[0][1] not in (twist.angular, -twist.angular)


def rolling(system: System, body: str, phrases: Phrases) -> Iterator[Block]:
    """Of a body that rolls on the ground: the acceleration of its point of contact, if any, and of its mass centre."""
    edge = next((e for e in system.tree.edges if e.body == body), None)
    j = edge.joining if edge is not None else None
    if edge is None or j is None or j.rolling is None or j.drift is not None or {j.mover, j.base} != {body, GROUND}:
        return
    motion = system.motion
    assert motion is not None
    omega, alpha = motion.velocities[body].angular, motion.accelerations[body].angular
    arm = system.scene.center(body) - j.point
    if alpha == 0 or any(longer(p, LONGEST) for p in (arm.x, arm.y)):
        return
    at, centre = j.place, centre_of(system.scene, body)
    name = Name(f"r_{centre}/{at.replace('_', '')}")
    note = line(name, " = [", phrases.math(arm.x), ", ", phrases.math(arm.y), "]")
    if omega == 0:
        # At rest its point of contact has no acceleration either.
        turned = line(phrases.math(as_vector(alpha, system)), " × ", name)
        sides = (line(Name(f"a_{centre}")), turned, *told_by_axes(system, body, phrases))
        yield Equation(sides, None, line(f"{body} rolls without slipping:"), note)
        return
    if around := _on_a_circle(system, j, centre, phrases):
        speed, inward, why = around
        yield Equation(speed, None, line(f"{body} rolls without slipping:"))
        return (yield Equation(inward, None, note=why))
    if round_centre := centre_on_a_line(system, j, phrases):
        return (yield from _from_the_centre(system, body, round_centre, phrases))
    normal = motion.accelerations[body].linear
    size = _size(normal.x, normal.y)
    if size is None:
        return
    own = Name(f"a_{at.replace('_', '')}")
    arrow = phrases.arrow(normal.x, normal.y)
    yield Equation((line(own), line(phrases.math(size), f" {arrow}")), None, line(f"{body} rolls without slipping:"))
    turned = line(phrases.math(as_vector(alpha, system)), " × ", name, " - ", phrases.math(omega**2), " ", name)
    yield Equation((line(Name(f"a_{centre}")), line(own, " + ", *turned)), None, note=note)


def _on_a_circle(
    system: System, j: Joining, centre: str, phrases: Phrases
) -> tuple[tuple[Line, ...], tuple[Line, ...], Line] | None:
    """v_G = r ω, and v_G²/(R + r) by that, with the path on which that is the acceleration towards its middle, of a
    round body whose centre goes round that of what it rolls on; None: it is another one.
    """
    assert j.rolling is not None
    own, base, value = j.rolling.mover, j.rolling.base, phrases.value
    if value.vanishes(own) or value.vanishes(base):
        return None
    off = j.point + j.rolling.tangent.turned() / own - system.scene.center(j.mover)
    radius, path = (_sized(e, phrases) for e in (1 / own, 1 / base - 1 / own))
    if not all(value.vanishes(p) for p in (off.x, off.y)) or radius is None or path is None:
        return None
    assert system.motion is not None
    omega = system.motion.velocities[j.mover].angular
    v = sp.Symbol(f"v_{centre}", real=True)
    if not omega.is_Symbol or v.name in system.scene.ledger.symbols:
        return None
    speed = (line(Name(v.name)), line(phrases.math(radius * omega)))
    inward = (line(phrases.math(v**2 / path)), line(phrases.math(radius**2 * omega**2 / path)))
    return speed, inward, line("a_n: ", Name(centre), " moves on a circle of radius ", phrases.math(path))


def _sized(length: sp.Expr, phrases: Phrases) -> sp.Expr | None:
    """A radius without its sign; None: it has no number by which to tell that, or is long."""
    found, number = simplified(length), phrases.value.known(length)
    if number is None or longer(found, LONGEST):
        return None
    return found if number > 0 else simplified(-found)


def centre_on_a_line(system: System, j: Joining, phrases: Phrases) -> tuple[str, Vec, Vec] | None:
    """The named centre of a round outline that rolls on a straight line, its arm from the contact, and its place; None:
    there is none, or the line moves. It keeps its distance from the line, so that it has no acceleration across it.
    """
    assert j.rolling is not None
    own, base, value = j.rolling.mover, j.rolling.base, phrases.value
    if j.base != GROUND or value.vanishes(own) or not value.vanishes(base):
        return None
    arm = j.rolling.tangent.turned() / own
    centre = j.point + arm
    for name in system.scene.points:
        at = system.scene.point(name)
        if system.scene.owner(name) == j.mover and all(value.vanishes(p) for p in (at.x - centre.x, at.y - centre.y)):
            return name, arm, at
    return None


def _from_the_centre(system: System, body: str, centre: tuple[str, Vec, Vec], phrases: Phrases) -> Iterator[Block]:
    """a_O = R α along the line, and a_G from it."""
    name, arm, at = centre
    motion = system.motion
    assert motion is not None
    omega, alpha = motion.velocities[body].angular, motion.accelerations[body].angular
    size, away = _size(arm.x, arm.y), system.scene.center(body) - at
    if size is None or any(longer(p, LONGEST) for p in (away.x, away.y)):
        return
    way, letter = arm.turned(), as_vector(alpha, system)
    way = -way if letter != alpha else way
    own, other = Name(f"a_{name}"), centre_of(system.scene, body)
    lead, why = line(f"{body} rolls without slipping:"), line(Name(name), " moves along a straight line")
    yield Equation((line(own), line(phrases.math(size * letter), f" {phrases.arrow(way.x, way.y)}")), None, lead, why)
    if all(phrases.value.vanishes(p) for p in (away.x, away.y)):
        return
    between = Name(f"r_{other}/{name}")
    turned = line(phrases.math(letter), " × ", between, " - ", phrases.math(omega**2), " ", between)
    note = line(between, " = [", phrases.math(away.x), ", ", phrases.math(away.y), "]")
    sides = (line(Name(f"a_{other}")), line(own, " + ", *turned), *told_by_axes(system, body, phrases))
    yield Equation(sides, None, note=note)


def in_plain_lengths(direction: Vec, component: sp.Expr, value: Valuation) -> list[tuple[Vec, sp.Expr]]:
    """A vector whose length is the root of a sum, R ω² √(1 + θ²), as those along and across what it turns with. One
    that turns with nothing stays what it is where its parts may point the other way, as from a place (x, y) towards a
    centre (0, -d).
    """
    square = simplified(sp.sympify(direction.dot(direction)))
    if not square.has(sp.Add) or not square.free_symbols:
        return [(direction, component)]
    groups: dict[sp.Expr, list[sp.Expr]] = {}
    for i, part in enumerate((direction.x, direction.y)):
        for term in sp.Add.make_args(expanded(sp.sympify(part))):
            waves = term.atoms(sp.sin, sp.cos)
            rest, wave = term.as_independent(*waves) if waves else (term, sp.S.One)
            sign = -1 if rest.could_extract_minus_sign() else 1
            groups.setdefault(sign * rest, [sp.S.Zero, sp.S.Zero])[i] += sign * wave
    units = [(Vec(x, y), rest * component) for rest, (x, y) in groups.items()]
    turns = any(sp.sympify(p).has(sp.sin, sp.cos) for p in (direction.x, direction.y))
    certain = turns or all(certain_sign(_in_data(rest, value)) == 1 for rest in groups)
    plain = certain and len(units) > 1 and all(simplified(way.dot(way)) == 1 for way, _ in units)
    return units if plain else [(direction, component)]


def _in_data(length: sp.Expr, value: Valuation) -> sp.Expr:
    """With what its letters stand for, as x_G for e m/M, down to the data."""
    known = dict(value.definitions)
    while length.free_symbols & known.keys():
        length = sp.sympify(length.xreplace(known))
    return length


def _size(x: sp.Expr, y: sp.Expr) -> sp.Expr | None:
    """The length of a vector as a plain product; None: it is zero or none."""
    length = simplified(sp.sqrt(simplified(x**2 + y**2)))
    return None if length == 0 or length.has(sp.Add) or length.is_Add else length
