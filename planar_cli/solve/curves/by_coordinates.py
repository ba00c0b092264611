"""Places in coordinates that are given over time: differentiated by the chain rule, so that θ, θ̇ and θ̈ stay letters.

x = f(θ) has ẋ = f′ θ̇ and ẍ = f″ θ̇² + f′ θ̈; at an instant the numbers of θ, θ̇ and θ̈ are put in.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.jets import Jet
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.solve.regimes.functions import directed
from planar_cli.solve.regimes.regime import Regime

DOTS = ("", "_dot", "_ddot")


@record
class ByCoordinates:
    """`driven`: the coordinates that are given over time, with the symbols of their rates; `value`: numbers of all."""

    driven: Mapping[sp.Symbol, tuple[sp.Symbol, sp.Symbol]]
    functions: Mapping[sp.Symbol, sp.Expr]
    value: Valuation

    def jet(self, place: Jet) -> Jet:
        """A place with its derivatives in the coordinates and their rates."""
        rate = self.derivative(place.value)
        return Jet(place.value, rate, self.derivative(rate))

    def vec(self, place: Vec) -> Vec:
        """Both components of a place."""
        return Vec(self.jet(place.x), self.jet(place.y))

    def derivative(self, expr: sp.Expr) -> sp.Expr:
        """d/dt by the chain rule."""
        rates = {q: dot for q, (dot, _) in self.driven.items()} | dict(self.driven.values())
        return sp.Add(*(sp.diff(expr, q) * rate for q, rate in rates.items()))

    def clean(self, expr: sp.Expr) -> sp.Expr:
        """As it is printed; of what is positive at this instant no magnitude is taken."""
        plain = simplified(expr)
        sizes = {e: e.args[0] if self.value(e.args[0]) > 0 else -e.args[0] for e in plain.atoms(sp.Abs)}
        return directed(simplified(plain.xreplace(sizes)), self.value)

    def known(self, expr: sp.Expr) -> Decimal | None:
        """The value of a formula at this instant."""
        return self.value.known(expr)

    def rows(self) -> Iterator[tuple[sp.Symbol, sp.Symbol, sp.Expr, int]]:
        """Each coordinate, itself and its rates as functions of time, and how often it is differentiated."""
        for q, (dot, ddot) in self.driven.items():
            formula = self.functions[q]
            for n, symbol in enumerate((q, dot, ddot)):
                yield q, symbol, expanded(formula), n
                formula = simplified(sp.diff(formula, self.time))

    @property
    def time(self) -> sp.Symbol:
        """The symbol of time."""
        return next(s for f in self.functions.values() for s in f.free_symbols if s.name == "t")


def by_coordinates(regime: Regime, value: Valuation, allowed: Callable[[sp.Expr], bool]) -> ByCoordinates | None:
    """None: no coordinate is given over time. `allowed`: may a formula stand on the page?"""
    scene = regime.general.instant.scene
    functions = {q: regime.closed(q) for q in scene.ledger.coordinates}
    functions = {q: f for q, f in functions.items() if regime.time in f.free_symbols and allowed(f)}
    if not functions:
        return None
    one, two = DOTS[1:]
    driven = {q: (sp.Symbol(q.name + one, real=True), sp.Symbol(q.name + two, real=True)) for q in functions}
    numbers: dict[sp.Symbol, Decimal] = {}
    for q, (dot, ddot) in driven.items():
        formula = functions[q]
        for symbol in (q, dot, ddot):
            numbers[symbol] = value(formula)
            formula = sp.diff(formula, regime.time)
    return ByCoordinates(driven, functions, value.extended(numbers))
