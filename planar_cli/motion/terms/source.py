"""Terms as straight-line Python: one function of the time and the state, without loops, calls or look-ups.

What is used once is written where it is used; what is used more often gets a name of its own, so that every operation
of the graph is done once. Constants are written as they are.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType

from planar_cli.errors import PlanarError
from planar_cli.motion.terms.functions import real_power
from planar_cli.motion.terms.terms import Term, ordered
from planar_cli.records import record

DEEPEST = 24
"""So many operations are nested into each other at most: Python's own parser ends at some hundred."""
SUM, PRODUCT, ATOM = 1, 2, 4
"""How tightly an expression binds."""

Function = Callable[[float, Sequence[float]], list[float]]
"""f(t, y)."""


NOTHING: Mapping[Term, Term] = MappingProxyType({})


class Singular(PlanarError):
    """A pivot is too small at this configuration: the pivot order does not serve here."""


@record
class Check:
    """A number that must stay away from zero: a pivot."""

    term: Term
    least: float
    """Its size must be at least this much, in its own unit."""


@record
class Code:
    """A generated function."""

    function: Function
    text: str
    """The Python source."""
    operations: int
    """Sums, products, quotients, powers and function calls in one evaluation."""


def compiled(
    outputs: Sequence[Term],
    inputs: Sequence[Term],
    time: Term | None = None,
    checks: Iterable[Check] = (),
    given: Mapping[Term, Term] = NOTHING,
) -> Code:
    """The function f(t, y) that returns the outputs as a list; y holds the inputs in their order.

    It raises `Singular` where a check fails. Every variable in the outputs must be an input, the time, or one of
    `given`: variables that are computed first, each from inputs and the time.
    """
    return _Writer(outputs, inputs, time, {c.term: c.least for c in checks}, given).code()


class _Writer:
    """The text of one function, as it grows."""

    def __init__(
        self,
        outputs: Sequence[Term],
        inputs: Sequence[Term],
        time: Term | None,
        checks: dict[Term, float],
        given: Mapping[Term, Term],
    ) -> None:
        self.outputs, self.inputs, self.checks, self.given = outputs, inputs, checks, given
        self.order = ordered([*outputs, *checks])
        if given:
            first = ordered([given[t] for t in self.order if t in given])
            known = set(first)
            self.order = [*first, *(t for t in self.order if t not in known)]
        self.text: dict[Term, str] = {}
        self.binds: dict[Term, int] = {}
        self.depth: dict[Term, int] = {}
        self.operations = 0
        self.lines: list[str] = []
        self.functions: dict[str, Callable[..., float]] = {}
        for i, v in enumerate(inputs):
            self._atom(v, f"y{i}")
        if time is not None:
            self._atom(time, "t")

    def code(self) -> Code:
        """Write all lines and compile them."""
        uses = self._uses()
        for term in self.text:
            self._check(term)
        for term in self.order:
            if term in self.text:
                continue
            if term in self.given:
                self._same(term, self.given[term])
                continue
            if term.op == "number":
                self._atom(term, repr(term.value))
                if term.value < 0:
                    self.binds[term] = SUM
                continue
            self._write(term)
            if uses[term] != 1 or self.depth[term] >= DEEPEST or term in self.checks:
                self._name(term)
        results = ", ".join(self.text[t] for t in self.outputs)
        head = ["def f(t, y):"]
        used = set(self.order)
        if any(v in used for v in self.inputs):
            names = ", ".join(f"y{i}" for i in range(len(self.inputs)))
            head.append(f" {names}, = y")
        text = "\n".join([*head, *self.lines, f" return [{results}]"]) + "\n"
        space: dict[str, object] = {"Singular": Singular, "inf": math.inf, "nan": math.nan, **self.functions}
        exec(compile(text, "<model>", "exec"), space)
        function = space["f"]
        assert callable(function)
        return Code(function, text, self.operations)

    def _uses(self) -> dict[Term, int]:
        uses, given = dict.fromkeys(self.order, 0), self.given
        for term in self.order:
            for arg in term.args:
                uses[given.get(arg, arg)] += 1
        for term in self.outputs:
            uses[given.get(term, term)] += 1
        return uses

    def _same(self, term: Term, other: Term) -> None:
        """A term that is written like another."""
        self.text[term], self.binds[term], self.depth[term] = self.text[other], self.binds[other], self.depth[other]

    def _atom(self, term: Term, text: str) -> None:
        self.text[term], self.binds[term], self.depth[term] = text, ATOM, 0

    def _name(self, term: Term) -> None:
        """Compute it on a line of its own."""
        name = f"a{len(self.lines)}"
        self.lines.append(f" {name} = {self.text[term]}")
        self._atom(term, name)
        self._check(term)

    def _check(self, term: Term) -> None:
        least = self.checks.get(term)
        if least is not None:
            self.lines.append(f" if {-least!r} < {self.text[term]} < {least!r}: raise Singular")

    def _write(self, term: Term) -> None:
        op, args = term.op, term.args
        if op == "variable":
            raise KeyError(term.graph.names[term])
        self.operations += 1
        depth, first = self.depth, self.depth[args[0]]
        last = depth[args[-1]]
        depth[term] = 1 + (max(last, first))
        if op == "+":
            self.text[term], self.binds[term] = self._sum(*args), SUM
        elif op == "*":
            a, b = args
            if a.constant and a.value < 0:
                factor = "" if a.value == -1.0 else f"{-a.value!r}*"
                self.text[term], self.binds[term] = f"-{factor}{self._as(b, ATOM if factor else PRODUCT)}", SUM
            else:
                self.text[term], self.binds[term] = f"{self._as(a, PRODUCT)}*{self._as(b, ATOM)}", PRODUCT
        elif op == "/":
            a, b = args
            self.text[term], self.binds[term] = f"{self._as(a, PRODUCT)}/{self._as(b, ATOM)}", PRODUCT
        elif op == "**" and args[1].constant and args[1].value.is_integer():
            a, b = args
            self.text[term], self.binds[term] = f"{self._as(a, ATOM)}**{self._as(b, ATOM)}", PRODUCT
        else:
            name = "real_power" if op == "**" else op
            self.functions[name] = real_power if op == "**" else term.graph.function(op)
            self.text[term] = f"{name}({', '.join(self.text[a] for a in args)})"
            self.binds[term] = ATOM

    def _sum(self, a: Term, b: Term) -> str:
        """a + b, written as a difference where one of them has a minus sign."""
        if self._minus(a) and not self._minus(b):
            a, b = b, a
        first, second = self._as(a, SUM), self._as(b, SUM)
        if second.startswith("-"):
            if self._negation(b):
                self.operations -= 1
            return f"{first} - {second[1:]}"
        return f"{first} + {self._as(b, PRODUCT)}"

    def _minus(self, term: Term) -> bool:
        return self.text[term].startswith("-")

    def _negation(self, term: Term) -> bool:
        """Is it written here as a minus sign before something?"""
        return self.binds[term] == SUM and term.op == "*" and term.args[0].value == -1.0

    def _as(self, term: Term, least: int) -> str:
        text = self.text[term]
        return text if self.binds[term] >= least else f"({text})"
