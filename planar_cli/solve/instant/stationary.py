"""`X is largest` at one instant, within what the assumptions allow: a constant that is sought makes X stationary.

Of all equations what is linear is eliminated; what is left relates X and the sought constants, z. X is stationary on
f(z) = 0 where the determinant of the slopes of f and X vanishes, and largest where the second derivative of X along
f = 0 is negative there.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import NoValue, Undecided
from planar_cli.problem.language.expression import Extreme
from planar_cli.records import record
from planar_cli.solve.instant.seeker import Seeker, Sought
from planar_cli.solve.instant.stationary_point import eliminated, unchanged


@record
class Stationary:
    """`condition`: `slope` vanishes, X does not change with a small change of what is free; `related`: f; `objective`:
    X; `letters`: z.
    """

    condition: Condition
    slope: sp.Expr
    related: tuple[sp.Expr, ...]
    objective: sp.Expr
    letters: tuple[sp.Symbol, ...]

    def holds(self, value: Valuation, sense: int) -> bool:
        """Is X largest (sense 1) or smallest (-1) at this solution, beside the solutions near by?"""
        try:
            return sense * self._bend(value) < 0
        except (Unvalued, NoValue, sp.matrices.exceptions.MatrixError):
            return False

    def _bend(self, value: Valuation) -> Decimal:
        """The second derivative of X along f = 0: t · (X'' - Σ λ f'') t, t tangent to f = 0, X' = Σ λ f'."""
        slopes = self._numbers([[sp.diff(f, z) for z in self.letters] for f in self.related], value)
        gradient = self._numbers([[sp.diff(self.objective, z) for z in self.letters]], value)
        count = len(self.letters)
        minors = [slopes.extract(list(range(count - 1)), [j for j in range(count) if j != k]) for k in range(count)]
        tangent = sp.Matrix([(-1) ** k * (m.det() if count > 1 else 1) for k, m in enumerate(minors)])
        bend = self._second(self.objective, tangent, value)
        if self.related:
            factors = (slopes * slopes.T).LUsolve(slopes * gradient.T)
            bend -= sum(x * self._second(f, tangent, value) for x, f in zip(factors, self.related, strict=True))
        return Valuation({})(bend)

    def _second(self, expr: sp.Expr, tangent: sp.Matrix, value: Valuation) -> sp.Expr:
        rows = self._numbers([[sp.diff(expr, a, b) for b in self.letters] for a in self.letters], value)
        return (tangent.T * rows * tangent)[0, 0]

    @staticmethod
    def _numbers(rows: Sequence[Sequence[sp.Expr]], value: Valuation) -> sp.Matrix:
        return sp.Matrix([[sp.Rational(str(value(e))) for e in row] for row in rows])


def stationary_branches(seeker: Seeker, targets: set[sp.Symbol], side: sp.Expr, rejected: list[Sought]) -> list[Sought]:
    """The branches in which X = `side` is stationary, and largest or smallest as asked; the others are rejected."""
    extreme = seeker.instant.statements.extremes[0]
    found = stationary_of(seeker, extreme, side)
    if found is None:
        return []
    seeker.linear = _also_linear(seeker.linear, found.slope)
    inside = found.slope.free_symbols & set(seeker.unknowns)
    held: list[Sought] = []
    for sought in seeker.branches(targets | inside, (found.condition,)):
        numbers = seeker.scene.valuations[0].extended(sought.branch.algebra.value.values)
        if not sought.objection:
            sought.objective = numbers(side)
            sought.objection = "" if found.holds(numbers, extreme.sense) else f"{extreme.text} does not hold near by"
        (rejected if sought.objection else held).append(sought)
    return held


def stationary_of(seeker: Seeker, extreme: Extreme, side: sp.Expr) -> Stationary | None:
    """Where X can be largest or smallest without a limit; None: nothing is left that it could depend on."""
    sought = frozenset(seeker.ledger.sought)
    exprs = [e for c in seeker.conditions for e in c.rows()]
    for body in seeker.scene.bodies:
        exprs += body_residuals(seeker.system, body)[: 3 if seeker.scene.rigid(body) else 2]
    residuals = [_opened(e, seeker) for e in exprs]
    try:
        related, objective, letters, condition = eliminated(
            residuals, _opened(side, seeker), frozenset(seeker.unknowns), (sought - seeker.linear) or sought, sought
        )
    except Undecided:
        return None
    factors = [f for f in sp.Mul.make_args(factored(condition)) if f.free_symbols & set(letters)]
    factors = [f for f in factors if not (f.is_Pow and f.exp.is_negative)]
    slope = sp.Mul(*factors)
    if not slope.free_symbols & sought:
        return None
    free = [z.name for z in letters if z in sought]
    words = f"{extreme.text}, so {unchanged(free, side)}"
    found = Condition("extreme", words, slope, mark=extreme.mark)
    return Stationary(found, slope, tuple(related), objective, tuple(letters))


def _opened(expr: sp.Expr, seeker: Seeker) -> sp.Expr:
    """With the formulas of all names put in that rest on something sought."""
    ledger, scene = seeker.ledger, seeker.scene
    while True:
        formulas = {
            s: e for s in expr.free_symbols if (e := ledger.values.get(s, ledger.definitions.get(s))) is not None
        }
        inside = {s: e for s, e in formulas.items() if scene.rests_on_sought(e) or _rests(e, seeker)}
        if not inside:
            return expr
        expr = expr.xreplace(inside)


def _rests(expr: sp.Expr, seeker: Seeker) -> bool:
    """Does a named intermediate rest on something sought, through other intermediates?"""
    definitions = seeker.ledger.definitions
    inside = [definitions[s] for s in expr.free_symbols if s in definitions]
    return any(seeker.scene.rests_on_sought(e) or _rests(e, seeker) for e in inside)


def _also_linear(linear: frozenset[sp.Symbol], expr: sp.Expr) -> frozenset[sp.Symbol]:
    """The unknowns in which every equation is linear, with this one among them."""
    try:
        linear_form(expr, linear)
    except Nonlinear:
        return linear.difference(expr.free_symbols)
    return linear
