"""What finds ask of places, velocities and accelerations: of which points, how often differentiated, in which parts."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

import sympy as sp

from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import GROUND, Find
from planar_cli.records import record
from planar_cli.solve.curves.by_coordinates import DOTS

LEVELS = {"r": 0, "x": 0, "y": 0, "v": 1, "IC": 1, "coriolis": 1, "KE": 1, "momentum": 1, "H": 1, "a": 2, "rho": 2}
ANGLES = {"theta": 0, "omega": 1, "alpha": 2}
WITHOUT_POINT = ("KE", "momentum", "H")
POLAR = ("r", "theta")


@record
class Use:
    """One quantity of a find, and how often what it is about is differentiated."""

    quantity: Quantity
    level: int


def asked_in(finds: Iterable[Find]) -> Iterator[Use]:
    for find in finds:
        dots = 0
        for q in (n for n in walk(find.found.what) if isinstance(n, Quantity)):
            if q.word in ("dot", "ddot"):
                dots += 1 if q.word == "dot" else 2
            elif q.word in ANGLES or q.word in LEVELS:
                yield Use(q, min({**LEVELS, **ANGLES}[q.word] + dots, 2))


def is_whole(quantity: Quantity, thing: str) -> bool:
    """Are both components of the velocity or the acceleration of a thing asked?"""
    return quantity.word in ("v", "a") and not quantity.parts and quantity.things == (thing,)


def polar_of(asked: list[Use]) -> dict[tuple[str, str], int]:
    """Points of which components along and across r are asked, each with the origin of r ("": that of the file)."""
    found: dict[tuple[str, str], int] = {}
    for use in asked:
        if use.quantity.parts and use.quantity.parts[0].kind in POLAR:
            things = use.quantity.things
            key = (things[0], "" if len(things) < 2 or things[1] == GROUND else things[1])
            found[key] = max(found.get(key, 0), use.level)
    return found


SIZES = frozenset({"v", "a"})
"""Of these the components in polar coordinates tell as well."""


def kinds_of(use: Use) -> set[str]:
    """What is asked of a point along its path: its speed (v), the size of its acceleration (a), t, n, rho."""
    quantity, kinds = use.quantity, {p.kind for p in use.quantity.parts}
    if quantity.word == "rho":
        return {"rho"}
    if quantity.word == "a":
        return (kinds & {"t", "n"}) | ({"a"} if "mag" in kinds else set())
    return {"v"} if quantity.word == "v" and "mag" in kinds else set()


def along_paths(asked: list[Use], polar: Iterable[tuple[str, str]]) -> list[tuple[str, list[Use]]]:
    """Points of which something along the path is asked that is not told in polar coordinates, as sizes are, with
    that.
    """
    around = {point for point, _ in polar}
    found: dict[str, list[Use]] = {}
    for use in asked:
        point = use.quantity.things[0]
        if kinds_of(use) - (SIZES if point in around else frozenset()):
            found.setdefault(point, []).append(use)
    return list(found.items())


def tells(find: Find, names: Collection[str], finds: Iterable[Find]) -> bool:
    """Has what is asked a line of its own here? `names`: coordinates that are told; `finds`: all that is asked."""
    q = find.found.what
    if isinstance(q, Name):
        return q.name in names
    if isinstance(q, Quantity) and q.word == "r" and {p.kind for p in q.parts} <= {"mag", "angle"} and q.parts:
        return q.things in [(point, origin) for point, origin in polar_of(list(asked_in(finds)))]
    if not isinstance(q, Quantity) or q.word not in ("r", "v", "a", "rho", *ANGLES):
        return False
    kinds = {p.kind for p in q.parts}
    return kinds <= {"x", "y"} or (kinds <= {"mag", "t", "n"} and q.word in ("v", "a")) or kinds <= set(POLAR)


def letter_of(find: Find) -> sp.Symbol | None:
    """The letter of a find that is one component or a magnitude; None: it is another thing."""
    q = find.found.what
    if not isinstance(q, Quantity) or len(q.parts) > 1 or q.word not in ("r", "v", "a", "rho"):
        return None
    kind, point = q.parts[0].kind if q.parts else "", q.things[0]
    if kind in ("x", "y"):
        return sp.Symbol(f"{kind}_{point}{DOTS[LEVELS[q.word]]}", real=True)
    if kind in (*POLAR, "t", "n"):
        return sp.Symbol(f"{q.word}_{point}_{kind}", real=True)
    return sp.Symbol(f"{q.word}_{point}", real=True) if kind == "mag" or q.word == "rho" else None


def magnitudes_of(asked: list[Use], point: str) -> set[int]:
    """Of a point's velocity (1) and acceleration (2) those of which the magnitude is asked."""
    sizes = (u for u in asked if [p.kind for p in u.quantity.parts] == ["mag"] and u.quantity.things == (point,))
    return {u.level for u in sizes if u.level}


def wanted_of(asked: list[Use], polar: set[str]) -> dict[tuple[str, bool], int]:
    """Which points (False) and angles of bodies (True) are told, differentiated how often. Of a point that is told in
    polar coordinates magnitudes need nothing more.
    """
    found: dict[tuple[str, bool], int] = {}
    for use in asked:
        q = use.quantity
        kinds = {p.kind for p in q.parts}
        if q.word not in ANGLES and q.things[0] in polar and kinds and kinds <= {*POLAR, "mag"}:
            continue
        for thing in q.things[:1] if q.word in WITHOUT_POINT else q.things:
            key = (thing, q.word in ANGLES)
            found[key] = max(found.get(key, 0), use.level)
    return found
