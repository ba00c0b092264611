"""One trial step of DOP853 as generated code, for a number of components: written out, or as loops.

Written out, with every component a local variable, a step takes a third to two thirds of the time of one with loops;
compiling that takes as long as some 500 steps do, so many components begin with loops.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from planar_cli.integrators._dop853_tableau import DENSE, ERROR_3, ERROR_5, NODES, STAGES
from planar_cli.integrators.base import Rates, Vector

LAST = 12
"""The stage whose state is the end of the step."""
KEPT = (0, 5, 6, 7, 8, 9, 10, 11)
"""The stages whose rates dense output needs."""
EXTRA = (13, 14, 15)
"""The stages that are evaluated for dense output alone."""

Kept = tuple[Vector, ...]
Coefficients = list[tuple[float, float, float, float, float, float, float]]
Dense = Callable[[Rates, float, Vector, float, Vector, Kept, Vector], Coefficients]
"""(f, t, y, h, new state, rates of KEPT, rates at the end) to F0 … F6 for each component: the solution a part x of the
step after its start is y + x (F0 + (1 - x) (F1 + x (F2 + (1 - x) (F3 + …))))."""
Trial = Callable[[Rates, float, Vector, Vector, float, Vector], tuple[Vector, float, float, Vector, Kept]]
"""(f, t, y, rates there, h, weights) to: the new state; the sums of squares of both errors, in parts of what is
allowed; the state of the last stage; the rates of KEPT."""


@cache
def written_out(n: int) -> Trial:
    """The trial step for n components, without loops."""
    found: Trial = _compiled(_written_out(n), "trial")
    return found


@cache
def with_loops() -> Trial:
    """The trial step for any number of components."""
    found: Trial = _compiled(_with_loops(), "trial")
    return found


@cache
def dense() -> Dense:
    """The coefficients of dense output, for any number of components."""
    found: Dense = _compiled(_dense(), "coefficients")
    return found


def _compiled(source: str, name: str) -> Any:
    space: dict[str, Any] = {}
    exec(compile(source, f"<dop853: {name}>", "exec"), {}, space)
    return space[name]


def _sum(weights: Mapping[int, float], suffix: str = "") -> str:
    return " + ".join(f"{w!r}*k{j}{suffix}" for j, w in weights.items())


_RETURN = f"    return new, e5, e3, last, ({', '.join(f'k{j}' for j in KEPT)})"


def _written_out(n: int) -> str:
    each = range(n)
    lines = ["def trial(f, t, y, k0, h, w):", _unpacked("y", n), _unpacked("k0", n), _unpacked("w", n)]
    for i in range(1, LAST + 1):
        row = STAGES[i]
        lines += [f"    c{j} = {a!r}*h" for j, a in row.items()]
        states = ", ".join(f"y_{m} + " + " + ".join(f"c{j}*k{j}_{m}" for j in row) for m in each)
        if i == LAST:
            lines.append(f"    new = [{states}]")
        elif i == LAST - 1:
            lines += [f"    last = [{states}]", f"    k{i} = f(t + h, last)", _unpacked(f"k{i}", n)]
        else:
            lines += [f"    k{i} = f(t + {NODES[i]!r}*h, [{states}])", _unpacked(f"k{i}", n)]
    for name, weights in (("e5", ERROR_5), ("e3", ERROR_3)):
        lines.append(f"    {name} = 0.0")
        for m in each:
            lines += [f"    d = ({_sum(weights, f'_{m}')})*w_{m}", f"    {name} += d*d"]
    return "\n".join([*lines, _RETURN])


def _unpacked(name: str, n: int) -> str:
    return f"    {', '.join(f'{name}_{m}' for m in range(n))}, = {name}"


def _with_loops() -> str:
    lines = ["def trial(f, t, y, k0, h, w):"]
    for i in range(1, LAST + 1):
        row = STAGES[i]
        names = ", ".join(f"k{j}" for j in row)
        items = ", ".join(f"a{j}" for j in row)
        total = " + ".join(f"{a!r}*a{j}" for j, a in row.items())
        states = f"[v + h*({total}) for v, {items} in zip(y, {names})]"
        if i == LAST:
            lines.append(f"    new = {states}")
        elif i == LAST - 1:
            lines += [f"    last = {states}", f"    k{i} = f(t + h, last)"]
        else:
            lines.append(f"    k{i} = f(t + {NODES[i]!r}*h, {states})")
    for name, weights in (("e5", ERROR_5), ("e3", ERROR_3)):
        names = ", ".join(f"k{j}" for j in weights)
        items = ", ".join(f"a{j}" for j in weights)
        total = " + ".join(f"{a!r}*a{j}" for j, a in weights.items())
        lines.append(f"    {name} = sum([(({total})*p)**2 for p, {items} in zip(w, {names})])")
    return "\n".join([*lines, _RETURN])


def _dense() -> str:
    """Three more stages, and the coefficients by their definition."""
    lines = ["def coefficients(f, t, y, h, new, kept, k12):", f"    {', '.join(f'k{j}' for j in KEPT)}, = kept"]
    for i in EXTRA:
        row = STAGES[i]
        names, items = ", ".join(f"k{j}" for j in row), ", ".join(f"a{j}" for j in row)
        total = " + ".join(f"{a!r}*a{j}" for j, a in row.items())
        lines.append(f"    k{i} = f(t + {NODES[i]!r}*h, [v + h*({total}) for v, {items} in zip(y, {names})])")
    every = (*KEPT, LAST, *EXTRA)
    names, items = ", ".join(f"k{j}" for j in every), ", ".join(f"a{j}" for j in every)
    higher = ", ".join("h*(" + " + ".join(f"{w!r}*a{j}" for j, w in row.items()) + ")" for row in DENSE)
    lines.append(f"    return [(d := b - v, h*a0 - d, 2.0*d - h*(a0 + a{LAST}), {higher})")
    lines.append(f"            for v, b, {items} in zip(y, new, {names})]")
    return "\n".join(lines)
