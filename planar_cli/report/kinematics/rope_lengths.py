"""The length of a rope in places, from which its relation of velocities or accelerations comes: y_A + 2 y_B = const."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

import sympy as sp

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.system.system import System
from planar_cli.joints.base import Joint
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.keys import RopeStop
from planar_cli.problem.scene.scene import GROUND, with_article
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.words.spoken import begun
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written

KEEPS, DERIVED = "keeps its length", "differentiated"


def length_told(w: Written, system: System, phrases: Phrases, twice: bool) -> Line:
    """`y_A + 2 y_B = const., differentiated`; nothing where a part of the rope turns, or runs over what turns."""
    if w.source != "row" or not w.lead.endswith(KEEPS):
        return ()
    if by_arc := _by_arc(w, system, phrases, twice):
        return by_arc
    places = _places(system)
    residual = expanded(_of_all(w, system) if twice else w.left - w.right)
    residual = expanded(cancelled(residual)) if residual.free_symbols - set(places) else residual
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
    return line(f"{begun(w.lead)}, ", phrases.math(found), f" = const., differentiated{' twice' if twice else ''}:")


def _of_all(w: Written, system: System) -> sp.Expr:
    """The velocities along a rope, with those that do not change, whose accelerations have gone from the equation."""
    rows = [row for mode in system.modes.values() for row in mode.facts.rows if row.title == w.lead]
    return system.first.row_velocity(rows[0]) if len(rows) == 1 else w.left - w.right


def wound(w: Written, system: System, written: Sequence[Written]) -> str:
    """`The cord keeps its length and does not slip on the wheel:`, of one that is wound on a body; "" of another
    relation. `written`: the relations of its stage; ropes on the same bodies that follow each other have one sentence.
    """
    joints, bodies = _wound(w, system)
    if not bodies:
        return ""
    runs = (list(run) for on, run in groupby(written, lambda x: _wound(x, system)[1]) if on == bodies)
    joints = next((tuple(j for x in run for j in _wound(x, system)[0]) for run in runs if w in run), joints)
    called, drum = _in_a_row(joints), " and on ".join(map(with_article, bodies))
    if len(joints) > 1:
        return f"{begun(called)} keep their lengths and do not slip on {drum}:"
    return f"{begun(called)} {KEEPS} and does not slip on {drum}:"


def _by_arc(w: Written, system: System, phrases: Phrases, twice: bool) -> Line:
    """`The cable keeps its length and does not slip on the wheel: the way of A is the arc on it, s_A = r_h θ;
    differentiated:` where it is wound on one body that turns about a fixed axle and v = ± r ω; nothing on a page of
    masses, which tells no angle.
    """
    joints, bodies = _wound(w, system)
    scene = system.scene
    displacement = scene.displacement
    if (
        len(joints) != 1
        or len(bodies) != 1
        or displacement is None
        or not all(b.is_massless for b in scene.problem.bodies)
    ):
        return ()
    edge = next((e for e in system.tree.edges if e.body == bodies[0]), None)
    angle = next((c for c in displacement.coordinates if c.body == bodies[0]), None)
    if edge is None or angle is None or edge.joining is None or edge.spin is None:
        return ()
    residual = expanded(_of_all(w, system) if twice else w.left - w.right)
    radius = residual.coeff(edge.spin)
    speed = residual - radius * edge.spin
    ends = {s: e.body for e in system.tree.edges for s in (e.slide, e.rise) if s is not None}
    drawn = next((s for s in (speed, -speed) if s in ends), None)
    if edge.parent != GROUND or not edge.joining.only_turns or radius == 0 or drawn is None:
        return ()
    end = scene.center_name(ends[drawn]) or ends[drawn]
    way = sp.Symbol(f"s_{end}", real=True)
    if way.name in scene.ledger.symbols and all(c.symbol != way or c.drawn != 0 for c in displacement.coordinates):
        return ()
    # v = ± r ω of the end, counted as its velocity is.
    arc = (-radius if speed == drawn else radius) * angle.symbol
    told = line("the way of ", Name(end), " is the arc on it, ", phrases.math(way), " = ", phrases.math(arc))
    return line(f"{wound(w, system, (w,))} ", *told, f"; {DERIVED}{' twice' if twice else ''}:")


def _wound(w: Written, system: System) -> tuple[tuple[Joint, ...], tuple[str, ...]]:
    """The rope of which a relation tells, and the bodies on which it is wound; none of another relation."""
    called = w.lead.removesuffix(KEEPS).strip() if w.source == "row" and w.lead.endswith(KEEPS) else ""
    own = tuple(j for j in system.scene.problem.joints if called and j.called == called)
    return own, tuple(dict.fromkeys(drum for j in own for drum in drums(j)))


def _in_a_row(joints: Sequence[Joint]) -> str:
    """`the cords A and B`; `the left cord and the right cord`."""
    called = [j.called for j in joints]
    nouns, names = {c.split(" ")[1] for c in called}, [c.split(" ", 2)[-1] for c in called]
    if len(called) > 1 and len(nouns) == 1 and all(nouns <= {j.kind, *j.nouns} for j in joints):
        return f"the {nouns.pop()}s {listed(names, 'and')}"
    return listed(called, "and")


def drums(joint: object) -> list[str]:
    """The bodies on which a joint is wound, if it is a rope."""
    stops = (s for s in getattr(joint, "path", ()) if isinstance(s, RopeStop) and s.way == "on")
    return [s.body for s in stops if s.body]


def _places(system: System) -> dict[sp.Symbol, sp.Expr]:
    """The coordinate that goes with each velocity and acceleration of a point that moves up and down or to the side."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for e in system.tree.edges:
        name = system.scene.center_name(e.body) or e.body
        own = {axis: sp.Symbol(system.scene.ledger.apart(f"{axis}_{name}"), real=True) for axis in "xy"}
        if e.joining is None and e.components is None:
            along, up = own["x"] * e.rightward, own["y"] * e.upward
            pairs = ((e.slide, along), (e.slide_rate, along), (e.rise, up), (e.rise_rate, up))
            found |= {s: place for s, place in pairs if s is not None}
        path = e.joining.path if e.joining is not None and e.parent == GROUND else None
        if path is not None and path.curvature == 0 and 0 in (path.tangent.x, path.tangent.y):
            along = own["x"] * path.tangent.x + own["y"] * path.tangent.y
            found |= {s: along for s in (e.slide, e.slide_rate) if s is not None}
    return found


def all_against(w: Written) -> bool:
    """Do all terms of an equation `… = 0` have a minus sign, so that it reads better without?"""
    return w.right == 0 and all(term.could_extract_minus_sign() for term in sp.Add.make_args(w.left))
