"""Numbers that vary, as a graph of operations: what the fast model of a scene is written in before it becomes code.

A term knows its value in the reference configuration (as drawn, at t = 0), so that signs and zeros are decided there,
and it can be differentiated and written out as straight-line Python. Terms with the same operation and operands are one
object, which is all the common subexpression elimination that is needed. SymPy is not used here.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from operator import attrgetter

from planar_cli.motion.terms.functions import EXACT, FUNCTIONS, Table, Turning, own_size, real_power, safely, summed
from planar_cli.records import changing

ROUNDING = 1e-11
"""A value below this part of the size of what it was made of is zero."""

Number = int | float


class Term:
    """One number. Terms are made by a `Graph` and by arithmetic with other terms and plain numbers."""

    __slots__ = ("args", "bare", "constant", "graph", "index", "op", "size", "value")

    graph: Graph
    """To which it belongs."""
    op: str
    """`number`, `variable`, `+`, `*`, `/`, `**`, `atan2` ..., a function of FUNCTIONS, or a table's name."""
    args: tuple[Term, ...]
    """Its operands."""
    value: float
    """Its value in the reference configuration; nan where it has none there."""
    size: float
    """The size of the largest parts that it was made of, in the reference configuration: the scale of its rounding."""
    index: int
    """Terms are numbered as they are made: operands come first."""
    constant: bool
    """Is it a plain number?"""
    bare: Term | None
    """The same without the minus sign before it; None: it has none."""

    def __add__(self, other: Term | Number) -> Term:
        return self.graph.add(self, self.graph.of(other))

    __radd__ = __add__

    def __neg__(self) -> Term:
        return self.bare or self.graph.multiply(self.graph.number(-1.0), self)

    def __sub__(self, other: Term | Number) -> Term:
        return self.graph.add(self, -self.graph.of(other))

    def __rsub__(self, other: Term | Number) -> Term:
        return self.graph.add(self.graph.of(other), -self)

    def __mul__(self, other: Term | Number) -> Term:
        return self.graph.multiply(self, self.graph.of(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Term | Number) -> Term:
        return self.graph.divide(self, self.graph.of(other))

    def __rtruediv__(self, other: Term | Number) -> Term:
        return self.graph.divide(self.graph.of(other), self)

    def __pow__(self, exponent: Term | Number) -> Term:
        return self.graph.power(self, self.graph.of(exponent))

    def __rpow__(self, base: Term | Number) -> Term:
        return self.graph.power(self.graph.of(base), self)

    @property
    def zero(self) -> bool:
        """Is it zero in the reference configuration, to rounding?"""
        return abs(self.value) <= ROUNDING * self.size

    @property
    def positive(self) -> int:
        """Its sign in the reference configuration: -1, 0 or 1."""
        return 0 if self.zero else (1 if self.value > 0 else -1)

    def __repr__(self) -> str:
        return f"<{self.op} {self.value:.6g}>" if self.op != "variable" else f"<{self.graph.names[self]}>"


@changing
class Graph:
    """All terms of one scene."""

    names: dict[Term, str] = field(default_factory=dict)
    """Variables, by name in the code."""
    tables: dict[str, Table] = field(default_factory=dict)
    """Functions given by a table, by the name that they have in the code."""
    turnings: dict[str, Turning] = field(default_factory=dict)
    """Angles that go on over many turns, by the name that they have in the code."""
    turned: dict[str, Term] = field(default_factory=dict)
    """The same as terms."""
    others: dict[str, Callable[..., float]] = field(default_factory=dict)
    """Functions of one scene, without a derivative unless `slopes` tells it, by the name that they have in the code."""
    slopes: dict[str, Callable[[Term], Term]] = field(default_factory=dict)
    """Derivatives of some of these, of one argument."""
    _known: dict[tuple[object, ...], Term] = field(default_factory=dict)
    _numbers: dict[float, Term] = field(default_factory=dict)
    _count: int = 0

    def of(self, number: Term | Number) -> Term:
        """A term as it is; a plain number as a term."""
        return number if isinstance(number, Term) else self.number(float(number))

    def number(self, value: float) -> Term:
        """A constant."""
        value += 0.0
        return self._numbers.get(value) or self._made(("number", value), "number", (), value, abs(value))

    def variable(self, name: str, value: float, size: float = 0.0) -> Term:
        """A new variable with its value in the reference configuration, on the scale `size`."""
        found = self._made(("variable", name), "variable", (), value, max(abs(value), size))
        self.names[found] = name
        return found

    def add(self, a: Term, b: Term) -> Term:
        """a + b."""
        if a.constant:
            if b.constant:
                return self.number(summed(a.value, b.value))
            a, b = b, a
        if b.constant:
            if b.value == 0:
                return a
            if a.op == "+" and a.args[0].constant:
                return self.add(a.args[1], self.number(summed(a.args[0].value, b.value)))
            key = ("+", b.index, a.index)
            return self._known.get(key) or self._made(key, "+", (b, a), a.value + b.value, max(a.size, b.size))
        left = _cancelled(a, b) or _cancelled(b, a)
        if left is not None:
            return left
        a, b = (b, a) if b.index < a.index else (a, b)
        key = ("+", a.index, b.index)
        return self._known.get(key) or self._made(key, "+", (a, b), a.value + b.value, max(a.size, b.size))

    def multiply(self, a: Term, b: Term) -> Term:
        """a b; a number comes first and goes into a number already there."""
        if b.constant or (b.index < a.index and not a.constant):
            a, b = b, a
        if a.constant:
            if b.constant:
                return self.number(a.value * b.value)
            if a.value == 0:
                return a
            if a.value == 1:
                return b
            one, other = b.args if b.op == "*" else (b, b)
            if one.constant:
                return self.multiply(self.number(a.value * one.value), other)
            if one.op == "variable" and one is not other and a.value != -1.0:
                # A length goes to its direction, which others need too, and not to a rate.
                return self.multiply(one, self.multiply(a, other))
        elif a.bare is not None or b.bare is not None:
            # A minus sign goes outward, where a sum takes it in.
            product = self.multiply(a.bare or a, b.bare or b)
            return product if a.bare is not None and b.bare is not None else -product
        elif b.op == "*" and a in b.args and b.args[0] is not b.args[1] and not b.args[0].constant:
            # Squares of rates are shared by all that turns with them.
            return self.multiply(self.multiply(a, a), b.args[1] if b.args[0] is a else b.args[0])
        key = ("*", a.index, b.index)
        return self._known.get(key) or self._made(key, "*", (a, b), a.value * b.value, a.size * b.size)

    def divide(self, a: Term, b: Term) -> Term:
        """a / b."""
        if b.constant and b.value:
            return self.multiply(self.number(1.0 / b.value), a)
        if a.constant and a.value == 0:
            return a
        if a is b:
            return self.number(1.0)
        if a.bare is not None or b.bare is not None:
            quotient = self.divide(a.bare or a, b.bare or b)
            return quotient if a.bare is not None and b.bare is not None else -quotient
        value = a.value / b.value if b.value else math.nan
        size = a.size / abs(b.value) if b.value else math.inf
        return self._made(("/", a.index, b.index), "/", (a, b), value, size)

    def power(self, a: Term, b: Term) -> Term:
        """a to the power b; small whole powers are products."""
        if a.constant and b.constant:
            return self.number(safely(real_power, a.value, b.value))
        if b.constant and b.value in (0.0, 0.5, 1.0, 2.0, 3.0, -1.0):
            match b.value:
                case 0.0:
                    return self.number(1.0)
                case 0.5:
                    return self.call("sqrt", a)
                case 1.0:
                    return a
                case 2.0:
                    return self.multiply(a, a)
                case 3.0:
                    return self.multiply(a, self.multiply(a, a))
                case _:
                    return self.divide(self.number(1.0), a)
        value = safely(real_power, a.value, b.value)
        return self._made(("**", a.index, b.index), "**", (a, b), value, abs(value))

    def call(self, name: str, *args: Term) -> Term:
        """A function of FUNCTIONS, of a table, or a turning."""
        function = self.function(name)
        value = safely(function, *(a.value for a in args))
        if all(a.constant for a in args) and not math.isnan(value):
            # A right angle in degrees is not quite one in radians.
            return self.number(0.0 if name in ("sin", "cos") and abs(value) <= EXACT * abs(args[0].value) else value)
        size = max(abs(value), own_size(name, *(a.size for a in args)))
        return self._made((name, *(a.index for a in args)), name, args, value, size)

    def table(self, points: Iterable[tuple[float, float]]) -> str:
        """A function that is given by values, straight in between; returns its name for `call`."""
        name = f"table{len(self.tables) // 2}"
        self.tables[name] = Table(tuple(points))
        self.tables[f"{name}_slope"] = self.tables[name].slopes()
        return name

    def turning(self, y: Term, x: Term, drawn: float | None = None, time: Term | None = None, near: float = 0) -> Term:
        """The direction of (x, y) as an angle that goes on over many turns, counted from the angle `drawn`; left out,
        from the reference configuration, where it is within half a turn of `near`. `time`: of one in no equation of
        motion, which a step may turn far.
        """
        name, start = f"turn{len(self.turnings)}", Turning(near, near).at(y.value, x.value)
        self.turnings[name] = Turning(start, start)
        self.turned[name] = self.call(name, y, x, *(() if time is None else (time,)))
        return self.turned[name] - (start if drawn is None else drawn)

    def function(self, name: str) -> Callable[..., float]:
        """What a call of this name computes."""
        if name in FUNCTIONS:
            return FUNCTIONS[name]
        if name in self.turnings:
            return self.turnings[name].at
        return self.others[name] if name in self.others else self.tables[name].at

    # --- derivatives -------------------------------------------------------------------------------------------------

    def gradient(self, term: Term) -> dict[Term, Term]:
        """∂term/∂variable for every variable in it."""
        weights, found = {term: self.number(1.0)}, dict[Term, Term]()
        for t in reversed(ordered([term])):
            weight = weights.pop(t, None)
            if weight is None or (weight.constant and weight.value == 0):
                continue
            if t.op == "variable":
                found[t] = weight
                continue
            for arg, slope in zip(t.args, self._slopes(t), strict=True):
                if not arg.constant:
                    share = self.multiply(weight, slope)
                    weights[arg] = self.add(weights[arg], share) if arg in weights else share
        return found

    def rate(self, term: Term, rates: Mapping[Term, Term]) -> Term:
        """The time derivative, with those of the variables (left out: 0)."""
        return self.rates([term], rates)[0]

    def rates(self, terms: Sequence[Term], rates: Mapping[Term, Term]) -> list[Term]:
        """The time derivatives of many terms, with those of the variables (left out: 0)."""
        zero, found = self.number(0.0), dict[Term, Term]()
        for t in ordered(terms):
            if t.op == "variable":
                found[t] = rates.get(t, zero)
                continue
            total = zero
            if any(found[a] is not zero for a in t.args):
                for arg, slope in zip(t.args, self._slopes(t), strict=True):
                    if found[arg] is not zero:
                        total = self.add(total, self.multiply(slope, found[arg]))
            found[t] = total
        return [found[t] for t in terms]

    def _slopes(self, t: Term) -> tuple[Term, ...]:
        """∂t/∂arg for each of its operands."""
        one = self.number(1.0)
        match t.op, t.args:
            case "number" | "variable", _:
                return ()
            case "+", _:
                return one, one
            case "*", (a, b):
                return b, a
            case "/", (a, b):
                return one / b, -t / b
            case "**", (a, b):
                slope = self.power(a, b - one) * b
                return slope, self.number(0.0) if b.constant else t * self.call("log", a)
            case name, (y, x, *rest) if name == "atan2" or name in self.turnings:
                square = x * x + y * y
                return x / square, -y / square, *(self.number(0.0) for _ in rest)
            case name, (a,):
                return (self._slope(name, a, t),)
        raise TypeError(t.op)

    def _slope(self, name: str, a: Term, t: Term) -> Term:
        """The derivative of a function of one argument; t is its value."""
        one = self.number(1.0)
        if name in self.slopes:
            return self.slopes[name](a)
        match name:
            case "sqrt":
                return self.number(0.5) / t
            case "sin":
                return self.call("cos", a)
            case "cos":
                return -self.call("sin", a)
            case "tan":
                return one + t * t
            case "asin":
                return one / self.call("sqrt", one - a * a)
            case "acos":
                return -one / self.call("sqrt", one - a * a)
            case "atan":
                return one / (one + a * a)
            case "exp":
                return t
            case "log":
                return one / a
            case "abs":
                return self.call("sign", a)
            case "sign" | "step":
                return self.number(0.0)
        return self.number(0.0) if name.endswith("_slope") else self.call(f"{name}_slope", a)

    def _made(self, key: tuple[object, ...], op: str, args: tuple[Term, ...], value: float, size: float) -> Term:
        """The term of this key."""
        found = self._known.get(key)
        if found is None:
            found = Term()
            found.graph, found.op, found.args, found.value, found.size = self, op, args, value, size
            found.index = self._count
            found.constant = op == "number"
            found.bare = args[1] if op == "*" and args[0].constant and args[0].value == -1.0 else None
            self._count += 1
            self._known[key] = found
            if found.constant:
                self._numbers[value] = found
        return found


def ordered(terms: Iterable[Term]) -> list[Term]:
    """The terms and all that they are made of, operands first."""
    seen: set[Term] = set()
    waiting = list(terms)
    while waiting:
        term = waiting.pop()
        if term not in seen:
            seen.add(term)
            waiting.extend(a for a in term.args if a not in seen)
    return sorted(seen, key=attrgetter("index"))


def evaluate(terms: Iterable[Term], values: Mapping[Term, float]) -> list[float]:
    """The terms at other values of the variables than those of the reference configuration (left out: as there)."""
    wanted = list(terms)
    found: dict[Term, float] = {}
    for t in ordered(wanted):
        args = [found[a] for a in t.args]
        match t.op:
            case "number":
                found[t] = t.value
            case "variable":
                found[t] = values.get(t, t.value)
            case "+":
                found[t] = args[0] + args[1]
            case "*":
                found[t] = args[0] * args[1]
            case "/":
                found[t] = args[0] / args[1]
            case "**":
                found[t] = real_power(args[0], args[1])
            case _:
                found[t] = t.graph.function(t.op)(*args)
    return [found[t] for t in wanted]


def _cancelled(a: Term, b: Term) -> Term | None:
    """a + b where b takes away a, or one of the two parts of a; None: it does not."""
    if _opposite(a, b):
        return a.graph.number(0.0)
    if a.op == "+":
        one, other = a.args
        if _opposite(one, b):
            return other
        if _opposite(other, b):
            return one
    return None


def _opposite(a: Term, b: Term) -> bool:
    """Is one the other with a minus sign before it?"""
    return a.bare is b or b.bare is a
