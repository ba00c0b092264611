"""The modes of small oscillation of several freedoms: the linear parts, where their determinant vanishes, each mode."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Paragraph, Value, line
from planar_cli.report.in_numbers.put_in import Writer
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import Modes, OscillationTrace

LONG = 40
"""A formula of more operations is told by its number, if it has one."""
OMEGA = sp.Symbol("omega", positive=True)


def mode_blocks(
    found: OscillationTrace, modes: Modes, value: Valuation, phrases: Phrases, symbolic: bool
) -> Iterator[Block]:
    """How the modes are found. `symbolic`: letters remain, so that no numbers are printed."""
    if modes.matrix:
        yield from _linear_parts(found, modes, phrases, symbolic)
        yield from _determinant(modes, value, phrases, symbolic)
    for i in range(len(modes.frequencies)):
        yield from _mode(found, modes, i, value, phrases, symbolic)


def _indexed(name: str, i: int) -> sp.Symbol:
    return sp.Symbol(f"{name}_{i + 1}", positive=True)


def _linear_parts(found: OscillationTrace, modes: Modes, phrases: Phrases, symbolic: bool) -> Iterator[Block]:
    """δ̈_i = -Σ a_ij δ_j - Σ c_ij δ̇_j."""
    count = range(len(modes.matrix))
    small, rates = [_indexed("delta", i) for i in count], [sp.Symbol(f"delta_{i + 1}_ddot", real=True) for i in count]
    paces = [sp.Symbol(f"delta_{i + 1}_dot", real=True) for i in count]
    own = [line(phrases.math(r), " = ", phrases.math(rate)) for r, (rate, _) in zip(rates, found.motion, strict=True)]
    yield Paragraph(
        line("For small deviations ", *_listed([(phrases.math(s),) for s in small]), " with ", *_listed(own), ":")
    )
    for i, (rate, row) in enumerate(zip(rates, modes.matrix, strict=True)):
        damped = zip(modes.rates[i], paces, strict=True) if modes.rates else ()
        law = sp.Add(*(-a * s for a, s in (*zip(row, small, strict=True), *damped)))
        yield Equation((phrases.math(rate), _written(law, [*small, *paces], phrases, symbolic)))


def _listed(parts: Sequence[Line]) -> Line:
    return tuple(x for part in parts for x in line(", ", part))[1:]


def _written(expr: sp.Expr, letters: Sequence[sp.Symbol], phrases: Phrases, symbolic: bool) -> Math:
    """A formula; a long one with numbers for all but some letters."""
    if not symbolic and longer(expr, LONG):
        writer = Writer(letters, phrases)
        found = writer.written(expr)
        if found is not None:
            return Math(found, writer.texts)
    return phrases.math(expr)


def _determinant(modes: Modes, value: Valuation, phrases: Phrases, symbolic: bool) -> Iterator[Block]:
    """The characteristic equation in ω², in letters and in numbers."""
    amplitudes = _listed([(phrases.math(_indexed("A", i)),) for i in range(len(modes.matrix))])
    shares = "The dampers share the modes as the springs do, so that these are those without damping. " * bool(
        modes.rates
    )
    yield Paragraph(
        line(
            f"{shares}In a mode all deviations vary as cos ωt, with the amplitudes ",
            *amplitudes,
            ". These differ from zero only where the determinant of their coefficients vanishes:",
        )
    )
    if modes.polynomial:
        p, q = modes.polynomial
        if symbolic or not longer(p + q, LONG):
            sides: list[Inline | Line] = [_polynomial((p, q), phrases)]
            yield Equation((*sides, phrases.math(sp.S.Zero)))
    if not symbolic:
        square = sp.Symbol("square", positive=True)
        product = sp.Poly(sp.prod([square - value_of(w, value) ** 2 for w in modes.frequencies]), square)
        numbers = [sp.sympify(str(value(sp.Rational(str(c))))) for c in product.all_coeffs()]
        yield _in_numbers(numbers, phrases)


def value_of(expr: sp.Expr, value: Valuation) -> sp.Rational:
    """The number of a formula, as it is."""
    return sp.Rational(str(value(expr)))


def _polynomial(coefficients: tuple[sp.Expr, sp.Expr], phrases: Phrases) -> Line:
    """ω⁴ - p ω² + q, the highest power first."""
    p, q = coefficients
    return line(phrases.math(OMEGA**4), " - ", phrases.math(p * OMEGA**2), " + ", phrases.math(q))


def _in_numbers(coefficients: Sequence[sp.Expr], phrases: Phrases) -> Equation:
    """The polynomial in ω² with numbers, the highest power first; they alternate in sign, as all roots are positive."""
    degree = len(coefficients) - 1
    parts: list[Any] = [phrases.math(OMEGA ** (2 * degree))]
    for k, c in enumerate(coefficients[1:], 1):
        parts += [" - " if c < 0 else " + ", Value(abs(Decimal(str(c))), "", phrases.figures)]
        parts += [" ", phrases.math(OMEGA ** (2 * (degree - k)))] if k < degree else []
    return Equation((line(*parts), phrases.math(sp.S.Zero)), None, (), line("ω in rad/s"))


def _mode(
    found: OscillationTrace, modes: Modes, i: int, value: Valuation, phrases: Phrases, symbolic: bool
) -> Iterator[Block]:
    """One mode: its circular frequency, its period or frequency, and the ratio of the amplitudes."""
    omega, expr = _indexed("omega", i), modes.frequencies[i]
    if modes.rates:
        yield from _damped(modes, i, phrases)
    shown = () if symbolic else (Value(value(expr), "rad/s", phrases.figures),)
    formula: list[Math] = []
    if modes.squares and (symbolic or not longer(expr, LONG)):
        formula = [phrases.math(expr), *(phrases.substituted(expr, shown[0]) if shown else [])]
    yield Equation((phrases.math(omega), *formula, *shown))
    for word, name, of, unit in (
        ("period", "T", 2 * sp.pi / omega, "s"),
        ("frequency", "f", omega / (2 * sp.pi), "Hz"),
    ):
        if word in modes.words:
            told = of.xreplace({omega: expr})
            last = phrases.math(simplified(told)) if symbolic else Value(value(told), unit, phrases.figures)
            yield Equation((phrases.math(_indexed(name, i)), phrases.math(of), last))
    yield from _damping(modes, i, omega, value, phrases, symbolic)
    yield from _ratio(found, modes, i, value, phrases, symbolic)


def _damped(modes: Modes, i: int, phrases: Phrases) -> Iterator[Block]:
    """One mode of which damping changes nothing but the frequency: ω_0², c, and ω² = ω_0² - c²/4."""
    yield Equation((phrases.math(_indexed("omega_0", i) ** 2), phrases.math(modes.squares[i])))
    natural, damping = _indexed("omega_0", i), _indexed("c", i)
    yield Equation((phrases.math(damping), phrases.math(2 * modes.decays[i])))
    where = line("where ", phrases.math(damping), " < ", phrases.math(2 * natural))
    omega = phrases.math(sp.sqrt(natural**2 - damping**2 / 4))
    yield Equation((phrases.math(_indexed("omega", i)), omega), None, (), where)


def _damping(
    modes: Modes, i: int, omega: sp.Symbol, value: Valuation, phrases: Phrases, symbolic: bool
) -> Iterator[Block]:
    """Its logarithmic decrement and damping ratio, by the root λ = -β ± i ω or by c = 2 β."""
    if not modes.words & {"decrement", "damping_ratio"}:
        return
    beta, rate = _indexed("beta", i), modes.decays[i] if modes.decays else sp.S.Zero
    told = phrases.math(rate) if symbolic else Value(value(rate), "1/s", phrases.figures)
    yield Equation((phrases.math(beta), told), None, (), line("it dies away as e^(-β t)"))
    for word, name, of in (
        ("decrement", "delta", 2 * sp.pi * beta / omega),
        ("damping_ratio", "zeta", beta / sp.sqrt(beta**2 + omega**2)),
    ):
        if word in modes.words:
            number = simplified(of.xreplace({omega: modes.frequencies[i], beta: rate}))
            last = phrases.math(number) if symbolic else Value(value(number), "", phrases.figures)
            yield Equation((phrases.math(_indexed(name, i)), phrases.math(of), last))


def _ratio(
    found: OscillationTrace, modes: Modes, i: int, value: Valuation, phrases: Phrases, symbolic: bool
) -> Iterator[Block]:
    """A_2/A_1 = (ω² - a_11)/a_12 of two freedoms of one kind."""
    units = [phrases.ledger.units.get(rate) for rate, _ in found.motion]
    if not modes.squares or None in units or len({u.dimension for u in units if u is not None}) > 1:
        return
    (a, b), _ = modes.matrix
    if b == 0 or (not symbolic and value.is_zero(b)):
        return
    ratio = simplified((modes.squares[i] - a) / b)
    if symbolic and longer(ratio, LONG):
        return
    number = phrases.math(ratio) if symbolic else Value(value(ratio), "", phrases.figures)
    yield Equation((line(phrases.math(_indexed("A", 1)), "/", phrases.math(_indexed("A", 0))), number))
