"""Work and kinetic energy: a law between two states."""

from __future__ import annotations

from typing import Any, ClassVar, final

from planar_cli.principles.base import Principle


@final
class WorkEnergy(Principle):
    """The work of all forces between two states is the change of the kinetic energy.

    Meaning
        The law relates two `states` without the time between them. Weights, springs, other loads and friction do work;
        ideal joints (smooth pins and guides, links, taut ropes, rolling without slip) do none. Where all of it has a
        potential this is the conservation of energy. By itself it is one of the laws that the plan chooses from;
        `method: energy` takes no other law between states. Then states are related even if the motion would not lead
        from one to the other by itself, which is said beside the answer.

    YAML
        title: Crate slides to a stop
        plane: vertical
        given: {m: 20 kg, mu: 0.3, v_0: 4 m/s}
        points: {C: [0, 0]}
        surfaces: {floor: {through: C, angle: 0 deg}}
        bodies: {crate: {particle: C, mass: m}}
        joints:
          - contact: {between: [crate, floor], at: C, mu: mu}
        states:
          1: [v(crate).x = v_0]
          2: [crate at rest]
        method: energy
        find: {way: x(crate) @ 2 - x(crate) @ 1, heat: heat(C) @ 1->2}

    Equations
        T_1 + U_1-2 = T_2                       T = Σ (m v_G²/2 + I_G ω²/2)
        weight:  U = m g (y_1 - y_2)            spring:  U = k (s_1² - s_2²)/2
        constant force:  U = F · Δr             couple:  U = M Δθ
        friction:  U = -∫ mu N ds               conservation:  T_1 + V_1 = T_2 + V_2

    Signs
        Work is positive where a force acts along the motion of its point.

    Valid when
        Every force that does work depends on the place alone; a support or belt that moves does work of its own.

    Reference
        An Introduction to Planar Dynamics, 3.3, 3.5, 4.5, equations 4.61 - 4.67, Examples 4-8 to 4-11.
    """

    kind: ClassVar[str] = "energy"
    laws: ClassVar[frozenset[str]] = frozenset(("energy",))
    diagram: ClassVar[str] = "two states"

    def objection(self, problem: Any) -> str:
        if self.relates_states(problem):
            return ""
        return "it relates two states, and this problem asks about one instant"
