"""Bodies of which a file gives a moment of inertia alone, as a wheel whose mass is counted in that of the cycle.

Its own momentum belongs into its diagram all the same, as part of the whole: m_rear v → at O_A, which has no moment
about its mass centre.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy as sp

from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Line, Math, Name, Text, Way, line
from planar_cli.report.notation.names import plain_name
from planar_cli.solve.solution import InstantSolution

WAYS = ((Vec(sp.S.One, sp.S.Zero), "→"), (Vec(sp.S.Zero, sp.S.One), "↑"))


def light_bodies(solution: InstantSolution) -> dict[str, Vec]:
    """The bodies without mass that turn and move on, with the velocities of their centres."""
    motion, scene = solution.trial.system.motion, solution.instant.scene
    found: dict[str, Vec] = {}
    for name, body in scene.bodies.items() if motion is not None else ():
        if body.mass != 0 or body.inertia == 0 or not body.rigid or motion is None:
            continue
        v = motion.velocity(body.center, name)
        if any(solution.value.known(p) != 0 for p in (v.x, v.y)):
            found[name] = v
    return found


def heavy_bodies(solutions: Sequence[InstantSolution]) -> list[str]:
    """The bodies of which the file gives a mass."""
    scenes = (solution.instant.scene for solution in solutions)
    return list(dict.fromkeys(name for scene in scenes for name, body in scene.bodies.items() if body.mass != 0))


def own_momenta(
    solution: InstantSolution, groups: Sequence[tuple[str, ...]], speed: Callable[[sp.Expr], sp.Expr | None]
) -> dict[str, Line] | None:
    """By its body, the momentum that is counted with that of the one body with mass: m_rear v → at O_A. None: a diagram
    would be false without it. `groups`: the bodies of each diagram; `speed`: that is told of a velocity at its end.
    """
    light, heavy, scene = light_bodies(solution), heavy_bodies([solution]), solution.instant.scene
    if not light:
        return {}
    whole = {*light, *heavy}
    if len(heavy) != 1 or any(len(group) > 1 and not whole <= set(group) for group in groups):
        return None
    if any(group == (heavy[0],) for group in groups):
        return None
    found: dict[str, Line] = {}
    for name, v in light.items():
        along = [(part, *way) for part, way in zip((v.x, v.y), WAYS, strict=True) if part != 0]
        mass = f"m_{name}"
        told = speed(along[0][0]) if len(along) == 1 else None
        if told is None or mass in scene.ledger.symbols:
            return None
        momentum = sp.Mul(sp.Symbol(mass, positive=True), told, evaluate=False)
        ((_, direction, arrow),) = along
        way = Way(scene.center(name), direction, solution.value)
        found[name] = line(Math(momentum), Text(f" {arrow} at {plain_name(scene.center_name(name))}", way=way))
    return found


def parts_of_mass(solution: InstantSolution, shares: Mapping[str, Line]) -> Line:
    """m_rear, m_front: parts of m."""
    if not shares:
        return ()
    (heavy,) = heavy_bodies([solution])
    mass = solution.instant.scene.bodies[heavy].mass
    whole = line(Math(mass)) if mass.is_Symbol else line(f"the mass of {heavy}")
    names = [piece for i, name in enumerate(shares) for piece in (", " * bool(i), Name(f"m_{name}"))]
    return line("; ", *names, ": parts of " if len(shares) > 1 else ": part of ", *whole)
