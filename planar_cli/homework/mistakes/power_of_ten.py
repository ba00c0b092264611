"""A prefix is lost: the number is off by a power of ten."""

from __future__ import annotations

from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.homework.mistakes.base import Mistake
from planar_cli.homework.named_mistakes import OFF_BY_TEN, POWER_OF_TEN, POWERS
from planar_cli.homework.paper import Expected


@final
class PowerOfTen(Mistake):
    """The number is off by a power of ten.

    In the equations
        Nothing: the right number is ten, a hundred or a thousand times as large, or as small.
    """

    kind: ClassVar[str] = POWER_OF_TEN

    def slips(self, expected: Expected) -> Iterable[tuple[str, tuple[float, ...]]]:
        for power in POWERS:
            yield OFF_BY_TEN, tuple(v * 10.0**power for v in expected.values)
