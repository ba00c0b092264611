"""Checks of values: what is told by numbers alone is a real, finite number of a size that can be worked with."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping

from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.formulas import Formula, formulas
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import Binary, Extreme, Function, Name, Negate, Quantity, Relation, Side
from planar_cli.problem.language.walk import Tree, children, rational
from planar_cli.problem.scene.known_values import Known, KnownValues, NoNumber, Rough, demand_direction, order
from planar_cli.problem.scene.scene import Problem, Symbol

POWERS = 50
"""Between ten to this power and one part of it all numbers of a file lie, in SI units."""


PLACES = frozenset(("x", "y", "r", "theta"))
"""Quantities of which a state may say that they grow without end."""
HIGHEST = 300
"""So high may a power of letters be: 2 to it is still a number of the machine."""


def values_are_numbers(scope: Scope) -> Iterator[Diagnostic]:
    """No formula of numbers has a complex or infinite value, or one of a size that leaves no digits."""
    values = KnownValues(scope.numbers)
    ends = {"t", *(symbol.name for symbol in scope.problem.coordinates)}
    for formula in formulas(scope.problem):
        for side in _sides(formula, ends):
            yield from _of_side(side, formula, values)


def letters_grow_slowly(scope: Scope) -> Iterator[Diagnostic]:
    """No value is a power of letters so high that no number of them leaves it a size to work with."""
    degrees = Degrees(scope.numbers)
    for symbol in scope.problem.given:
        if symbol.value is None:
            continue
        degree = degrees.of(symbol.value)
        if degree > HIGHEST:
            text = f"the value of {symbol.name} is of degree {degree:.4g} in letters, more than {HIGHEST}"
            yield Diagnostic(symbol.mark, "PL207", text, "give some of its names numbers")
            return


def answers_are_numbers(problem: Problem) -> Iterator[Diagnostic]:
    """A stated answer is a real number, or infinite; a tolerance is a part of the value between 0 and 1."""
    values = KnownValues(Scope(problem, ()).numbers)
    for answer in problem.answers:
        stated = answer.value if isinstance(answer.value, tuple) else (answer.value,)
        for side in stated:
            if isinstance(side, Side) and not _is_infinity(side):
                what = f"the answer {answer.name}"
                yield from _of_side(side, Formula(side, what, answer.mark), values)
    yield from _tolerances(problem, values)


def _tolerances(problem: Problem, values: KnownValues) -> Iterator[Diagnostic]:
    own = [(answer.tolerance, f"the tolerance of the answer {answer.name}") for answer in problem.answers]
    for side, what in ((problem.tolerance, "the tolerance"), *own):
        if side is None:
            continue
        try:
            value = values.value(side)
        except NoNumber as wrong:
            if side is not problem.tolerance:
                # That of the file is one of its formulas.
                yield Diagnostic(wrong.mark, wrong.code, f"{what}: {wrong.text}", wrong.hint)
            continue
        if value is not None and not 0 <= (value.value if isinstance(value, Rough) else value) <= 1:
            hint = "it is a part of the value: `0.01` lets an answer be one per cent off"
            yield Diagnostic(side.mark, "PL462", f"{what} does not lie between 0 and 1", hint)


def _sides(formula: Formula, ends: Container[str]) -> Iterator[Side]:
    """The sides whose values count; a state may say that a place is infinite, or the time or a coordinate (`ends`)."""
    tree = formula.tree
    if isinstance(tree, Relation):
        sides: tuple[Side, ...] = (tree.left, tree.right)
        if formula.what.startswith("the state") and tree.operator == "=" and any(_is_one_of(s, ends) for s in sides):
            sides = tuple(side for side in sides if not _is_infinity(side))
        yield from sides
    elif isinstance(tree, Extreme):
        yield tree.side
    elif isinstance(tree, Side):
        yield tree


def _is_one_of(side: Side, names: Container[str]) -> bool:
    place = isinstance(side, Quantity) and side.word in PLACES
    return place or (isinstance(side, Name) and side.at is None and side.name in names)


def _is_infinity(side: Side) -> bool:
    inner = side.operand if isinstance(side, Negate) else side
    return isinstance(inner, Name) and inner.name == "infinity"


def _of_side(side: Side, formula: Formula, values: KnownValues) -> Iterator[Diagnostic]:
    try:
        value = values.value(side)
        if value is not None and formula.angle:
            demand_direction(value, side.mark)
    except NoNumber as wrong:
        yield Diagnostic(wrong.mark, wrong.code, f"{formula.what}: {wrong.text}", wrong.hint)
        return
    power = _beyond(value)
    if power and not isinstance(side, Name):
        text = f"{formula.what} is about 10^{power} in m, kg, s: too {'large' if power > 0 else 'small'} to work with"
        yield Diagnostic(side.mark, "PL207", text, f"numbers lie between 10^-{POWERS} and 10^{POWERS}")


def _beyond(value: Known | None) -> int:
    """The power of ten of a value that is too large or too small; 0 for all others."""
    power = None if value is None else order(value)
    return power if power is not None and abs(power) > POWERS else 0


class Degrees:
    """How high powers of letters the names of a file are at most, as in a polynomial."""

    def __init__(self, names: Mapping[str, Symbol]) -> None:
        self.names = names
        self._found: dict[str, float] = {}

    def of(self, tree: Tree) -> float:
        """The degree of a formula; functions of letters count as letters."""
        match tree:
            case Name(name=name):
                return self._named(name)
            case Function(argument=argument):
                return min(1.0, self.of(argument))
            case Binary(operator="^", left=base, right=exponent):
                power = rational(exponent)
                return self.of(base) * (1.0 if power is None else abs(float(power)))
            case Binary(operator="*" | "/", left=left, right=right):
                return self.of(left) + self.of(right)
            case _:
                return max((self.of(child) for child in children(tree)), default=0.0)

    def _named(self, name: str) -> float:
        symbol = self.names.get(name)
        if symbol is None or symbol.value is None:
            return float(symbol is not None)
        if name not in self._found:
            # What goes in a circle is told as such (PL436).
            self._found[name] = 0.0
            self._found[name] = self.of(symbol.value)
        return self._found[name]
