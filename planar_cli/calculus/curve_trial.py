"""What is decided about a curve by numbers: which terms vanish, which signs hold, whether an equation is true.

Sixty digits; letters without a number are drawn at random several times, and all draws must agree on a decision.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from copy import copy
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.equation.values.sample import generator

DRAWS = 3
SIGN_DRAWS = 10
PLACES = 7
ENOUGH = 3
"""An equation must have been evaluated at so many places at least."""
_NONE = frozenset[sp.Symbol]()


class Trial:
    """Numbers for a path: draws of its letters, and values of its parameter.

    `letters`: symbols that have no number though the valuation may hold a draw for them; symbols that the valuation
    does not know are letters anyway.
    """

    def __init__(
        self,
        expressions: Iterable[Any],
        parameter: sp.Symbol,
        valuation: Valuation,
        letters: frozenset[sp.Symbol] = _NONE,
    ) -> None:
        self.parameter = parameter
        free = {s for e in expressions for s in e.free_symbols} - {parameter}
        known = {s for s in free if s in valuation.values or s in valuation.definitions}
        self.letters = sorted((free - known) | (free & letters), key=str)
        self.rng = generator(1)
        missing = [s for s in self.letters if s not in known]
        self.draws = [valuation.extended(self._draw(missing)) for _ in range(DRAWS if missing else 1)]
        self.wide = [valuation.extended(self._draw(self.letters)) for _ in range(SIGN_DRAWS if self.letters else 1)]
        self.free = free

    def _draw(self, symbols: Iterable[sp.Symbol]) -> dict[sp.Symbol, Decimal]:
        """Positive values between 0.02 and 50, as the letters of a file are."""
        return {s: self._random() * Decimal(10) ** self.rng.randint(-1, 1) for s in symbols}

    def _random(self) -> Decimal:
        return Decimal(self.rng.randrange(2 * 10**17, 5 * 10**18)) / 10**18

    def over(self, parameter: sp.Symbol) -> Trial:
        """The same draws, with another parameter of the path."""
        other = copy(self)
        other.parameter = parameter
        return other

    def zero(self, expr: Any) -> bool:
        """Does an expression without the axes vanish, for all draws and, if it holds the parameter, everywhere?"""
        expr = sp.sympify(expr)
        if expr.is_number and expr.is_Rational:
            return bool(expr == 0)
        if expr.has(self.parameter):
            return self.true(expr, {})
        return all(draw.vanishes(expr) for draw in self.draws)

    def sign(self, expr: Any) -> int | None:
        """The sign of an expression; None where it hangs on letters or cannot be told."""
        expr = sp.sympify(expr)
        if self.zero(expr):
            return 0
        if expr.is_positive or expr.is_negative:
            return 1 if expr.is_positive else -1
        numbers = [draw.known(expr) for draw in ([*self.draws, *self.wide] if self.letters else self.draws)]
        signs = {None if v is None else 1 if v > 0 else -1 for v in numbers}
        return signs.pop() if len(signs) == 1 else None

    def true(
        self,
        residual: Any,
        places: Mapping[sp.Symbol, sp.Expr],
        over: sp.Symbol | None = None,
        between: tuple[float, float] = (-2.7, 2.7),
    ) -> bool:
        """Does a residual vanish along the path?

        `places`: what the axes are, as expressions of the parameter; `over`: the parameter, if it is not the path's
        own; `between`: the values that it takes.
        """
        parameter = over or self.parameter
        evaluated = 0
        for draw in self.draws:
            for value in self._values(parameter, between):
                at = draw.extended({parameter: value})
                try:
                    point = at.extended({axis: at(place) for axis, place in places.items()})
                    if not point.is_zero(residual):
                        return False
                except Unvalued:
                    return False
                except ArithmeticError:
                    continue
                evaluated += 1
        return evaluated >= ENOUGH * len(self.draws)

    def _values(self, parameter: sp.Symbol, between: tuple[float, float]) -> list[Decimal]:
        low, high = (Decimal(str(b)) for b in between)
        if parameter.is_positive or parameter.is_nonnegative:
            low = max(low, Decimal("0.05"))
        rng = generator(2)
        step = (high - low) / PLACES
        return [low + step * (i + Decimal(rng.randrange(1, 10**18)) / 10**18) for i in range(PLACES)]
