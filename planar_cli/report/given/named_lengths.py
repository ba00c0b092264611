"""Lengths of springs and dampers that turn with a body, named once with their derivatives by its angle.

    AK = √(l² (1 - cos θ)² + (h + l sin θ)²)
    AK′ = d(AK)/dθ = (l² sin(θ) (1 - cos θ) + l cos(θ) (h + l sin θ))/AK
    pull of the spring coil:   F_coil = k (AK - h)
    ↺ ΣM_O:   -F_coil AK′ - F_dashpot DW′ = I_O α

By virtual work the moment of a pull F along a length L that depends on the angle alone is -F dL/dθ. It is told so only
where that is the factor of the pull in the equation that stood there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer
from planar_cli.problem.scene.acting import acting_loads
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution

LONG = 12
"""An arm of more operations is not seen through."""
PLACES = (0.31, 0.83)
"""Of the coordinate, in its base unit: two, as a root of a difference may vanish at one."""
SAME = 1e-9


@record
class Length:
    """The length between two points, one of which a body carries. `derivative`: by its angle."""

    letter: sp.Symbol
    slope: sp.Symbol
    parts: tuple[sp.Expr, sp.Expr]
    angle: sp.Symbol
    pull: sp.Symbol
    coefficient: sp.Expr | None
    """Of a damper, N s/m."""

    @property
    def root(self) -> sp.Expr:
        """The length by its parts along the axes."""
        x, y = self.parts
        return sp.sqrt(x**2 + y**2)

    @property
    def derivative(self) -> sp.Expr:
        """By the angle, with the length by its letter."""
        return sp.Add(*(part * sp.diff(part, self.angle) for part in self.parts)) / self.letter


def with_named_lengths(
    blocks: list[Block], motion: MotionTrace, instant: InstantSolution, phrases: Phrases
) -> list[Block]:
    """The blocks of a general position with such lengths by letters; as they are where no arm is long."""
    rooted = {s: i for i, b in enumerate(blocks) if (s := _pulled(b)) is not None}
    found = list(_lengths(motion, instant)) if rooted else []
    pulls = {x.pull: rooted[x.pull] for x in found if x.pull in rooted}
    moments = [i for i, b in enumerate(blocks) if isinstance(b, Equation) and b.number is not None and _holds(b, pulls)]
    if len(moments) != 1:
        return blocks
    (at,) = moments
    moment = blocks[at]
    assert isinstance(moment, Equation)
    left, right = (s.expr for s in moment.sides if isinstance(s, Math))
    found = [x for x in found if x.pull in pulls]
    arms = {x.pull: sp.expand(left - right).coeff(x.pull) for x in found}
    if not found or arms.keys() != {p for p in pulls if left.has(p)} or not any(longer(e, LONG) for e in arms.values()):
        return blocks
    if not all(_same(arms[x.pull], -sp.diff(x.root, x.angle), x.angle, phrases) for x in found):
        return blocks
    rest = left.xreplace({x.pull: sp.S.Zero for x in found})
    terms = [-x.pull * x.slope for x in found]
    sides = (Math(sp.Add(*terms, *([] if rest == 0 else [rest]), evaluate=False)), *moment.sides[1:])
    put = {pulls[x.pull]: _pull(blocks[pulls[x.pull]], x, phrases) for x in found}
    if not all(put.values()):
        return blocks
    put[at] = [replace(moment, sides=sides)]
    return [new for i, b in enumerate(blocks) for new in put.get(i, [b])]


def _pulled(b: Block) -> sp.Symbol | None:
    """The letter of the pull of a spring or damper that is told by a formula with a root; None of anything else."""
    if not isinstance(b, Equation) or not b.lead or len(b.sides) < 2:
        return None
    letter, formula = b.sides[:2]
    if not isinstance(letter, Math) or not isinstance(formula, Math) or not letter.expr.is_Symbol:
        return None
    roots = [p for p in formula.expr.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q == 2]
    return letter.expr if roots and formula.expr.has(sp.sin, sp.cos) else None


def _holds(b: Equation, pulls: dict[sp.Symbol, int]) -> bool:
    """Is it the equation, of two sides, on the left of which the pulls stand?"""
    exprs = [s.expr for s in b.sides if isinstance(s, Math)]
    if len(exprs) < 2 or len(b.sides) != 2:
        return False
    left, right = (e.free_symbols & pulls.keys() for e in exprs)
    return bool(left) and not right


def _lengths(motion: MotionTrace, instant: InstantSolution) -> Iterator[Length]:
    """Of the springs and dampers with one end that moves, where one angle places all."""
    scene, system = instant.instant.scene, instant.trial.system
    places = {law.coordinate.symbol for _, _, laws in motion.stretches for law in laws}
    angles = [s for s in places if scene.ledger.units[s].angle]
    if len(places) != 1 or not angles:
        return
    for load in acting_loads(motion.problem):
        ends: tuple[str, ...] = getattr(load, "between", ())
        own = next((w for w in system.wrenches if w.name == load.name and w.kind in ("spring", "damper")), None)
        moving = [p for p in ends if scene.owner(p) != GROUND]
        if own is None or len(ends) != 2 or len(moving) != 1 or not all(p.isalpha() and len(p) == 1 for p in ends):
            continue
        (fixed,) = (p for p in ends if p not in moving)
        reach = scene.points[moving[0]] - scene.points[fixed]
        name = f"{moving[0]}{fixed}"
        if name in scene.ledger.reserved:
            continue
        letter, slope = (sp.Symbol(n, positive=n == name) for n in (name, f"{name}′"))
        coefficient = getattr(load, "coefficient", None)
        damps = None if own.kind != "damper" or coefficient is None else scene.value(coefficient)
        parts = (_plain(reach.x), _plain(reach.y))
        yield Length(letter, slope, parts, angles[0], sp.sympify(own.magnitude), damps)


def _plain(part: sp.Expr) -> sp.Expr:
    """l (1 - cos θ) for l cos θ - l: but for its sign, which no length has."""
    whole = sp.sympify(part)
    found = min(factored(whole), whole, key=sp.count_ops)
    turned = [-f if f.is_Add and f.as_coeff_Add()[0].is_negative else f for f in sp.Mul.make_args(found)]
    return sp.Mul(*turned)


def _same(one: sp.Expr, other: sp.Expr, angle: sp.Symbol, phrases: Phrases) -> bool:
    """Are two formulas the same, with the numbers of all letters, at two places?"""
    numbers: dict[sp.Symbol, Any] = {}
    for s in (one.free_symbols | other.free_symbols) - {angle}:
        known = phrases.value.known(s)
        if known is None:
            return False
        numbers[s] = sp.Float(str(known))
    for place in PLACES:
        numbers[angle] = sp.Float(place)
        first, second = (complex(e.xreplace(numbers)) for e in (one, other))
        if abs(first - second) > SAME * (1 + abs(second)):
            return False
    return True


def _pull(b: Block, x: Length, phrases: Phrases) -> list[Block]:
    """The length, its derivative, and the pull by them; empty where the pull is another formula."""
    assert isinstance(b, Equation)
    formula = b.sides[1].expr if isinstance(b.sides[1], Math) else sp.S.Zero
    told = _by_letters(formula, x, phrases)
    if told is None:
        return []
    return [
        Equation((Math(x.letter), phrases.math(x.root))),
        Equation((Math(x.slope), line("d(", Math(x.letter), ")/d", Math(x.angle)), phrases.math(x.derivative))),
        replace(b, sides=(b.sides[0], phrases.math(told))),
    ]


def _by_letters(formula: sp.Expr, x: Length, phrases: Phrases) -> sp.Expr | None:
    """The pull of a spring by its length, or that of a damper by how fast this changes."""
    if x.coefficient is None:
        roots = [p for p in formula.atoms(sp.Pow) if p.exp == sp.S.Half and p.has(x.angle)]
        if len(roots) != 1 or not _same(roots[0], x.root, x.angle, phrases):
            return None
        told = formula.xreplace({roots[0]: x.letter})
        return None if told.has(x.angle) else told
    rates = [s for s in formula.free_symbols if s != x.angle and s not in phrases.ledger.values]
    if len(rates) != 1 or not _same(
        formula.coeff(rates[0]), x.coefficient * sp.diff(x.root, x.angle), x.angle, phrases
    ):
        return None
    return sp.Mul(x.coefficient, rates[0], x.slope, evaluate=False)
