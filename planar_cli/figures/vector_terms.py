"""The vector equations of a page as data: sums of vectors."""

from __future__ import annotations

from typing import Literal

import sympy as sp

from planar_cli.records import record
from planar_cli.report.document.blocks import Line

Kind = Literal["named", "cross", "square", "doubled", "along", "polar", "other"]


@record
class Term:
    """One vector of a sum. `named`: by its own name; `cross`: ω × r; `square`: ω² r; `doubled`: 2 ω × v_rel; `along`: a
    size times a unit vector; `polar`: the part of a velocity or acceleration that its name says, radial, across,
    outward (r̈), inward (r ω²), speeding (r α), coriolis, of the place of its arm about the pole; `other`: what is only
    known by the rest of its equation.
    """

    kind: Kind
    sign: int
    words: Line
    """As the page has it."""
    name: str = ""
    """Of the vector, also of the one in 2 ω × v_rel."""
    rate: sp.Expr = sp.S.Zero
    size: sp.Expr = sp.S.Zero
    """By which a unit vector is multiplied."""
    unit: str = ""
    arm: tuple[str, str] = ("", "")
    """The indices of its end and its start."""
    letter: str = ""
    """v or a, where its name does not say that."""


@record
class Sum:
    """A vector equation: its left side by name, and what it is the sum of."""

    name: str
    terms: tuple[Term, ...]

    @property
    def letter(self) -> str:
        return self.name[0]
