"""Where equations of the state at one instant are zero: Newton's method, each step the shortest that does it.

Steps are measured on the scales of the variables, what is left on those of the equations.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.errors import Mark
from planar_cli.motion.terms.constraints import coefficients
from planar_cli.motion.terms.dense import least_squares
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.source import Code, compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.records import record

CLOSED = 1e-12
"""Residuals below this part of their scale are zero."""
AGREES = 1e-9
"""Relations that are met to this part of their scale agree with each other."""
NOISE = 1e-13
"""What is left of a row's largest coefficient below this is rounding."""
MOST_ROUNDS, MOST_IDLE = 60, 12
"""So many steps of Newton's method are made, and so many that do not halve what is left."""


@record
class Equation:
    """Something that is zero at the start."""

    term: Term
    size: float
    """Its scale."""
    text: str
    """In words."""
    mark: Mark

    @property
    def factor(self) -> float:
        """The power of two next to the scale: dividing by it rounds nothing."""
        return 2.0 ** round(math.log2(self.size))


class Zeros:
    """A state that is moved until equations hold."""

    def __init__(self, layout: Layout, sizes: Sequence[float], time: float, state: Sequence[float]) -> None:
        self.layout, self.sizes = layout, sizes
        self.time, self.state = time, list(state)
        self.codes: dict[tuple[Term, ...], Code] = {}

    def matrix(self, equations: Sequence[Equation], numbers: range) -> list[list[float]]:
        """∂(equation/factor)/∂(variable/scale) at the state at hand; columns in the unit of each variable."""
        layout = self.layout
        variables = {layout.state[n]: i for i, n in enumerate(numbers)}
        rows = [coefficients(e.term, variables, layout) for e in equations]
        values = iter(self.numbers(tuple(t for row in rows for t in row.values())))
        found = []
        for row, equation in zip(rows, equations, strict=True):
            line = [0.0] * len(numbers)
            for i in row:
                line[i] = next(values) / equation.factor
            # What is nothing but the rounding of a row must not be solved for.
            largest = max(map(abs, line), default=0.0)
            found.append([0.0 if abs(x) <= NOISE * largest else x for x in line])
        return found

    def solved(self, equations: Sequence[Equation], numbers: range) -> bool:
        """Newton's method; does it end with all of them zero?"""
        if not equations:
            return True
        best, idle = math.inf, 0
        for _ in range(MOST_ROUNDS):
            values = self.values(equations)
            if not all(map(math.isfinite, values)):
                return False
            off = max(abs(v) / e.size for v, e in zip(values, equations, strict=True))
            if off <= CLOSED or (off <= AGREES and off >= best / 2):
                return True
            idle = 0 if off < best / 2 else idle + 1
            if idle > MOST_IDLE:
                return False
            best = min(best, off)
            right = [-v / e.factor for v, e in zip(values, equations, strict=True)]
            fit = least_squares(self.matrix(equations, numbers), right)
            for n, change in zip(numbers, fit.unknowns, strict=True):
                self.state[n] += change
        return False

    def values(self, equations: Sequence[Equation]) -> list[float]:
        return self.at([e.term for e in equations], self.state)

    def unmet(self, equations: Sequence[Equation], state: Sequence[float]) -> list[Equation]:
        """Those that do not hold in a state."""
        values = self.at([e.term for e in equations], state)
        return [e for e, v in zip(equations, values, strict=True) if abs(v) > AGREES * e.size]

    def at(self, terms: Sequence[Term], state: Sequence[float]) -> list[float]:
        """Terms in a state; not numbers where one of them has no value, as at a guess: another one is tried."""
        found, self.state = self.state, list(state)
        try:
            return self.numbers(tuple(terms))
        except (ZeroDivisionError, ValueError):
            return [math.nan] * len(terms)
        finally:
            self.state = found

    def numbers(self, terms: tuple[Term, ...]) -> list[float]:
        """Terms at the state at hand."""
        if terms not in self.codes:
            self.codes[terms] = compiled(terms, self.layout.state, self.layout.time)
        return self.codes[terms].function(self.time, self.state)
