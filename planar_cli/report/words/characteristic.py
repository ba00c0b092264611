"""The characteristic equation of a linear law of motion, with the stiffness and damping of this law in it."""

from __future__ import annotations

import re

import sympy as sp

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.document.blocks import Line, Math, Name, Text, line
from planar_cli.solve.law import Law

ROOT = sp.Symbol("lambda")
UNDAMPED, HARMONIC = "no damping", "simple harmonic motion"
_WHAT_IS_ZERO = re.compile(r", (?:c|ω²) [=<] 0")


def with_coefficients(words: str, law: Law | None, time: sp.Symbol) -> Line:
    """Words that name the general equation with that of the law: λ² + c λ/m + k/m = 0. What a force drives that varies
    in `time` is no simple harmonic motion.
    """
    before, found, after = words.partition(EQUATION)
    if not found or law is None or law.order != 2:
        return line(words)
    if law.vibration is not None:
        return line(_kind(before.partition(":")[0], time in law.f.free_symbols), _WHAT_IS_ZERO.sub("", after))
    q = law.coordinate.symbol
    damping, stiffness = -sp.diff(law.f, law.v), -sp.diff(law.f, q)
    if (damping + stiffness).free_symbols & {q, law.v}:
        return line(words)
    if before.startswith(UNDAMPED) and time not in law.f.free_symbols:
        square = line(Name("omega_0"), "² = ", Math(simplified(stiffness)))
        return line(f"{HARMONIC} with ", *square, _WHAT_IS_ZERO.sub("", after))
    before = before.replace("the roots 0 and -c of", "0 and another root of")
    terms = [*(ROOT * t for t in sp.Add.make_args(damping)), *sp.Add.make_args(stiffness)]
    return line(before, Math(ROOT**2), *map(_with_sign, terms), " = 0", _WHAT_IS_ZERO.sub("", after))


def linear_method(words: str, law: Law | None, time: sp.Symbol) -> str:
    """How a linear law is solved, as the head of a page names it: by what `with_coefficients` prints."""
    text = "".join(p.text for p in with_coefficients(words, law, time) if isinstance(p, Text))
    if text.startswith(HARMONIC):
        return "Simple harmonic motion."
    return "Linear equation of motion, solved by its characteristic equation."


def _kind(words: str, driven: bool) -> str:
    """How a law swings whose ω_n and ζ were told."""
    if words == UNDAMPED and not driven:
        return HARMONIC
    return words + {"under-damped": ", ζ < 1", "critically damped": ", ζ = 1", "over-damped": ", ζ > 1"}.get(words, "")


def _with_sign(term: sp.Expr) -> Line:
    if term == 0:
        return ()
    return line(" - ", Math(-term)) if term.could_extract_minus_sign() else line(" + ", Math(term))
