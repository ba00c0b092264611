"""What to say where unknowns are determined, but no order of equations leads to them: in words, never by their names
in the program, with the place in the file and what may help.
"""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.equation.algebra.plain import by_name
from planar_cli.equation.system.system import System
from planar_cli.errors import Diagnostic, Mark, Undecided, Unplanned

ACROSS = (
    "check where the two touch, `at`, and the common normal, `normal`: a joint may keep them from approaching so; "
    "what comes before this blow is told in a file without it"
)
LESS = "ask for less at this instant, or follow the motion with `planar simulate`"


def unplanned(system: System, targets: Iterable[sp.Symbol]) -> Undecided:
    """Undecided, at the impact of a blow, else at the first find."""
    from planar_cli.solve.diagnosis.words import listed, named

    problem = system.scene.problem
    words = listed(named(s, system.titles) for s in by_name(set(targets)))
    struck = next((j for j in problem.joints if j.strikes), None)
    place = struck.mark if struck is not None else problem.find[0].mark if problem.find else Mark(problem.file, 1, 1)
    text = f"not decided: {words} follow from no equations that can be solved one after the other"
    return Unplanned([Diagnostic(place, "PL627", text, LESS if struck is None else ACROSS)])
