"""Places that are asked, and what leads from one point to another: x_A, y_A and x_B - x_A, y_B - y_A."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, simplified
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found


def place_asked(answer: Found) -> Quantity | None:
    """The place, or the vector between two points, that an answer is; None: it is another thing."""
    what = answer.find.found.what if answer.find is not None else None
    if not isinstance(what, Quantity) or what.word != "r" or what.parts or answer.kind != "vector":
        return None
    return what if len(what.things) < 2 or what.things[1] != GROUND else None


def place_name(q: Quantity, axis: str, ledger: Ledger) -> Line:
    """x_A, or x_B - x_A."""
    first, *others = (Math(sp.Symbol(ledger.apart(f"{axis}_{name}"), real=True)) for name in q.things)
    return line(first, *(p for other in others for p in (" - ", other)))


class PlaceTelling:
    """What stands before the components of a place that is asked."""

    def __init__(self, scene: Scene, phrases: Phrases) -> None:
        self.scene, self.phrases = scene, phrases
        self._displaced: list[tuple[Found, Quantity]] = []

    def heading(self, q: Quantity) -> Iterator[Block]:
        """Between which points a vector leads."""
        if len(q.things) == 2:
            to, since = q.things
            own = line(Name(f"r_{to}/{since}"), " = ", Name(f"r_{to}"), " - ", Name(f"r_{since}"))
            yield Paragraph(line(f"From {since} to {to}, ", *own, ":"))

    def shifted(self, answer: Found, q: Quantity) -> list[Block]:
        """A displacement that is that of another point before, as the line between both keeps length and direction;
        empty where there is none.
        """
        if len(q.things) != 2:
            return []
        for before, p in self._displaced:
            (to, since), (other_to, other_since) = q.things, p.things
            one, other = (self._between(a, b) for a, b in ((since, other_since), (to, other_to)))
            if one is None or one != other or one == (0, 0):
                continue
            arm = line(" + [", self.phrases.math(one[0]), ", ", self.phrases.math(one[1]), "]")
            both = (
                line(Name(f"r_{b}"), " = ", Name(f"r_{a}"), *arm) for a, b in ((other_since, since), (other_to, to))
            )
            words = f"{other_since}{since} keeps its length and direction (translation): "
            return [
                Paragraph(line(words, *next(both), ", ", *next(both), ", subtracted:")),
                Equation((line(Name(answer.name)), line(Name(before.name)))),
            ]
        self._displaced.append((answer, q))
        return []

    def _between(self, one: str, other: str) -> tuple[sp.Expr, sp.Expr] | None:
        """What leads from one point to another, in letters."""
        if one not in self.scene.points or other not in self.scene.points:
            return None
        arm = self.scene.point(one) - self.scene.point(other)
        x, y = (sp.S.Zero if identically_zero(e) else simplified(e) for e in (arm.x, arm.y))
        return x, y
