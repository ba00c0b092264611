"""Bodies whose mass centres have a_x and a_y in the equations of a plan: moments about a constructed centre, such as an
instantaneous centre, would else need an arm for each part of their accelerations.
"""

from __future__ import annotations

from planar_cli.solve.instant.plan import Plan

MANY = 4
"""A sum over so many bodies has one term for each."""


def bodies_by_axes(plan: Plan) -> frozenset[str]:
    """The bodies of groups of several, of which moments are taken about a point that has no name of its own, and of
    groups of many.
    """
    return frozenset(
        body
        for block in plan.blocks
        for e in block.equations
        if e.choice is not None
        and (len(e.bodies) >= MANY or (e.choice.moment and not e.choice.name and len(e.bodies) > 1))
        for body in e.bodies
    )
