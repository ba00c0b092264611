"""What cannot part, as the other joints hold it together: a wheel on a fixed axle stays on its brake block.

The velocity with which it would part follows from those that the joints which hold demand; so it does not part, and
presses with a force that its neighbours may leave open.
"""

from __future__ import annotations

from collections.abc import Collection

from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import ZERO
from planar_cli.solve.multibody.assembly import Assembly
from planar_cli.solve.multibody.linear import Span

LOCKED = "the other joints hold it together"


def locked(system: System, outcome: Assembly, stated: Collection[str]) -> bool:
    """Is there a joint that has parted, though the others hold it together? `outcome`: of these modes, in numbers;
    `stated`: joints of which the file says the mode.
    """
    parted = [m for name, m in system.modes.items() if m.parted and system.aliases.get(name, name) not in stated]
    if not parted:
        return False
    assembly = Assembly(outcome.value, outcome.centers, outcome.rigid, outcome.twists)
    for mode in system.modes.values():
        for joining in mode.facts.joinings:
            assembly.joining(joining)
        for row in mode.facts.rows:
            assembly.rows.append(assembly.row(row))
    width = len(assembly.columns)
    span = Span(width + 1)
    for line in assembly.dense():
        span.grows(line)
    for mode in parted:
        for test in mode.tests:
            if test.joining is not None and test.joining.path is not None:
                found = assembly.across(test.joining, assembly.number(test.joining.path.tangent.turned()))
            elif test.row is not None:
                found = assembly.row(test.row)
            else:
                continue
            line = [ZERO] * (width + 1)
            for j, c in found.items():
                line[width if j < 0 else j] = c
            if not span.grows(line):
                return True
    return False
