"""A couple that is asked as what the moments on a body about its fixed axle lack: that of the motor that a `motion` of
the file stands for.

drum at one, moments about O, with the couple M_1 that drives it:
↺ ΣM_O:   M_1 - T_rope,one R = M k_O² α_one
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.system.led import turns_about_a_fixed_point
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Heading, Math, Name, Paragraph, Text, line
from planar_cli.report.equations.steps import KINETICS, is_ritual
from planar_cli.report.kinetics.forces import force_rows
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Request
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ENERGY

STATE = "__"
DRIVES = " that drives it:"
LONGEST = 24
"""A longer couple is told by its formula alone."""


def missing_couple(asked: Request, part: sp.Expr, found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The moments about the axle of the body that this couple drives; nothing where it is another quantity."""
    states = {s.name.partition(STATE)[2] for s in part.free_symbols if STATE in s.name}
    of_couple = asked.unit is not None and asked.unit.dimension == ENERGY and len(asked.parts) == 1
    if not of_couple or len(states) != 1 or longer(part, LONGEST) or not found.problem.motion:
        return
    for regime in found.regimes:
        system = regime.solution.trial.system
        for edge in system.tree.edges:
            if edge.joining is None or edge.spin_rate is None or not turns_about_a_fixed_point(system, edge.body):
                continue
            terms = sp.Add.make_args(part)
            alpha = [t for t in terms if any(s.name.partition(STATE)[0] == edge.spin_rate.name for s in t.free_symbols)]
            if len(alpha) != 1 or not _is_lacking(part, edge.body, edge.joining.point, system):
                continue
            own, others = sp.Symbol(asked.find.name, real=True), [t for t in terms if t not in alpha]
            left = phrases.math(sp.Add(own, *(-t for t in others), evaluate=False))
            place = edge.joining.place
            (state,) = states
            words = f"{edge.body} at {state}, moments about {place}, with the couple "
            yield Paragraph(line(words, Name(asked.find.name), DRIVES))
            yield from _diagram(regime.solution, edge.body, own, phrases)
            yield Equation((left, phrases.math(alpha[0])), None, line("↺ ", Name(f"ΣM_{place}"), ":"))
            return


def with_couples_among_forces(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part with such diagrams and moments at the end of the step of the forces, if there is one."""
    found = list(blocks)
    start = next((i for i, b in enumerate(blocks) if _is_headed_so(b)), None)
    step = next((i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text == KINETICS), None)
    if start is None or step is None or step > start:
        return found
    stop = next(i for i, b in enumerate(blocks) if i > start and isinstance(b, Equation)) + 1
    heads = (i for i, b in enumerate(blocks) if i > step and isinstance(b, Heading) and not is_ritual(b))
    end = next(heads, len(blocks))
    if end > start:
        return found
    return [*found[:end], *found[start:stop], *found[end:start], *found[stop:]]


def _is_headed_so(block: Block) -> bool:
    last = block.line[-1] if isinstance(block, Paragraph) and block.line else None
    return isinstance(last, Text) and last.text == DRIVES


def _diagram(solution: InstantSolution, body: str, couple: sp.Symbol, phrases: Phrases) -> Iterator[Block]:
    """The forces on the body, with this couple in the place of what drives it."""
    system = solution.trial.system
    stage = next((s for s in reversed(solution.stages) if s.level == "acceleration"), None)
    told = Phrases(solution.instant.scene.ledger, solution.value, phrases.figures, phrases.symbolic)
    rows = [] if stage is None else force_rows(solution, stage, told, inertia_as_force=False, bodies=(body,))
    for row in rows:
        left: list[Any] = []
        for piece in row.left:
            drives = isinstance(piece, Math) and piece.expr in _drives(system, body)
            left.append(Math(couple) if drives else piece)
        yield replace(row, left=tuple(p for p in left if p not in (Text(""), Text(" "))))


def _drives(system: System, body: str) -> list[sp.Symbol]:
    """The letters of what drives a body."""
    own = (p for p in system.pushes if p.kind == "drive" and any(a.body == body for a in p.actions))
    return [system.symbols[p.name] for p in own]


def _is_lacking(couple: sp.Expr, body: str, pivot: Vec, system: System) -> bool:
    """Does this couple balance the moments on a body about its axle, in any state?"""
    x, y, moment = body_residuals(system, body)
    rest = moment - (pivot.x * y - pivot.y * x)
    general = {s.name: s for s in rest.free_symbols}
    put = {s: general.get(s.name.partition(STATE)[0], s) for s in couple.free_symbols if STATE in s.name}
    drives = _drives(system, body)
    whole = (couple.xreplace(put) + rest.xreplace(dict.fromkeys(drives, sp.S.Zero))).xreplace(
        dict(system.scene.ledger.definitions)
    )
    return len(drives) == 1 and not longer(whole, 8 * LONGEST) and expanded(whole) == 0
