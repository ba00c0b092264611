"""Factors of one at the parts of an acceleration: the normal, the tangential and the Coriolis part; at the moment of
inertia of a body in its energy and momentum, and at what that about a fixed axis has more.

Equations that are written with them can be carried out again with one part left out, as by a student who forgets it. No
name of a file has a Greek letter, so that none is taken.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.algebra.expansion import wide

if TYPE_CHECKING:
    from planar_cli.equation.values.ledger import Ledger

CORIOLIS, NORMAL, TANGENTIAL, AXIS, SPIN = "κ_coriolis", "κ_normal", "κ_tangential", "κ_axis", "κ_spin"
_marking: ContextVar[bool] = ContextVar("marking", default=False)


@contextmanager
def marked() -> Iterator[None]:
    """Equations that are set up here have the factors in them."""
    token = _marking.set(True)
    try:
        yield
    finally:
        _marking.reset(token)


def in_letters() -> bool:
    """Do equations keep their long coefficients in letters? So they do where they are to be carried out again, with
    other data or with a part left out; on a page a number is easier to read.
    """
    return _marking.get()


def with_mark(expr: sp.Expr, part: str) -> sp.Expr:
    """A part of an acceleration, with its factor where equations are marked."""
    return expr * sp.Symbol(part, positive=True) if _marking.get() and expr != 0 else expr


def is_mark(symbol: sp.Symbol) -> bool:
    """Is it one of the factors?"""
    return symbol.name in (CORIOLIS, NORMAL, TANGENTIAL) or symbol.name.startswith((AXIS, SPIN))


def axis_of(body: str) -> str:
    """The factor at what the moment of inertia of one body has more about a fixed axis."""
    return f"{AXIS}_{body}"


def spin_of(body: str) -> str:
    """The factor at the moment of inertia of one body in its energy and momentum."""
    return f"{SPIN}_{body}"


def know_marks(ledger: Ledger, bodies: Collection[str]) -> None:
    """The factors are known: they are one."""
    if _marking.get():
        for part in (CORIOLIS, NORMAL, TANGENTIAL, *map(axis_of, bodies), *map(spin_of, bodies)):
            ledger.known(part, sp.S.One, "1")


def without_common_marks(residual: sp.Expr) -> sp.Expr:
    """What vanishes, without factors of all its terms: where an unknown acceleration is eliminated, its tangential part
    is a factor of all that is left, and leaving it out would leave nothing.
    """
    marks = [s for s in residual.free_symbols if s.name in (CORIOLIS, NORMAL, TANGENTIAL)]
    if (len(marks) < 2 and not any(residual.has(s**2) for s in marks)) or wide(residual):
        return residual
    terms = spread = sp.Add.make_args(sp.expand(residual))
    for mark in marks:
        while all(mark in term.free_symbols for term in terms):
            terms = tuple(term / mark for term in terms)
    return residual if terms == spread else sp.Add(*terms)
