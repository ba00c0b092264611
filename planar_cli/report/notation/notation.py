"""Formulas as text: one writer, two notations, Unicode plain text and LaTeX. SymPy's own printers are not used."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import Any

from planar_cli.report.notation import latex as tex
from planar_cli.report.notation.formula import (
    Bars,
    Call,
    Compared,
    Formula,
    Integration,
    Negative,
    Numeral,
    Pieces,
    Power,
    Product,
    Quotient,
    Root,
    Sum,
    Values,
    Variable,
    read,
)
from planar_cli.report.notation.names import latex_name, plain_name, printable
from planar_cli.report.notation.numbers import superscript
from planar_cli.report.notation.turned import turned

_BELOW_ZERO = re.compile(r"-[\d.]+(×10\S+)?°?")
_SIMPLE_NUMERAL = re.compile(r"[0-9.]+°?|[πe∞]")
_LATEX_FUNCTIONS = frozenset("sin cos tan cot sec csc arcsin arccos arctan sinh cosh tanh ln exp max min".split())


def plain(expr: Any, values: Values | None = None) -> str:
    """An expression in Unicode plain text; `values` are texts to print in place of symbols."""
    return _Plain().write(turned(read(expr, values)))


def latex(expr: Any, values: Values | None = None) -> str:
    """An expression in LaTeX mathematics, without dollar signs; `values` as in `plain`."""
    return _Latex().write(turned(read(expr, values)))


class _Writer(ABC):
    """What both notations share: signs, order, and where brackets are needed."""

    dot: str

    @abstractmethod
    def name(self, name: str) -> str: ...

    @abstractmethod
    def numeral(self, text: str) -> str: ...

    @abstractmethod
    def quotient(self, node: Quotient, leading: bool) -> str: ...

    @abstractmethod
    def power(self, base: str, exponent: Formula) -> str: ...

    @abstractmethod
    def root(self, inside: Formula) -> str: ...

    @abstractmethod
    def call(self, node: Call, bare: bool) -> str: ...

    @abstractmethod
    def brackets(self, text: str) -> str: ...

    @abstractmethod
    def bars(self, text: str) -> str: ...

    @abstractmethod
    def relation(self, relation: str) -> str: ...

    @abstractmethod
    def pieces(self, node: Pieces) -> str: ...

    @abstractmethod
    def integral(self, node: Integration) -> str: ...

    def integrand(self, node: Integration) -> str:
        """What stands before dx; one is left out."""
        if node.inside == Numeral("1"):
            return ""
        return self.factor(node.inside, True, ()) + " "

    @abstractmethod
    def is_self_contained(self, node: Quotient) -> bool:
        """True if a quotient can stand among factors without brackets."""

    def write(self, node: Formula) -> str:
        match node:
            case Numeral(text):
                return self.numeral(text)
            case Variable(name):
                return self.name(name)
            case Sum():
                return self.sum(node)
            case Product(factors):
                return self.product(factors, leading=True)
            case Quotient():
                return self.quotient(node, leading=True)
            case Power(base, exponent):
                return self.power(self.operand(base), exponent)
            case Call():
                return self.call(node, node.bare)
            case Negative() | Root() | Bars() | Compared() | Pieces() | Integration():
                return self._wrapped(node)

    def _wrapped(self, node: Negative | Root | Bars | Compared | Pieces | Integration) -> str:
        match node:
            case Integration():
                return self.integral(node)
            case Pieces():
                return self.pieces(node)
            case Negative(inside):
                return "-" + self.term(inside)
            case Root(inside):
                return self.root(inside)
            case Bars(inside):
                return self.bars(self.write(inside))
            case Compared(left, relation, right):
                return f"{self.write(left)} {self.relation(relation)} {self.write(right)}"

    def sum(self, node: Sum) -> str:
        (subtracted, first), *rest = node.terms
        plainly = not subtracted and not isinstance(first, Pieces)
        text = self.write(first) if plainly else ("-" if subtracted else "") + self.term(first)
        for subtracted, term in rest:
            # 9.81 - 1.2, not 9.81 + (-1.2).
            size = None if subtracted else _without_minus(term)
            text += (" - " if subtracted or size is not None else " + ") + self.term(term if size is None else size)
        return text

    def term(self, node: Formula) -> str:
        """A formula behind a sign: sums and further signs get brackets."""
        match node:
            case Sum() | Negative() | Compared() | Pieces():
                return self.brackets(self.write(node))
            case Integration():
                return self.write(node)
            case Numeral(text) if text.startswith("-"):
                return self.brackets(self.numeral(text))
            case Product(factors):
                return self.product(factors, leading=False)
            case Quotient():
                return self.quotient(node, leading=False)
        return self.write(node)

    def product(self, factors: tuple[Formula, ...], leading: bool) -> str:
        text = ""
        for place, factor in enumerate(factors):
            shown = self.factor(factor, opening=place == 0 and leading, follower=factors[place + 1 : place + 2])
            text += f"{self.between(text, shown)}{shown}" if text else shown
        return text

    def between(self, before: str, after: str) -> str:
        """Juxtaposition is a product, but two numbers in a row need a dot."""
        return self.dot if after[:1].isdigit() or (after.startswith(r"\frac{") and before[-1:].isdigit()) else " "

    def factor(self, node: Formula, opening: bool, follower: tuple[Formula, ...]) -> str:
        match node:
            case Sum() | Compared() | Negative() | Pieces() | Integration():
                return self.brackets(self.write(node))
            case Numeral(text) if (not opening and text.startswith("-")) or re.search(r"\S[ +/-]", text):
                return self.brackets(self.numeral(text))
            case Quotient() if not self.is_self_contained(node):
                return self.brackets(self.write(node))
            case Call(bare=True) if follower and not (isinstance(follower[0], Call) and follower[0].bare):
                return self.call(node, False)
        return self.write(node)

    def operand(self, node: Formula) -> str:
        """A formula as base of a power."""
        match node:
            case Variable() | Bars():
                return self.write(node)
            case Numeral(text) if _SIMPLE_NUMERAL.fullmatch(text):
                return self.write(node)
        return self.brackets(self.write(node))


def _without_minus(node: Formula) -> Formula | None:
    """A number below zero, or what begins with one as its factor, without its sign; None: it is none."""
    match node:
        case Numeral(text) if _BELOW_ZERO.fullmatch(text):
            return Numeral(text[1:])
        case Product((first, *others)) if (size := _without_minus(first)) is not None:
            return Product((size, *others))
        case Quotient(above, below) if (size := _without_minus(above)) is not None:
            return Quotient(size, below)
    return None


class _Plain(_Writer):
    dot = " · "

    def name(self, name: str) -> str:
        return plain_name(name)

    def numeral(self, text: str) -> str:
        return printable(text)

    def quotient(self, node: Quotient, leading: bool) -> str:
        above, below = self._above(node.above, leading), self._below(node.below)
        return f"{above} / {below}" if self._is_wide(node, above, below) else f"{above}/{below}"

    def _above(self, node: Formula, leading: bool) -> str:
        if isinstance(node, Sum | Quotient | Negative | Pieces):
            return self.brackets(self.write(node))
        return self.write(node) if leading else self.term(node)

    def _below(self, node: Formula) -> str:
        match node:
            case Sum() | Product() | Quotient() | Negative() | Pieces():
                return self.brackets(self.write(node))
            case Numeral(text) if not _SIMPLE_NUMERAL.fullmatch(text):
                return self.brackets(text)
        return self.write(node)

    def _is_wide(self, node: Quotient, above: str, below: str) -> bool:
        """Spaces about the stroke where either part is long enough to be misread."""
        products = isinstance(node.above, Product) or isinstance(node.below, Product)
        last = node.above.factors[-1] if isinstance(node.above, Product) else node.above
        busy = any(sign in above + below for sign in (" + ", " - ", " · "))
        return (products and busy) or (isinstance(last, Call) and last.bare)

    def power(self, base: str, exponent: Formula) -> str:
        if isinstance(exponent, Numeral) and exponent.text.isdigit():
            return base + superscript(exponent.text)
        text = self.write(exponent)
        return f"{base}^{text}" if isinstance(exponent, Variable) else f"{base}^{self.brackets(text)}"

    def root(self, inside: Formula) -> str:
        text = self.write(inside)
        simple = isinstance(inside, Variable) or (isinstance(inside, Numeral) and _SIMPLE_NUMERAL.fullmatch(text))
        return "√" + text if simple else "√" + self.brackets(text)

    def call(self, node: Call, bare: bool) -> str:
        function = node.function + (superscript(str(node.exponent)) if node.exponent != 1 else "")
        arguments = ", ".join(self.write(a) for a in node.arguments)
        return f"{function} {arguments}" if bare else f"{function}{self.brackets(arguments)}"

    def brackets(self, text: str) -> str:
        return f"({text})"

    def bars(self, text: str) -> str:
        return f"|{text}|"

    def relation(self, relation: str) -> str:
        return relation

    def pieces(self, node: Pieces) -> str:
        return "; ".join(f"{self.write(e)} {c}" for (e, _), c in zip(node.pieces, self.when(node), strict=True))

    def when(self, node: Pieces) -> Iterator[str]:
        """The condition of each piece; of x < a; x < b; else the ranges x < a, a < x < b, x > b."""
        before: Compared | None = None
        for _, condition in node.pieces:
            now = condition if isinstance(condition, Compared) and condition.relation in "<≤" else None
            if condition is None:
                yield "else" if before is None else f"for {self.write(before.left)} > {self.write(before.right)}"
            elif now is None or before is None or before.left != now.left:
                yield f"for {self.write(condition)}"
            else:
                yield f"for {self.write(before.right)} < {self.write(now)}"
            before = now

    def integral(self, node: Integration) -> str:
        bounds = f"{self.write(node.lower)} → {self.write(node.upper)}"
        return f"∫[{bounds}] {self.integrand(node)}d{self.write(node.variable)}"

    def is_self_contained(self, node: Quotient) -> bool:
        return not isinstance(node.above, Sum | Negative) and isinstance(node.below, Numeral)


class _Latex(_Writer):
    dot = r" \cdot "

    def name(self, name: str) -> str:
        return latex_name(name)

    def numeral(self, text: str) -> str:
        number, _, unit = text.partition(" ")
        return tex.numeral(number) + rf"~\mathrm{{{tex.numeral(unit)}}}" if unit[:1].isalpha() else tex.numeral(text)

    def quotient(self, node: Quotient, leading: bool) -> str:
        return rf"\frac{{{self.write(node.above)}}}{{{self.write(node.below)}}}"

    def power(self, base: str, exponent: Formula) -> str:
        return f"{base}^{{{self.write(exponent)}}}"

    def root(self, inside: Formula) -> str:
        return rf"\sqrt{{{self.write(inside)}}}"

    def call(self, node: Call, bare: bool) -> str:
        name = (
            "\\" + node.function
            if node.function in _LATEX_FUNCTIONS
            else rf"\operatorname{{{tex.numeral(node.function)}}}"
        )
        function = name + (f"^{{{node.exponent}}}" if node.exponent != 1 else "")
        arguments = ", ".join(self.write(a) for a in node.arguments)
        return f"{function} {arguments}" if bare else f"{function}{self.brackets(arguments)}"

    def brackets(self, text: str) -> str:
        return rf"\left({text}\right)" if r"\frac" in text or r"\sqrt" in text else f"({text})"

    def bars(self, text: str) -> str:
        # Bars would close the cell of a table in Markdown.
        return rf"\left\lvert {text} \right\rvert" if r"\frac" in text else rf"\lvert {text} \rvert"

    def relation(self, relation: str) -> str:
        return tex.relation(relation)

    def pieces(self, node: Pieces) -> str:
        rows = (f"{self.write(e)} & {tex.words('else') if c is None else self.write(c)}" for e, c in node.pieces)
        return r"\begin{cases} " + r" \\ ".join(rows) + r" \end{cases}"

    def integral(self, node: Integration) -> str:
        bounds = rf"_{{{self.write(node.lower)}}}^{{{self.write(node.upper)}}}"
        return rf"\int{bounds} {self.integrand(node)}\, d{self.write(node.variable)}"

    def is_self_contained(self, node: Quotient) -> bool:
        return True
