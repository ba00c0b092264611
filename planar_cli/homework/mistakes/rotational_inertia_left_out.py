"""A body that turns is treated as a particle: its moment of inertia is forgotten."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar, final

import sympy as sp

from planar_cli.equation.values.parts_of_accelerations import SPIN
from planar_cli.homework.mistakes.base import Mistake, Model, inputs_at
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.language.expression import Binary, Name, Negate
from planar_cli.problem.language.walk import walk
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.scene import Problem
from planar_cli.replay.equations import Equations
from planar_cli.units import INERTIA


@final
class RotationalInertiaLeftOut(Mistake):
    """The moment of inertia of a body is left out.

    In the equations
        The moment of inertia of a body is zero; one body at a time, or all that have the same letter. Where it stands
        only in the energy or momentum of a body, I ω²/2 and I ω are missing there.
    """

    kind: ClassVar[str] = "rotational-inertia-left-out"

    def models(self, equations: Equations, problem: Problem) -> Iterable[Model]:
        for symbol, title in inertias(equations):
            changed = replace(equations, defined={**equations.defined, symbol: sp.S.Zero})
            # Behind a comma stands how it was found.
            yield Model(f"this is the result without the {title.partition(', ')[0]}", changed)
        yield from _of_letters(equations, problem)
        finds = equations.rests_on(e for a in equations.asked.values() for e in a.parts)
        for name, symbol in equations.inputs.items():
            if name.startswith(SPIN) and symbol in finds:
                body = printed(name.removeprefix(f"{SPIN}_"))
                yield Model(
                    f"this is the result without the moment of inertia of {body}", equations, {symbol: sp.S.Zero}
                )


def _of_letters(equations: Equations, problem: Problem) -> Iterable[Model]:
    """A moment of inertia that is a given letter is zero for all bodies that have it: it stands in the equations as it
    is, and nothing is defined by it.
    """
    for name, symbol in inputs_at(equations, problem, "inertia").items():
        if equations.units.get(symbol) is None or equations.units[symbol].dimension != INERTIA:
            continue
        bodies = [b.name for b in problem.bodies if _has_letter(getattr(b, "inertia", None), name)]
        said = listed((printed(b) for b in bodies), "and")
        yield Model(f"this is the result without the moment of inertia of {said}", equations, {symbol: sp.S.Zero})


def _has_letter(side: object, name: str) -> bool:
    return isinstance(side, Name | Negate | Binary) and any(isinstance(p, Name) and p.name == name for p in walk(side))


def inertias(equations: Equations) -> Iterable[tuple[sp.Symbol, str]]:
    """The moments of inertia that are named in the equations, also in what I_O is made of, with their titles."""
    inside = set().union(*(r.free_symbols for s in equations.steps for r in s.residuals), set())
    waiting = list(inside)
    while waiting:
        more = sp.sympify(equations.defined.get(waiting.pop(), 0)).free_symbols - inside
        inside |= more
        waiting += more
    for symbol, title in equations.titles.items():
        unit = equations.units.get(symbol)
        if symbol in inside and symbol in equations.defined and unit is not None and unit.dimension == INERTIA:
            yield symbol, title
