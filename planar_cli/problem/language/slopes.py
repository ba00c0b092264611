"""The slope of a formula that a file writes, as a formula of the same language."""

from __future__ import annotations

from fractions import Fraction

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Binary, Function, Name, Negate, Number, Scaled, Side
from planar_cli.problem.language.walk import changed, walk


def slope(formula: Side, variable: str) -> Side | None:
    """d formula / d variable; None: it holds what is not differentiated here (a power that varies, an inverse sine)."""
    if not _holds(formula, variable):
        return _number(0, formula.mark)
    match formula:
        case Name():
            return _number(1, formula.mark)
        case Negate():
            inner = slope(formula.operand, variable)
            return None if inner is None else Negate(inner, formula.mark)
        case Scaled():
            inner = slope(formula.operand, variable)
            return None if inner is None else Scaled(inner, formula.unit, formula.sense, formula.mark)
        case Binary(operator="^"):
            return _of_power(formula, variable)
        case Binary():
            return _of_two(formula, variable)
        case Function(at=None):
            return _of_function(formula, variable)
    return None


def _of_two(formula: Binary, variable: str) -> Side | None:
    left, right, mark = formula.left, formula.right, formula.mark
    first, second = slope(left, variable), slope(right, variable)
    if first is None or second is None:
        return None
    match formula.operator:
        case "+" | "-":
            return _two(formula.operator, first, second)
        case "*":
            return _two("+", _two("*", first, right), _two("*", left, second))
    over = _two("-", _two("*", first, right), _two("*", left, second))
    return _two("/", over, _two("^", right, _number(2, mark)))


def _of_power(formula: Binary, variable: str) -> Side | None:
    """n u^(n - 1) u'."""
    inner = slope(formula.left, variable)
    if inner is None or _holds(formula.right, variable):
        return None
    lower = _two("-", formula.right, _number(1, formula.mark))
    if isinstance(formula.right, Number):
        lower = Number(formula.right.value - 1, None, 1, formula.mark)
    return _two("*", _two("*", formula.right, _two("^", formula.left, lower)), inner)


def _of_function(formula: Function, variable: str) -> Side | None:
    argument, mark = formula.argument, formula.mark
    inner = slope(argument, variable)
    one = _number(1, mark)

    def of(name: str) -> Side:
        return Function(name, argument, None, mark)

    outer: dict[str, Side] = {
        "sin": of("cos"),
        "cos": Negate(of("sin"), mark),
        "tan": _two("/", one, _two("^", of("cos"), _number(2, mark))),
        "sqrt": _two("/", one, _two("*", _number(2, mark), of("sqrt"))),
        "exp": of("exp"),
        "log": _two("/", one, argument),
        "atan": _two("/", one, _two("+", one, _two("^", argument, _number(2, mark)))),
    }
    return None if inner is None or formula.name not in outer else _two("*", outer[formula.name], inner)


def put_in(side: Side, variable: str, value: Side) -> Side:
    """The formula with something else for its variable."""
    return changed(side, lambda s: value if isinstance(s, Name) and s.name == variable and s.at is None else None)


def _holds(side: Side, variable: str) -> bool:
    return any(isinstance(node, Name) and node.name == variable for node in walk(side))


def _two(operator: str, left: Side, right: Side) -> Side:
    """Two sides joined, without what changes nothing."""
    first, second = (s.value if isinstance(s, Number) and s.unit is None else None for s in (left, right))
    match operator:
        case "+" if first == 0:
            return right
        case "+" | "-" if second == 0:
            return left
        case "*" if first == 0 or second == 1:
            return left
        case "*" if second == 0 or first == 1:
            return right
        case "^" if second == 1:
            return left
    return Binary(operator, left, right, left.mark)


def _number(value: int, mark: Mark) -> Number:
    return Number(Fraction(value), None, 1, mark)
