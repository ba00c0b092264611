"""One trial step of DOP853 as generated code, for a number of components: written out, or as loops.

Written out, with every component a local variable, a step takes a third to two thirds of the time of one with loops;
compiling that takes as long as some 500 steps do, so many components begin with loops.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

from planar_cli.integrators._dop853_tableau import DENSE, ERROR_3, ERROR_5, NODES, STAGES
from planar_cli.integrators.base import Rates, Vector

LAST = 12
"""The stage whose state is the end of the step."""
KEPT = (0, 5, 6, 7, 8, 9, 10, 11)
"""The stages whose rates dense output needs."""
EXTRA = (13, 14, 15)
"""The stages that are evaluated for dense output alone."""

Kept = tuple[Vector, ...]
Trial = Callable[[Rates, float, Vector, Vector, float, Vector], tuple[Vector, float, float, Vector, Kept]]
"""(f, t, y, rates there, h, weights) to: the new state; the sums of squares of both errors, in parts of what is
allowed; the state of the last stage; the rates of KEPT."""


@cache
def written_out(n: int) -> Trial:
    """The trial step for n components, without loops."""
    return _compiled(_written_out(n))


@cache
def with_loops() -> Trial:
    """The trial step for any number of components."""
    return _compiled(_with_loops())


def dense_rates(f: Rates, t: float, y: Vector, h: float, kept: Kept, end: Vector) -> dict[int, Vector]:
    """The rates of all stages that dense output needs; three of them are evaluated here."""
    rates = dict(zip(KEPT, kept, strict=True))
    rates[LAST] = end
    for i in EXTRA:
        inner = _weighted(STAGES[i], rates, len(y))
        rates[i] = f(t + NODES[i] * h, [a + h * b for a, b in zip(y, inner, strict=True)])
    return rates


def dense_coefficients(rates: Mapping[int, Vector], h: float, y: Vector, new: Vector) -> list[Vector]:
    """The coefficients of dense output: y + x (F0 + (1 - x) (F1 + x (F2 + (1 - x) (F3 + …))))."""
    first = [b - a for a, b in zip(y, new, strict=True)]
    second = [h * k - d for k, d in zip(rates[0], first, strict=True)]
    third = [2.0 * d - h * (k + m) for d, k, m in zip(first, rates[0], rates[LAST], strict=True)]
    return [first, second, third, *([h * v for v in _weighted(row, rates, len(y))] for row in DENSE)]


def _weighted(weights: Mapping[int, float], rates: Mapping[int, Vector], n: int) -> Vector:
    total = [0.0] * n
    for stage, weight in weights.items():
        total = [a + weight * b for a, b in zip(total, rates[stage], strict=True)]
    return total


def _compiled(source: str) -> Trial:
    space: dict[str, Trial] = {}
    exec(compile(source, "<one trial step of dop853>", "exec"), {}, space)
    return space["trial"]


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
