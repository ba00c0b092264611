"""The classical Runge-Kutta method."""

from __future__ import annotations

from typing import ClassVar, final

from planar_cli.integrators._fixed import EqualSteps
from planar_cli.integrators.base import Rates, Vector


@final
class RungeKutta4(EqualSteps):
    """The classical Runge-Kutta method of order 4, with equal steps.

    Meaning
        Four evaluations in a step; the error falls with the fourth power of its length. A method to compare with: the
        length is chosen at the start and kept.

    Equations
        k1 = f(t, y)    k2 = f(t + h/2, y + h k1/2)    k3 = f(t + h/2, y + h k2/2)    k4 = f(t + h, y + h k3)
        y(t + h) = y + h (k1 + 2 k2 + 2 k3 + k4)/6

    Valid when
        The motion is smooth and not stiff.

    Reference
        W. Kutta, Z. Math. Phys. 46 (1901) 435.
    """

    kind: ClassVar[str] = "rk4"
    order: ClassVar[int] = 4
    cost: ClassVar[int] = 3

    def advance(self, f: Rates, t: float, y: Vector, r: Vector, h: float) -> Vector:
        half = h / 2
        b = f(t + half, [v + half * k for v, k in zip(y, r, strict=True)])
        c = f(t + half, [v + half * k for v, k in zip(y, b, strict=True)])
        d = f(t + h, [v + h * k for v, k in zip(y, c, strict=True)])
        sixth = h / 6
        return [v + sixth * (k + 2.0 * (m + n) + o) for v, k, m, n, o in zip(y, r, b, c, d, strict=True)]
