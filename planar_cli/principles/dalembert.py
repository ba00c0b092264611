"""D'Alembert's principle: inertial forces make a problem of equilibrium."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar, final

import sympy as sp

from planar_cli.principles._bodies import body_families
from planar_cli.principles.base import BodyFamily, Integrated, Position, Principle


@final
class DAlembert(Principle):
    """Inertial forces -m a_G and couples -I_G alpha are added; then all forces are in equilibrium.

    Meaning
        To the free-body diagram of every body the inertial force, opposite to its acceleration, and the inertial
        couple, opposite to its angular acceleration, are added at the mass centre. Where a body slides on a moving one
        the inertial force has its parts one by one: of the entrained, the relative and the Coriolis acceleration. This
        is motion as it is seen from the moving body.

    YAML
        title: Disk braked by a torque
        plane: vertical
        given: {m: 4 kg, R: 0.5 m, M: 3 N*m}
        points: {O: [0, 0]}
        bodies: {disk: {disk: O, radius: R, mass: m}}
        joints:
          - pin: {at: O, between: [ground, disk]}
        loads:
          - torque: {body: disk, moment: -M}
        instant: [omega(disk) = 5 rad/s]
        method: dalembert
        find: {alpha: alpha(disk), O: reaction(O).y}

    Equations
        ΣF - m a_G = 0
        ΣM_C - r_G/C × m a_G - I_G alpha = 0

    Signs
        Forces right and up, moments counterclockwise.

    Valid when
        Always; in a frame that moves, the entrained and Coriolis inertial forces are among the forces.

    Reference
        An Introduction to Planar Dynamics, 4.7, Example 4-15.
    """

    kind: ClassVar[str] = "dalembert"
    title: ClassVar[str] = "d'alembert"
    diagram: ClassVar[str] = "free-body diagram with inertial forces: equilibrium"
    inertia_as_force: ClassVar[bool] = True

    def at_instant(self, position: Position) -> Iterator[BodyFamily]:
        return body_families(position)

    def over(self, position: Position, chosen: bool) -> tuple[Integrated]:
        return (Integrated(),)

    def sides(self, left: Any, right: Any) -> tuple[Any, Any]:
        return left - right, sp.S.Zero
