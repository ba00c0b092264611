"""Places of which a file says which of two it means: the square whose root has the other sign at the other one."""

from __future__ import annotations

from dataclasses import field, replace
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.scene.places import Jets
from planar_cli.equation.values.jets import Jet
from planar_cli.problem.scene.located import located
from planar_cli.problem.scene.scene import TwoFacts
from planar_cli.records import record
from planar_cli.replay.at_states import StateNumbers
from planar_cli.replay.opened import NotWritten

if TYPE_CHECKING:
    from planar_cli.equation.scene.scene import Scene
    from planar_cli.replay.equations import Equations

NEARBY = (1.0, 1.004, 0.997)
"""Factors of data with which two squares are compared."""
SAME = 1e-9


@record
class _Noting(Jets):
    """Places that note the squares of which they take roots."""

    squares: list[sp.Expr] = field(default_factory=list)

    def root(self, square: Jet) -> Jet:
        self.squares.append(square.value)
        return Jets.root(self, square)


def squares_of_places(scene: Scene) -> dict[str, sp.Expr]:
    """By point of which a circle is a fact: the square. Only a file that draws its places has them."""
    if scene.displacement is not None:
        return {}
    found: dict[str, sp.Expr] = {}
    for point in scene.problem.points:
        if isinstance(point.place, TwoFacts) and point.place.distances:
            noting = _Noting(scene.evaluator, scene.formula, lambda: scene.valuations[0])
            located(point, noting)
            found[point.name] = sp.sympify(noting.squares[0])
    return found


def with_other_place(equations: Equations, point: str) -> Equations | None:
    """The equations with a point at the other of its two places; None: it does not stand in them."""
    squares = [_Roots(equations, square) for square in equations.squares[point]]

    def change(expr: sp.Expr) -> sp.Expr:
        roots = {r: -r for r in expr.atoms(sp.Pow) if any(square.has_root(r) for square in squares)}
        return sp.sympify(expr.xreplace(roots))

    changed = replace(
        equations,
        steps=tuple(replace(s, residuals=tuple(map(change, s.residuals))) for s in equations.steps),
        defined={s: change(sp.sympify(e)) for s, e in equations.defined.items()},
        asked={n: replace(a, parts=tuple(map(change, a.parts))) for n, a in equations.asked.items()},
    )
    return changed if changed != equations else None


class _Roots:
    """Which roots in equations are those of a square, but for a factor that stays the same: they were simplified."""

    def __init__(self, equations: Equations, square: sp.Expr) -> None:
        given, values = set(equations.inputs.values()), equations.value
        near = ({s: values[s] * f if k % 2 else values[s] / f for k, s in enumerate(given)} for f in NEARBY)
        self._at = [StateNumbers(values.get, equations.defined) for values in near]
        self._of_square = self._numbers(square)
        self._known: dict[sp.Expr, bool] = {}

    def has_root(self, power: sp.Pow) -> bool:
        """Does it change its sign with the root?"""
        if (2 * power.exp).is_odd is not True:
            return False
        if power.base not in self._known:
            self._known[power.base] = self._is_multiple(self._numbers(power.base))
        return self._known[power.base]

    def _is_multiple(self, numbers: list[float]) -> bool:
        if not numbers or not self._of_square or 0.0 in self._of_square:
            return False
        ratios = [a / b for a, b in zip(numbers, self._of_square, strict=True)]
        return ratios[0] > 0 and all(abs(r - ratios[0]) <= SAME * ratios[0] for r in ratios)

    def _numbers(self, expr: sp.Expr) -> list[float]:
        """At all places; none where it rests on more than data."""
        try:
            return [at.of(expr) for at in self._at]
        except (NotWritten, TypeError):
            return []
