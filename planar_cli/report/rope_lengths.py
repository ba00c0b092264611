"""The length of a rope in places, from which its relation of velocities or accelerations comes: y_A + 2 y_B = const."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.expansion import expanded
from planar_cli.equation.system import System
from planar_cli.problem.keys import RopeStop
from planar_cli.problem.scene import GROUND, with_article
from planar_cli.report.blocks import Line, line
from planar_cli.report.words import Phrases
from planar_cli.solve.instant.written import Written

KEEPS = "keeps its length"


def length_told(w: Written, system: System, phrases: Phrases, twice: bool) -> Line:
    """`y_A + 2 y_B = const., differentiated`; nothing where a part of the rope turns, or runs over what turns."""
    if w.source != "row" or not w.lead.endswith(KEEPS):
        return ()
    places = _places(system)
    residual = expanded(_of_all(w, system) if twice else w.left - w.right)
    found = sp.S.Zero
    for term in sp.Add.make_args(residual):
        factor, rest = term.as_coeff_Mul()
        if rest not in places or not factor.is_Integer:
            return ()
        found += factor * places[rest]
    if found == 0 or not found.is_Add:
        return ()
    if all(a.could_extract_minus_sign() for a in found.args) or sp.Add.make_args(found)[0].could_extract_minus_sign():
        found = -found
    called = f"{w.lead[:1].upper()}{w.lead[1:]}"
    return line(f"{called}, ", phrases.math(found), f" = const., differentiated{' twice' if twice else ''}:")


def _of_all(w: Written, system: System) -> sp.Expr:
    """The velocities along a rope, with those that do not change, whose accelerations have gone from the equation."""
    rows = [row for mode in system.modes.values() for row in mode.facts.rows if row.title == w.lead]
    return system.first.row_velocity(rows[0]) if len(rows) == 1 else w.left - w.right


def wound(w: Written, system: System) -> str:
    """`keeps its length and does not slip on the wheel`, of a rope that is wound on a body."""
    if w.source != "row" or not w.lead.endswith(KEEPS):
        return ""
    called = w.lead.removesuffix(KEEPS).strip()
    own = (j for j in system.scene.problem.joints if j.called == called)
    bodies = list(dict.fromkeys(with_article(drum) for j in own for drum in drums(j)))
    if not bodies:
        return ""
    return f"{called[:1].upper()}{called[1:]} keeps its length and does not slip on {' and on '.join(bodies)}:"


def drums(joint: object) -> list[str]:
    """The bodies on which a joint is wound, if it is a rope."""
    stops = (s for s in getattr(joint, "path", ()) if isinstance(s, RopeStop) and s.way == "on")
    return [s.body for s in stops if s.body]


def _places(system: System) -> dict[sp.Symbol, sp.Expr]:
    """The coordinate that goes with each velocity and acceleration of a point that moves up and down or to the side."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for e in system.tree.edges:
        name = system.scene.center_name(e.body) or e.body
        own = {axis: sp.Symbol(f"{axis}_{name}", real=True) for axis in "xy"}
        if e.joining is None and e.components is None:
            pairs = ((e.slide, own["x"]), (e.slide_rate, own["x"]), (e.rise, own["y"]), (e.rise_rate, own["y"]))
            found |= {s: place for s, place in pairs if s is not None}
        path = e.joining.path if e.joining is not None and e.parent == GROUND else None
        if path is not None and path.curvature == 0 and 0 in (path.tangent.x, path.tangent.y):
            along = own["x"] * path.tangent.x + own["y"] * path.tangent.y
            found |= {s: along for s in (e.slide, e.slide_rate) if s is not None}
    return found
