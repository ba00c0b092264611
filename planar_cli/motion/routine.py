"""What is computed from the solution of a linear system, over and over at other states: generated code with fall-backs.

The code eliminates in a fixed order of pivots. Where a pivot becomes too small the order is chosen once more from the
state at hand; where that does not help either (redundant equations, singular positions), the system is solved in the
sense of least squares by its rank.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from planar_cli.motion.dense import least_squares
from planar_cli.motion.elimination import chosen, eliminate_all
from planar_cli.motion.layout import Layout
from planar_cli.motion.pivots import Order
from planar_cli.motion.source import Code, Singular, compiled
from planar_cli.motion.terms import Term

MOST_ORDERS = 3
"""So many orders of pivots are kept."""

Unknowns = Sequence[Sequence[Term]]
"""For every right side the unknowns."""
Outputs = Callable[[Unknowns], Sequence[Term]]
"""From the unknowns to what is to be computed."""


class System:
    """Equations that are linear in their unknowns, with one or more right sides; their coefficients vary."""

    def __init__(
        self,
        layout: Layout,
        rows: Sequence[Mapping[int, Term]],
        rights: Sequence[Sequence[Term]],
        values: Mapping[Term, float] | None = None,
    ) -> None:
        """`values`: where the first order of pivots is chosen; None: in the reference configuration."""
        self.layout, self.rows, self.rights = layout, rows, rights
        self.orders: list[Order] = [chosen(rows, values)]
        self._entries: Code | None = None
        self._stand_ins: list[list[Term]] = []

    def another(self, t: float, y: Sequence[float]) -> bool:
        """Add an order of pivots for this state; False where that would not help."""
        if len(self.orders) >= MOST_ORDERS:
            return False
        found = chosen(self.rows, self.layout.values(t, y))
        known = {order.pivots for order in self.orders}
        if len(found.rows) > len(self.orders[0].rows) or found.pivots in known:
            return False
        self.orders.append(found)
        return True

    def code(self, index: int, outputs: Outputs) -> Code:
        """The outputs by one of the orders."""
        layout = self.layout
        solved = eliminate_all(layout.graph, self.rows, self.rights, self.orders[index])
        results = outputs([s.unknowns for s in solved])
        return compiled(results, layout.state, layout.time, solved[0].checks)

    def by_rank(self, t: float, y: Sequence[float]) -> list[float]:
        """The unknowns of all right sides, one after the other, in the sense of least squares."""
        if self._entries is None:
            flat = [term for row in self.rows for term in row.values()]
            flat += [term for right in self.rights for term in right]
            self._entries = compiled(flat, self.layout.state, self.layout.time)
        numbers = iter(self._entries.function(t, y))
        matrix = [[0.0] * len(self.rows) for _ in self.rows]
        for i, row in enumerate(self.rows):
            for j in row:
                matrix[i][j] = next(numbers)
        found: list[float] = []
        for right in self.rights:
            found += least_squares(matrix, [next(numbers) for _ in right]).unknowns
        return found

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


class Routine:
    """One function of time and state."""

    def __init__(self, system: System, outputs: Outputs) -> None:
        self.system, self.outputs = system, outputs
        self.codes: list[Code] = []
        """By the orders of the system, as far as they have been needed."""
        self._from_unknowns: Code | None = None

    def __call__(self, t: float, y: Sequence[float]) -> list[float]:
        """The outputs at a state."""
        for index in range(len(self.system.orders)):
            try:
                return self.code(index).function(t, y)
            except (Singular, ZeroDivisionError):
                continue
        if self.system.another(t, y):
            return self(t, y)
        return self.by_rank(t, y)

    @property
    def operations(self) -> int:
        """Of one evaluation by the first order."""
        return self.code(0).operations

    def code(self, index: int) -> Code:
        """The function by one of the orders of pivots."""
        while len(self.codes) <= index:
            self.codes.append(self.system.code(len(self.codes), self.outputs))
        return self.codes[index]

    def by_rank(self, t: float, y: Sequence[float]) -> list[float]:
        """The outputs where the system has no single solution."""
        layout, variables = self.system.layout, self.system.stand_ins()
        if self._from_unknowns is None:
            inputs = (*layout.state, *(v for part in variables for v in part))
            self._from_unknowns = compiled(self.outputs(variables), inputs, layout.time)
        return self._from_unknowns.function(t, [*y, *self.system.by_rank(t, y)])
