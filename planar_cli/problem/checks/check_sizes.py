"""Checks of sizes: masses, radii and stiffnesses are more than zero, and no magnitude is said to be negative."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.checks.signs import certain_sign
from planar_cli.problem.language.expression import Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import changed
from planar_cli.problem.scene.known_values import KnownValues
from planar_cli.problem.scene.scene import Composite, Symbol

POSITIVE = (
    "the mass",
    "the weight",
    "the radius",
    "the moment of inertia",
    "the width",
    "the height",
    "the length",
    "stiffness",
)

MASSES = ("the mass", "the weight", "the moment of inertia")


def sizes_are_positive(scope: Scope) -> Iterator[Diagnostic]:
    """A size, mass or stiffness is more than zero, whatever its letters are; only a hole may have minus mass."""
    letters = {symbol.name: symbol for symbol in scope.problem.symbols}
    given = {symbol.name: symbol for symbol in scope.problem.given}
    for formula in formulas(scope.problem):
        # A hole has minus mass, and no other size less than zero.
        hole = "of a part" in formula.what and formula.what.startswith(MASSES)
        if not formula.what.startswith(POSITIVE) or hole:
            continue
        sign = certain_sign(formula.tree, letters, given) if isinstance(formula.tree, Side) else None
        if sign == -1 or (sign == 0 and "inertia" not in formula.what):
            hint = "leave the mass out for a body without mass" if "mass" in formula.what else ""
            yield Diagnostic(formula.mark, "PL454", f"{formula.what} is not more than zero", hint)
    for body in scope.problem.bodies:
        if isinstance(body.shape, Composite) and _weighs_nothing(body.shape, given):
            text = f"the mass of {body.name} is not more than zero: its holes outweigh the rest"
            yield Diagnostic(body.mark, "PL454", text, "only the mass of a hole has a minus")
    for load in scope.problem.loads:
        relaxed = getattr(load, "natural_length", None)
        if relaxed is not None and certain_sign(relaxed, letters, given) == -1:
            text = f"the natural length of {load.called} is negative"
            yield Diagnostic(relaxed.mark, "PL454", text, "a length is zero or more")
        drag = getattr(load, "magnitude", None) if load.kind == "drag" else None
        if isinstance(drag, Side) and certain_sign(changed(drag, _as_size), letters, given) == -1:
            text = f"{load.called} is negative: it would push onward"
            yield Diagnostic(drag.mark, "PL454", text, "leave out the minus")
    gravity = given.get("g")
    if gravity is not None and gravity.value is not None and certain_sign(gravity.value, letters, given) == -1:
        text = "g is negative; it is a size, and weights act downward by themselves"
        yield Diagnostic(gravity.value.mark, "PL454", text, "leave the minus out")


def _weighs_nothing(shape: Composite, given: Mapping[str, Symbol]) -> bool:
    """Do the masses of its parts, where all have numbers, add up to nothing or less?"""
    known = KnownValues(given)
    total = 0.0
    for piece in shape.pieces:
        if piece.mass is None:
            return False
        if (value := known.number(piece.mass)) is None:
            return False
        total += value
    return total <= 0


def magnitudes_are_not_negative(scope: Scope) -> Iterator[Diagnostic]:
    """No relation says that a magnitude is, or is below, a number less than zero."""
    p = scope.problem
    letters = {symbol.name: symbol for symbol in p.symbols}
    given = {symbol.name: symbol for symbol in p.given}
    stated = [
        *(law.statement for law in p.motion),
        *(p.instant or ()),
        *(s for state in p.states for s in state.relations),
    ]
    for r in stated:
        if not isinstance(r, Relation):
            continue
        for size, other, below in ((r.left, r.right, "<"), (r.right, r.left, ">")):
            denied = r.operator == "=" or r.operator.startswith(below)
            if denied and _is_size(size) and certain_sign(changed(other, _as_size), letters, given) == -1:
                yield Diagnostic(other.mark, "PL454", f"`{r.text}`: a magnitude is zero or more", "leave the minus out")


def _is_size(side: Side) -> bool:
    """Is it the magnitude of a vector?"""
    return isinstance(side, Quantity) and bool(side.parts) and side.parts[-1].kind == "mag"


def _as_size(side: Side) -> Side | None:
    """A magnitude is a number that is not negative."""
    return Number(Fraction(1), None, 1, side.mark) if _is_size(side) else None
