"""Impulse and momentum: a law between two states."""

from __future__ import annotations

from typing import Any, ClassVar, final

from planar_cli.principles.base import Principle


@final
class ImpulseMomentum(Principle):
    """The impulse of all forces between two states is the change of the momentum.

    Meaning
        The law relates two `states`; a single instant has no interval over which anything could act. Asked for at one
        instant, it is refused with this reason.

    YAML
        method: momentum

    Equations
        m v_G1 + ΣImp = m v_G2,   H_1 + ΣAng.Imp = H_2

    Signs
        Work, impulse and angular impulse are those of the forces on the body.

    Valid when
        Two states are given, and what happens between them.

    Reference
        An Introduction to Planar Dynamics, 4.6.
    """

    kind: ClassVar[str] = "momentum"
    diagram: ClassVar[str] = "two states"

    def objection(self, problem: Any) -> str:
        return "it relates two states, and this problem asks about one instant"
