"""Work and kinetic energy: a law between two states."""

from __future__ import annotations

from typing import Any, ClassVar, final

from planar_cli.principles.base import Principle


@final
class WorkEnergy(Principle):
    """The work of all forces between two states is the change of the kinetic energy.

    Meaning
        The law relates two `states`; a single instant has no interval over which anything could act. Asked for at one
        instant, it is refused with this reason.

    YAML
        method: energy

    Equations
        T_1 + U_1-2 = T_2

    Signs
        Work, impulse and angular impulse are those of the forces on the body.

    Valid when
        Two states are given, and what happens between them.

    Reference
        An Introduction to Planar Dynamics, 4.5, equations 4.61 - 4.67.
    """

    kind: ClassVar[str] = "energy"
    diagram: ClassVar[str] = "two states"

    def objection(self, problem: Any) -> str:
        return "it relates two states, and this problem asks about one instant"
