"""The contract of the shelf of principles: how the equations of kinetics are put on paper.

All principles at one instant are the same families of equations (equation/, solve/offers.py): every force direction and
moment centre of every group of bodies. A principle says whether it applies, on which side of the equation inertia
stands, and what is drawn. A member is one file with one final class; its docstring is its manual page.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, ClassVar


class Principle(ABC):
    """`kind`: the word of `method:` and `--method`. `diagram`: what is drawn, as the heading of step 2 says it."""

    kind: ClassVar[str]
    diagram: ClassVar[str]
    inertia_as_force: ClassVar[bool] = False

    @abstractmethod
    def objection(self, problem: Any) -> str:
        """Why the principle can not answer this problem; "" when it can. `problem`: a problem.scene.Problem."""

    def sides(self, left: Any, right: Any) -> tuple[Any, Any]:
        """The equation's sides, from Σ forces (left) and inertia (right)."""
        return left, right
