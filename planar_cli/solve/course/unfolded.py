"""A motion that is solved: its course, the branch of its equations that happens, and all that is told of it."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.solve.course.chain import Branch
from planar_cli.solve.course.derivation import Route
from planar_cli.solve.course.finds import FindReader
from planar_cli.solve.course.motion_equations import MotionEquations
from planar_cli.solve.course.oscillation import Oscillation
from planar_cli.solve.course.simulate import Followed
from planar_cli.solve.course.trace import SpanIntegral


@dataclass(slots=True)
class Unfolded:
    """A course with the branch of its equations that happens, and how it was followed in numbers (None: it could not
    be). `guessed`: letters whose values come from the numbers alone. `route`: the way that is told. `spans`: quantities
    over spans; `oscillations`: about equilibrium states that are asked about. `checks`: what was compared, in phrases.
    `presumed`: what is positive with these letters, and need not be.
    """

    course: MotionEquations
    finds: FindReader
    branch: Branch
    followed: Followed | None
    value: Valuation
    guessed: frozenset[sp.Symbol] = frozenset()
    route: Route | None = None
    spans: tuple[SpanIntegral, ...] = ()
    oscillations: tuple[Oscillation, ...] = ()
    checks: tuple[str, ...] = ()
    presumed: tuple[sp.Expr, ...] = ()
