"""An answer, or a motion, that rests on a mass or an inertia that the file does not give."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.errors import Diagnostic, Mark, NoSolution
from planar_cli.problem.scene.scene import Find, Outline
from planar_cli.solve.diagnosis.words import listed
from planar_cli.solve.solution import Found


def demand_cancelled(scene: Scene, finds: Sequence[Find | None], found: Sequence[Found]) -> None:
    """Raise where an answer rests on a mass (or inertia) that the file does not give."""
    hidden = scene.cancelling
    if not hidden:
        return
    for find, answer in zip(finds, found, strict=False):
        for expr in answer.expressions or ():
            rests = [s for s in hidden if s in expr.free_symbols and _matters(scene, expr, s)]
            if rests:
                raise NoSolution([not_cancelled(scene, answer.name, find, rests)])


def not_cancelled(scene: Scene, name: str, find: Find | None, rests: Sequence[sp.Symbol]) -> Diagnostic:
    """What to say of a find (or of all the motion) that rests on the mass or the inertia of some bodies; all of the
    first one's kind.
    """
    of_mass = {m.mass: b for b, m in scene.bodies.items() if m.mass in rests}
    bodies = list(of_mass.values())
    kind, repair = "mass", "mass: 2 kg"
    if rests[0] not in of_mass:
        bodies = [b for b, m in scene.bodies.items() if m.inertia == rests[0]]
        kind, repair = "moment of inertia", "inertia: 0.1 kg*m^2` or `radius_of_gyration: 0.2 m"
    if len(bodies) > 1:
        text = f"{name} depends on the masses of {listed(bodies)}, which are not given and do not cancel"
        hint = f"each `any` is a mass of its own: write `{repair}`, or one letter for those that are equal: `mass: m`"
        hint += " with `symbols: {m: kg}`"
    else:
        text = f"{name} depends on the {kind} of {listed(bodies)}, which is not given and does not cancel"
        hint = f"give it: `{repair}`"
    body = next((b for b in scene.problem.bodies if b.name in bodies), None)
    if body is not None and kind != "mass" and isinstance(body.shape, Outline) and not body.points:
        hint += ", or its `radius`, if it is a uniform wheel"
    mark = body.mark if body is not None else find.mark if find is not None else Mark(scene.problem.file, 1, 1)
    return Diagnostic(mark, "PL614", text, hint)


def _matters(scene: Scene, expr: sp.Expr, symbol: sp.Symbol) -> bool:
    """Does the value change with the symbol?"""
    base = scene.valuations[0]
    one, other = (base.extended({symbol: Decimal(n)}).known(expr) for n in ("0.7", "1.9"))
    if one is None or other is None:
        return False
    return abs(one - other) > Decimal("1e-25") * max(abs(one), abs(other), Decimal(1))
