"""The contract of the shelf of principles: how the equations of kinetics are put on paper.

All principles at one instant are the same families of equations (equation/, solve/offers.py): every force direction and
moment centre of every group of bodies. Between two states each has equations of its own, all written side by side; the
plan takes the shortest way through them. A principle says whether it applies, on which side of the equation inertia
stands, what is drawn, and which laws between states are its own. A member is one file with one final class; its
docstring is its manual page.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, ClassVar


class Principle(ABC):
    """`kind`: the word of `method:` and `--method`. `diagram`: what is drawn, as the heading of step 2 says it. `laws`:
    the kinds of law between two states that it uses (solve/course/equations.py).
    """

    kind: ClassVar[str]
    diagram: ClassVar[str]
    laws: ClassVar[frozenset[str]]
    inertia_as_force: ClassVar[bool] = False

    @abstractmethod
    def objection(self, problem: Any) -> str:
        """Why the principle can not answer this problem; "" when it can. `problem`: a problem.scene.Problem."""

    @staticmethod
    def relates_states(problem: Any) -> bool:
        """Does the problem, or a case of it, have two states between which something happens?"""
        return any(len(p.states) > 1 for p in (problem, *(case.problem for case in problem.cases)))

    def sides(self, left: Any, right: Any) -> tuple[Any, Any]:
        """The equation's sides, from Σ forces (left) and inertia (right)."""
        return left, right
