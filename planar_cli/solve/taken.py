"""What a solved motion hands on to whoever follows it anew in numbers."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.records import record


@record
class Taken:
    """What a solved motion tells whoever follows it anew in numbers, beside what its file says."""

    letters: Mapping[str, float]
    """Constants that were sought, and letters of the file as they were drawn, by name [SI]."""
    opened: Mapping[str, float]
    """What joints leave open and a blow tells: restitutions, by the name of the constant."""
    times: Mapping[str, float]
    """When states are reached [s]."""
    speeds: Mapping[str, tuple[float, float, float]]
    """Of bodies in the first state: of the mass centre along x and y [m/s], and of turning [rad/s]."""
