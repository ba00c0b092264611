"""Bodies that tip without slipping: how they begin to turn tells whether their friction is enough."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.system.system import System


def tipping(system: System) -> set[sp.Symbol]:
    """The angular accelerations of bodies that tip about an edge which does not slip."""
    tips = [m for m in system.modes.values() if m.name == "tip" and m.direction == 0]
    turning = {j.mover for m in tips for j in m.facts.joinings}
    return {e.spin_rate for e in system.tree.edges if e.body in turning and e.spin_rate is not None}
