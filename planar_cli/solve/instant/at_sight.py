"""Unknowns that an equation of their own says are zero: they leave before anything is planned."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.records import record
from planar_cli.solve.instant.algebra import Line, SolvedBlock
from planar_cli.solve.instant.candidates import Candidate
from planar_cli.solve.instant.numbers import Numbers
from planar_cli.solve.instant.offers import Offers
from planar_cli.solve.instant.write import Writer


@record
class Nil:
    """A relation between motions that says that its one unknown is zero, and the columns in which it counts."""

    candidate: Candidate
    columns: Numbers

    @property
    def symbol(self) -> sp.Symbol:
        return self.columns.unknowns[self.candidate.mask.bit_length() - 1]

    def counts(self, targets: set[sp.Symbol], forces: set[sp.Symbol]) -> bool:
        """Does the page have to say it: of what is asked for, and of a force by which the file picks the state, as
        where a contact is about to part?
        """
        condition = self.candidate.condition
        if condition is None:
            return False
        return self.symbol in targets or (self.symbol in forces and condition.kind in ("given", "limit"))

    def told(self, system: System, number: int) -> SolvedBlock:
        """The relation on paper, and what it says."""
        written = Writer(system, self.columns, number).write(self.candidate)
        line = Line(self.symbol, sp.S.Zero, Decimal(0), (number,))
        return SolvedBlock((written,), (self.symbol,), (), (line,))


@record
class Offered:
    """All candidates in the columns that are left. `zero`: what left; `first`: the relations that say so of what is
    asked for, or of that on which an answer rests; `idle`: those that say so of the rest.
    """

    offers: Offers
    candidates: list[Candidate]
    columns: Numbers
    zero: tuple[sp.Symbol, ...] = ()
    first: tuple[Nil, ...] = ()
    idle: tuple[Nil, ...] = ()


def offered(make: Callable[[Numbers], Offers], columns: Numbers, targets: set[sp.Symbol]) -> Offered:
    """All candidates, when what vanishes at sight has left. Forces that are asked for stay: an equation of kinetics
    gives them.
    """
    zero: tuple[sp.Symbol, ...] = ()
    first: tuple[Nil, ...] = ()
    others: dict[sp.Symbol, Nil] = {}
    while True:
        offers = make(columns)
        found = offers.all()
        nils = [Nil(c, columns) for c in found if c.mask.bit_count() == 1 and not c.row[-1]]
        nils = [nil for nil in nils if nil.symbol in columns.linear]
        idle = {nil.symbol for nil in nils if nil.symbol not in targets}
        moves = {nil.symbol: nil for nil in reversed(nils) if nil.counts(targets, set(offers.system.symbols.values()))}
        if not idle and not moves:
            return Offered(offers, found, columns, zero, first, tuple(others.values()))
        first += tuple(moves[s] for s in columns.unknowns if s in moves)
        others |= {nil.symbol: nil for nil in reversed(nils) if nil.symbol in idle and nil.symbol not in moves}
        gone = sorted({*idle, *moves}, key=lambda s: s.name)
        zero += tuple(gone)
        columns = columns.without(set(gone), columns.value.extended(dict.fromkeys(gone, Decimal(0))))
