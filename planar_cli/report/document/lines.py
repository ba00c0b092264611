"""The pieces of a line: words, names, formulas and values, without saying how they look.

Formulas are carried as SymPy expressions, but this module does not need SymPy.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from decimal import Decimal
from functools import lru_cache
from typing import TYPE_CHECKING, Literal

from planar_cli.records import record

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from planar_cli.equation.values.exact import Valuation
    from planar_cli.problem.scene.geometry import Vec

TextStyle = Literal["plain", "strong", "muted"]
KEPT = 10_000
"""So many formulas are remembered as they are spelled out."""


@record
class Way:
    """Where a vector is drawn, in exact expressions: at a place, in a direction (None: it is a couple, whose sense the
    words tell), with the numbers of the position in which the words tell its way. `bodies`: it is no vector but the
    point about which moments of these are taken; `before`: it is a momentum before a blow, beside impulses; `kind`: of
    a force, as weight, spring, normal, friction, tension; else "".
    """

    place: Vec
    direction: Vec | None
    value: Valuation
    bodies: tuple[str, ...] = ()
    before: bool = False
    kind: str = ""


@record
class Text:
    """Words; they may come from a file, so a format escapes them. `way`: of those that tell how a vector is drawn;
    words that read alike are the same.
    """

    text: str
    style: TextStyle = "plain"
    way: Way | None = field(default=None, repr=False, compare=False)


@record
class Name:
    """A name of the file or of a principle in mathematical notation: `omega_AB`, `ΣM_C`. `of_thing`: is it that of a
    quantity of a body or a point, which gives way where the file calls a letter so?
    """

    name: str
    of_thing: bool = field(default=False, compare=False)


@record
class Math:
    """A formula. `values`: texts to print in place of symbols, for the side that shows the substituted numbers."""

    expr: Expr
    values: Mapping[Symbol, str] | None = field(default=None, hash=False)

    def __repr__(self) -> str:
        return f"Math(expr={_spelled(self.expr)}, values={self.values!r})"


@record
class Value:
    """A number with its unit as the author writes units (`rad/s^2`; empty: none), printed to so many figures."""

    number: Decimal
    unit: str = ""
    figures: int = 4


@lru_cache(maxsize=KEPT)
def _spelled(expr: Expr) -> str:
    """A formula for comparing what reads alike, which spells the same ones out again and again."""
    return repr(expr)


Term = Text | Name | Math | Value


@record
class Relation:
    """A short relation inside a line; `relation` is one of = ≠ < ≤ > ≥ ≈ →."""

    left: Term
    relation: str
    right: Term


Inline = Term | Relation
Line = tuple[Inline, ...]


def line(*parts: str | Inline | Line) -> Line:
    """A line from pieces: a string is plain text, a line is spliced in."""
    pieces: list[Inline] = []
    for part in parts:
        if isinstance(part, tuple):
            pieces.extend(part)
        else:
            pieces.append(Text(part) if isinstance(part, str) else part)
    return tuple(pieces)
