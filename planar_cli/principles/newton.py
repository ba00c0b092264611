"""Newton's second law for bodies."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, final

from planar_cli.principles._bodies import body_families
from planar_cli.principles.base import BodyFamily, Integrated, Position, Principle


@final
class Newton(Principle):
    """Forces equal inertia: about the mass centre, a fixed axis, or any point.

    Meaning
        The free-body diagram equals the kinetic diagram: m a_G at the mass centre and the couple I_G alpha. Any
        direction and any point may be taken; best a point through which unknown forces pass.

    YAML
        title: Crate pulled along a rough floor
        plane: vertical
        given: {m: 20 kg, mu: 0.3, P: 100 N}
        points: {C: [0, 0]}
        surfaces: {floor: {through: C, angle: 0 deg}}
        bodies: {crate: {particle: C, mass: m}}
        joints:
          - contact: {between: [crate, floor], at: C, mu: mu}
        loads:
          - force: {body: crate, magnitude: P, angle: 0 deg}
        instant: [at rest]
        method: newton
        find: {a: a(crate).x}

    Equations
        ΣF = m a_G
        ΣM_C = r_G/C × m a_G + I_G alpha        about any point C
        ΣM_O = I_O alpha                        about a fixed point O of the body, I_O = I_G + m d²

    Signs
        Forces and accelerations right and up, moments counterclockwise.

    Valid when
        The reference frame is inertial.

    Reference
        An Introduction to Planar Dynamics, 4.1 - 4.4, equations 4.11, 4.33, 4.43, 4.47.
    """

    kind: ClassVar[str] = "newton"
    title: ClassVar[str] = "newton-euler"
    usual: ClassVar[bool] = True
    diagram: ClassVar[str] = "free-body diagram = kinetic diagram"

    def at_instant(self, position: Position) -> Iterator[BodyFamily]:
        return body_families(position)

    def over(self, position: Position, chosen: bool) -> tuple[Integrated]:
        return (Integrated(),)
