"""One instant worked out, and finds with their answers."""

from __future__ import annotations

from dataclasses import field
from typing import Any

import sympy as sp

from planar_cli.calculus.curve_words import Curve
from planar_cli.equation.values.exact import Settled, Valuation
from planar_cli.problem.scene.scene import Find
from planar_cli.records import changing, record
from planar_cli.solve.instant.conditions import Proviso
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Explicit
from planar_cli.units import Unit


@record
class Found:
    """One find with its answer.

    `kind`: number, vector, truth, word or curve. `values`: SI numbers (None while letters remain), one or two.
    `expressions`: closed formulas in the file's names, where they are short or letters remain; the equation of a curve.
    `word`: of a truth value or mode.
    `asked`: the find in the unknowns of the instant. `curve`: of kind "curve", what it is and how it was found.
    `turn`: -1 where a page counts a rotation clockwise.
    """

    name: str
    kind: str
    unit: Unit
    values: tuple[Settled, ...] | None
    expressions: tuple[sp.Expr, ...] | None
    word: str = ""
    find: Find | None = None
    energy: bool = False
    asked: tuple[sp.Expr, ...] = ()
    curve: Curve | None = None
    turn: int = 1


BY_ENERGY = "the balance of energy gives the same equation of motion"
"""How a check by energy is told; how well it agrees follows."""
AT_A_TOP = "the last state is one of equilibrium: with a little more it is passed, with less never reached"
CAVEATS = (
    "released at rest in an unstable equilibrium",
    "it begins at rest in equilibrium",
    "the last state is one of equilibrium",
    "let go by itself it does not reach state",
)
"""How the checks of a motion begin that say on what its answers rest."""


@changing
class InstantSolution:
    """One instant worked out. `rejected`: the first assumption and others, with why they fail. `value`: numbers of all.

    `sought`: the branch taken where constants, speeds or extremes were sought; `left_out`: those that were not.
    `quiet`: it only tells velocities at a blow. `conditions`: what is positive where its modes hold, and need not be.
    """

    state: str
    instant: Instant
    trial: Trial
    rejected: tuple[Trial, ...]
    stages: tuple[Stage, ...]
    lines: tuple[Explicit, ...]
    value: Valuation
    checks: dict[str, Any] = field(default_factory=dict)
    sought: Any = None
    left_out: tuple[Any, ...] = ()
    quiet: bool = False
    conditions: tuple[Proviso, ...] = ()

    @property
    def open_speeds(self) -> frozenset[sp.Symbol]:
        """Velocity unknowns that nothing tells; no answer rests on them."""
        if self.sought is None:
            return frozenset()
        told = self.sought.branch.algebra.value.values
        tree = self.trial.system.tree
        return frozenset(s for s in tree.velocity_unknowns() if s in self.sought.unknowns and s not in told)
