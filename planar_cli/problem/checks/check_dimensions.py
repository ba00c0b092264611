"""Checks of dimensions: every formula against what its place expects, through `dimensions.py`."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli import units
from planar_cli.errors import Diagnostic
from planar_cli.joints.base import Joint
from planar_cli.problem.checks.formulas import Formula, formulas
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.dimensions import (
    ANGLE,
    ANY,
    Kind,
    Lookup,
    check_found,
    check_side,
    check_statement,
    dimension_of,
)
from planar_cli.problem.language.expression import Name, Number, Quantity, Side
from planar_cli.problem.scene.scene import Particle
from planar_cli.units import UnitError, parse_unit

LOCALS = {"x": Kind(units.LENGTH), "theta": ANGLE}


class Kinds:
    """The look-up of one scope: the kind of each name, worked out once."""

    def __init__(self, scope: Scope) -> None:
        self.scope = scope
        self._known: dict[str, Kind] = {"g": Kind(units.ACCELERATION)}
        self._open: set[str] = set()

    def of(self, node: Name | Quantity) -> Kind | None:
        """The kind of a name, or of a quantity that the general table does not know; None: see there."""
        if isinstance(node, Quantity):
            return self._quantity(node)
        if node.name not in self._known:
            self._known[node.name] = self._name(node.name)
        return self._known[node.name]

    def within(self, names: frozenset[str]) -> Lookup:
        """The same look-up where the variables of a curve are known too."""

        def lookup(node: Name | Quantity) -> Kind | None:
            if isinstance(node, Name) and node.name in names:
                return LOCALS[node.name]
            return self.of(node)

        return lookup

    def _name(self, name: str) -> Kind:
        find = self.scope.case_finds.get(name)
        if find is not None:
            return check_found(find.found, self.of, [])
        symbol = self.scope.numbers.get(name)
        if symbol is None or name in self._open:
            return ANY
        if symbol.value is None:
            return unit_kind(symbol.unit or "")
        self._open.add(name)
        kind = dimension_of(symbol.value, self.of)
        self._open.discard(name)
        return kind

    def _quantity(self, quantity: Quantity) -> Kind | None:
        """`impulse(j/b)`, on a body b, is an impulse; `impulse(f/P)`, about a point, an angular one."""
        if quantity.word == "impulse" and about(quantity, self.scope) is None:
            return Kind(units.IMPULSE)
        return None


def about(quantity: Quantity, scope: Scope) -> str | None:
    """The point about which `impulse(f/P)` is taken; None for `impulse(f)` and `impulse(j/b)`, on the body b."""
    if len(quantity.things) < 2:
        return None
    first, second = quantity.things
    if second in scope.bodies and second not in scope.points:
        return None
    if second not in scope.bodies:
        return second
    shape = scope.bodies[second].shape
    names = {second, shape.place} if isinstance(shape, Particle) else {second}
    joints = [m for m in scope.members.get(first, ()) if isinstance(m, Joint)]
    held = any(second in scope.partners(m) or names & scope.mentioned(m) for m in joints)
    return None if held else second


def unit_kind(text: str) -> Kind:
    """The kind of what is measured in a unit; any, where the unit could not be read."""
    try:
        unit = parse_unit(text)
    except UnitError:
        return ANY
    return Kind(unit.dimension, unit.angle)


def dimensions_agree(scope: Scope) -> Iterator[Diagnostic]:
    """Every formula has the dimension of its place, and its terms fit each other."""
    kinds = Kinds(scope)
    report: list[Diagnostic] = []
    for formula in formulas(scope.problem):
        _check(formula, kinds, report)
    report += _of_gravity(scope, kinds)
    for find in scope.problem.find:
        check_found(find.found, kinds.of, report)
    yield from report


def _of_gravity(scope: Scope, kinds: Kinds) -> list[Diagnostic]:
    """The name g is that of the acceleration of gravity, whoever declares it."""
    symbol, wrong = scope.numbers.get("g"), list[Diagnostic]()
    if symbol is None:
        return wrong
    if symbol.value is not None:
        check_side(symbol.value, units.ACCELERATION, kinds.of, wrong)
    elif unit_kind(symbol.unit or "").dimension not in (ANY.dimension, units.ACCELERATION):
        text = f"g is the acceleration of gravity, and no quantity in {symbol.unit}"
        wrong.append(Diagnostic(symbol.mark, "PL224", text, "write it in `m/s^2` or `ft/s^2`, or take another letter"))
    return wrong


def _check(formula: Formula, kinds: Kinds, report: list[Diagnostic]) -> None:
    if not isinstance(formula.tree, Side):
        check_statement(formula.tree, kinds.of, report)
    elif formula.unit is None:
        if not formula.quantities:
            check_side(formula.tree, None, kinds.of, report)
    else:
        expected = parse_unit(formula.unit).dimension
        wrong: list[Diagnostic] = []
        check_side(formula.tree, expected, kinds.within(formula.locals), wrong, formula.angle)
        report += [_with_place(d, formula, kinds.scope) for d in wrong]


def _with_place(diagnostic: Diagnostic, formula: Formula, scope: Scope) -> Diagnostic:
    """The message says whose value it is, where the value as a whole has the wrong dimension."""
    if diagnostic.code not in ("PL224", "PL225"):
        return diagnostic
    message = f"{formula.what}: {diagnostic.message}"
    return Diagnostic(diagnostic.mark, diagnostic.code, message, diagnostic.hint or _repair(formula, scope))


def _repair(formula: Formula, scope: Scope) -> str:
    """What to write, and where, when the value is that of a name."""
    unit = "write a pure number" if formula.unit == "1" else f"write it in `{formula.unit}`"
    symbol = scope.numbers.get(formula.tree.name) if isinstance(formula.tree, Name) else None
    if symbol is None:
        return unit
    if isinstance(symbol.value, Number) and symbol.value.unit == "lb":
        unit = "`lb` is a mass; the force is `lbf`"
    return f"{symbol.name} stands in line {symbol.mark.line}: {unit}"
