"""Truncated Taylor series in the time, with slopes: a residual evaluated once gives its rows in a multibody system.

    x(t) = value + rate t + second t²/2,       slopes[i] = ∂x/∂q_i

Fed with the poses q(t) = q + q̇ t (no accelerations), a residual φ comes out with its Jacobian row (slopes), its rate at
the actual velocities, and its second derivative at zero accelerations, so that φ̈ = Σ slopes · q̈ + second.
"""

from __future__ import annotations

from decimal import Decimal

from planar_cli.records import record

ZERO = Decimal(0)
ONE = Decimal(1)
TWO = Decimal(2)
Number = Decimal | int
Slopes = dict[int, Decimal]


@record
class TimeJet:
    """One number that varies; constants mix in as Decimal or int."""

    value: Decimal
    rate: Decimal
    second: Decimal
    slopes: Slopes

    def __add__(self, other: TimeJet | Number) -> TimeJet:
        if not isinstance(other, TimeJet):
            return TimeJet(self.value + other, self.rate, self.second, self.slopes)
        slopes = dict(self.slopes)
        for i, s in other.slopes.items():
            slopes[i] = slopes[i] + s if i in slopes else s
        return TimeJet(self.value + other.value, self.rate + other.rate, self.second + other.second, slopes)

    __radd__ = __add__

    def __neg__(self) -> TimeJet:
        return TimeJet(-self.value, -self.rate, -self.second, {i: -s for i, s in self.slopes.items()})

    def __sub__(self, other: TimeJet | Number) -> TimeJet:
        if not isinstance(other, TimeJet):
            return TimeJet(self.value - other, self.rate, self.second, self.slopes)
        slopes = dict(self.slopes)
        for i, s in other.slopes.items():
            slopes[i] = slopes[i] - s if i in slopes else -s
        return TimeJet(self.value - other.value, self.rate - other.rate, self.second - other.second, slopes)

    def __rsub__(self, other: Number) -> TimeJet:
        return -self + other

    def __mul__(self, other: TimeJet | Number) -> TimeJet:
        if not isinstance(other, TimeJet):
            if not other:
                return TimeJet(ZERO, ZERO, ZERO, {})
            slopes = {i: s * other for i, s in self.slopes.items()}
            return TimeJet(self.value * other, self.rate * other, self.second * other, slopes)
        a, b = self.value, other.value
        slopes = {i: s * b for i, s in self.slopes.items()}
        for i, s in other.slopes.items():
            slopes[i] = slopes[i] + a * s if i in slopes else a * s
        second = self.second * b + TWO * self.rate * other.rate + a * other.second
        return TimeJet(a * b, self.rate * b + a * other.rate, second, slopes)

    __rmul__ = __mul__

    def __truediv__(self, other: TimeJet | Number) -> TimeJet:
        return self * (other.inverse() if isinstance(other, TimeJet) else ONE / other)

    def __rtruediv__(self, other: Number) -> TimeJet:
        return self.inverse() * other

    def inverse(self) -> TimeJet:
        """1/x. ZeroDivisionError (of Decimal) where x vanishes."""
        f = ONE / self.value
        return self._chain(f, -f * f, TWO * f * f * f)

    def sqrt(self) -> TimeJet:
        """√x of a positive x."""
        f = self.value.sqrt()
        first = ONE / (TWO * f)
        return self._chain(f, first, -first / (TWO * self.value))

    def _chain(self, value: Decimal, first: Decimal, second: Decimal) -> TimeJet:
        """f(x) from f, f' and f'' at the value of x."""
        slopes = {i: first * s for i, s in self.slopes.items()}
        return TimeJet(value, first * self.rate, second * self.rate * self.rate + first * self.second, slopes)


def constant(value: Number) -> TimeJet:
    """A jet that does not vary."""
    return TimeJet(Decimal(value), ZERO, ZERO, {})
