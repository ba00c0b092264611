"""Several freedoms that swing about one equilibrium: modes of small oscillation, each with a period of its own.

With s the small deviations, s̈ + A s = 0 with A = M⁻¹ K, and s = a cos ωt:

    det(A - ω² I) = 0        of two freedoms    ω² = (tr A ∓ √(tr² A - 4 det A))/2        T = 2π/ω

With damping, s̈ + C ṡ + A s = 0, ω is the imaginary part of a root λ of the characteristic equation. Where C = α I + β A
the modes are those without damping, each with a damping of its own:

    c = α + β ω_0²        ω = √(ω_0² - c²/4)        ζ = c/(2 ω_0)        δ = π c/ω

SI units; the longest period first.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TypeGuard

import mpmath
import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.equation.values.exact import DIGITS, Sample, Valuation
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.oscillation import SLOW, Oscillation, roots_of, stability
from planar_cli.solve.between.trace.oscillation_trace import Modes

LONGEST = 60
"""Of entries with more operations there is no formula that anybody reads."""


def of_modes(what: object, swings: Mapping[str, Oscillation]) -> TypeGuard[Quantity]:
    """Is a find a period, or what goes with one, about an equilibrium with several freedoms? Each mode answers it."""
    if not isinstance(what, Quantity) or what.word not in OF_SWINGS or what.things[0] not in swings:
        return False
    return not swings[what.things[0]].single


def demand_modes(found: Oscillation, q: Quantity, value: Valuation) -> None:
    """NoSolution: about this equilibrium not every mode oscillates, or letters leave the periods open."""
    state, count = found.stop.name, len(found.speeds)
    verdict = stability(found, value)
    if verdict.stable and has_formula(found, value):
        return
    entries = [e for rows in (found.stiffness, found.damping) for row in rows for e in row]
    open_ = isinstance(value, Sample) and value.drawn & set().union(*(e.free_symbols for e in entries))
    if verdict.stable and open_:
        text = f"the {count} freedoms about {state} have periods for which there is no short formula in letters"
        alike = "" if undamped(found) else "; in letters two modes need dampers that share them as the springs do"
        raise _none(q, text, f"give numbers for the letters{alike}")
    told = () if open_ or verdict.kind == "unstable" else _from_roots(found, value)
    if not verdict.stable or len(told) < count:
        why = "the damping is too strong" if verdict.stable else f"it is {verdict.kind}"
        text = f"not every one of the {count} freedoms oscillates about {state}: {why}"
        periods = ", ".join(f"{mpmath.nstr(2 * mpmath.pi / mpmath.mpf(str(w)), 6)} s" for w in map(value, told))
        raise _none(q, text + (f"; the periods are: {periods}" if periods else ""))


def _none(q: Quantity, text: str, hint: str = "ask `stable(…)` instead") -> NoSolution:
    return NoSolution([Diagnostic(q.mark, "PL632", text, hint)])


def circular_frequencies(found: Oscillation, value: Valuation) -> tuple[sp.Expr, ...]:
    """ω of every mode [rad/s], the lowest first: formulas of two freedoms, else numbers."""
    if has_formula(found, value):
        modes = zip(squares_of_two(found), dampings_of_two(found) or (), strict=True)
        return tuple(sp.sqrt(square if c == 0 else sp.factor_terms(square - c**2 / 4)) for square, c in modes)
    return _from_roots(found, value)


def _from_roots(found: Oscillation, value: Valuation) -> tuple[sp.Expr, ...]:
    """The same as numbers, of the modes that oscillate."""
    with mpmath.workdps(DIGITS):
        return tuple(sp.Rational(str(r.imag)) for r in _swinging(found, value))


def _swinging(found: Oscillation, value: Valuation) -> list[mpmath.mpc]:
    """The roots λ with a positive imaginary part, of the modes that oscillate, the slowest first."""
    roots = roots_of(found, value)
    size = max(abs(r) for r in roots)
    return [r for r in roots if r.imag > SLOW * size]


def has_formula(found: Oscillation, value: Valuation) -> bool:
    """Is there a formula of the roots? With damping it is looked for where letters have no numbers."""
    entries = sp.Add(*(e for row in found.stiffness for e in row), evaluate=False)
    if len(found.speeds) != 2 or longer(entries, LONGEST):
        return False
    return undamped(found) or (isinstance(value, Sample) and dampings_of_two(found) is not None)


def undamped(found: Oscillation) -> bool:
    return all(c == 0 for row in found.damping for c in row)


def coefficients_of_two(found: Oscillation) -> tuple[sp.Expr, sp.Expr]:
    """p and q of the characteristic equation ω⁴ - p ω² + q = 0."""
    (a, b), (c, d) = found.stiffness
    return sp.factor(simplified(a + d)), sp.factor(simplified(a * d - b * c))


def squares_of_two(found: Oscillation) -> tuple[sp.Expr, sp.Expr]:
    """The roots ω² of that, the smaller one first."""
    p, q = coefficients_of_two(found)
    root = sp.sqrt(sp.factor(simplified(p**2 - 4 * q)))
    low, high = (sp.factor_terms(sp.together(sp.expand((p + sign * root) / 2))) for sign in (-1, 1))
    return low, high


def dampings_of_two(found: Oscillation) -> tuple[sp.Expr, sp.Expr] | None:
    """c of both modes [1/s], the slower one first, where damping leaves the modes as they are; None: it does not."""
    if undamped(found):
        return sp.S.Zero, sp.S.Zero
    (a, b), (c, d) = found.stiffness
    damping = found.damping
    pairs = ((damping[0][1], b), (damping[1][0], c), (damping[0][0] - damping[1][1], a - d))
    factor = next((simplified(x / y) for x, y in pairs if not identically_zero(y)), sp.S.Zero)
    alone = simplified(damping[0][0] - factor * a)
    entries = ((i, j, alone if i == j else sp.S.Zero) for i in range(2) for j in range(2))
    if not all(identically_zero(damping[i][j] - factor * found.stiffness[i][j] - own) for i, j, own in entries):
        return None
    low, high = (sp.factor_terms(simplified(alone + factor * square)) for square in squares_of_two(found))
    return low, high


def decays(found: Oscillation, value: Valuation) -> tuple[sp.Expr, ...]:
    """c/2 of every mode [1/s], in their order: deviations die away as e^(-c t/2)."""
    if has_formula(found, value):
        return tuple(c / 2 for c in dampings_of_two(found) or ())
    with mpmath.workdps(DIGITS):
        return tuple(sp.Rational(str(-r.real)) for r in _swinging(found, value))


def mode_sizes(found: Oscillation, word: str, value: Valuation) -> tuple[sp.Expr, ...]:
    """The periods [s], the longest first, or the frequencies [Hz], the lowest first; in the same order what goes with
    the damping.
    """
    omegas = circular_frequencies(found, value)
    if word not in ("period", "frequency"):
        pairs = list(zip(decays(found, value), omegas, strict=True))
        if word == "decrement":
            return tuple(2 * sp.pi * rate / w for rate, w in pairs)
        if has_formula(found, value):
            return tuple(rate / sp.sqrt(w2) for (rate, _), w2 in zip(pairs, squares_of_two(found), strict=True))
        return tuple(rate / sp.sqrt(rate**2 + w**2) for rate, w in pairs)
    return tuple(2 * sp.pi / w if word == "period" else w / (2 * sp.pi) for w in omegas)


def modes_told(found: Oscillation, finds: Iterable[AskedFind], value: Valuation) -> Modes | None:
    """The modes for the page; None: their periods or frequencies are not asked. `found`: its place put in."""
    words = set()
    for find in finds:
        what = find.find.found.what
        if of_modes(what, {found.stop.name: found}):
            words.add(what.word if find.factor == 1 else "circular")
    if not words:
        return None
    formula = has_formula(found, value)
    return Modes(
        matrix=found.stiffness if formula or undamped(found) else (),
        rates=found.damping if formula and not undamped(found) else (),
        decays=() if undamped(found) else decays(found, value),
        polynomial=coefficients_of_two(found) if formula else (),
        squares=squares_of_two(found) if formula else (),
        frequencies=circular_frequencies(found, value),
        words=frozenset(words),
    )
