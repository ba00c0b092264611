"""The components a_r and a_θ of what a turning rod drives along a groove, in its diagram and in its equations.

a_r = r̈ - r ω² = -4.32 m/s²            a_θ = r α + 2 ṙ ω = 2.494 m/s²
can:  N_fork ↙,  N_wall ↘   =   m a_r ↖,  m a_θ ↙
↖ ΣF_r:   -N_wall sin ψ = m a_r         (An Introduction to Planar Dynamics, 1.5, 2.1)
"""

from __future__ import annotations

from copy import copy
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.notation.clean import is_clean
from planar_cli.solve.instant.algebra import Line, SolvedBlock
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.tangent_angle import radius_told
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import LENGTH, parse_unit

OUTWARD, ACROSS = sp.symbols("a_r a_theta", real=True)
COMPONENTS = (OUTWARD, ACROSS)


@record
class PolarParts:
    """The components of one particle: `ways`: e_r and e_θ; `sizes`: what a_r and a_θ are; `put`: what their letters
    stand in the place of, one rate by each.
    """

    body: str
    ways: tuple[Vec, Vec]
    sizes: tuple[sp.Expr, sp.Expr]
    put: dict[sp.Symbol, sp.Expr]

    def told(self, expr: sp.Expr) -> sp.Expr:
        """An expression in the letters of the components; the same where it is not made of both parts of one."""
        found = simplified(sp.expand(sp.sympify(expr).xreplace(self.put)))
        gone = set(self.put) | {s for size in self.sizes for s in size.free_symbols}
        return expr if found.free_symbols & gone else found


def with_polar_parts(part: PartSolution) -> PartSolution:
    """The part of one instant told so; the same where no groove guides what slides on a turning rod."""
    if part.motion is not None:
        return part
    instants = tuple(_instant(instant) for instant in part.instants)
    return part if instants == part.instants else replace(part, instants=instants)


def _instant(instant: InstantSolution) -> InstantSolution:
    ledger = instant.instant.scene.ledger
    radius = radius_told(instant.trial.system, instant.value)
    taken = {s.name for s in (*ledger.symbols.values(), *instant.trial.system.symbols.values())}
    # The letters are told with their numbers.
    if radius is None or ledger.letters or not is_clean(ledger, ledger.behind(radius), dimension=LENGTH):
        return instant
    if not instant.stages or taken & {s.name for s in COMPONENTS}:
        return instant
    *first, last = instant.stages
    edges = [e for e in instant.trial.system.tree.edges if e.slide_rate is not None and e.body in last.accelerations]
    known = len(edges) == 1 and _is_known(edges[0], instant)
    found = _parts(edges[0], radius, instant) if known else None
    if found is None:
        return instant
    told = _stage(last, found, instant)
    if told is last:
        return instant
    ledger.units.update(dict.fromkeys(COMPONENTS, parse_unit("m/s^2")))
    return replace(instant, stages=(*first, told), value=instant.value.extended(_numbers(found, instant)))


def _is_known(edge: Edge, instant: InstantSolution) -> bool:
    """Does the groove alone give ṙ and r̈, as where the rod is driven? Where forces do, a_r and a_θ are not known."""
    blocks = [b for stage in instant.stages for b in stage.blocks]
    given = {x.symbol for b in blocks if len(b.equations) == 1 and b.equations[0].law == "relation" for x in b.lines}
    return {edge.slide, edge.slide_rate} <= given


def _parts(edge: Edge, radius: sp.Expr, instant: InstantSolution) -> PolarParts | None:
    """None: what slides does not move outward with its letter, or the rod stands."""
    motion, value = instant.trial.system.motion, instant.value
    if motion is None or edge.slide is None or edge.slide_rate is None or edge.joining is None:
        return None
    spin, gain = motion.velocities[edge.parent].angular, motion.accelerations[edge.parent].angular
    at, path = edge.joining.point, edge.joining.path
    if path is None or value.is_zero(spin) or value(at.dot(path.tangent)) <= 0:
        return None
    gain = sp.S.Zero if value.is_zero(gain) else gain
    slide, rate = edge.slide, edge.slide_rate
    sizes = rate - radius * spin**2, radius * gain + 2 * slide * spin
    put = {rate: OUTWARD + radius * spin**2, slide: (ACROSS - radius * gain) / (2 * spin)}
    return PolarParts(edge.body, (path.tangent, path.tangent.turned()), sizes, put)


def _numbers(found: PolarParts, instant: InstantSolution) -> dict[sp.Symbol, sp.Expr]:
    return {letter: instant.value(size) for letter, size in zip(COMPONENTS, found.sizes, strict=True)}


def _stage(stage: Stage, found: PolarParts, instant: InstantSolution) -> Stage:
    algebra = copy(stage.algebra)
    algebra.value = algebra.value.extended(_numbers(found, instant))
    blocks = tuple(_block(b, found) for b in stage.blocks)
    told = [w for b in blocks for w in b.equations if w.law == "force" and found.body in w.bodies]
    if any(not w.right.free_symbols & set(COMPONENTS) for w in told if w.right != 0):
        return stage
    drawn = {**stage.accelerations, found.body: list(zip(found.ways, COMPONENTS, strict=True))}
    return replace(stage, blocks=blocks, algebra=algebra, accelerations=drawn)


def _block(block: SolvedBlock, found: PolarParts) -> SolvedBlock:
    own = tuple(_equation(w, found) for w in block.equations)
    if own == block.equations:
        return block
    return replace(block, equations=own, lines=tuple(_line(x, found) for x in block.lines))


def _equation(w: Written, found: PolarParts) -> Written:
    if w.law != "force" or w.bodies != (found.body,):
        return w
    right = found.told(w.right)
    lead = w.lead or _lead(w, found)
    return w if right == w.right else replace(w, right=right, lead=lead)


def _lead(w: Written, found: PolarParts) -> str:
    """r or θ, where a sum counts along e_r or e_θ."""
    for name, way in zip(("r", "theta"), found.ways, strict=True):
        if w.along is not None and all(sp.simplify(a - b) == 0 for a, b in zip(w.along, (way.x, way.y), strict=True)):
            return name
    return ""


def _line(x: Line, found: PolarParts) -> Line:
    return replace(x, formula=found.told(x.formula))
