"""Euler's method as game engines use it: new velocities first, and with these new positions."""

from __future__ import annotations

from typing import ClassVar, final

from planar_cli.integrators._fixed import EqualSteps
from planar_cli.integrators.base import Rates, Vector


@final
class SemiImplicitEuler(EqualSteps):
    """Semi-implicit (symplectic) Euler, order 1, with equal steps.

    Meaning
        The first half of the state holds positions, the second their rates. What a physics engine of a game does;
        energy stays bounded where nothing dissipates, but every value is only as good as the step is short.

    Equations
        v(t + h) = v + h a(t, q, v)     q(t + h) = q + h v(t + h)

    Valid when
        A rough picture is enough.

    Reference
        E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, I.1.
    """

    kind: ClassVar[str] = "semi_implicit_euler"
    order: ClassVar[int] = 1
    cost: ClassVar[int] = 0

    def advance(self, f: Rates, t: float, y: Vector, r: Vector, h: float) -> Vector:
        half = len(y) // 2
        fast = [v + h * a for v, a in zip(y[half:], r[half:], strict=True)]
        return [q + h * v for q, v in zip(y[:half], fast, strict=True)] + fast
