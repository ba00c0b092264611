"""Linear equations in letters that are solved together, row below row: where one letter product divides all of the
coefficients and another all that is known, the rows are plain numbers.

(11) to (15) with (1) to (10) put in, divided by m L².

row    α_OA   α_AB   α_BC   α_CD   α_DE   right side in g cos β / L
(11)   1/2    1/2    1/2    1/2    1/3    -1/2
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import trigonometric
from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, Table, line
from planar_cli.report.equations.results import numbered
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import SolvedBlock
from planar_cli.solve.instant.written import Written

LEAST, MOST = 4, 12
"""Of fewer equations it is told what each unknown is by the others; of more there is no room beside each other."""
DEEPEST = 3
"""Names stand for others not more often."""
LARGEST = 10_000
"""A plain number has no larger numerator or denominator."""
CLOSE = Decimal("1e-30")

Row = tuple[list[sp.Expr], sp.Expr]
"""The coefficients of the unknowns, and what is known on the other side."""


def letter_system(
    block: SolvedBlock,
    order: Sequence[sp.Symbol],
    named: Mapping[sp.Symbol, sp.Expr],
    numbers: Mapping[int, int],
    cited: Sequence[int],
    phrases: Phrases,
) -> list[Block]:
    """The rows of a system in letters, and what they give. `order`: its unknowns; `named`: what stands for others in
    its equations; `numbers`: the printed numbers of these, by their own; `cited`: of the lines that are put into them.
    Empty: the rows are no plain numbers.
    """
    if not LEAST <= len(order) <= MOST or any(w.law not in ("force", "moment") for w in block.equations):
        return []
    written = sorted(block.equations, key=lambda w: numbers[w.number])
    rows = [_row(w, order, named) for w in written]
    left, right = _common(c for own, _ in rows for c in own), _common(known for _, known in rows)
    if left is None or right is None:
        return []
    table = [[sp.cancel(c / left) for c in own] for own, _ in rows]
    sides = [sp.cancel(known / right) for _, known in rows]
    if not all(n.is_Rational and max(abs(n.p), n.q) <= LARGEST for own in (*table, sides) for n in own):
        return []
    matrix = sp.Matrix(table)
    if matrix.det() == 0:
        return []
    factor = right / left
    roots = {s: n * factor for s, n in zip(order, matrix.LUsolve(sp.Matrix(sides)), strict=True)}
    if not all(_agrees(phrases, s, root) for s, root in roots.items()):
        return []
    own = numbered([numbers[w.number] for w in written])
    lead = f"{own} with {numbered(cited)} put in" if cited else own
    head = (line("row"), *(line(Math(s)) for s in order), line("right side in ", phrases.math(factor)))
    body = [
        (line(f"({numbers[w.number]})"), *(line(Math(n)) for n in (*ratios, side)))
        for w, ratios, side in zip(written, table, sides, strict=True)
    ]
    told: list[Block] = [
        Paragraph(line(lead, ", divided by ", phrases.math(left), ".")),
        Table(head, tuple(body)),
    ]
    for i, (s, root) in enumerate(roots.items()):
        told.append(Equation((phrases.math(s), phrases.math(root)), None, () if i else line("together:")))
    return told


def _row(w: Written, order: Sequence[sp.Symbol], named: Mapping[sp.Symbol, sp.Expr]) -> Row:
    residual = sp.sympify(w.right - w.left)
    for _ in range(DEEPEST):
        residual = residual.xreplace({s: named[s] for s in residual.free_symbols if s in named})
    residual = expanded(residual)
    coefficients = [trigonometric(expanded(residual.diff(s))) for s in order]
    return coefficients, -trigonometric(expanded(residual.xreplace(dict.fromkeys(order, sp.S.Zero))))


def _common(terms: Iterable[sp.Expr]) -> sp.Expr | None:
    """The product of letters that each of some terms is, but for a number; None: there is no such one."""
    products = {term.as_coeff_Mul()[1] for term in terms if term != 0}
    return products.pop() if len(products) == 1 else None


def _agrees(phrases: Phrases, symbol: sp.Symbol, root: sp.Expr) -> bool:
    """Has an unknown this value with the numbers that are drawn for the letters?"""
    found, value = phrases.value.known(symbol), phrases.value(root)
    return found is not None and abs(found - value) <= CLOSE * max(abs(value), Decimal(1))
