"""Coordinates as functions of time, or of one coordinate that is kept: from relations about places, loops and laws."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field
from decimal import Decimal

import sympy as sp

from planar_cli.calculus.laws import Moment, relations
from planar_cli.equation.algebra.plain import identically_zero, simplified
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import PI, Unvalued, Valuation
from planar_cli.errors import NoValue, Undecided
from planar_cli.records import changing, record
from planar_cli.solve.instant.roots import real_roots
from planar_cli.solve.regimes.equations import laws_of
from planar_cli.solve.regimes.regime import Regime

SAME = Decimal("1e-20")
INVERSE = {sp.asin: sp.sin, sp.acos: sp.cos}


@record
class Function:
    """coordinate = expr. `words`: from where it follows; `sides`: ∫ dq = ∫ v dt, where it was integrated."""

    symbol: sp.Symbol
    expr: sp.Expr
    words: str
    sides: tuple[sp.Expr, sp.Expr] | None = None


@changing
class Functions:
    """All coordinates of one regime that can be written as functions of time and of those in `kept`.

    `starts`: values of t, coordinates and free speeds at one instant, as far as they are known. `timed`: may time stand
    in them? Without it only loops are used.
    """

    regime: Regime
    starts: Mapping[sp.Symbol, sp.Expr]
    kept: frozenset[sp.Symbol] = frozenset()
    timed: bool = True
    found: dict[sp.Symbol, Function] = field(default_factory=dict)

    def find(self) -> dict[sp.Symbol, Function]:
        """One coordinate after the other, as long as there are any."""
        while any(self._next()):
            pass
        return self.found

    @property
    def value(self) -> Valuation:
        return self.regime.general.instant.scene.valuations[0]

    def put_in(self, expr: sp.Expr) -> sp.Expr:
        """An expression with all functions put in."""
        for _ in range(len(self.found) + 1):
            inside = {s: f.expr for s, f in self.found.items() if s in expr.free_symbols}
            if not inside:
                break
            expr = expr.xreplace(inside)
        return expr

    def _open(self, expr: sp.Expr) -> list[Coordinate]:
        return [
            c
            for c in self.regime.coordinates
            if c.symbol in expr.free_symbols and c.symbol not in self.kept and c.symbol not in self.found
        ]

    def _next(self) -> Iterator[Function]:
        """The coordinate that follows next."""
        found = self._by_place() or (self._by_law() if self.timed else None)
        if found is not None:
            self.found[found.symbol] = found
            yield found

    # --- relations about places --------------------------------------------------------------------------------------

    def _by_place(self) -> Function | None:
        starts = {c.start for c in self.regime.coordinates}
        for c in sorted(self.regime.general.constraints, key=lambda c: c.kind != "motion"):
            residual = self.put_in(c.residual)
            unknown = self._open(residual)
            if len(unknown) != 1 or residual.free_symbols & starts:
                continue
            if not self.timed and self.regime.time in residual.free_symbols:
                continue
            expr = self._solved(residual, unknown[0].symbol)
            if expr is not None:
                words = "given" if c.kind == "motion" else f"{c.title} does not change"
                return Function(unknown[0].symbol, expr, words)
        return None

    def _solved(self, residual: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
        """The root that is near the drawn position."""
        value = self.value
        residual = smooth(residual, value)
        try:
            roots = real_roots(residual, x, value, True, False)
        except (Undecided, NoValue, Unvalued):
            return None
        here = value(x)
        angle = self.regime.general.instant.scene.ledger.units[x].angle
        for root in roots:
            if root.expression is None:
                continue
            off = root.value - here
            turns = round(off / (2 * PI)) if angle else 0
            if abs(off - 2 * PI * turns) <= SAME * max(abs(here), Decimal(1)):
                return simplified(smooth(root.expression - 2 * sp.pi * turns, value))
        return None

    # --- laws --------------------------------------------------------------------------------------------------------

    def _by_law(self) -> Function | None:
        """q(t) from q̇ = f(t, q), or from q̈ = f(t, q, q̇) where the speed at the start is known as well."""
        for c in self.regime.coordinates:
            if c.symbol in self.found or c.symbol in self.kept or not self._known(c.symbol):
                continue
            rate = self.put_in(self.regime.rates[c.symbol])
            if rate.free_symbols & set(self.regime.letters) <= {self.regime.time, c.symbol}:
                found = self._integrated(c.symbol, 1, rate, None, None)
                if found is not None:
                    return found
        for law in laws_of(self.regime).laws:
            q = law.coordinate.symbol
            if law.order == 2 and q not in self.found and q not in self.kept and self._known(q, law.speed):
                assert law.speed is not None
                found = self._integrated(q, 2, law.f, law.v, law.factor * self.starts[law.speed])
                if found is not None:
                    return found
        return None

    def _known(self, *symbols: sp.Symbol | None) -> bool:
        return self.regime.time in self.starts and all(s in self.starts for s in symbols)

    def _integrated(
        self, q: sp.Symbol, order: int, f: sp.Expr, v: sp.Symbol | None, speed: sp.Expr | None
    ) -> Function | None:
        t0, q0, v0 = (sp.Dummy(name, real=True) for name in ("t_0", "q_0", "v_0"))
        first = {t0: self.starts[self.regime.time], q0: self.starts[q], v0: speed if speed is not None else sp.S.Zero}
        value = self.value.extended({d: self.value(sp.sympify(e)) for d, e in first.items()})
        end = Moment(self.regime.time, q, v if v is not None else sp.Dummy("v", real=True))
        for span in relations(order, f, Moment(t0, q0, v0), end, value):
            if span.kind == "q(t)" and span.explicit is not None and not span.explicit.has(sp.Integral):
                sides = None
                if span.left is not None and span.right is not None:
                    sides = span.left.xreplace(first), span.right.xreplace(first)
                return Function(q, simplified(span.explicit.xreplace(first)), "integrated over time", sides)
        return None


def smooth(expr: sp.Expr, value: Valuation) -> sp.Expr:
    """Absolute values, roots of squares, and inverse sines of sines, as the branch that is drawn goes on: |cos θ| as
    cos θ, √(b² + 2 b s + s²) as b + s.
    """

    def signed(e: sp.Expr) -> sp.Expr:
        inside = e.args[0]
        return inside if value(inside) >= 0 else -inside

    def unwound(e: sp.Expr) -> sp.Expr:
        inner = e.args[0]
        angle = inner.args[0] if isinstance(inner, sp.sin | sp.cos) else None
        if angle is None:
            return e
        base = angle if INVERSE[type(e)] is type(inner) else sp.pi / 2 - angle
        for way in (base, -base, sp.pi - base):
            turns = (value(e) - value(way)) / (2 * PI)
            if abs(turns - round(turns)) <= SAME:
                return way + 2 * sp.pi * round(turns)
        return e

    def rooted(e: sp.Expr) -> sp.Expr:
        inside = sp.factor(e.base)
        return signed(sp.Abs(inside.base)) if inside.is_Pow and inside.exp == 2 else e

    expr = expr.replace(lambda e: isinstance(e, sp.asin | sp.acos), unwound)
    expr = expr.replace(lambda e: e.is_Pow and e.exp == sp.S.Half and e.base.is_Add, rooted)
    found: sp.Expr = simplified(expr).replace(lambda e: isinstance(e, sp.Abs), signed)
    return found


def directed(expr: sp.Expr, value: Valuation) -> sp.Expr:
    """Directions atan2(y, x) without the positive factor that both parts have."""

    def plain(e: sp.Expr) -> sp.Expr:
        y, x = e.args
        for phi in sorted({f.args[0] for f in e.atoms(sp.sin, sp.cos, sp.tan)}, key=str):
            if identically_zero(y * sp.cos(phi) - x * sp.sin(phi)) and value(x * sp.cos(phi) + y * sp.sin(phi)) > 0:
                return sp.sympify(phi)
        above, below = sp.fraction(simplified(y / x))
        sign = 1 if value(above) * value(y) > 0 else -1
        return sp.atan2(sign * above, sign * below)

    found: sp.Expr = expr.replace(lambda e: isinstance(e, sp.atan2) and e.args[1] != 0 and e.args[0] != 0, plain)
    return found


def drawn_start(regime: Regime) -> dict[sp.Symbol, sp.Expr]:
    """At t = 0 everything is where it is drawn; speeds are not known."""
    drawn = {c.symbol: c.drawn for c in regime.coordinates if c.drawn is not None}
    return {regime.time: sp.S.Zero, **drawn}


def explained(functions: Mapping[sp.Symbol, Function], exprs: Iterable[sp.Expr]) -> list[Function]:
    """The functions that expressions use, those first on which others rest."""
    wanted: list[sp.Symbol] = []
    left = [s for e in exprs for s in e.free_symbols]
    while left:
        s = left.pop()
        if s in functions and s not in wanted:
            wanted.append(s)
            left += functions[s].expr.free_symbols
    return [f for s, f in functions.items() if s in wanted]
