"""How often a relation comes to hold along a motion: its gap changes its sign, or only just touches zero.

What holds at the beginning does not count, what holds at the end does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from planar_cli.records import changing

HALVINGS = 60
"""The least size of a gap is found in so many parts."""
Gap = Callable[[float], float]


@changing
class Occurrences:
    """Counts while the gap, left less right side, is looked at from time to time."""

    operator: str
    """One of = < > <= >= ."""
    near: float
    """A gap below this is zero."""
    number: int = 0
    """How often the relation has come to hold."""
    sign: int = 0
    """The last sign of the gap; 0 as long as it has had none."""
    zero: bool = False
    """Has the gap been zero since then?"""

    def part(self, gap: Gap, times: Iterable[float]) -> None:
        """A part of the motion in which the gap does not jump, looked at at these times."""
        seen: list[tuple[float, float]] = []
        for t in times:
            value = gap(t)
            if self.operator == "=" and not seen and value * self.sign < -self.near:
                # It has jumped over zero.
                self.sign, self.zero = -self.sign, False
            seen = [*seen[-2:], (t, value)]
            self._between(gap, seen)
            self._here(value)

    def _here(self, value: float) -> None:
        sign = 0 if abs(value) <= self.near else 1 if value > 0 else -1
        if self.operator != "=":
            self.number += sign == -self.sign and sign == self._holds
        elif sign == 0:
            self.number += self.sign != 0 and not self.zero
        else:
            self.number += sign == -self.sign and not self.zero
        self.zero = sign == 0
        self.sign = sign or self.sign

    @property
    def _holds(self) -> int:
        """The sign of the gap where an inequality holds."""
        return 1 if self.operator in (">", ">=") else -1

    def _between(self, gap: Gap, seen: list[tuple[float, float]]) -> None:
        """Has the gap been zero between the last three looks, at which its sign is the same?"""
        if len(seen) < 3:
            return
        (a, fa), (_, fb), (c, fc) = seen
        sign = 1 if fb > 0 else -1
        if min(sign * fa, sign * fc) < sign * fb or sign * fb <= self.near:
            return
        for _ in range(HALVINGS):
            third = (c - a) / 3
            a, c = (a, c - third) if sign * gap(a + third) < sign * gap(c - third) else (a + third, c)
        least = sign * gap(0.5 * (a + c))
        if least < -self.near:
            self.number += 2 if self.operator == "=" else 1
        elif least <= self.near:
            self.number += self.operator == "="
