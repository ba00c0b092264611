"""Is a force, an acceleration or a time asked?"""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.equation.system.conditions import ACCELERATION, ORDERS
from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.problem.language.outermost import ENERGIES
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Find


def asks_kinetics(finds: Iterable[Find]) -> bool:
    """Is a force, an acceleration or a time asked, or something else for which the equations of kinetics are needed? A
    work or a heat is a term of the balance of energies.
    """
    nodes = [n for f in finds for n in walk(f.found.what)]
    if any(isinstance(n, Name) and n.name == "t" for n in nodes):
        return True
    quantities = [n for n in nodes if isinstance(n, Quantity) and n.word not in ENERGIES]
    return any(ORDERS.get(n.word, ACCELERATION) >= ACCELERATION for n in quantities)
