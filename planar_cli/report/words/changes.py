"""How much one coordinate changes by others, as the kinematics of a motion tell: Δy_G = R Δθ."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, simplified
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.solve.between.trace.trace import Relation

STATE = "__"
CHANGE = "Delta_"
ANGLES = ("theta", "phi")


def changes(e: Relation) -> Line:
    """The relation between what coordinates change by from one state to the other; empty: none in letters."""
    ends = [s for s in by_name(e.residual.free_symbols) if s.name.endswith(f"{STATE}{e.stop}")]
    residual = sp.expand(e.residual)
    factors = {s: simplified(residual.coeff(s)) for s in ends}
    own = next((s for s, f in factors.items() if f == 1), None)
    if own is None or any(STATE in x.name for f in factors.values() for x in f.free_symbols):
        return ()
    starts = {s: s.name.partition(STATE)[0] + f"{STATE}{e.since}" for s in ends}
    rest = residual - sp.expand(sum(f * s for s, f in factors.items()))
    begun = {x.name: x for x in rest.free_symbols}
    known = {begun[name]: factors[s] for s, name in starts.items() if name in begun}
    if sp.expand(rest + sum(f * x for x, f in known.items())) != 0:
        return ()
    turns = {s: s.name.startswith(ANGLES) for s in ends}
    if any(f.is_number and turns[s] != turns[own] for s, f in factors.items()):
        # A number of the file would hide its unit.
        return ()
    told = {s: sp.Symbol(f"{CHANGE}{s.name.partition(STATE)[0]}", real=True) for s in ends}
    others = sp.Add(*(-f * told[s] for s, f in factors.items() if s != own))
    return line(Math(told[own]), " = ", Math(others))
