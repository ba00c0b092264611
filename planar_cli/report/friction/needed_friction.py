"""What a coefficient is that a file asks for as friction over normal force: the least with which nothing slips.

μ_needed = F_C/N_C = 5.5015/96.03 = 0.05729          no slipping while |F_C| ≤ μ N_C
"""

from __future__ import annotations

from typing import Any

from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Binary, Grouped, Quantity
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found


def limit_of(answer: Found, system: System, phrases: Phrases) -> Line:
    """The limit of friction from which the asked quotient is one; empty: another formula is asked."""
    what: Any = answer.find.found.what if answer.find is not None else None
    while isinstance(what, Grouped):
        what = what.operand
    match what:
        case Binary(
            operator="/", left=Quantity(word="friction", things=(one,)), right=Quantity(word="N", things=(two,))
        ):
            names = {"friction": one, "normal": two}
        case _:
            return ()
    if one != two:
        return ()
    joints = {name for name in system.modes if one in (name, system.aliases.get(name))}
    found = {p.kind: system.symbols.get(p.name) for p in system.pushes if p.joint in joints and p.kind in names}
    friction, normal = found.get("friction"), found.get("normal")
    if friction is None or normal is None:
        return ()
    return line("no slipping while |", phrases.math(friction), "| ≤ μ ", phrases.math(normal))
