"""Is a force, an acceleration or a time asked?"""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.equation.conditions import ACCELERATION, ORDERS
from planar_cli.problem.expression import Name, Quantity
from planar_cli.problem.outermost import ENERGIES
from planar_cli.problem.scene import Find
from planar_cli.problem.walk import walk


def asks_kinetics(finds: Iterable[Find]) -> bool:
    """Is a force, an acceleration or a time asked, or something else for which the equations of kinetics are needed? A
    work or a heat is a term of the balance of energies.
    """
    nodes = [n for f in finds for n in walk(f.found.what)]
    if any(isinstance(n, Name) and n.name == "t" for n in nodes):
        return True
    quantities = [n for n in nodes if isinstance(n, Quantity) and n.word not in ENERGIES]
    return any(ORDERS.get(n.word, ACCELERATION) >= ACCELERATION for n in quantities)
