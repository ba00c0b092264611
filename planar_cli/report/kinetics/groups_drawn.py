"""The diagrams of groups of bodies: an equation of disk and rod together is read off what acts on both, without what
they do to each other.

    disk, rod:  m_D g ↓ at G,  N_C ↑ at C,  m_R g ↓ at G_rod   =   m_D a_G → at G,  I α ↻,  m_R a_R → at G_rod

A body of which no equation is told alone has no diagram of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Forces, Inline, Line, Math, Text, Way, line
from planar_cli.report.kinetics.entries import entries, listed
from planar_cli.report.notation.names import plain_name
from planar_cli.solve.solution import InstantSolution

MOST = 4
"""The diagrams of a chain of more bodies are told one by one: those of its groups would be as long as all of them."""
VECTORS = 11
"""A diagram of more forces and accelerations is not read: its bodies have theirs one by one. What a body's mass times
acceleration has along one line is one of them."""
NOTHING = line("0")
DRIVE = re.compile("drive_")
ARROWS = "→←↑↓↗↙↖↘↺↻"
OPPOSITE = dict(zip(ARROWS, "←→↓↑↙↗↘↖↻↺", strict=True))


def with_groups(rows: Sequence[Forces], instant: InstantSolution, told: Iterable[Sequence[str]]) -> list[Forces]:
    """The rows of a stage: that of each body of which an equation is told alone, and one for each group. `told`: the
    bodies of each equation.
    """
    sets = list(dict.fromkeys(frozenset(bodies) for bodies in told if bodies))
    if max(map(len, sets), default=0) > MOST:
        return list(rows)
    drawn = {g: [r for r in rows if g.issuperset(_bodies(r))] for g in sets if len(g) > 1}
    groups = [own for g, own in drawn.items() if len(own) > 1 and g == {b for r in own for b in _bodies(r)}]
    taken = {b for own in groups for r in own for b in _bodies(r)}
    kept = [r for r in rows if frozenset(_bodies(r)) in sets or not taken.issuperset(_bodies(r))]
    made = [_together(own, instant) for own in sorted(groups, key=len)]
    full = any(sum(1 for _ in _told(r.left)) + _moving(r.right) > VECTORS for r in made)
    return list(rows) if full else [*kept, *made]


def _bodies(row: Forces) -> list[str]:
    return row.body.split(", ")


def _placed(row: Forces, scene: Scene) -> Forces:
    """That of a particle with where it is, as among others each force needs its place."""
    if scene.rigid(_bodies(row)[0]):
        return row
    at = f" at {plain_name(centre_of(scene, _bodies(row)[0]))}"

    def told(piece: Inline) -> Inline:
        if not isinstance(piece, Text) or piece.way is None or " at " in piece.text:
            return piece
        return replace(piece, text=re.sub(f"[{ARROWS}]", rf"\g<0>{at}", piece.text, count=1))

    return replace(row, left=tuple(map(told, row.left)), right=tuple(map(told, row.right)))


def _together(rows: Sequence[Forces], instant: InstantSolution) -> Forces:
    """One diagram of bodies without the forces between them."""
    placed = [_placed(row, instant.instant.scene) for row in rows]
    acting = list(_outer([(_bodies(row), list(_told(row.left))) for row in placed], instant.trial.system))
    # The momenta before a blow come first.
    acting.sort(key=lambda entry: not any(isinstance(p, Text) and p.way is not None and p.way.before for p in entry))
    moving = [entry for row in placed for entry in _told(row.right)]
    left, right = (listed(side or [NOTHING]) for side in (acting, moving))
    return replace(rows[0], body=", ".join(row.body for row in rows), left=left, right=right)


def _told(side: Line) -> Iterator[Line]:
    return (entry for entry in entries(side) if entry != NOTHING)


def _outer(acting: Sequence[tuple[list[str], list[Line]]], system: System) -> Iterator[Line]:
    """What acts on some bodies but has no opposite on another one of them."""
    every = [(bodies, entry) for bodies, side in acting for entry in side]
    inner: set[int] = set()
    for i, (bodies, entry) in enumerate(every):
        others = (k for k, (own, _) in enumerate(every) if k not in inner and own != bodies)
        found = (k for k in others if _acts_between(entry, bodies, every[k][0], system) and _cancel(entry, every[k][1]))
        if i not in inner and (other := next(found, None)) is not None:
            inner |= {i, other}
    yield from (entry for i, (_, entry) in enumerate(every) if i not in inner)


def _moving(side: Line) -> int:
    """The arrows of a kinetic diagram: several parts along one line through one point, [m l α_AB, 1/2 m l α_BC] ↑ at
    G_BC, are drawn as one.
    """
    seen: list[Way] = []
    ways = [way for entry in _told(side) if (way := _parts(entry)[1]) is not None]
    for way in ways:
        if not any(_one_line(way, other) for other in seen):
            seen.append(way)
    return len(seen)


def _one_line(one: Way, other: Way) -> bool:
    if one.direction is None or other.direction is None:
        return False
    arm = other.place - one.place
    return all(d == 0 or one.value.vanishes(d) for d in (one.direction.cross(other.direction), arm.x, arm.y))


def _acts_between(entry: Line, some: Sequence[str], others: Sequence[str], system: System) -> bool:
    """Is it a reaction, or does its load act on both sides, as a spring between them?"""
    letters = {s for p in entry if isinstance(p, Math) for s in p.expr.free_symbols}
    if letters & set(system.symbols.values()):
        return True
    loads = [{w.name for w in system.wrenches if w.body in bodies} for bodies in (some, others)]
    return bool(loads[0] & loads[1])


def _cancel(one: Line, other: Line) -> bool:
    """Are both the same force along the same line, or the same couple, in opposite directions?"""
    (size, way, arrow), (other_size, other_way, other_arrow) = _parts(one), _parts(other)
    if (
        way is None
        or other_way is None
        or way.before
        or other_way.before
        or size != other_size
        or OPPOSITE.get(arrow) != other_arrow
    ):
        return False
    if way.direction is None or other_way.direction is None:
        return way.direction is other_way.direction
    # What drives one body along another is told at a place of each.
    arm = Vec(sp.S.Zero, sp.S.Zero) if DRIVE.match(size) else other_way.place - way.place
    apart = (v.cross(way.direction) for v in (arm, other_way.direction))
    return all(a == 0 or way.value.vanishes(a) for a in apart)


def _parts(entry: Line) -> tuple[str, Way | None, str]:
    """Its size, where it is and which way."""
    for i, piece in enumerate(entry):
        if isinstance(piece, Text) and piece.way is not None:
            return as_text(entry[:i]), piece.way, next((c for c in piece.text if c in ARROWS), "")
    return as_text(entry), None, ""
