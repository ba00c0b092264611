"""Where a component of a velocity is given: first the vector equation of that point, of which it is one."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.kinematics.components import component
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Name, Paragraph, line
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.names import index_of
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written

COMPONENT = re.compile(r"([va])\((\w+)\)\.[xy] = ")
LONGEST = 12
"""A component of more operations is told only with what is given put in."""
LEVELS = {"v": "velocity", "a": "acceleration"}


def against(w: Written, number: sp.Expr) -> bool:
    """Is a component that the file gives as a number on the other side of an equation with the other sign?"""
    found = COMPONENT.match(w.lead) if w.source == "given" and not w.times else None
    given = w.lead[found.end() :] if found is not None else ""
    if not given.lstrip("-")[:1].isdigit() or number == 0:
        return False
    return bool(number.could_extract_minus_sign()) != given.startswith("-")


def with_given(
    w: Written, blocks: list[Block], stage: Stage, vectors: VectorTelling, number: Callable[[Stage, int], int]
) -> list[Block]:
    """The blocks of a closing relation with the number of the given velocity that stands in it in place of an unknown:
    v = (x_B - R) ω_rod, by (1).
    """
    last = blocks[-1] if blocks else None
    j = next((j for j in vectors.system.tree.closures if j.joint == w.lead and j.place), None)
    if w.source != "closure" or stage.level != "velocity" or j is None or not isinstance(last, Equation) or last.note:
        return blocks
    own = vectors.motion.velocity(j.point, j.mover)
    put = w.residual.free_symbols - own.x.free_symbols - own.y.free_symbols
    given = [g for b in stage.blocks for g in b.equations if g.source == "given" and not g.given and not g.times]
    by = [g for g in given if put & g.residual.free_symbols and not g.residual.free_symbols <= w.residual.free_symbols]
    if len(by) != 1 or len(last.sides) > 2:
        return blocks
    whole = _whole(w, j, own, vectors)
    return [*blocks[:-1], *whole, replace(last, note=line(f"by ({number(stage, by[0].number)})"))]


def _whole(w: Written, j: Joining, own: Vec, vectors: VectorTelling) -> list[Block]:
    """v_By = R ω_wheel + (x_B - R) ω_rod = 0, before what is given is put in; nothing along an oblique line."""
    x, y = w.along or (sp.S.One, sp.S.One)
    if j.base != GROUND or j.drift is not None or 0 not in (x, y) or vectors.phrases.symbolic:
        return []
    axis, part = ("x", own.x) if y == 0 else ("y", own.y)
    part = simplified(part)
    if longer(part, LONGEST) or not is_clean(vectors.phrases.ledger, part):
        return []
    return [Equation((line(Name(f"v_{component(index_of(j.place), axis)}")), vectors.phrases.math(part), line("0")))]


def vector_before(w: Written, vectors: VectorTelling, level: str) -> list[Block]:
    """v_O = ω × r_O/C before the given v_O, where O is a point of a body that turns."""
    found = COMPONENT.match(w.lead) if w.source == "given" and not w.place and not w.times else None
    scene = vectors.system.scene
    if found is None or LEVELS[found[1]] != level or found[2] not in scene.points:
        return []
    body = scene.owner(found[2])
    if body not in scene.bodies or not scene.rigid(body):
        return []
    told = list(vectors.point(body, scene.point(found[2]), found[2], level))
    return told or list(_carried(body, found[2], level, vectors))


def _carried(body: str, place: str, level: str, vectors: VectorTelling) -> Iterator[Block]:
    """Of a body that translates, as a rack on a wheel, the velocity of the point at which it is carried; of its
    acceleration what a wheel that rolls on a straight line gives it along the contact.
    """
    edge, motion = vectors.edges.get(body), vectors.motion
    j = edge.joining if edge is not None else None
    spins = (twists[body].angular for twists in (motion.velocities, motion.accelerations))
    turns = any(spin not in vectors.zero and not vectors.phrases.value.is_zero(spin) for spin in spins)
    if edge is None or j is None or turns or edge.parent == GROUND or j.path is not None or j.drift is not None:
        return
    own, carrier, note = index_of(place), vectors.edges.get(edge.parent), line(f"{body} translates")
    if level == "velocity":
        yield from vectors.point(edge.parent, j.point, j.place, level)
        yield Equation((line(Name(f"v_{own}")), line(Name(f"v_{index_of(j.place)}"))), None, note=note)
        return
    ground = carrier.joining if carrier is not None and carrier.parent == GROUND else None
    straight = ground is not None and ground.rolling is not None and vectors.phrases.value.is_zero(ground.rolling.base)
    if straight and j.rolling is not None and ground is not None:
        omega, alpha = (t[edge.parent].angular for t in (motion.velocities, motion.accelerations))
        arm, touches = Name(f"r_{index_of(j.place)}/{index_of(ground.place)}"), Name(f"v_{index_of(ground.place)}")
        gained = line(Name(f"a_{own}"), " = ", vectors.phrases.math(alpha), " × ", arm)
        if vectors.phrases.value.is_zero(omega):
            yield Paragraph(line(*note, f" and never slips at {j.place}; {edge.parent} does not turn now: ", *gained))
            return
        driven = () if ground.drift is None else (touches, " + ")
        whole = (Name(f"v_{own}"), " = ", *driven, vectors.phrases.math(omega), " × ", arm, " at all times")
        across = f". The point {j.place} of {edge.parent} has an acceleration across the contact as well."
        yield Paragraph(line(*note, f" and never slips at {j.place}: ", *whole, ", differentiated: ", *gained, across))
