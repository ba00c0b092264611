"""The vectors of the vector equations of a page, in numbers: each by the others of its equation, or by the motion."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.values.jets import Jet
from planar_cli.errors import PlanarError
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.vector_sums import VECTOR
from planar_cli.figures.vector_terms import Sum, Term
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import with_article
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Paragraph, Text
from planar_cli.report.document.marks import Spot
from planar_cli.report.notation.names import index_of

CLOSED = 1e-9
"""How closely the vectors of an equation close, in parts of the largest one."""
TANGENT = "e_t"
RADIAL = ("radial", "outward", "inward")
"""The parts of a motion in polar coordinates that lie along the line from the pole."""
FIXED_TO = re.compile(r"(?P<place>\S+)′: the point fixed to (?P<body>.+) that coincides with ")


@record
class Closed:
    """A vector equation in numbers that agree: its left side, and each term with its vector [m/s or m/s²]."""

    sum: Sum
    whole: Spot
    parts: tuple[tuple[Term, Spot], ...]


class Values:
    """Vectors by their names, as equation after equation gives them."""

    def __init__(self, drawn: Drawn, quantities: Quantities, blocks: Sequence[Block]) -> None:
        self.drawn, self.quantities = drawn, quantities
        self.known: dict[str, Spot] = {}
        self.units: dict[str, Spot] = {}
        self.frames = dict(_frames(blocks, drawn))

    def closed(self, sums: Sequence[Sum]) -> list[Closed]:
        """Those equations of which all vectors are known and agree."""
        found: dict[int, Closed] = {}
        waiting = list(enumerate(sums))
        while waiting:
            made = [(i, c) for i, s in waiting if (c := self._closed(s)) is not None]
            if not made:
                break
            found |= dict(made)
            waiting = [(i, s) for i, s in waiting if i not in found]
        return [found[i] for i in sorted(found)]

    def _closed(self, s: Sum) -> Closed | None:
        self._tangent(s)
        parts = [(t, self._term(t)) for t in s.terms]
        unknown = [t for t, value in parts if value is None]
        told = [v for _, v in parts if v is not None]
        total = (sum(x for x, _ in told), sum(y for _, y in told))
        whole = self._named(s.name)
        if len(unknown) > 1 or (unknown and whole is None):
            return None
        if whole is None:
            whole = total
        if unknown:
            self._rest(unknown[0], (whole[0] - total[0], whole[1] - total[1]))
            parts = [(t, v if v is not None else (whole[0] - total[0], whole[1] - total[1])) for t, v in parts]
        elif math.dist(whole, total) > CLOSED * max(math.hypot(*v) for v in (whole, *told)):
            return None
        self.known.setdefault(s.name, whole)
        return Closed(s, whole, tuple((t, v) for t, v in parts if v is not None))

    def _tangent(self, s: Sum) -> None:
        """e_t of an acceleration, along the velocity of its point; in the sense in which its size is counted."""
        term = next((t for t in s.terms if t.unit == TANGENT and t.kind == "along"), None)
        velocity, whole = self._own(f"v{s.name[1:]}"), self._named(s.name)
        size = self.drawn.number(term.size) if term is not None else None
        if term is None or velocity is None or whole is None or not size or not any(velocity):
            return
        along = (velocity[0] * whole[0] + velocity[1] * whole[1]) / math.hypot(*velocity) ** 2
        unit = (along * velocity[0] / size, along * velocity[1] / size)
        if abs(math.hypot(*unit) - 1) < CLOSED:
            self.units[_line_of(term)] = unit

    def _rest(self, term: Term, rest: Spot) -> None:
        """What the others of an equation leave for one of its terms."""
        if term.kind == "named":
            self.known.setdefault(term.name, rest)
        size = self.drawn.number(term.size)
        if term.unit and size:
            self.units.setdefault(_line_of(term), (rest[0] / size, rest[1] / size))

    def _term(self, t: Term) -> Spot | None:
        found: Spot | None = None
        match t.kind:
            case "named":
                found = self._named(t.name)
            case "cross" | "square":
                found = self._turning(t)
            case "doubled":
                found = self._doubled(t)
            case "along":
                found = self._along(t)
            case "polar":
                found = self._polar(t)
            case _:
                found = None
        return None if found is None else (t.sign * found[0], t.sign * found[1])

    def _named(self, name: str) -> Spot | None:
        return self.known.get(name) or self._own(name)

    def _turning(self, t: Term) -> Spot | None:
        rate, arm = self.drawn.number(t.rate), self._arm(*t.arm)
        if rate == 0:
            return (0.0, 0.0)
        if rate is None or arm is None:
            return None
        return (-rate * arm[1], rate * arm[0]) if t.kind == "cross" else (rate * arm[0], rate * arm[1])

    def _doubled(self, t: Term) -> Spot | None:
        rate, relative = self.drawn.number(t.rate), self._named(t.name) if t.name else self._along(t)
        return None if rate is None or relative is None else (-2 * rate * relative[1], 2 * rate * relative[0])

    def _along(self, t: Term) -> Spot | None:
        size, unit = self.drawn.number(t.size), self.units.get(_line_of(t))
        if size == 0:
            return (0.0, 0.0)
        return None if size is None or unit is None else (size * unit[0], size * unit[1])

    def _polar(self, t: Term) -> Spot | None:
        """A part of the motion of a place about a pole, along the line between them or across it."""
        (place, pole), letter = t.arm, t.letter
        arm = self._arm(place, pole)
        rates = [self._named(f"v_{place}"), self._own(f"v_{pole}")]
        if arm is None or None in rates or not any(arm):
            return None
        r = math.hypot(*arm)
        (x, y), (vx, vy), (ox, oy) = (arm[0] / r, arm[1] / r), *(v for v in rates if v is not None)
        out, across = (vx - ox) * x + (vy - oy) * y, (vy - oy) * x - (vx - ox) * y
        if letter == "a":
            own, other = self._named(f"a_{place}"), self._own(f"a_{pole}")
            if own is None or other is None:
                return None
            turned, coriolis = across * across / r, 2 * out * across / r
            out, across = (
                (own[0] - other[0]) * x + (own[1] - other[1]) * y,
                (own[1] - other[1]) * x - (own[0] - other[0]) * y,
            )
            parts = {"outward": out + turned, "inward": -turned, "speeding": across - coriolis, "coriolis": coriolis}
        else:
            parts = {}
        size = {**parts, "radial": out, "across": across}[t.name]
        return (size * x, size * y) if t.name in RADIAL else (-size * y, size * x)

    def _arm(self, end: str, start: str) -> Spot | None:
        one, other = self._place(end), self._place(start)
        return None if one is None or other is None else (one[0] - other[0], one[1] - other[1])

    def _place(self, index: str) -> Spot | None:
        name = self._name(index)
        return None if name is None else self._spot(name, "value")

    def _name(self, index: str) -> str | None:
        """The point or body that a page calls so in an index."""
        scene = self.drawn.scene
        named = {index_of(n): n for n in scene.points}
        centres = {index_of(centre_of(scene, b)): b for b in scene.bodies}
        bodies = {index_of(b): b for b in scene.bodies}
        return named.get(index) or centres.get(index) or bodies.get(index)

    def _own(self, name: str) -> Spot | None:
        """A velocity or acceleration as the motion tells it; of P′ as that of the body to which it is fixed."""
        told = VECTOR.fullmatch(name)
        point = self._name(told["index"]) if told is not None else None
        if told is None or point is None:
            return None
        if not told["prime"]:
            return self._spot(point, "rate" if told["letter"] == "v" else "second")
        body = self.frames.get(told["index"])
        at = self._vec(point, "value")
        if body is None or at is None:
            return None
        motion = self.quantities.motion
        return self.drawn.spot(motion.velocity(at, body) if told["letter"] == "v" else motion.acceleration(at, body))

    def _spot(self, name: str, level: str) -> Spot | None:
        found = self._vec(name, level)
        return None if found is None else self.drawn.spot(found)

    def _vec(self, name: str, level: str) -> Vec | None:
        try:
            jets = self.quantities.place(name)
        except PlanarError:
            return None
        x, y = (_part(j, level) for j in (jets.x, jets.y))
        return None if x is None or y is None else Vec(x, y)


def _part(jet: Jet, level: str) -> sp.Expr | None:
    return {"value": jet.value, "rate": jet.rate, "second": jet.second}[level]


def _line_of(t: Term) -> str:
    """Along which line a size is counted: that of v_P/AB is that of a_P/AB."""
    return f"{t.unit} {str(t.size)[1:]}"


def _frames(blocks: Sequence[Block], drawn: Drawn) -> Iterator[tuple[str, str]]:
    """P′: the point fixed to AB that coincides with P."""
    bodies = {with_article(b): b for b in drawn.scene.bodies}
    for block in blocks:
        for piece in block.line if isinstance(block, Paragraph) else ():
            told = FIXED_TO.match(piece.text) if isinstance(piece, Text) else None
            if told is not None and told["body"] in bodies:
                yield told["place"], bodies[told["body"]]
