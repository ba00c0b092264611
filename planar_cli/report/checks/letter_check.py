"""A check that a person can make of a page in letters: an equation that the solution did not use, with its results.

rod:  ↺ ΣM_G = √2/8 L T = 1/11 m g L, I α = 1/11 m g L
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.kinematics.own_accelerations import in_letters_found
from planar_cli.report.words.counted import sense_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution

LONGEST = 16
"""Operations in one side, in the letters of the page or of the file."""
DEEPEST = 20


@record
class _Sum:
    """One sum over what acts on a body, and what it amounts to, in the letters of the page."""

    lead: Line
    acting: sp.Expr
    inertia: sp.Expr


def letter_check(instant: InstantSolution, phrases: Phrases) -> Line:
    """The check of one body; empty where no equation is left whose letters the page has found, or it is long."""
    system = instant.trial.system
    if not phrases.symbolic or not instant.trial.outcomes or system.motion is None or system.reactions is None:
        return ()
    written = [w for s in instant.stages if s.level == "acceleration" for b in s.blocks for w in b.equations]
    formulas = _formulas(instant)
    for name, body in system.scene.bodies.items():
        used = [w for w in written if name in w.bodies and w.law in ("force", "moment")]
        if not used or body.mass == 0:
            continue
        for found in _left(instant, name, used):
            if told := _told(name, found, formulas, instant, phrases):
                return told
    return ()


def _formulas(instant: InstantSolution) -> dict[sp.Symbol, sp.Expr]:
    """What the page has found, by its letters."""
    found: dict[sp.Symbol, sp.Expr] = {s: sp.S.Zero for s, v in instant.trial.velocities[0].values.items() if not v}
    for stage in instant.stages:
        found |= {**stage.algebra.explicit, **stage.algebra.formulas, **dict.fromkeys(stage.zero, sp.S.Zero)}
    return {**instant.instant.scene.ledger.definitions, **found}


def _left(instant: InstantSolution, name: str, used: list[Written]) -> Iterator[_Sum]:
    """The sums of one body about its mass centre, along x and along y that stand in no equation of the solution."""
    system = instant.trial.system
    body, motion, reactions = system.scene.bodies[name], system.motion, system.reactions
    assert motion is not None
    assert reactions is not None
    acting = [(w.point, w.force, sp.sympify(w.couple), sp.S.One) for w in system.wrenches if w.body == name]
    pushed = [(a, expr) for push, expr in reactions.pushes for a in push.actions if a.body == name]
    acting += [(a.point, a.force, sp.sympify(a.couple), sp.sympify(expr)) for a, expr in pushed]
    still = system.balanced(name)
    if body.rigid and not any(w.law == "moment" and w.lead == body.center_name for w in used):
        turned = (((p - body.center).cross(f) if f is not None else 0) * e + c * e for p, f, c, e in acting)
        alpha = sp.S.Zero if still else body.inertia * motion.accelerations[name].angular
        own = body.center_name if body.center_name and body.center_name != name else "G"
        turn = system.tree.turn((name,))
        yield _Sum(line(f"{sense_of(turn)} ", Name(f"ΣM_{own}")), sp.Add(*(turn * t for t in turned)), turn * alpha)
    a = motion.acceleration(body.center, name)
    for axis, arrow in (("x", "→"), ("y", "↑")):
        if not any(w.law == "force" and w.lead == axis and w.bodies == (name,) for w in used):
            parts = (getattr(f, axis) * e for _, f, _, e in acting if f is not None)
            inertia = sp.S.Zero if still else in_letters_found(sp.sympify(body.mass * getattr(a, axis)), instant)
            yield _Sum(line(f"{arrow} ", Name(f"ΣF_{axis}")), sp.Add(*parts), inertia)


def _told(
    name: str, found: _Sum, formulas: dict[sp.Symbol, sp.Expr], instant: InstantSolution, phrases: Phrases
) -> Line:
    """Both sides in the letters of the page, then in those of the file; nothing where these are not the same."""
    acting, inertia = (simplified(e.xreplace(_zeros(instant))) for e in (found.acting, found.inertia))
    if acting.is_Symbol or not sp.Add.make_args(acting) or acting == 0 or longer(acting, LONGEST):
        return ()
    system = instant.trial.system
    pushes = set(system.symbols.values())
    unknown = pushes.union(system.tree.acceleration_unknowns(), system.tree.velocity_unknowns())
    if not acting.free_symbols & pushes:
        return ()
    sides = [_closed(e, formulas) for e in (acting, inertia)]
    if any(e is None or e.free_symbols & unknown for e in sides):
        return ()
    one, other = (factored(simplified(e)) for e in sides if e is not None)
    if longer(one, LONGEST) or longer(inertia, LONGEST) or one == acting or simplified(one - other) != 0:
        return ()
    told = line(f"{name}: ", *found.lead, " = ", phrases.math(acting), " = ", phrases.math(one))
    return told if inertia == 0 else line(*told, ", ", phrases.math(inertia), " = ", phrases.math(one))


def _zeros(instant: InstantSolution) -> dict[sp.Symbol, sp.Expr]:
    return {z: sp.S.Zero for stage in instant.stages for z in stage.zero}


def _closed(expr: sp.Expr, formulas: dict[sp.Symbol, sp.Expr]) -> sp.Expr | None:
    """In the letters of the file; None: it gets long."""
    for _ in range(DEEPEST):
        inside = {s: formulas[s] for s in expr.free_symbols if s in formulas}
        if not inside:
            return expr
        expr = expr.xreplace(inside)
        if longer(expr, 40 * LONGEST):
            return None
    return None
