"""Numbers, symbols and directions of a solution in words: the small phrases that the narration is made of."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import field, replace
from decimal import Decimal
from typing import Any

import sympy as sp
from sympy.functions.elementary.trigonometric import InverseTrigonometricFunction

from planar_cli.calculus.curve_words import CIRCLE, Curve
from planar_cli.equation.algebra.plain import PRINTABLE, by_name, longer
from planar_cli.equation.scene.arrows import vector_arrow
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind, Ledger, display
from planar_cli.equation.values.one_way import one_way, sized
from planar_cli.problem.language.expression import Quantity
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, Text, Value
from planar_cli.report.notation.enough_figures import figures_each
from planar_cli.report.notation.given_distances import with_given_distances
from planar_cli.report.notation.neat import Neat
from planar_cli.report.notation.numbers import quantity, significant, vector_words
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.notation.pieces import met
from planar_cli.report.notation.rounding import rounded
from planar_cli.report.notation.total_masses import with_totals
from planar_cli.report.notation.trigonometric_numbers import in_radians, right_angles, turned_angles
from planar_cli.report.words.in_decimals import in_decimals
from planar_cli.report.words.senses import direction_words, sense_of_formula, steepness_words
from planar_cli.report.words.slopes import Slope
from planar_cli.report.words.swallowed import swallowed
from planar_cli.solve.passages import squared_radius
from planar_cli.solve.solution import Found
from planar_cli.units import LENGTH, TIME, Dimension, Unit

ANGLES = ("", "1", "deg", "rad", "rev")


@record
class Phrases:
    """Phrases for one ledger and valuation. `figures`: significant figures. `symbolic`: letters remain, no numbers."""

    ledger: Ledger
    value: Valuation
    figures: int
    symbolic: bool
    lettered: frozenset[sp.Symbol] = frozenset()
    """Symbols that stand for letters without a number, or rest on one: no number is put in for them."""
    ways: Mapping[sp.Symbol, int] = field(default_factory=dict)
    """The signs of speeds, where these are known all the time."""
    drawn: Valuation | None = None
    """The position of a motion in which arrows are drawn; None: the one of `value`."""
    slopes: tuple[Slope, ...] = ()
    """The fixed lines of the file by which directions are told."""

    @property
    def letters(self) -> bool:
        """Do names without a number stand for the file's own quantities, beside time and coordinates?"""
        return any(s.is_positive and s.name != "g" for s in self.ledger.letters)

    def math(self, expr: Any) -> Math:
        """An expression in its names."""
        return Math(rounded(self.neat(self.met(sp.sympify(expr))), self.figures))

    def neat(self, expr: sp.Expr) -> sp.Expr:
        """An expression as a person would write it."""
        whole = self.writer(expr)
        return whole if self.symbolic else with_given_distances(whole, self.ledger, self.value)

    @property
    def writer(self) -> Neat:
        """Writes formulas as a person would."""
        return Neat(self.ledger, self.value)

    def met(self, expr: sp.Expr) -> sp.Expr:
        """Of a formula in pieces those that the motion meets; with letters all of them; |v| as it goes, of what is
        known to be positive |v| = v, of a difference |a - b| = b - a where that is positive.
        """
        expr = one_way(expr, self.ways)
        if self.symbolic:
            return expr
        return met(sized(expr, self.value.known), self.value)

    def numbers(
        self, expr: sp.Expr, sizes: Mapping[sp.Symbol, Decimal] | None = None, turns: bool = True
    ) -> Math | None:
        """The expression with numbers put in for its names; None where letters have none,
        nothing is to be put in, or so few figures as a page has would give another result. `sizes`: of symbols that
        stand for numbers in it already; `turns`: it may be an angle.
        """
        if not all(self.has_numbers(s) for s in expr.free_symbols - set(sizes or ())):
            return None
        expr = self.neat(self.met(expr)) if sizes is None else with_totals(expr, self.ledger)
        degrees = [s for s in by_name(expr.free_symbols) if self._in_degrees(s)]
        apart = (
            {}
            if turns and is_angle(expr, degrees)
            else {s: sp.Symbol(f"{s.name} rad", **s.assumptions0) for s in degrees}
        )
        counted: dict[sp.Symbol, Decimal] = {}
        for symbol in by_name(expr.free_symbols):
            value = (sizes or {}).get(symbol, self.value.known(symbol))
            if value is None:
                return None
            counted[symbol] = self._in_page_units(symbol, value)
        if not counted:
            return None
        # One angle may stand in a function, in degrees, and beside it, in radians.
        expr = in_radians(expr, apart)
        counted |= {own: counted[s] for s, own in apart.items()}
        figures = figures_each(expr, rounded, counted, degrees, self.figures)
        if figures is None:
            return None
        texts = {s: significant(x, figures.each[s]) for s, x in counted.items()}
        for symbol in degrees:
            turned = self._in_unit(counted[symbol], self.ledger.units[symbol])
            texts[symbol] = significant(turned, figures.each[symbol]) + "°"
        expr, inside = turned_angles(rounded(expr, figures.own), self.ledger)
        return Math(expr, texts | {own: f"{texts[s]} rad" for s, own in inside.items()})

    def has_numbers(self, expr: sp.Expr) -> bool:
        """Have all symbols of an expression numbers of their own?"""
        return not self.symbolic and not (self.lettered and any(self._rests(s) for s in expr.free_symbols))

    def _rests(self, symbol: sp.Symbol) -> bool:
        """Has it no number of its own?"""
        definition = self.value.definitions.get(symbol)
        inside = definition.free_symbols if definition is not None else ()
        return symbol in self.lettered or any(self._rests(s) for s in inside)

    def substituted(self, expr: sp.Expr, value: Any) -> list[Math]:
        """The side with numbers put in, where it says more than the value that follows it."""
        from planar_cli.report.notation.notation import plain

        found = self.numbers(expr, turns=not isinstance(value, Value) or value.unit in ANGLES)
        if found is None:
            return []
        if isinstance(value, Value) and value.unit == "deg" and found.values is not None:
            told, texts = right_angles(found.expr, found.values)
            found = Math(told, {**found.values, **texts})
        same = isinstance(value, Value) and plain(found.expr, found.values) in _texts(value)
        return [] if same else [found]

    def _in_degrees(self, symbol: sp.Symbol) -> bool:
        unit = self.ledger.units.get(symbol)
        return unit is not None and unit.angle and bool(unit.pi_power) and unit.text == "deg"

    def in_radians(self, symbol: sp.Symbol, formula: sp.Expr | None, value: Decimal) -> list[Value]:
        """An angle that is told in degrees, where it is worked out in radians, as ω t is."""
        if formula is None or not self._in_degrees(symbol) or formula.is_number or not value.is_finite():
            return []
        turns = is_angle(formula, [s for s in formula.free_symbols if self._in_degrees(s)])
        return [] if turns else [Value(value, "rad", self.figures)]

    def _in_page_units(self, symbol: sp.Symbol, value: Decimal) -> Decimal:
        unit = self.ledger.units.get(symbol)
        return value if unit is None else self._in_unit(value, self.page_unit(unit))

    def _in_unit(self, value: Decimal, unit: Unit) -> Decimal:
        return display(value, unit, self.ledger.us)

    def page_unit(self, unit: Unit) -> Unit:
        """The unit of the lines of the page: SI, or feet, slugs, seconds and pounds in a file in US units."""
        own = coherent_unit(unit.dimension, unit.angle, self.ledger.us)
        # As the file writes it: a mass that flows is counted in kg/s, not in N·s/m.
        return unit if unit.factor == own.factor and not unit.angle and not unit.pi_power else own

    def of_dimension(self, value: Decimal, dimension: Dimension, angle: bool = False) -> Value:
        """A value in base units in the unit of the page."""
        unit = coherent_unit(dimension, angle, self.ledger.us)
        return Value(self._in_unit(value, unit), unit.text, self.figures)

    def vector(self, x: Decimal, y: Decimal, dimension: Dimension) -> Line:
        """[x, y] of values in base units, with the unit of the page."""
        one, other = (self.of_dimension(p, dimension) for p in (x, y))
        return components(one.number, other.number, one.unit, self.figures)

    def in_units(self, value: Decimal, unit: Unit, energy: bool = False) -> list[Value]:
        """A value in base units in the unit of the page, which the numbers before it have, and in the one that is
        asked, where it is another.
        """
        own = self.page_unit(unit)
        same = unit.text == "deg" or self._in_unit(Decimal(1), unit) == self._in_unit(Decimal(1), own)
        units = [unit] if same else [own, unit]
        return [Value(self._in_unit(value, u), told_unit(u, energy), self.figures) for u in units]

    def shown(self, symbol: sp.Symbol, value: Decimal | None = None) -> Value:
        """The value of a symbol in the units of the page."""
        unit = self.ledger.units.get(symbol)
        number = self.value(symbol) if value is None else value
        if unit is None:
            return Value(number, "1", self.figures)
        if unit.angle and unit.text == "deg":
            return Value(self._in_unit(number, unit), "deg", self.figures)
        own = self.page_unit(unit)
        return Value(self._in_unit(number, own), own.text, self.figures)

    def converted(self, symbol: sp.Symbol, value: Decimal) -> list[Value]:
        """The value of a constant that is sought in the unit in which the file asks for it: 2.083 ft = 25 in."""
        unit, role = self.ledger.units.get(symbol), self.ledger.roles.get(symbol)
        if unit is None or role is None or role.kind is not Kind.SOUGHT or self.symbolic:
            return []
        if unit.angle and unit.text != "rev":
            return []
        return self.in_units(value, unit)[1:] if value and value.is_finite() else []

    def arrow(self, x: Any, y: Any) -> str:
        """The direction of a vector as an arrow."""
        place = self if self.drawn is None else replace(self, value=self.drawn)
        return vector_arrow(place.certain(x), place.certain(y))

    def along(self, direction: tuple[Any, Any] | None) -> str:
        """The sense in which forces or momenta count as positive."""
        assert direction is not None
        return self.arrow(*direction)

    def certain(self, expr: Any) -> Decimal:
        """The value of an expression, zero where it is that to all certain digits."""
        value = self.value(expr)
        return Decimal(0) if value and self.value.is_zero(expr) else value


def _texts(value: Value) -> tuple[str, str]:
    """The number of a value without its unit, and with it."""
    return significant(value.number, value.figures), quantity(value.number, value.unit, value.figures)


def told_unit(unit: Unit, energy: bool) -> str:
    """The text of a unit; of an energy joule where its unit would be that of a moment."""
    return "J" if energy and unit.text == "N*m" else unit.text


def is_angle(expr: sp.Expr, degrees: Collection[sp.Symbol]) -> bool:
    """Is it a sum of angles that may all stand in degrees?"""
    kinds = (*degrees, InverseTrigonometricFunction)
    terms = (term.as_independent(*kinds, as_Add=False) for term in sp.Add.make_args(sp.expand_mul(expr)))
    return all(
        factor.is_number and (angle in degrees or isinstance(angle, InverseTrigonometricFunction) or angle == 1)
        for factor, angle in terms
    )


def answer_line(found: Found, phrases: Phrases, decimals: bool = False) -> Line:
    """The answer of a find: its value with unit and direction, its formula, or its word. `decimals`: and these."""
    if found.curve is not None:
        what = found.find.found.what if found.find is not None else None
        return curve_line(found.curve, phrases, isinstance(what, Quantity) and what.word == "hodograph")
    if found.word:
        return (Text(answer_word(found)),)
    if found.values is None:
        if any(longer(expr, PRINTABLE) for expr in found.expressions or ()):
            return (Text(f"more than {PRINTABLE} operations as one formula; the lines give it step by step"),)
        parts: list[Any] = []
        for i, expr in enumerate(found.expressions or ()):
            formula = swallowed(expr, found, phrases.ledger, phrases.figures) or Math(phrases.neat(expr))
            parts += [Text("[" if i == 0 and found.kind == "vector" else ", " if i else ""), formula]
        line = (*parts, Text("]")) if found.kind == "vector" else tuple(p for p in parts if p != Text(""))
        if decimals and phrases.letters and found.kind == "number":
            line = (*line, *in_decimals(found, phrases.neat, phrases.ledger, phrases.figures))
        sense = sense_of_formula(found, set(phrases.ledger.letters) - set(phrases.ledger.coordinates), phrases.ledger)
        return (
            *_in_asked_unit(line, found, phrases),
            *_unit_of_formula(found, phrases),
            *((Text(sense),) if sense else ()),
        )
    numbers = [display(v, found.unit, phrases.ledger.us) for v in found.values]
    unit = told_unit(found.unit, found.energy)
    if found.kind == "vector":
        what = found.find.found.what if found.find is not None else None
        place = isinstance(what, Quantity) and what.word in ("IC", "r")
        if not place and not any(numbers):
            return (Text("0"),)
        return _vector_line(numbers, unit, phrases.figures, place)
    if found.kind == "list":
        return tuple(x for n in numbers for x in (Text(", "), Value(n, unit, phrases.figures)))[1:]
    words = direction_words(found, numbers[0], phrases.ledger, phrases.value, phrases.slopes)
    shown = abs(numbers[0]) if words else numbers[0]
    steep = "" if words else steepness_words(found, numbers[0])
    return (Value(shown, unit, phrases.figures), Text(f" {words}" if words else steep))


def _unit_of_formula(found: Found, phrases: Phrases) -> Line:
    """In which units a formula counts that holds time, coordinates and numbers, but no other letters; with letters it
    has the unit that these make of it, whatever was asked.
    """
    if phrases.letters:
        asked = found.find.found.unit if found.find is not None else None
        if asked is None or found.unit.angle or display(Decimal(1), found.unit, phrases.ledger.us) == 1:
            return ()
        return (Text(f" (it has the unit of its letters; {_unit_only(asked)} is for numbers)"),)
    if found.unit.text == "1":
        return ()
    timed = any(s.name == "t" for e in found.expressions or () for s in e.free_symbols)
    return (Text(f" (in {_unit_only(found.unit.text)}{', t in s' if timed else ''})"),)


def _in_asked_unit(line: Line, found: Found, phrases: Phrases) -> Line:
    """A formula, whose numbers are in base units, times what makes it one in the unit of the answer."""
    factor = display(Decimal(1), found.unit, phrases.ledger.us)
    if phrases.letters or factor == 1 or all(e == 0 for e in found.expressions or ()):
        return line
    head = Text(f"{significant(factor, phrases.figures)} · ")
    whole = found.kind == "vector" or not (found.expressions or (sp.S.One,))[0].is_Add
    return (head, *line) if whole else (head, Text("("), *line, Text(")"))


def curve_line(curve: Curve, phrases: Phrases, hodograph: bool = False) -> Line:
    """The name of a curve, its equation with the units of its numbers, and where that holds. `hodograph`: it is one of
    velocities.
    """
    from planar_cli.report.notation.notation import plain

    parts: list[Any] = [Text(curve.told(plain)), *_radius(curve, phrases, hodograph)]
    if curve.equation is not None:
        shown = squared_radius(curve.equation, curve.radius)
        parts += [Text(", "), phrases.math(curve.equation) if shown == curve.equation else Math(shown)]
        plain_numbers = _with_numbers(curve.equation, phrases)
        if plain_numbers is not None:
            parts += [Text(", that is "), plain_numbers]
        if not phrases.letters and curve.equation.rhs != 0:
            length = "ft" if phrases.ledger.us else "m"
            parts.append(Text(f" (velocities in {length}/s)" if hodograph else f" (lengths in {length})"))
    if curve.holds:
        parts.append(Text(f", {curve.holds}"))
    return tuple(parts)


def _radius(curve: Curve, phrases: Phrases, hodograph: bool) -> Line:
    """Of a circle its radius, with the number of one that is no plain number."""
    if not curve.kind.startswith(CIRCLE) or curve.radius is None:
        return ()
    formula = phrases.math(curve.radius)
    if phrases.letters:
        return (Text(" of radius "), formula)
    value = phrases.of_dimension(phrases.value(curve.radius), LENGTH / TIME if hodograph else LENGTH)
    return (Text(" of radius "), *(() if curve.radius.is_Rational else (formula, Text(" = "))), value)


def _with_numbers(equation: Any, phrases: Phrases) -> Math | None:
    """A curve with the numbers of all names put in; None where there are none, or letters without a number."""
    inside = [s for s in equation.free_symbols if s in phrases.ledger.values]
    if phrases.letters or not inside:
        return None
    numbers = {s: sp.Rational(str(phrases.value(s))) for s in inside}
    sides = [side.xreplace(numbers) for side in (equation.lhs, equation.rhs)]
    numeric = [rounded(sp.nsimplify(sp.N(s, 30), rational=True), phrases.figures) for s in sides]
    return Math(sp.Eq(*numeric, evaluate=False))


def components(x: Decimal, y: Decimal, unit: str, figures: int) -> Line:
    """[x, y] with the unit of both."""
    shown = (Text("["), Value(x, "1", figures), Text(", "), Value(y, "1", figures), Text("]"))
    return shown if unit == "1" else (*shown, Text(f" {_unit_only(unit)}"))


def _vector_line(numbers: list[Decimal], unit: str, figures: int, place: bool) -> Line:
    """Components, then magnitude and direction; a place has components only."""
    x, y = numbers
    if x.is_infinite() or y.is_infinite():
        return (Text("at infinity"),)
    size = (x * x + y * y).sqrt()
    words = "" if place else vector_words(x, y)
    head = components(x, y, unit, figures)
    return (*head, Text(", that is "), Value(size, unit, figures), Text(f" {words}")) if words else head


def _unit_only(unit: str) -> str:
    from planar_cli.units import pretty_unit

    return pretty_unit(unit)


def answer_word(found: Found) -> str:
    """A truth value or a mode as it is said."""
    return {
        "true": "yes",
        "false": "no",
        "stick": "stick (it does not slip)",
        "slip": "slip",
        "apart": "apart",
        "tip": "tip",
    }.get(found.word, found.word)


def answer_text(found: Found, phrases: Phrases) -> str:
    """The answer as plain text, for the JSON document."""
    from planar_cli.report.notation.notation import plain

    parts = []
    for piece in answer_line(found, phrases):
        if isinstance(piece, Text):
            parts.append(piece.text)
        elif isinstance(piece, Value):
            parts.append(quantity(piece.number, piece.unit, piece.figures))
        elif isinstance(piece, Math):
            parts.append(plain(piece.expr))
    return "".join(parts).strip()
