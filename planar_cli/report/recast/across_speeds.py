"""The speed of what moves about a fixed point, at states at which it moves across the radius: r_1 v_1 = r_2 v_2 for
r_1² φ̇_1 = r_2² φ̇_2, where velocities are asked and no rates of angles.

At these states, among them the nearest and the farthest, r does not change: v = r φ̇.
(An Introduction to Planar Dynamics, 1.3, 3.3.)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from itertools import takewhile
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.values.ledger import Role
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.nodes.reading import listed
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Text, line
from planar_cli.report.document.said import letter_of
from planar_cli.report.kinematics.polar import POLAR
from planar_cli.report.words.state_words import place
from planar_cli.solve.between.trace.trace import ImpactEquation, MotionTrace, Result, RouteStep, RouteTrace
from planar_cli.solve.instant.roots import Root
from planar_cli.solve.solved_problem import PartSolution

ANGULAR = ("omega", "alpha", "theta", "dot", "ddot", "a")
"""What is asked in terms of angles and their rates."""
LONG = 60
"""A formula of more operations is not worked over."""

HALF = sp.Rational(1, 2)
OF_FILE = ("find", "quantity")
"""Fields that hold what the file says."""
Speeds = dict[sp.Symbol, tuple[sp.Symbol, sp.Symbol]]
"""By the rate of an angle at a state, the speed there and the radius."""


def with_across_speeds(part: PartSolution) -> PartSolution:
    """The part, with speeds in the telling of its motion."""
    motion = part.motion
    speeds = {} if motion is None else _speeds(motion)
    if motion is None or not speeds:
        return part
    numbers = {v: motion.value(turning) * motion.value(r) for turning, (v, r) in speeds.items()}
    put = _Put(speeds)
    told = replace(
        motion,
        value=motion.value.extended(numbers),
        unknowns=put.symbols(motion.unknowns),
        guessed=put.symbols(motion.guessed),
        general={put.symbol(s): g for s, g in motion.general.items()},
        route=put.route(motion.route, motion),
        requests=put.of(motion.requests),
        spans=put.of(motion.spans),
        unused=put.of(motion.unused),
        named=put.of(motion.named),
    )
    return replace(part, motion=told)


def across_meanings(motion: MotionTrace) -> dict[sp.Symbol, Line]:
    """What the speeds are: v_1, v_2: the speeds at 1 and 2, perpendicular to the radius there."""
    speeds = list(dict.fromkeys(v for v, _ in _speeds(motion).values()))
    letters = [p for v in speeds for p in (", ", Math(v))][1:]
    states = listed([place(str(motion.ledger.roles[v].at)).removeprefix("at ") for v in speeds], "and")
    plural = "s" if len(speeds) > 1 else ""
    told = line(*letters, f": the speed{plural} at {states}, perpendicular to the radius (", Name("r_dot"), " = 0)")
    return dict.fromkeys(speeds, told)


def without_polar_velocities(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks without v = ṙ e_r + r φ̇ e_φ, of which nothing is used where the speeds across the radius are told."""
    skipped: list[Block] = []
    for i, block in enumerate(blocks):
        own = [b for b in takewhile(lambda b: isinstance(b, Equation), blocks[i + 1 :]) if isinstance(b, Equation)]
        if isinstance(block, Paragraph) and any(isinstance(p, Text) and POLAR in p.text for p in block.line):
            skipped = [block, *own] if len(own) == 1 and letter_of(own[0].sides[0]).startswith("v") else []
        if not any(b is block for b in skipped):
            yield block


def _speeds(motion: MotionTrace) -> Speeds:
    """Of particles in polar coordinates, where r does not change at any state that the route speaks of."""
    relations = [e for step in motion.route.steps for e in step.relations]
    # A blow is told in velocities along x and y.
    if any(isinstance(e.source, ImpactEquation) for e in relations) or _asks_of_angles(motion):
        return {}
    found: Speeds = {}
    rates: set[str] = set()
    for regime in motion.regimes:
        scene = regime.solution.instant.scene
        alone = len(scene.bodies) == 1 and not any(f"v_{s}" in motion.ledger.symbols for s in motion.states)
        for edge in regime.solution.trial.system.tree.edges:
            own = edge.components
            if own is None or not own.turns:
                continue
            stem = "v" if alone else f"v_{centre_of(scene, edge.body)}"
            rates.add(f"{own.turns}_dot")
            for turning, general in motion.general.items():
                at = motion.ledger.roles[turning].at
                if general.name == f"{own.turns}_dot" and at is not None and not turning.name.startswith(stem):
                    found |= _at_state(motion, own.velocities, turning, at, f"{stem}__{at}")
    used = {s for e in relations for s in e.residual.free_symbols if s in motion.general}
    # Speeds at some states beside rates of angles at others would be two languages.
    return found if all(s in found for s in used if motion.general[s].name in rates) else {}


def _asks_of_angles(motion: MotionTrace) -> bool:
    asked = [q for f in motion.problem.find for q in walk(f.found.what)]
    turns = {c.name for c in motion.problem.coordinates}
    if any(isinstance(q, Letter) and q.name in turns for q in asked):
        return True
    return any(isinstance(q, Quantity) and q.word in ANGULAR for q in asked)


def _at_state(
    motion: MotionTrace, velocities: tuple[sp.Expr, sp.Expr], turning: sp.Symbol, at: str, name: str
) -> Speeds:
    """v = r φ̇ at one state, where ṙ is zero and φ̇ is not. `name`: of the speed."""
    here = {g: own for own, g in motion.general.items() if motion.ledger.roles[own].at == at}
    outward, across = (sp.sympify(v).xreplace(here) for v in velocities)
    radius, known = across / turning, motion.route.formulas
    radius = motion.route.plain.get(radius, radius)
    if known.get(outward, motion.route.plain.get(outward)) != 0 or not radius.is_Symbol or known.get(turning) == 0:
        return {}
    ledger, speed = motion.ledger, sp.Symbol(name, real=True)
    ledger.units[speed] = ledger.units[outward]
    ledger.roles[speed] = Role(ledger.roles[turning].kind, ledger.roles[turning].of, at)
    return {turning: (speed, radius)}


class _Put:
    """Puts speeds into what is said of a motion."""

    def __init__(self, speeds: Speeds) -> None:
        self.speeds = speeds
        self.formulas = {turning: v / r for turning, (v, r) in speeds.items()}

    def symbol(self, s: sp.Symbol) -> sp.Symbol:
        return self.speeds[s][0] if s in self.speeds else s

    def symbols(self, found: frozenset[sp.Symbol]) -> frozenset[sp.Symbol]:
        return frozenset(map(self.symbol, found))

    def of(self, told: Any) -> Any:
        """Records, tuples, mappings and expressions with the speeds in them."""
        if isinstance(told, sp.Basic):
            return told.xreplace(self.formulas)
        if isinstance(told, tuple):
            return tuple(map(self.of, told))
        if isinstance(told, Mapping):
            return {self.symbol(k) if isinstance(k, sp.Symbol) else k: self.of(v) for k, v in told.items()}
        if is_dataclass(told) and not isinstance(told, type):
            inside = [f.name for f in fields(told) if f.name not in OF_FILE]
            changed = {name: self.of(getattr(told, name)) for name in inside}
            same = all(new is getattr(told, name) for name, new in changed.items())
            return told if same else replace(told, **changed)
        return told

    def route(self, route: RouteTrace, motion: MotionTrace) -> RouteTrace:
        formulas = {self.symbol(s): self._worked(s, f) for s, f in route.formulas.items()}
        steps = tuple(self._step(step, motion) for step in route.steps)
        return replace(
            route, steps=steps, settled=self.symbols(route.settled), formulas=formulas, plain=self.of(route.plain)
        )

    def _step(self, step: RouteStep, motion: MotionTrace) -> RouteStep:
        return replace(
            step,
            relations=self.of(step.relations),
            unknowns=tuple(map(self.symbol, step.unknowns)),
            needs=self.symbols(step.needs),
            results=tuple(self._result(r, motion) for r in step.results),
        )

    def _result(self, result: Result, motion: MotionTrace) -> Result:
        if result.unknown not in self.speeds:
            return replace(result, formula=None if result.formula is None else self.of(result.formula))
        speed, radius = self.speeds[result.unknown]
        reach = motion.value(radius)
        formula = None if result.formula is None else self._worked(result.unknown, result.formula)
        roots = tuple(
            Root(None if x.expression is None else self._worked(result.unknown, x.expression), x.value * reach)
            for x in result.roots
        )
        return Result(speed, formula, result.value * reach, roots)

    def _worked(self, unknown: sp.Symbol, formula: sp.Expr) -> sp.Expr:
        """The formula of what takes the place of an unknown."""
        formula = sp.sympify(formula).xreplace(self.formulas)
        if unknown not in self.speeds:
            return formula
        radii = {r: sp.Dummy(r.name, positive=True) for _, r in self.speeds.values()}
        whole = (formula * self.speeds[unknown][1]).xreplace(radii)
        if not longer(whole, LONG):
            whole = whole.replace(lambda x: x.is_Pow and x.exp in (HALF, -HALF), lambda x: sp.factor(x.base) ** x.exp)
            whole = simplified(whole)
        return whole.xreplace({d: r for r, d in radii.items()})
