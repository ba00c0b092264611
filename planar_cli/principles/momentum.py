"""Impulse and momentum: a law between two states."""

from __future__ import annotations

from typing import Any, ClassVar, final

from planar_cli.principles.base import Principle


@final
class ImpulseMomentum(Principle):
    """The impulse of all forces between two states is the change of the momentum.

    Meaning
        The law relates two `states` by the time between them, for a body or a group, in one direction or about one
        point. Taken where no unknown reaction acts it gives speeds at once; where nothing acts at all, momentum is
        conserved, be it in one direction only. In a blow (`just after`, `impact`, `impulse`) it is the only law. By
        itself it is one of the laws that the plan chooses from; `method: momentum` takes no other law between states.

    YAML
        title: Braked wheel
        plane: vertical
        given: {I: 0.8 kg*m^2, M: 6 N*m}
        points: {O: [0, 0]}
        bodies: {wheel: {disk: O, radius: 0.3 m, mass: 20 kg, inertia: I}}
        joints:
          - pin: {at: O, between: [ground, wheel]}
        loads:
          - torque: {body: wheel, moment: -M}
        states:
          1: [t = 0, omega(wheel) = 30 rad/s]
          2: [omega(wheel) = 0]
        method: momentum
        find: {t: t @ 2}

    Equations
        m v_G1 + ∫F dt = m v_G2
        H_O1 + ∫M_O dt = H_O2                   H_O = Σ (r_G/O × m v_G + I_G ω)
        about a point C that moves:  dH_C/dt = ΣM_C - v_C × m v_G

    Signs
        Along x and y; angular momenta counterclockwise. `impulse(f)` is that of the force on the body.

    Valid when
        The point O is fixed, or is the mass centre, or keeps its place beside it.

    Reference
        An Introduction to Planar Dynamics, 3.4, 3.7, 4.6, equations 4.68 - 4.76, Examples 4-12 to 4-14, 4-18.
    """

    kind: ClassVar[str] = "momentum"
    laws: ClassVar[frozenset[str]] = frozenset(("momentum",))
    diagram: ClassVar[str] = "two states"

    def objection(self, problem: Any) -> str:
        if self.relates_states(problem):
            return ""
        return "it relates two states, and this problem asks about one instant"
