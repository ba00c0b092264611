"""The contract of the shelf of mistakes.

A mistake is what a student typically does wrong. A member is one file with one final class. From the equations of the
right solution it makes models in which one thing is changed, or from the right numbers those of a slip at the end; the
wrong answer follows by carrying the same equations out. Nothing is authored by hand for a problem.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field, replace
from typing import Any, ClassVar

import numpy as np
import sympy as sp

from planar_cli.equation.values.parts_of_accelerations import is_mark
from planar_cli.errors import PlanarError
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.sets.printed_names import printed_rate
from planar_cli.problem.language.expression import Binary, Name, Negate
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.replay.equations import Equations
from planar_cli.replay.opened import NotWritten
from planar_cli.units import Unit

GEOMETRY = frozenset({"relation", "given", "drawn", "link", "loop", "single"})
"""Kinds of equations in which no force stands."""
COEFFICIENTS = ("mu", "mu_s", "mu_k", "friction")
"""Keys of coefficients of friction."""
NOT_CARRIED_OUT = (ArithmeticError, PlanarError, NotWritten, KeyError, np.linalg.LinAlgError)
"""What a model comes to that has no numbers, as m g/N where the normal force is left out: it tells of no mistake."""


@record
class Model:
    """The equations with one thing changed. `inputs`: formulas that stand in place of given numbers; `start`: where
    unknowns with several roots are sought.
    """

    feedback: str
    """A sentence to the student."""
    equations: Equations
    inputs: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    start: Mapping[sp.Symbol, float] = field(default_factory=dict)

    @property
    def changes_data(self) -> bool:
        """Does another number stand in place of a given one, and not only a factor of a part of an acceleration?"""
        return any(not is_mark(symbol) for symbol in self.inputs)


class Mistake(ABC):
    """What every mistake has; the module's docstring is the contract."""

    kind: ClassVar[str]
    effect: ClassVar[str] = ""
    """What is left out where a motion is followed in numbers, as `planar simulate --without` calls it; "": nothing."""

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        """The equations with this mistake in them, once for each thing that it can be made with."""
        return ()

    def slips(self, expected: Expected) -> Iterable[tuple[str, tuple[float, ...]]]:
        """Wrong results that follow from the right one, with what to say."""
        return ()


# --- what members are made of ----------------------------------------------------------------------------------------


def with_changed(
    equations: Equations, change: Callable[[sp.Expr], sp.Expr], applies: Callable[[str], bool] = lambda kind: True
) -> Equations | None:
    """The equations with those residuals changed whose kind `applies`; None: nothing changes."""
    steps = []
    for step in equations.steps:
        kinds = step.kinds or ("",) * len(step.residuals)
        pairs = zip(step.residuals, kinds, strict=True)
        steps.append(replace(step, residuals=tuple(change(r) if applies(k) else r for r, k in pairs)))
    return None if tuple(steps) == equations.steps else equations.mapped(steps)


def with_step_changed(
    equations: Equations, step: int, residual: int, change: Callable[[sp.Expr], sp.Expr]
) -> Equations | None:
    """The equations with one residual of one step changed; None: it does not change."""
    steps = list(equations.steps)
    residuals = list(steps[step].residuals)
    before, residuals[residual] = residuals[residual], sp.sympify(change(residuals[residual]))
    steps[step] = replace(steps[step], residuals=tuple(residuals))
    return None if residuals[residual] == before else equations.mapped(steps)


def with_put_in(
    equations: Equations, values: Mapping[sp.Symbol, Any], applies: Callable[[str], bool] = lambda kind: True
) -> Equations | None:
    """The same with symbols replaced."""
    return with_changed(equations, lambda r: sp.sympify(r.xreplace(dict(values))), applies) if values else None


def has_forces(kind: str) -> bool:
    """Is an equation of this kind one of forces, moments, momenta or energies?"""
    return kind not in GEOMETRY


def named_in(problem: Problem, *keys: str, alone: bool = False) -> Iterator[str]:
    """The given names that stand at some keys of joints, loads, bodies and surfaces, each once. `alone`: not as a part
    of a formula.
    """
    shapes = (getattr(b, "shape", None) for b in (*problem.bodies, *problem.surfaces))
    found: dict[str, None] = {}
    for member in (*problem.joints, *problem.loads, *problem.bodies, *shapes):
        for key in keys:
            side = getattr(member, key, None)
            for part in walk(side) if isinstance(side, Name if alone else Name | Negate | Binary) else ():
                if isinstance(part, Name) and part.at is None:
                    found.setdefault(part.name)
    yield from found


def inputs_at(equations: Equations, problem: Problem, *keys: str, alone: bool = False) -> dict[str, sp.Symbol]:
    """The inputs that stand at some keys; `alone`: not as a part of a formula."""
    return {n: equations.inputs[n] for n in named_in(problem, *keys, alone=alone) if n in equations.inputs}


def inputs_by_unit(equations: Equations, is_meant: Callable[[Unit], bool]) -> Iterator[tuple[Unit, list[sp.Symbol]]]:
    """Each unit that is meant, with the inputs that are given in it."""
    found: dict[str, list[sp.Symbol]] = {}
    for symbol in equations.inputs.values():
        unit = equations.units.get(symbol)
        if unit is not None and is_meant(unit):
            found.setdefault(unit.text, []).append(symbol)
    yield from ((equations.units[symbols[0]], symbols) for symbols in found.values())


def terms_without(expr: sp.Expr, drops: Callable[[sp.Expr], bool]) -> sp.Expr:
    """A sum without some of its terms."""
    terms = sp.Add.make_args(sp.expand(expr))
    return sp.Add(*(t for t in terms if not drops(t)))


def without_part(equations: Equations, mark: str, feedback: str, of_one: Callable[[str, bool], str]) -> Iterator[Model]:
    """The equations without a part of the accelerations, where they have it; what was left out is zero on the page.
    Where several things turn or move, also without that of each of them alone: `of_one` tells it by the letter of its
    rate; does that turn?
    """
    symbol = equations.inputs.get(mark)
    if symbol is None:
        return
    # In a blow velocities change as accelerations do in a motion; nobody leaves a part of them out there.
    equations = with_put_in(equations, {symbol: sp.S.One}, lambda kind: kind == "blow") or equations
    finds = [e for a in equations.asked.values() for e in a.parts]
    if symbol not in equations.rests_on(finds):
        return
    yield Model(feedback, equations, {symbol: sp.S.Zero})
    if symbol in _inside(r for step in equations.steps for r in step.residuals) & _inside(finds):
        # In the forces it is right, in the acceleration that is asked it is forgotten.
        gone = {n: replace(a, parts=tuple(_zero(e, symbol) for e in a.parts)) for n, a in equations.asked.items()}
        yield Model(feedback, replace(equations, asked=gone))
    rates = {r for e in _formulas(equations) for r in _rates(equations, e, symbol)}
    if len(rates) < 2:
        return
    for rate in sorted(rates, key=lambda s: s.name):
        said = of_one(printed_rate(rate.name), equations.turns(rate))
        left = _without_rate(equations, symbol, rate)
        if symbol in _inside(_formulas(left)):
            yield Model(said, left)


def _inside(exprs: Iterable[sp.Expr]) -> set[sp.Symbol]:
    return set().union(*(e.free_symbols for e in exprs))


def _zero(expr: sp.Expr, mark: sp.Symbol) -> sp.Expr:
    return sp.sympify(expr.xreplace({mark: sp.S.Zero}))


def _formulas(equations: Equations) -> Iterator[sp.Expr]:
    yield from (r for step in equations.steps for r in step.residuals)
    yield from equations.defined.values()
    yield from (e for asked in equations.asked.values() for e in asked.parts)


def _rates(equations: Equations, expr: sp.Expr, mark: sp.Symbol) -> set[sp.Symbol]:
    """The rates, such as ω of ω² r, with which the marked terms in an expression are made, also inside its roots."""
    if mark not in expr.free_symbols:
        return set()
    term = sp.expand_mul(expr, deep=False)
    if not _has_factor(term, mark):
        return set().union(*(_rates(equations, a, mark) for a in term.args))
    return {s for s in term.free_symbols if _is_rate(equations, s)}


def _has_factor(term: sp.Expr, mark: sp.Symbol) -> bool:
    return term == mark or (term.is_Mul and any(f.as_base_exp()[0] == mark for f in term.args))


def _is_rate(equations: Equations, symbol: sp.Symbol) -> bool:
    """A velocity or an acceleration, of a point or of a rotation; g is none that moves."""
    unit = equations.units.get(symbol)
    if unit is None or symbol == equations.inputs.get("g"):
        return False
    return unit.dimension.mass == 0 and unit.dimension.length in (0, 1) and unit.dimension.time in (-1, -2)


def _without_rate(equations: Equations, mark: sp.Symbol, rate: sp.Symbol) -> Equations:
    """The equations without the marked terms that have one rate in them."""

    def change(expr: sp.Expr) -> sp.Expr:
        if not {mark, rate} <= expr.free_symbols:
            return expr
        term = sp.expand_mul(expr, deep=False)
        if _has_factor(term, mark):
            return sp.S.Zero
        return sp.sympify(term.func(*map(change, term.args)))

    return replace(
        equations,
        steps=tuple(replace(s, residuals=tuple(map(change, s.residuals))) for s in equations.steps),
        defined={s: change(e) for s, e in equations.defined.items()},
        asked={n: replace(a, parts=tuple(map(change, a.parts))) for n, a in equations.asked.items()},
    )
