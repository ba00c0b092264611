"""One regime of a motion: a general position in one choice of modes, with the rates of everything that varies.

What moves is described by the coordinates q and the free speeds u; every other quantity is a formula in them and t:

    dq/dt = R(t, q, u)        du/dt = f(t, q, u)        dX/dt = ∂X/∂t + Σ ∂X/∂q R + Σ ∂X/∂u f
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.machine import compiled
from planar_cli.equation.algebra.plain import derivative, letters, longer, simplified
from planar_cli.equation.algebra.trigonometry import put_together
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.equation.values.one_way import one_way
from planar_cli.equation.values.sample import anywhere
from planar_cli.errors import NoValue
from planar_cli.problem.scene.facts import Test
from planar_cli.records import changing, record
from planar_cli.solve.instant.locked import LOCKED
from planar_cli.solve.regimes.energy import balance_of
from planar_cli.solve.regimes.general import General, loose_tree
from planar_cli.solve.regimes.speed_transfer import edges_of, transferred_speed

LONGEST = 150
"""A formula with more operations is not simplified."""


@record
class Watch:
    """A test of the assumed modes as a formula: it must stay positive (or not negative)."""

    test: Test
    expr: sp.Expr


@changing
class Regime:
    """What acts in one choice of modes, worked out for what is stated and asked in it."""

    general: General
    ways: Mapping[str, int] = field(default_factory=dict)
    """The signs of free speeds by name, where a law asks for them; then it is written for this way."""
    exprs: list[sp.Expr] = field(default_factory=list)
    """What it was worked out for."""
    rates: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Of coordinates, closed formulas."""
    accelerations: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """Of free speeds, closed formulas."""
    watches: tuple[Watch, ...] = ()
    """What must hold."""
    sided: dict[str, tuple[int, sp.Expr]] = field(default_factory=dict)
    """Places on one side of that from which their distance is measured, by name."""
    slips: tuple[sp.Expr, ...] = ()
    """Speeds of slip, positive the way that is assumed."""
    balance: tuple[sp.Expr, sp.Expr] | None = None
    """Kinetic energy and power, of one freedom."""
    runs: bool = False
    """Does time pass in it? Else it only tells velocities at a blow."""
    loose: bool = False
    """Do tests of modes hold pushes that are not determined?"""
    undetermined: list[sp.Expr] = field(default_factory=list)
    """What is needed and rests on such."""

    @property
    def time(self) -> sp.Symbol:
        return self.general.time

    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        return self.general.coordinates

    @property
    def free(self) -> tuple[sp.Symbol, ...]:
        return self.general.free

    @property
    def letters(self) -> tuple[sp.Symbol, ...]:
        """t, all coordinates, all free speeds."""
        return (self.time, *(c.symbol for c in self.coordinates), *self.free)

    def work(self, exprs: Iterable[sp.Expr], runs: bool = True) -> None:
        """Work out rates and accelerations, and whatever these expressions need. `runs`: does time pass in it?"""
        general = self.general
        rates = {c.symbol: self._rate(c) for c in general.coordinates}
        wanted = [e for e in exprs if e not in self.exprs]
        if self.rates and not wanted and (self.runs or not runs):
            return
        self.runs = runs = self.runs or runs
        accelerations = {u: general.rate_of(u) for u in general.free} if runs else {}
        watches, slips = (self._watches(), self._sliding()) if runs else ((), [])
        self.balance = balance_of(general) if runs else None
        self.exprs += wanted
        general.closed_forms.clear()
        every = [
            *rates.values(),
            *accelerations.values(),
            *(w.expr for w in watches),
            *slips,
            *(self.balance or ()),
            *self.exprs,
        ]
        self.undetermined = [e for e in every if not general.unique(e)]
        general.govern(e for e in every if e not in self.undetermined)
        self.rates = {s: self._regular(self.closed(e)) for s, e in rates.items()}
        self.accelerations = {u: self._regular(self.closed(e)) for u, e in accelerations.items()}
        told = self.told
        self.watches = tuple(w for w in (Watch(w.test, self.closed(w.expr)) for w in watches) if told(w.expr))
        self.slips = tuple(e for e in map(self.closed, slips) if told(e))
        scene = self.general.instant.scene
        # Formulas in letters are for the side that is drawn; whether it is left depends on the letters.
        sided = scene.sided if runs and not scene.problem.symbols else {}
        self.sided = {key: (way, self.closed(way * e)) for key, (way, e) in sided.items()}

    def _regular(self, expr: sp.Expr) -> sp.Expr:
        """A formula simplified where it has no value as drawn, as 0/0 may be taken out of it."""
        if not letters(expr) & set(self.letters) or longer(expr, LONGEST):
            return expr
        base = self.general.instant.scene.valuations[0]
        drawn = {c.symbol: base(c.drawn) if c.drawn is not None else Decimal(0) for c in self.coordinates}
        ordinary = self.general.instant.scene.ledger.natural
        drawn |= {u: anywhere(i) * ordinary(u) for i, u in enumerate(self.free)}
        try:
            base.extended(drawn)(expr)
        except Unvalued:
            return expr
        except NoValue:
            return simplified(put_together(expr))
        return expr

    def _rate(self, c: Coordinate) -> sp.Expr:
        """The rate of a coordinate; of a speed that this regime does not have, what its motion makes of it."""
        general = self.general
        tree = general.trial.system.tree
        known = {s.name for s in tree.velocity_unknowns()}
        rates = general.instant.scene.evaluator.speeds
        known |= {r.name for r in rates}
        if c.speed.name in known:
            return c.rate
        edges = edges_of(loose_tree(general.instant, general.choice))
        motion, scene = general.quantities.motion, general.instant.scene
        inside: dict[sp.Symbol, sp.Expr] = {}
        for s in c.rate.free_symbols:
            if s.name not in known and s in edges:
                inside[s] = transferred_speed(s, edges[s], motion, scene) or sp.S.Zero
        return c.rate.xreplace({c.speed: sp.S.Zero, **inside})

    def told(self, expr: sp.Expr) -> bool:
        """Is everything in a closed formula known once the letters are? Where nothing has mass, forces are not."""
        pushes = set(self.general.trial.system.symbols.values())
        return not letters(expr) & (pushes - set(self.general.instant.scene.ledger.letters))

    def moves(self) -> bool:
        """Do the velocities hold together, so that there is a motion at all?"""
        return self.general.trial.system.reactions is not None

    def moved(self) -> str:
        """What speaks against this regime in any position: contradicting equations; "" when nothing does."""
        objection = self.general.trial.objection
        return objection if objection in ("contradiction", "velocities", LOCKED) else ""

    def closed(self, expr: sp.Expr, kept: frozenset[sp.Symbol] = frozenset()) -> sp.Expr:
        """An expression of the instant as a formula in t, coordinates, free speeds and unknowns that are kept."""
        found = self.general.closed_but_for(expr, kept) if kept else self.general.closed(expr)
        return one_way(found, self.going())

    def in_letters(self, expr: sp.Expr) -> sp.Expr:
        """The same for its numbers only, not made plainer."""
        return one_way(self.general.in_letters(expr), self.going())

    def going(self) -> dict[sp.Symbol, int]:
        """The free speeds whose sign is assumed."""
        return {u: self.ways[u.name] for u in self.free if u.name in self.ways}

    def derivative(self, expr: sp.Expr) -> sp.Expr:
        """The rate of a closed formula."""
        parts = [derivative(expr, self.time)]
        parts += [derivative(expr, q) * r for q, r in self.rates.items() if q in expr.free_symbols]
        parts += [derivative(expr, u) * f for u, f in self.accelerations.items() if u in expr.free_symbols]
        return simplified(sp.Add(*parts))

    def _watches(self) -> tuple[Watch, ...]:
        """The tests of pushes in the assumed modes, where they are unique."""
        system = self.general.trial.system
        found = []
        self.loose = False
        assert system.reactions is not None
        values = {p.name: e for p, e in system.reactions.pushes}
        for mode in system.modes.values():
            for test in mode.tests:
                if test.row is not None or test.joining is not None:
                    continue
                expr = left_of(test, values)
                if expr != 0 and not self.general.unique(expr):
                    self.loose = True
                elif expr != 0:
                    found.append(Watch(test, expr))
        return tuple(found)

    def _sliding(self) -> list[sp.Expr]:
        """Speeds of slip of the contacts that slip; none may change its sign."""
        system = self.general.trial.system
        assert system.motion is not None
        return [
            system.motion.row_velocity(mode.sliding) * mode.direction
            for mode in system.modes.values()
            if mode.sliding is not None and mode.direction
        ]


def left_of(test: Test, values: Mapping[str, sp.Expr]) -> sp.Expr:
    """What a test must not let become negative; of two components within a limit by squares, (μ N)² - F_x² - F_y²."""
    if test.within:
        squares = (sp.sympify(values[name]) ** 2 for name in test.within if name in values)
        return sp.sympify(test.constant) ** 2 - sp.Add(*squares)
    parts = [factor * values[name] for name, factor in test.pushes if name in values]
    return sp.sympify(sp.Add(*parts, test.constant))


def number_function(
    exprs: Sequence[sp.Expr], letters: Sequence[sp.Symbol], value: Valuation
) -> Callable[..., list[float]]:
    """Machine numbers of expressions as a function of letters; everything else takes its value."""
    exprs = [sp.sympify(e) for e in exprs]
    made = compiled(exprs, letters, lambda s: float(value(s)))

    def call(*arguments: float) -> list[float]:
        try:
            return [float(x) for x in made(*arguments)]
        except (ValueError, ZeroDivisionError, OverflowError) as error:
            raise NoValue("a formula has no real value here") from error

    return call
