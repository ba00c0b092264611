"""Own vectors put into equations: where the components of a find stand in a later equation, the student's own do."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.replay.equations import Equations
from planar_cli.replay.numbers import Replay


def own_component(find: str, place: int) -> sp.Symbol:
    """The letter for a component of a student's own."""
    return sp.Symbol(f"own {find} {place}", real=True)


def with_own(replay: Replay, finds: Sequence[str]) -> Equations:
    """The equations with letters for the components of some finds, wherever these stand as they are asked. They are
    inputs, by their names. v_A + ω × r has the components of v_A as terms of its own; of a sum in another form nothing
    is put in.
    """
    equations, run = replay.equations, replay.run({})
    made, value, inputs = equations, dict(equations.value), dict(equations.inputs)
    for find in finds:
        for place, part in enumerate(equations.asked[find].parts):
            if part.is_Symbol or not part.free_symbols:
                continue
            letter = own_component(find, place)
            made = _put_in(made, find, part, letter)
            inputs[letter.name], value[letter] = letter, float(run.of(part)[0])
    return replace(made, inputs=inputs, value=value)


def own_inputs(equations: Equations, find: str, numbers: Sequence[float]) -> Mapping[sp.Symbol, float]:
    """The letters of a find with a student's numbers."""
    letters = (equations.inputs.get(own_component(find, k).name) for k in range(len(numbers)))
    return {letter: n for letter, n in zip(letters, numbers, strict=True) if letter is not None}


def _put_in(equations: Equations, find: str, part: sp.Expr, letter: sp.Symbol) -> Equations:
    def change(expr: sp.Expr) -> sp.Expr:
        return _replaced(sp.sympify(expr), part, letter)

    return replace(
        equations,
        steps=tuple(replace(s, residuals=tuple(map(change, s.residuals))) for s in equations.steps),
        defined={s: change(e) for s, e in equations.defined.items()},
        asked={
            n: a if n == find else replace(a, parts=tuple(map(change, a.parts))) for n, a in equations.asked.items()
        },
    )


def _replaced(expr: sp.Expr, part: sp.Expr, letter: sp.Symbol) -> sp.Expr:
    """An expression with a letter for a part, or for minus it, that stands among its terms or as a sum inside it."""
    expr = sp.sympify(expr.xreplace({part: letter}))
    terms = Counter(sp.Add.make_args(expr))
    for sign in (1, -1):
        wanted = Counter(sp.Add.make_args(sp.expand(sign * part)) if sign < 0 else sp.Add.make_args(part))
        if all(terms[t] >= count for t, count in wanted.items()):
            return sp.Add(*(terms - wanted).elements(), sign * letter)
    return expr
