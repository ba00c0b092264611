"""The plan carried out: every block solved, line by line, in symbols and in sixty-digit numbers at once.

The lines of the elimination are the lines of the solution. Each result is a formula in names (knowns, earlier results)
and a number; closed formulas are put together from them at the end, where they are asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import longer, tidy
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.records import record
from planar_cli.solve.instant.led import OF_LENGTH
from planar_cli.solve.instant.outright import Outright, outright
from planar_cli.solve.instant.pivots import easiest
from planar_cli.solve.instant.plan import Block
from planar_cli.solve.instant.written import Written

NAMED = 24
"""A longer coefficient gets a name where several letters are carried."""
FEW_LETTERS = 5
"""With so few letters the exact coefficients of a block stay short enough to be written out."""
MOST_FORMULAS = 3
"""So many numeric equations at most are solved together in formulas; more of them in numbers."""
SHORT, LONGER = 6, 14
"""A coefficient of at most so many operations stays a formula while a block is solved; where there is one letter."""
FAINT = Decimal("1e-30")
"""A smaller result may be what is left of terms that cancel."""


@record
class Line:
    """One line of step 3: `symbol` = `formula` = `value`, from equations of these numbers.

    `letters`: unknowns that the formula still carries.
    """

    symbol: sp.Symbol
    formula: sp.Expr
    value: Decimal | None
    equations: tuple[int, ...]
    letters: tuple[sp.Symbol, ...] = ()


@record
class SolvedBlock:
    """One block with its lines."""

    equations: tuple[Written, ...]
    unknowns: tuple[sp.Symbol, ...]
    letters: tuple[sp.Symbol, ...]
    lines: tuple[Line, ...]


class Algebra:
    """Solves blocks one after the other. `value`: numbers of everything known, extended as results come in.

    `fresh`: makes symbols for long coefficients that several letters share, lest formulas grow beyond any page.
    `places`: the positions of states, in which nothing that is divided by should vanish.
    """

    def __init__(
        self,
        value: Valuation,
        explicit: dict[sp.Symbol, sp.Expr],
        symbolic: bool,
        unknowns: frozenset[sp.Symbol],
        fresh: Callable[[str], sp.Symbol] | None = None,
        places: Callable[[], Sequence[Valuation]] = tuple,
    ) -> None:
        self.value, self.explicit, self.symbolic, self.unknowns = value, explicit, symbolic, unknowns
        self.fresh, self.places = fresh, places
        self.named: dict[sp.Expr, sp.Symbol] = {}
        self.formulas: dict[sp.Symbol, sp.Expr] = {}

    def solve(self, block: Block, written: tuple[Written, ...], unknowns: tuple[sp.Symbol, ...]) -> SolvedBlock:
        """Solve one block whose unknowns all enter linearly."""
        order = tuple(unknowns[j] for j in block.unknowns)
        letters = tuple(unknowns[j] for j in block.letters)
        if len(order) == 1:
            lines = [self._single(written[0], order[0])]
        else:
            residuals = [self.in_unknowns(w, order) for w in written]
            last = [i for i, w in enumerate(written) if w.words == OF_LENGTH]
            easy = easiest(residuals, order, letters, self._vanishes_at_a_state, last)
            written, order, letters = tuple(written[i] for i in easy.equations), easy.unknowns, easy.letters
            residuals = [residuals[i] for i in easy.equations]
            told = outright(residuals, order, self.value, self._solve_for) if len(letters) == 1 else None
            if told is not None:
                lines, letters = self._outright(told, residuals, written), ()
            else:
                try:
                    lines = self._together(residuals, written, order, letters)
                except Unvalued:
                    # An unknown stands in an equation in which it cancels, as the α of another body may about a pin.
                    residuals = [self._without_cancelled(r, order) for r in residuals]
                    lines = self._together(residuals, written, order, letters)
        for line in lines:
            if not line.letters:
                self.value = (
                    self.value.extended({line.symbol: self.value(line.formula)})
                    if line.value is None
                    else self.value.extended({line.symbol: line.value})
                )
                self.formulas[line.symbol] = line.formula
        return SolvedBlock(written, order, letters, tuple(lines))

    def _outright(self, told: Outright, residuals: list[sp.Expr], written: tuple[Written, ...]) -> list[Line]:
        """The line of what some equations tell together, and those of what follows from it."""
        numbers = tuple(written[p].number for p in told.places)
        found = [Line(told.unknown, told.formula, self._number(told.formula), numbers)]
        known = self.value.extended({told.unknown: found[0].value or Decimal(0)})
        for x, place in told.others:
            formula = self._solve_for(residuals[place], x)
            found.append(Line(x, formula, known(formula), (written[place].number,)))
            known = known.extended({x: found[-1].value or Decimal(0)})
        return found

    def _vanishes_at_a_state(self, factor: sp.Expr) -> bool:
        return any(place.vanishes(factor) for place in self.places())

    def in_unknowns(self, equation: Written, unknowns: tuple[sp.Symbol, ...]) -> sp.Expr:
        """Left minus right side; explicit lines and named intermediates are put in where they hold an unknown of the
        block, else they have values.
        """
        residual = equation.residual
        inside = {}
        for symbol in residual.free_symbols:
            line = self.explicit.get(symbol)
            if line is None:
                continue
            if (line.free_symbols & self.unknowns) - set(self.value.values):
                inside[symbol] = line
            elif symbol not in self.value.values:
                self.value = self.value.extended({symbol: self.value(line)})
        return self._opened(self._without_idle(residual.xreplace(inside), unknowns), unknowns)

    def _without_idle(self, residual: sp.Expr, unknowns: tuple[sp.Symbol, ...]) -> sp.Expr:
        """Unknowns of later blocks whose coefficients cancel are left out."""
        idle = self.unknowns & residual.free_symbols - set(unknowns) - set(self.value.values)
        if not idle:
            return residual
        for x in idle:
            try:
                residual = linear_form(residual, {x}).constant
            except Nonlinear:
                continue
        return residual

    def _without_cancelled(self, residual: sp.Expr, unknowns: tuple[sp.Symbol, ...]) -> sp.Expr:
        """Unknowns of the block whose coefficients vanish are left out."""
        form = linear_form(residual, set(unknowns))
        return sp.Add(form.constant, *(c * x for x, c in form.terms.items() if self._counts(c)))

    def _opened(self, residual: sp.Expr, unknowns: tuple[sp.Symbol, ...]) -> sp.Expr:
        """Named intermediates that hold an unknown of the block are put in."""
        definitions = self.value.definitions
        while inside := {s: definitions[s] for s in residual.free_symbols if holds(definitions, s, set(unknowns))}:
            residual = residual.xreplace(inside)
        return residual

    def _solve_for(self, residual: sp.Expr, x: sp.Symbol) -> sp.Expr:
        form = linear_form(residual, {x})
        constant = form.constant
        if constant.is_Add:
            constant = sp.Add(*(a for a in constant.args if self._counts(a)))
        return tidy(-constant / tidy(form.terms[x]))

    def _counts(self, term: sp.Expr) -> bool:
        try:
            return not self.value.is_zero(term)
        except Unvalued:
            return True

    def _number(self, formula: sp.Expr) -> Decimal:
        """The value of a result, zero where it is that to all certain digits."""
        value = self.value(formula)
        return Decimal(0) if value and abs(value) < FAINT and self.value.is_zero(formula) else value

    def _single(self, equation: Written, x: sp.Symbol) -> Line:
        formula = self._solve_for(self.in_unknowns(equation, (x,)), x)
        try:
            return Line(x, formula, self._number(formula), (equation.number,))
        except Unvalued:
            # What is told later stands in it, and drops out: the masses of two parts may, of which the sum does not
            # change with where they are parted.
            formula = cancelled(self._opened(formula, tuple(self.unknowns - self.value.values.keys())))
            return Line(x, formula, self._number(formula), (equation.number,))

    def _collected(self, residual: sp.Expr, order: tuple[sp.Symbol, ...]) -> sp.Expr:
        """The residual with moments of inertia and other named intermediates put in, collected in unknowns."""
        definitions = self.value.definitions
        for _ in range(20):
            inside = {s: e for s in residual.free_symbols if (e := definitions.get(s)) is not None and e.free_symbols}
            if not inside:
                break
            residual = residual.xreplace(inside)
        form = linear_form(residual, set(order))
        return sp.Add(factored(form.constant), *(factored(c) * x for x, c in form.terms.items()))

    def _letters_of(self, exprs: list[sp.Expr]) -> set[sp.Symbol]:
        """The letters in which coefficients are written."""
        return set().union(*(e.free_symbols for e in exprs)) - self.unknowns

    def _together(
        self,
        residuals: list[sp.Expr],
        written: tuple[Written, ...],
        order: tuple[sp.Symbol, ...],
        letters: tuple[sp.Symbol, ...],
    ) -> list[Line]:
        """Express the unknowns in the letters one at a time; the equations left over give the letters."""
        if self.symbolic and self.fresh is not None and len(letters) > 1:
            opened = [self._collected(r, order) for r in residuals]
            if len(self._letters_of(opened)) <= FEW_LETTERS:
                residuals = opened
            else:
                return self._by_names(residuals, written, order, letters)
        lines: list[Line] = []
        inside: dict[sp.Symbol, sp.Expr] = {}
        own: dict[sp.Symbol, sp.Expr] = {}
        chained = order[: len(order) - len(letters)]
        for residual, equation, x in zip(residuals, written, chained, strict=False):
            formula = self._in_letters(self._solve_for(residual.xreplace(inside), x), letters)
            own[x] = self._solve_for(residual, x) if residual.free_symbols & inside.keys() else formula
            inside[x] = formula
            lines.append(
                Line(x, formula, None, (equation.number,), tuple(s for s in letters if s in formula.free_symbols))
            )
        rest = [self._in_letters(r.xreplace(inside), letters) for r in residuals[len(chained) :]]
        solved = self._letters(rest, letters)
        numbers = tuple(e.number for e in written[len(chained) :])
        found = [Line(s, solved[s], self._number(solved[s]), numbers) for s in letters]
        self.value = self.value.extended({x.symbol: x.value for x in found if x.value is not None})
        back = []
        for x in lines:
            number = self._number(x.formula)
            self.value = self.value.extended({x.symbol: number})
            back.append(Line(x.symbol, own[x.symbol], number, x.equations))
        return [*[x for x in lines if x.letters], *found, *back]

    def _in_letters(self, expr: sp.Expr, letters: tuple[sp.Symbol, ...]) -> sp.Expr:
        """Collect an expression in the letters; in a numeric problem with exact or certain numbers as coefficients."""
        form = linear_form(expr, set(letters))
        if self.symbolic:
            return sp.Add(tidy(form.constant), *(tidy(c) * x for x, c in form.terms.items()))
        whole = [tidy(e) for e in (form.constant, *form.terms.values())]
        most = LONGER if len(letters) == 1 else SHORT
        short = all(not longer(e, most) for e in whole)
        constant, *coefficients = whole if short else [self._plain(e) for e in whole]
        return sp.Add(constant, *(c * x for c, x in zip(coefficients, form.terms, strict=True)))

    def _by_names(
        self,
        residuals: list[sp.Expr],
        written: tuple[Written, ...],
        order: tuple[sp.Symbol, ...],
        letters: tuple[sp.Symbol, ...],
    ) -> list[Line]:
        """As `_together` with symbols and several letters: long coefficients get names, each letter its own line."""
        lines: list[Line] = []
        inside: dict[sp.Symbol, sp.Expr] = {}
        chained = order[: len(order) - len(letters)]
        for residual, equation, x in zip(residuals, written, chained, strict=False):
            formula = self._in_names(self._solve_for(residual.xreplace(inside), x), letters, lines)
            inside[x] = formula
            held = tuple(s for s in letters if s in formula.free_symbols)
            lines.append(Line(x, formula, None if held else self.value(formula), (equation.number,), held))
        rest = [self._in_names(r.xreplace(inside), letters, lines) for r in residuals[len(chained) :]]
        numbers = tuple(e.number for e in written[len(chained) :])
        for s, formula in self._in_steps(rest, letters, lines):
            lines.append(Line(s, formula, self.value(formula), numbers))
            self.value = self.value.extended({s: self.value(formula)})
        back = [Line(x.symbol, x.formula, self.value(x.formula), x.equations) for x in lines if x.letters]
        return [*lines, *back]

    def _in_names(self, expr: sp.Expr, letters: tuple[sp.Symbol, ...], lines: list[Line]) -> sp.Expr:
        form = linear_form(expr, set(letters))
        return sp.Add(self._name(form.constant, lines), *(self._name(c, lines) * x for x, c in form.terms.items()))

    def _name(self, expr: sp.Expr, lines: list[Line]) -> sp.Expr:
        """The expression, or where it is long a symbol with a line of its own."""
        if self.value.is_zero(expr):
            return sp.S.Zero
        found = tidy(expr)
        if self.fresh is None or not longer(found, NAMED):
            return found
        if found not in self.named:
            symbol = self.named[found] = self.fresh(f"k_{len(self.named) + 1}")
            value = self.value(found)
            self.value = self.value.extended({symbol: value})
            lines.append(Line(symbol, found, value, ()))
        return self.named[found]

    def _in_steps(
        self, residuals: list[sp.Expr], letters: tuple[sp.Symbol, ...], lines: list[Line]
    ) -> list[tuple[sp.Symbol, sp.Expr]]:
        """The letters one after the other, the last one first, by elimination with the largest pivot."""
        forms = [linear_form(r, set(letters)) for r in residuals]
        rows = [[f.terms.get(s, sp.S.Zero) for s in letters] + [f.constant] for f in forms]
        size = len(letters)
        for k in range(size):
            best = max(range(k, size), key=lambda i: abs(self.value(rows[i][k])))
            rows[k], rows[best] = rows[best], rows[k]
            for i in range(k + 1, size):
                if rows[i][k] != 0:
                    factor = self._name(rows[i][k] / rows[k][k], lines)
                    ahead = zip(rows[i][k + 1 :], rows[k][k + 1 :], strict=True)
                    rows[i][k:] = [sp.S.Zero, *(self._name(a - factor * b, lines) if b != 0 else a for a, b in ahead)]
        found = []
        for k in reversed(range(size)):
            known = sp.Add(rows[k][size], *(rows[k][j] * letters[j] for j in range(k + 1, size)))
            found.append((letters[k], tidy(-known / rows[k][k])))
        return found

    def _plain(self, expr: sp.Expr) -> sp.Expr:
        """A number for an expression of knowns, to all digits."""
        value = self.value(expr)
        return sp.S.Zero if not value or self.value.is_zero(expr) else sp.Rational(str(value))

    def _letters(self, residuals: list[sp.Expr], letters: tuple[sp.Symbol, ...]) -> dict[sp.Symbol, sp.Expr]:
        """Solve the last equations for the letters by elimination with the largest pivot."""
        inside = set(letters)
        forms = [linear_form(r, inside) for r in residuals]
        rows = [[f.terms.get(s, sp.S.Zero) for s in letters] + [f.constant] for f in forms]
        size = len(letters)
        if size > MOST_FORMULAS and not self.symbolic:
            numbers = in_numbers([[self.value(e) for e in row] for row in rows])
            return {s: sp.Rational(str(x)) for s, x in zip(letters, numbers, strict=True)}
        for k in range(size):
            best = max(range(k, size), key=lambda i: abs(self.value(rows[i][k])))
            rows[k], rows[best] = rows[best], rows[k]
            for i in range(size):
                if i != k and rows[i][k] != 0 and not self.value.is_zero(rows[i][k]):
                    factor = tidy(rows[i][k] / rows[k][k])
                    rows[i] = [
                        tidy(a - factor * b) if j > k else sp.S.Zero if j == k else a
                        for j, (a, b) in enumerate(zip(rows[i], rows[k], strict=True))
                    ]
        return {s: tidy(-rows[k][size] / rows[k][k]) for k, s in enumerate(letters)}


def in_numbers(rows: list[list[Decimal]]) -> list[Decimal]:
    """The solution of Σ row[j] x_j + row[-1] = 0 by elimination with the largest pivot."""
    size = len(rows)
    for k in range(size):
        best = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[best] = rows[best], rows[k]
        for row in rows[k + 1 :]:
            if row[k]:
                factor = row[k] / rows[k][k]
                row[k:] = [a - factor * b if b else a for a, b in zip(row[k:], rows[k][k:], strict=True)]
    found: list[Decimal] = []
    for k in reversed(range(size)):
        known = sum((a * x for a, x in zip(rows[k][k + 1 : size], reversed(found), strict=True)), rows[k][size])
        found.append(-known / rows[k][k])
    return found[::-1]


def holds(definitions: Mapping[sp.Symbol, sp.Expr], symbol: sp.Symbol, unknowns: set[sp.Symbol]) -> bool:
    """Does a named intermediate rest on one of the unknowns?"""
    expr = definitions.get(symbol)
    if expr is None:
        return False
    return any(s in unknowns or holds(definitions, s, unknowns) for s in expr.free_symbols)
