"""What is computed from the solution of a linear system, over and over at other states: generated code with fall-backs.

The code eliminates in a fixed order of pivots. Where a pivot becomes too small the order is chosen once more from the
state at hand. Near a singular position, which no order serves, the outputs are continued through it: they are those of
states a little before and after it on the way that the velocities go. Where nothing moves, or all positions are
singular, the system is solved in the sense of least squares by its rank.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from planar_cli.motion.terms.dense import DEPENDENT, Matrix, constrained, least_squares
from planar_cli.motion.terms.elimination import SHRUNK, SMALL_PIVOT, chosen, factor
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.pivots import Order
from planar_cli.motion.terms.source import Code, Function, Singular, compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.records import record

MOST_ORDERS = 6
"""So many orders of pivots are kept, and so often another one is sought in vain."""
CLEAR = 100.0
"""Pivots of another order are larger by this factor than what no longer serves, if there are such."""
WEIGHTS = tuple((s * k, w) for k, w in ((1, 0.8), (2, -0.4), (3, 4 / 35), (4, -1 / 70)) for s in (-1, 1))
"""The value at 0 of the polynomial through the values at these places: exact up to the eighth order of distances."""

Unknowns = Sequence[Sequence[Term]]
"""For every right side the unknowns."""
Outputs = Callable[[Unknowns], Sequence[Term]]
"""From the unknowns to what is to be computed."""
Right = Callable[[Unknowns], Sequence[Term]]
"""A right side, from the unknowns of those before."""
Neighbour = Callable[[float, Sequence[float], int], tuple[float, list[float]]]
"""A state some steps before (< 0) or after the given one, on the way that its velocities go. Raises Singular."""
Whole = Callable[[float, Sequence[float]], list[float]]
"""From the time and a part of the state to all of it."""


@record
class View:
    """The part of a state from which the rest follows."""

    inputs: tuple[Term, ...]
    """Coordinates and rates that are independent."""
    given: Mapping[Term, Term]
    """The others, as terms of these."""
    whole: Whole
    """From (t, part) to the state."""


class System:
    """Equations that are linear in their unknowns, with one or more right sides; their coefficients vary."""

    def __init__(
        self,
        layout: Layout,
        rows: Sequence[Mapping[int, Term]],
        rights: Sequence[Right],
        values: Mapping[Term, float] | None = None,
        small: float = SMALL_PIVOT,
    ) -> None:
        """`values`: where the first order of pivots is chosen; None: in the reference configuration.

        `small`: pivots below this part of their parts do not serve.
        """
        self.layout, self.rows, self.rights, self.small = layout, rows, rights, small
        self.orders: list[Order] = [chosen(rows, values)]
        self._vain = 0
        self._entries: Code | None = None
        self._sides: list[Code] = []
        self._stand_ins: list[list[Term]] = []

    def another(self, t: float, y: Sequence[float]) -> bool:
        """Add an order of pivots for this state; False where that would not help."""
        if len(self.orders) >= MOST_ORDERS or self._vain >= MOST_ORDERS:
            return False
        values, first = self.layout.values(t, y), self.orders[0]
        try:
            found = chosen(self.rows, values, CLEAR * self.small)
        except ZeroDivisionError:
            # An equation has no value in this very state.
            self._vain += 1
            return False
        if len(found.rows) > len(first.rows):
            found = chosen(self.rows, values)
        singular = len(found.rows) > len(first.rows) or found.least < min(self.small, SHRUNK * first.least)
        # Where an equation as a whole has become small, its parts have too: then what it was tells.
        singular = singular or found.least_beside(first) < self.small
        if singular or any(found.places == order.places for order in self.orders):
            self._vain += 1
            return False
        self.orders.append(found)
        return True

    def loses(self, index: int) -> bool:
        """Does an order leave out a constraint: is what it says of the forces lost in rounding?"""
        return any(row >= self.layout.count for row in self.orders[index].rows)

    def code(self, index: int, outputs: Outputs, view: View | None = None) -> Code:
        """The outputs by one of the orders; `view`: from a part of the state."""
        layout = self.layout
        factored = factor(layout.graph, self.rows, self.orders[index])
        found: list[Sequence[Term]] = []
        for right in self.rights:
            found.append(factored.solve(right(found)))
        checks = factored.checks(self.small)
        if view is None:
            return compiled(outputs(found), layout.state, layout.time, checks)
        return compiled(outputs(found), view.inputs, layout.time, checks, view.given)

    def by_rank(self, t: float, y: Sequence[float], dependent: float) -> list[float]:
        """The unknowns of all right sides, one after the other, in the sense of least squares."""
        layout, variables = self.layout, self.stand_ins()
        if self._entries is None:
            self._entries = compiled([c for row in self.rows for c in row.values()], layout.state, layout.time)
            for k, right in enumerate(self.rights):
                inputs = (*layout.state, *(v for part in variables[:k] for v in part))
                self._sides.append(compiled(right(variables[:k]), inputs, layout.time))
        numbers = iter(self._entries.function(t, y))
        matrix = [[0.0] * len(self.rows) for _ in self.rows]
        for i, row in enumerate(self.rows):
            for j in row:
                matrix[i][j] = next(numbers)
        found: list[float] = []
        solve = constrained if self._symmetric() else _whole
        for side in self._sides:
            found += solve(matrix, side.function(t, [*y, *found]), self.layout.count, dependent)
        return found

    def _symmetric(self) -> bool:
        """Do the multipliers act along their constraints?"""
        count = self.layout.count
        return all(
            j < count and self.rows[j].get(count + k) is t
            for k, row in enumerate(self.rows[count:])
            for j, t in row.items()
        )

    def stand_ins(self) -> list[list[Term]]:
        """A variable for every unknown."""
        if not self._stand_ins:
            graph = self.layout.graph
            first = len(graph.names)
            self._stand_ins = [
                [graph.variable(f"unknown{first}_{k}_{i}", 0.0) for i in range(len(self.rows))]
                for k in range(len(self.rights))
            ]
        return self._stand_ins


def _whole(matrix: Matrix, right: Sequence[float], count: int, dependent: float) -> Sequence[float]:
    """All equations at once."""
    return least_squares(matrix, right, dependent).unknowns


class Routine:
    """One function of time and state."""

    def __init__(
        self, system: System, outputs: Outputs, neighbour: Neighbour | None = None, view: View | None = None
    ) -> None:
        """`neighbour`: where the outputs near a singular position are taken from; None: they are found by rank.

        `view`: states are given by this part of them, in `regular`.
        """
        self.system, self.outputs, self.neighbour, self.view = system, outputs, neighbour, view
        self.codes: list[Code] = []
        """By the orders of the system, as far as they have been needed."""
        self.serving: list[Function] = []
        """Of those the functions that lose nothing, as far as they have been needed."""
        self._looked = 0
        self._from_unknowns: Code | None = None

    def __call__(self, t: float, y: Sequence[float]) -> list[float]:
        """The outputs at a state."""
        try:
            return self.regular(t, y)
        except Singular:
            pass
        if self.neighbour is not None:
            try:
                return self._continued(self.neighbour, t, y)
            except Singular:
                # Nothing moves, or there is no regular position nearby.
                pass
        return self.by_rank(t, y)

    @property
    def operations(self) -> int:
        """Of one evaluation by the first order."""
        return self.code(0).operations

    def code(self, index: int) -> Code:
        """The function by one of the orders of pivots."""
        while len(self.codes) <= index:
            self.codes.append(self.system.code(len(self.codes), self.outputs, self.view))
        return self.codes[index]

    def regular(self, t: float, y: Sequence[float]) -> list[float]:
        """The outputs by one of the orders; raises Singular where none serves."""
        for function in self.serving:
            try:
                return function(t, y)
            except (Singular, ZeroDivisionError):
                continue
        while self._looked < len(self.system.orders) or self.system.another(t, self._whole(t, y)):
            index, self._looked = self._looked, self._looked + 1
            if self.system.loses(index):
                continue
            self.serving.append(self.code(index).function)
            try:
                return self.serving[-1](t, y)
            except (Singular, ZeroDivisionError):
                continue
        raise Singular

    def _whole(self, t: float, y: Sequence[float]) -> Sequence[float]:
        return y if self.view is None else self.view.whole(t, y)

    def _continued(self, neighbour: Neighbour, t: float, y: Sequence[float]) -> list[float]:
        """The outputs through a singular position, from both sides of it."""
        total: list[float] | None = None
        for place, weight in WEIGHTS:
            found = self.regular(*neighbour(t, y, place))
            total = [a + weight * b for a, b in zip(total or [0.0] * len(found), found, strict=True)]
        return total or []

    def by_rank(self, t: float, y: Sequence[float], dependent: float = DEPENDENT) -> list[float]:
        """The outputs where the system has no single solution.

        `dependent`: what is left of a column below this part of its size depends on the others.
        """
        layout, variables = self.system.layout, self.system.stand_ins()
        if self._from_unknowns is None:
            inputs = (*layout.state, *(v for part in variables for v in part))
            self._from_unknowns = compiled(self.outputs(variables), inputs, layout.time)
        return self._from_unknowns.function(t, [*y, *self.system.by_rank(t, y, dependent)])
