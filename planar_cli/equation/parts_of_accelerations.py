"""Factors of one at the parts of an acceleration: the normal, the tangential and the Coriolis part; and at what the
moment of inertia about a fixed axis has more than that about the mass centre.

Equations that are written with them can be carried out again with one part left out, as by a student who forgets it. No
name of a file has a Greek letter, so that none is taken.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING

import sympy as sp

if TYPE_CHECKING:
    from planar_cli.equation.ledger import Ledger

CORIOLIS, NORMAL, TANGENTIAL, AXIS = "κ_coriolis", "κ_normal", "κ_tangential", "κ_axis"
_marking: ContextVar[bool] = ContextVar("marking", default=False)


@contextmanager
def marked() -> Iterator[None]:
    """Equations that are set up here have the factors in them."""
    token = _marking.set(True)
    try:
        yield
    finally:
        _marking.reset(token)


def with_mark(expr: sp.Expr, part: str) -> sp.Expr:
    """A part of an acceleration, with its factor where equations are marked."""
    return expr * sp.Symbol(part, positive=True) if _marking.get() and expr != 0 else expr


def axis_of(body: str) -> str:
    """The factor at what the moment of inertia of one body has more about a fixed axis."""
    return f"{AXIS}_{body}"


def know_marks(ledger: Ledger, bodies: Iterable[str]) -> None:
    """The factors are known: they are one."""
    if _marking.get():
        for part in (CORIOLIS, NORMAL, TANGENTIAL, *map(axis_of, bodies)):
            ledger.known(part, sp.S.One, "1")
