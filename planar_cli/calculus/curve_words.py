"""A curve as it is told: its kind, its equation, and the lines by which the parameter was eliminated.

Units: whatever the coordinates carry (SI inside); nothing here converts. Angles are in radians.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from planar_cli.records import record

Step = tuple[str, Any]
"""Words, and the equation or expression that they introduce."""

POINT, LINE, CIRCLE, ELLIPSE, PARABOLA, HYPERBOLA, CONIC, CURVE = (
    "point",
    "straight line",
    "circle",
    "ellipse",
    "parabola",
    "hyperbola",
    "conic",
    "curve",
)


@record
class Curve:
    """The curve of a moving point.

    `kind`: "circle", "parabola", "cycloid", …; "curve" where it has no name.
    `equation`: in the two axes, or in polar coordinates (a spiral); None where none was found and verified.
    `steps`: how the parameter was eliminated, in order; the last one is the equation itself.
    `centre`, `radius`: of a circle; `centre` also of an ellipse or hyperbola, and the place of a point at rest.
    `holds`: where the equation holds, in words; empty: for every value of the parameter.
    `given_by`: what describes the curve where no equation does: "x(t) and y(t)".
    `course`: the two coordinates as formulas of `parameter`, where they are that.
    """

    kind: str
    equation: sp.Eq | None = None
    steps: tuple[Step, ...] = ()
    centre: tuple[sp.Expr, sp.Expr] | None = None
    radius: sp.Expr | None = None
    holds: str = ""
    given_by: str = ""
    course: tuple[sp.Expr, sp.Expr] | None = None
    parameter: sp.Symbol | None = None

    @property
    def words(self) -> str:
        """The curve in words, formulas in SymPy's spelling."""
        return self.told(str)

    def told(self, write: Callable[[Any], str]) -> str:
        """The curve in words: "circle about (0, h)"; `write` puts formulas into text."""
        if self.centre is not None and self.kind == CIRCLE:
            return f"circle about ({write(self.centre[0])}, {write(self.centre[1])})"
        if self.centre is not None and self.kind == POINT:
            return f"point: it stays at ({write(self.centre[0])}, {write(self.centre[1])})"
        if self.equation is None and self.given_by:
            if self.kind == CURVE:
                return f"a curve given by {self.given_by}"
            return f"{self.kind}, given by {self.given_by}"
        return self.kind
