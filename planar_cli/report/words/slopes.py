"""Slopes of a scene, by which a reader says where something points: up the slope, not at 20° above +x."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Name, Part, Quantity, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Line, Problem
from planar_cli.records import record

SLOPE = "slope"
"""What a slanting line is called to which the file gives no name of its own."""
CALLED = ("incline", "ramp", "roof", "plank", "hill", "chute", "belt")
"""Names of surfaces that say themselves what slants."""


@record
class Slope:
    """A fixed straight line in a vertical plane along which bodies may go: its angle, and what it is called."""

    angle: Side
    called: str


def slopes_of(problem: Problem) -> tuple[Slope, ...]:
    """The fixed lines of a file that may slant: surfaces, and tracks of guides; none in a horizontal plane."""
    if problem.plane != "vertical":
        return ()
    surfaces = tuple(
        Slope(s.shape.angle, s.name if s.name in CALLED else SLOPE)
        for s in problem.surfaces
        if isinstance(s.shape, Line) and s.body is None
    )
    tracks = (getattr(joint, "along", None) for joint in problem.joints)
    return surfaces + tuple(Slope(t, SLOPE) for t in tracks if isinstance(t, Side) and not isinstance(t, Name))


def direction_of(side: Side, ledger: Ledger, value: Valuation) -> tuple[sp.Expr, sp.Expr] | None:
    """Cosine and sine of an angle that the file gives by numbers and names with numbers; None: it says more."""
    nodes = list(walk(side))
    if any(isinstance(node, Quantity) for node in nodes):
        return None
    named = {ledger.symbols.get(node.name) for node in nodes if isinstance(node, Name) and node.name != "pi"}
    if not all(symbol in ledger.values for symbol in named) or any(symbol in value.drawn for symbol in named):
        return None
    angle = Evaluator(ledger, {}).value(side)
    return sp.cos(angle), sp.sin(angle)


def slope_words(
    part: Part,
    positive: bool,
    way: tuple[sp.Expr, sp.Expr],
    slopes: tuple[Slope, ...],
    ledger: Ledger,
    value: Valuation,
) -> str:
    """Up or down the slope that a part is along, or at right angles to it; empty: no slope has this direction, or what
    has it is level or plumb. `way`: cosine and sine of the direction that the part names.
    """
    cosine, sine = way
    if value.is_zero(cosine) or value.is_zero(sine):
        return ""
    for slope in slopes:
        own = direction_of(slope.angle, ledger, value)
        if own is None or not value.is_zero(own[0] * sine - own[1] * cosine):
            continue
        if part.kind == "along":
            return f"{'up' if (value(sine) > 0) == positive else 'down'} the {slope.called}"
        upward = (value(cosine) > 0) == positive
        return f"perpendicular to the {slope.called}, {'upward' if upward else 'downward'}"
    return ""
