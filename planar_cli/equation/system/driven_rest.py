"""Equilibrium in a scene that `motion` drives: what nothing drives stays where it is, seen from what is driven."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge, Motion, Tree
from planar_cli.equation.system.conditions import Condition


def relative_rest(
    motion: Motion, tree: Tree, coordinates: Sequence[sp.Expr], told: Collection[sp.Expr]
) -> Iterator[Condition]:
    """What equilibrium demands beside that: no second rate of a coordinate that is not driven; without coordinates, no
    acceleration relative to what a body is joined to, or to what is driven. `tree`: how the joints lead the bodies;
    `motion`: in whose unknowns it is written; `coordinates`: their second rates; `told`: what joints and `motion` tell.
    """
    joined = [e for e in tree.edges if e.rise_rate is None]
    for a in coordinates:
        if a not in told:
            yield Condition("given", "equilibrium", a)
    driven = next((e for e in joined if {e.slide_rate, e.spin_rate} & set(told)), None)
    if coordinates:
        return
    for edge in joined:
        for a in (edge.slide_rate, edge.spin_rate):
            if a is not None and a not in told:
                yield Condition("given", "equilibrium", a if motion.tree is tree else _relative(motion, edge, a))
    for edge in (e for e in tree.edges if e.rise_rate is not None and not {*told} >= {e.slide_rate, e.rise_rate}):
        if driven is None:
            return
        at = motion.center(edge.body)
        relative = motion.acceleration(at, edge.body) - motion.acceleration(at, driven.body)
        yield Condition("given", "equilibrium", relative, body=edge.body, base=driven.body)
        if edge.spin_rate is not None:
            turning = motion.accelerations[edge.body].angular - motion.accelerations[driven.body].angular
            yield Condition("given", "equilibrium", turning, body=edge.body, base=driven.body)


def _relative(motion: Motion, edge: Edge, a: sp.Expr) -> sp.Expr:
    """The acceleration of a body at rest relative to what it is joined to: how it turns, or along its path."""
    joining = edge.joining
    assert joining is not None, "a body that nothing joins has two components"
    if a == edge.spin_rate:
        return motion.accelerations[joining.mover].angular - motion.accelerations[joining.base].angular
    assert joining.path is not None, "what slides has a path"
    relative = motion.acceleration(joining.point, joining.mover) - motion.acceleration(joining.point, joining.base)
    return relative.dot(joining.path.tangent)
