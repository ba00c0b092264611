"""Sine and cosine of a given angle are exchanged."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import ClassVar, final

import sympy as sp

from planar_cli.homework.mistakes._one_equation import told
from planar_cli.homework.mistakes.base import Mistake, Model, with_step_changed
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import PURE

NOTHING = 1e-9
MOST = 30
"""Terms of a problem in which they are exchanged alone; in more a wrong number would too often fit one of them."""


def angles(equations: Equations) -> dict[str, sp.Symbol]:
    """The given angles."""
    found = {}
    for name, symbol in equations.inputs.items():
        unit = equations.units.get(symbol)
        if unit is not None and unit.angle and unit.dimension == PURE:
            found[name] = symbol
    return found


@final
class SineForCosine(Mistake):
    """Sine and cosine are exchanged.

    In the equations
        A given angle is 90° less itself, so that its sine and cosine change places: everywhere, or in one term of one
        equation, or of a formula by which something is told; one at a time, where there are thirty such terms at most.
    """

    kind: ClassVar[str] = "sine-for-cosine"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for name, symbol in angles(equations).items():
            said = f"sine and cosine of {printed(name)} are exchanged"
            yield Model(said, equations, {symbol: sp.pi / 2 - symbol})
            models = list(_in_one_term(equations, symbol, said))
            yield from models if 1 < len(models) <= MOST else ()


def _in_one_term(equations: Equations, angle: sp.Symbol, said: str) -> Iterator[Model]:
    for k, step in enumerate(equations.steps):
        for i, (kind, residual) in enumerate(zip(step.kinds, step.residuals, strict=False)):
            where = told(step, i) or "one place"
            for swap in _swaps(residual, angle) if kind not in ("given", "drawn") else ():
                changed = with_step_changed(equations, k, i, swap)
                if changed is not None:
                    yield Model(f"{said} in {where}", changed)
    for name, asked in equations.asked.items():
        for place, part in enumerate(asked.parts):
            for swap in _swaps(part, angle) if rests_on_angle(part, angle) else ():
                parts = tuple(swap(p) if j == place else p for j, p in enumerate(asked.parts))
                changed = replace(equations, asked={**equations.asked, name: replace(asked, parts=parts)})
                yield Model(f"{said} in one place", changed)


def rests_on_angle(expr: sp.Expr, angle: sp.Symbol) -> bool:
    """Is it another one with another angle? The size of a vector is the same whichever way it is written."""
    slope = sp.diff(expr, angle)
    numbers = {s: sp.Float(0.3 + 0.07 * k) for k, s in enumerate(sorted(slope.free_symbols, key=lambda s: s.name))}
    found = sp.N(slope.xreplace(numbers))
    return not found.is_number or bool(sp.Abs(found) > NOTHING)


def _swaps(expr: sp.Expr, angle: sp.Symbol) -> Iterator[Callable[[sp.Expr], sp.Expr]]:
    """For each term with a sine or cosine of the angle the change of this term alone."""
    terms = sp.Add.make_args(sp.expand(expr))
    for term in terms:
        other = term.xreplace({sp.sin(angle): sp.cos(angle), sp.cos(angle): sp.sin(angle)})
        if other != term:
            yield partial(_with, terms, term, other)


def _with(terms: Sequence[sp.Expr], term: sp.Expr, other: sp.Expr, _: sp.Expr) -> sp.Expr:
    """A sum with another term for one."""
    return sp.Add(*(other if t == term else t for t in terms))
