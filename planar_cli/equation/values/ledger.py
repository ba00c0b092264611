"""The names of one problem as SymPy symbols: which have numbers, which stay letters, which are to be solved for.

The only maker of symbols. Every symbol carries the unit in which it is shown; inside, all numbers are in
the base units of the file (units.py).
"""

from __future__ import annotations

import random
from collections import ChainMap
from collections.abc import Callable, Iterable, Mapping
from dataclasses import field
from decimal import Decimal
from enum import Enum
from fractions import Fraction

import sympy as sp

from planar_cli.base_units import factor_to_base
from planar_cli.equation.values.exact import PI, Sample, Valuation
from planar_cli.equation.values.sample import fraction, generator, widely
from planar_cli.errors import NoValue
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.ordinary import GRAVITY, Scales
from planar_cli.records import changing, record
from planar_cli.units import PURE, Unit, parse_unit

DRAWS, WIDER, MANY = 2, 10, 30
ROUGH = Decimal("0.3")
"""An ordinary coefficient of friction."""
UNPLACED = 40
"""Where the joints can be closed at none of the first draws, no others are tried."""
TRIES_FROM = 10_000
"""Streams of random numbers of all tries after the first begin here."""


class Kind(Enum):
    """What a symbol is in a problem, whatever it is called."""

    TIME = "time"
    GIVEN = "given"
    LETTER = "a known without a number"
    SOUGHT = "sought constant"
    COORDINATE = "coordinate"
    START = "value of a coordinate at the start"
    SPEED = "velocity unknown"
    ACCELERATION = "acceleration unknown"
    NAMED = "named intermediate"
    STATE = "value at a state"


@record
class Role:
    """What a symbol is."""

    kind: Kind
    of: sp.Symbol | None = None
    """The coordinate to which a start belongs, or a speed or acceleration of the file's own; what has its value at a
    state.
    """
    at: str | None = None
    """The state at which it is a value."""


NAMED = Role(Kind.NAMED)


@changing
class Ledger:
    """Symbols and what is known of them.

    `values`: exact expression of a known (a number, or a formula of other knowns). `definitions`: named intermediates
    in the order in which they were made, with `titles` saying what each is. `letters`: knowns without a number.
    `sought`: unknown constants and coordinates. `units`: the unit for display, by symbol. `ranges`: from where to where
    a letter is drawn, where the usual range would not do; `beside`: near which formula of other letters, from where to
    where in parts of its size (of a radian, for an angle). `project`: moves drawn coordinates to where loops close.
    `named`: symbols that stand for an expression, by name and expression. `roles`: what every symbol is. `reserved`:
    the names of the file, which no symbol of ours gets. `scales`: ordinary sizes of the scene. `above_zero`: sums that
    the file assumes to be positive. `coefficients`: of what the letters of these names are the coefficients,
    "friction" or "rebound".
    """

    symbols: dict[str, sp.Symbol] = field(default_factory=dict)
    values: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    definitions: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    titles: dict[sp.Symbol, str] = field(default_factory=dict)
    letters: list[sp.Symbol] = field(default_factory=list)
    sought: list[sp.Symbol] = field(default_factory=list)
    coordinates: list[sp.Symbol] = field(default_factory=list)
    units: dict[sp.Symbol, Unit] = field(default_factory=dict)
    us: bool = False
    ranges: dict[str, tuple[Decimal, Decimal]] = field(default_factory=dict)
    beside: dict[str, tuple[sp.Expr, Decimal, Decimal]] = field(default_factory=dict)
    project: Callable[[Valuation], Mapping[sp.Symbol, Decimal]] | None = None
    named: dict[tuple[str, sp.Expr], sp.Symbol] = field(default_factory=dict)
    roles: dict[sp.Symbol, Role] = field(default_factory=dict)
    reserved: frozenset[str] = frozenset()
    scales: Scales = field(default_factory=Scales)
    above_zero: tuple[sp.Expr, ...] = ()
    coefficients: dict[str, str] = field(default_factory=dict)

    def known(self, name: str, value: sp.Expr, unit: str) -> sp.Symbol:
        """A name with a value; positive when its number is."""
        symbol = sp.Symbol(name, positive=True) if value.is_positive else sp.Symbol(name, real=True)
        self.symbols[name] = symbol
        self.values[symbol] = value
        self.units[symbol] = parse_unit(unit)
        self.roles[symbol] = Role(Kind.GIVEN)
        return symbol

    def time(self) -> sp.Symbol:
        """The time t."""
        symbol = self.symbols["t"] = sp.Symbol("t", real=True)
        self.units[symbol] = parse_unit("s")
        self.roles[symbol] = Role(Kind.TIME)
        return symbol

    def letter(self, name: str, unit: str) -> sp.Symbol:
        """A known without a number: a positive letter."""
        symbol = self.symbols[name] = sp.Symbol(name, positive=True)
        self.letters.append(symbol)
        self.units[symbol] = parse_unit(unit)
        self.roles[symbol] = Role(Kind.LETTER)
        return symbol

    def gravity(self, letter: bool) -> None:
        """g, which the file does not give: a letter, or that of the Earth."""
        if letter:
            self.letter("g", "m/s^2")
        else:
            self.known("g", exact(GRAVITY, parse_unit("m/s^2"), self.us), "m/s^2")

    def seek(self, name: str, unit: str, *, coordinate: bool = False, distance: bool = False) -> sp.Symbol:
        """An unknown constant, or a coordinate."""
        symbol = self.symbols[name] = sp.Symbol(name, nonnegative=True) if distance else sp.Symbol(name, real=True)
        self.sought.append(symbol)
        if coordinate:
            self.coordinates.append(symbol)
        self.units[symbol] = parse_unit(unit)
        self.roles[symbol] = Role(Kind.COORDINATE if coordinate else Kind.SOUGHT)
        return symbol

    def settle(self, symbol: sp.Symbol, value: sp.Expr) -> None:
        """What was sought is now known by a formula."""
        self.sought.remove(symbol)
        self.values[symbol] = value

    def release(self, symbol: sp.Symbol) -> None:
        """What was sought stays a letter of the answer (a coordinate, in a formula that holds throughout)."""
        self.sought.remove(symbol)
        self.letters.append(symbol)

    def fresh(self, name: str, unit: str, *, positive: bool = False, role: Role = NAMED) -> sp.Symbol:
        """A new symbol of ours, named apart from every name of the file; a value of a distance is one itself."""
        free = name
        while free in self.symbols or free in self.reserved:
            free += "′"
        distance = role.of is not None and role.kind in (Kind.STATE, Kind.START) and role.of.is_nonnegative
        signs = {"positive": True} if positive else {"nonnegative": True} if distance else {"real": True}
        symbol = self.symbols[free] = sp.Symbol(free, **signs)
        self.units[symbol] = parse_unit(unit)
        self.roles[symbol] = role
        return symbol

    def apart(self, name: str) -> str:
        """A name of ours that the file has not."""
        while name in self.reserved:
            name += "′"
        return name

    def adopt(self, symbol: sp.Symbol, unit: Unit, role: Role) -> None:
        """A symbol that another ledger of the same problem has made; its name is taken here."""
        self.symbols.setdefault(symbol.name, symbol)
        self.know(symbol, unit, role)

    def know(self, symbol: sp.Symbol, unit: Unit, role: Role) -> None:
        """What a symbol is that another ledger of the same problem has made."""
        self.units.setdefault(symbol, unit)
        self.roles.setdefault(symbol, role)

    def is_speed(self, symbol: sp.Symbol) -> bool:
        """Is a symbol a velocity unknown, or the rate of a coordinate of the file?"""
        return self.roles[symbol].kind is Kind.SPEED

    def once(self, name: str, unit: str, expr: sp.Expr) -> sp.Symbol:
        """A symbol of ours for an expression: the same one for the same expression."""
        if (name, expr) not in self.named:
            self.named[name, expr] = self.fresh(name, unit)
        return self.named[name, expr]

    def define(self, name: str, expr: sp.Expr, unit: str, title: str, *, positive: bool = False) -> sp.Symbol:
        """A named intermediate."""
        symbol = self.fresh(name, unit, positive=positive)
        self.definitions[symbol] = expr
        self.titles[symbol] = title
        return symbol

    def known_letters(self) -> set[sp.Symbol]:
        """What the file gives: letters without a number, letters with one, and what is a formula of these."""
        known = set(self.letters)
        while new := {s for s, e in self.values.items() if s not in known and e.free_symbols <= known}:
            known |= new
        return known

    def is_multiple_of_a_letter(self, expr: sp.Expr) -> bool:
        """`4*m`, with m kept as a letter: it is written 4 m wherever it stands."""
        _, rest = expr.as_coeff_Mul()
        return rest.is_Symbol and rest not in self.values

    def behind(self, symbol: sp.Symbol) -> sp.Expr:
        """The formula of a named intermediate, or of a constant that is given by one; of others the symbol itself."""
        return sp.sympify(self.definitions.get(symbol, self.values.get(symbol, symbol)))

    def heading(self, angle: sp.Expr) -> Vec:
        """The unit vector in a direction. Of one that is given by name as a right angle it is that of the axis: φ = 90°
        leaves no cos φ in the equations.
        """
        parts, given = (sp.cos(angle), sp.sin(angle)), Valuation({}, self.values)
        if angle.free_symbols <= self.values.keys():
            signs = [given(p) for p in parts]
            parts = next((tuple(sp.Integer(round(s)) for s in signs) for p in parts if given.is_zero(p)), parts)
        return Vec(*parts)

    def natural(self, symbol: sp.Symbol) -> Decimal:
        """An ordinary size of what a symbol stands for; of a letter of the file, 1 in the base units."""
        unit = self.units.get(symbol)
        return Decimal(1) if unit is None or symbol.is_positive else self.scales.exact(unit.dimension)

    @property
    def symbolic(self) -> bool:
        """Do letters without numbers remain?"""
        return bool(self.letters)

    def valuations(self, holds: Callable[[Valuation], bool], tries: int = 400) -> tuple[Valuation, ...]:
        """Draws of all letters (and of what is sought) for which `holds`; one is enough when there is nothing to draw.

        Letters are of like size, unless `holds` wants them otherwise, as M > 10 m does. The draws are the same in every
        run. An empty result: no draw was found.
        """
        return self._draws(holds, tries, self._draw) or self._draws(holds, WIDER * tries, self._far)

    def far_draws(self, holds: Callable[[Valuation], bool]) -> tuple[Valuation, ...]:
        """Draws from some decades for which `holds`."""
        return self._draws(holds, MANY * WIDER, self._far, MANY)

    def _draws(
        self,
        holds: Callable[[Valuation], bool],
        tries: int,
        draw: Callable[[sp.Symbol, random.Random], Decimal],
        wanted: int = DRAWS,
    ) -> tuple[Valuation, ...]:
        # Letters of the file come first, so that they are the same in every scene of it.
        free = sorted([*self.letters, *self.sought], key=lambda s: self.roles[s].kind is not Kind.LETTER)
        found: list[Valuation] = []
        unplaced = 0
        for k in range(tries if free else 1):
            # Each try has numbers of its own: another scene of the file, in which more or less is sought, draws the
            # same letters at the same try.
            rng = generator(k and TRIES_FROM + k)
            known = ChainMap(self.values, self.definitions)
            numbers = {s: draw(s, rng) for s in free}
            try:
                numbers |= self._beside([s for s in free if s.name in self.beside], Valuation(numbers, known), rng)
            except NoValue:
                # There is no such place at these letters: others are drawn.
                continue
            candidate = Sample(numbers, known, frozenset(free)) if free else Valuation({}, known)
            placed = self._projected(candidate)
            if placed is not None and _holds(holds, placed):
                found.append(placed)
            unplaced += placed is None
            if len(found) == (wanted if free else 1) or (unplaced > UNPLACED and unplaced == k + 1):
                break
        return tuple(found)

    def _beside(self, free: Iterable[sp.Symbol], value: Valuation, rng: random.Random) -> dict[sp.Symbol, Decimal]:
        """Draws of what lies beside formulas of other letters."""
        found = {}
        for symbol in free:
            expr, low, high = self.beside[symbol.name]
            origin = value(expr)
            size = Decimal(1) if self.units[symbol].angle else abs(origin)
            found[symbol] = origin + size * (low + (high - low) * fraction(rng))
        return found

    def _projected(self, candidate: Valuation) -> Valuation | None:
        if self.project is None:
            return candidate
        try:
            return candidate.extended(self.project(candidate))
        except ArithmeticError:
            return None

    def _draw(self, symbol: sp.Symbol, rng: random.Random) -> Decimal:
        if widely() and symbol.name not in self.ranges:
            return self._far(symbol, rng)
        number = fraction(rng)
        if symbol.name in self.ranges:
            low, high = self.ranges[symbol.name]
            return low + (high - low) * number
        if self.units[symbol].angle and self.units[symbol].dimension == PURE:
            # Moderate ones, as in a drawing, on either side of an eighth of a turn.
            return PI * (Decimal("0.09") + Decimal("0.24") * number)
        size = ROUGH if symbol.name in self.coefficients else self.natural(symbol)
        return (Decimal("0.5") + Decimal("1.5") * number) * size

    def _far(self, symbol: sp.Symbol, rng: random.Random) -> Decimal:
        """A draw from some decades, or of any acute angle."""
        if symbol.name in self.ranges:
            return self._draw(symbol, rng)
        number = fraction(rng)
        if self.units[symbol].angle and self.units[symbol].dimension == PURE:
            return PI * number / 2
        return Decimal(10) ** (3 * (2 * number - 1)) * self.natural(symbol)


def _holds(test: Callable[[Valuation], bool], valuation: Valuation) -> bool:
    try:
        return test(valuation)
    except ArithmeticError:
        return False


def exact(number: Fraction, unit: Unit | None, us: bool) -> sp.Expr:
    """A written number in the base units of a file, exact."""
    value = sp.Rational(number.numerator, number.denominator)
    if unit is None:
        return value
    factor = factor_to_base(unit, us)
    return value * sp.Rational(factor.numerator, factor.denominator) * sp.pi**unit.pi_power


def at_state(letter: str) -> str:
    """`theta @ free` for the letter of a state, `theta__free`; any other one as it is."""
    stem, _, state = letter.partition("__")
    return f"{stem} @ {state}" if state else stem


def display(value: Decimal, unit: Unit, us: bool) -> Decimal:
    """A value in the base units of a file in the given unit."""
    factor = factor_to_base(unit, us)
    return value / (Decimal(factor.numerator) / Decimal(factor.denominator) * PI**unit.pi_power)


def total(parts: Iterable[sp.Expr]) -> sp.Expr:
    """Σ parts."""
    return sp.Add(*parts)
