"""Machine code of formulas: Python functions in which everything that occurs more than once is worked out once.

SymPy's `lambdify` writes a formula out as a tree. Formulas of coupled bodies are put together of parts, which stand in
them many times over: as a tree they are a hundred times as long, to write as well as to work out.
"""

from __future__ import annotations

import builtins
import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import parts_of

_WORDS = {sp.sin: "sin", sp.cos: "cos", sp.tan: "tan", sp.asin: "asin", sp.acos: "acos", sp.atan: "atan"}
_WORDS |= {sp.sinh: "sinh", sp.cosh: "cosh", sp.tanh: "tanh", sp.asinh: "asinh", sp.acosh: "acosh", sp.atanh: "atanh"}
_WORDS |= {sp.exp: "exp", sp.log: "log", sp.atan2: "atan2", sp.Abs: "abs", sp.Max: "max", sp.Min: "min"}
_SCOPE = {name: getattr(math, name, None) or getattr(builtins, name) for name in _WORDS.values()}
_SCOPE |= {"sqrt": math.sqrt, "pow": math.pow, "copysign": math.copysign, "inf": math.inf, "nan": math.nan}
_DEEPEST = 20
"""A part of more levels gets a line of its own."""


def compiled(
    exprs: Sequence[sp.Expr], letters: Sequence[sp.Symbol], number: Callable[[sp.Symbol], float] | None = None
) -> Callable[..., Sequence[float]]:
    """Machine numbers of formulas as a function of letters; `number` is that of each other symbol."""
    names = {s: f"x{i}" for i, s in enumerate(letters)}
    parts = list(parts_of(exprs))
    others = {p: 0.0 if number is None else number(p) for p in parts if p.is_Symbol and p not in names}
    if not all(map(_known, parts)):
        inside = {s: sp.Float(repr(x), 17) for s, x in others.items()}
        known: Callable[..., Sequence[float]] = sp.lambdify(
            list(letters), [e.xreplace(inside) for e in exprs], modules="math"
        )
        return known
    code = _Code({**names, **{s: f"({x!r})" for s, x in others.items()}})
    results = code.results(exprs, parts)
    body = [f"def made({', '.join(names.values())}):", *code.lines, f"return [{', '.join(results)}]"]
    scope: dict[str, Any] = dict(_SCOPE)
    exec(compile("\n    ".join(body), "<formulas>", "exec"), scope)
    own: Callable[..., Sequence[float]] = scope["made"]
    return own


def _known(part: sp.Basic) -> bool:
    """Can it be written down? A table or an integral is worked out where it is needed only, which SymPy sees to."""
    if part.is_Symbol or part.is_Add or part.is_Mul or part.is_Pow or part in (sp.pi, sp.E):
        return True
    return bool(part.is_Rational or part.is_Float) or part.func in _WORDS or part.func is sp.sign


class _Code:
    """Lines that work out formulas. `names`: what stands for the symbols."""

    def __init__(self, names: Mapping[sp.Symbol, str]) -> None:
        self.names = names
        self.lines: list[str] = []

    def results(self, exprs: Sequence[sp.Expr], order: Sequence[sp.Basic]) -> list[str]:
        """What stands for the formulas after the lines. `order`: their parts, those inside others first."""
        uses = Counter(a for part in order for a in part.args)
        uses.update(exprs)
        written: dict[sp.Basic, str] = {}
        depth: dict[sp.Basic, int] = {}
        for part in order:
            text = self._written(part, written)
            depth[part] = 1 + max((depth[a] for a in part.args), default=0)
            if part.args and not part.is_Rational and (uses[part] > 1 or depth[part] > _DEEPEST):
                name = f"v{len(self.lines)}"
                self.lines.append(f"{name} = {text}")
                text, depth[part] = name, 0
            written[part] = text
        return [written[e] for e in exprs]

    def _written(self, part: sp.Basic, written: Mapping[sp.Basic, str]) -> str:
        if part.is_Symbol:
            return self.names[part]
        if part.is_Number or part in (sp.pi, sp.E):
            return f"({float(part)!r})"
        inside = [written[a] for a in part.args]
        if part.is_Add:
            return f"({' + '.join(inside)})"
        if part.is_Mul:
            above = "*".join(written[a] for a in part.args if not _below(a)) or "1.0"
            below = "*".join(_power(written[a.base], -a.exp) for a in part.args if _below(a))
            return f"({above}/({below}))" if below else f"({above})"
        if part.is_Pow:
            return f"(1.0/{_power(inside[0], -part.exp)})" if _below(part) else _power(inside[0], part.exp, inside[1])
        if part.func is sp.sign:
            return f"({inside[0]} and copysign(1.0, {inside[0]}))"
        return f"{_WORDS[part.func]}({', '.join(inside)})"


def _below(factor: sp.Basic) -> bool:
    """Does a factor stand below the fraction stroke?"""
    return bool(factor.is_Pow and factor.exp.is_Rational and factor.exp < 0)


def _power(base: str, exponent: sp.Expr, written: str = "") -> str:
    if exponent == 1:
        return base
    if exponent == 2 and base.isidentifier():
        return f"({base}*{base})"
    if exponent == sp.Rational(1, 2):
        return f"sqrt({base})"
    return f"({base})**{int(exponent)}" if exponent.is_Integer else f"pow({base}, {written or repr(float(exponent))})"
