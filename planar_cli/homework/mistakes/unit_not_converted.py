"""A number was not converted: km/h for m/s, rev/min for rad/s, inches for feet, degrees for radians."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import ClassVar, final

from planar_cli.homework.mistakes.base import Mistake
from planar_cli.homework.paper import Expected
from planar_cli.units import LENGTH, PURE, RATE, VELOCITY, Dimension, parse_unit

SLIPS: dict[tuple[Dimension, bool], tuple[tuple[str, float], ...]] = {
    (VELOCITY, False): (("km/h", 3.6), ("m/s", 1 / 3.6)),
    (LENGTH, False): (("inches", 12.0), ("feet", 1 / 12)),
    (RATE, True): (("rev/min", 30 / math.pi), ("rad/s", math.pi / 30), ("rev/s", 1 / (2 * math.pi))),
    (PURE, True): (("degrees", 180 / math.pi), ("radians", math.pi / 180)),
}


@final
class UnitNotConverted(Mistake):
    """The number stands for another unit than the one that is written."""

    kind: ClassVar[str] = "unit-not-converted"

    def slips(self, expected: Expected) -> Iterable[tuple[str, tuple[float, ...]]]:
        unit = parse_unit(expected.unit)
        for told, factor in SLIPS.get((unit.dimension, unit.angle), ()):
            yield f"the number is one in {told}", tuple(v * factor for v in expected.values)
