"""Sines and cosines near an equilibrium, as they are linearised there: θ = 180° + δ, sin θ ≈ -δ."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.report.document.blocks import Line, Math, Text, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.oscillation_trace import OscillationTrace

DEVIATION = sp.Symbol("delta", real=True)
QUARTER, NEAR = 90, Decimal("1e-20")
"""An equilibrium is upright or level; so near to it, degrees."""


def at_rest_there(found: OscillationTrace, value: Valuation, phrases: Phrases) -> tuple[Line, Math, Line] | None:
    """`At θ = 180°:`, the equation of motion with it, and why that is an equilibrium; None where no angle stands in a
    sine, or it is at no quarter of a turn but the place from which it is counted.
    """
    place = _quarter_of(found, value)
    if place is None or not place[2] or found.damping != 0:
        return None
    law, angle, turns = place
    if not identically_zero(law.subs(angle, turns * sp.pi / 2)):
        return None
    texts = {angle: f"{turns * QUARTER}°"}
    return line("At ", phrases.math(angle), f" = {texts[angle]}:"), Math(law, texts), line("at rest, it stays there")


def near_equilibrium(found: OscillationTrace, value: Valuation, phrases: Phrases) -> Line:
    """`θ = 180° + δ, sin θ ≈ -δ`; empty where no angle stands in a sine, or it is at no quarter of a turn."""
    place = _quarter_of(found, value)
    if place is None:
        return ()
    law, angle, turns = place
    waves = [f for f in law.atoms(sp.sin, sp.cos) if f.args[0].is_Symbol]
    at = turns * sp.pi / 2
    degrees = f"{turns * QUARTER}°".replace("-", "-")
    told: list[Math | Text] = [
        phrases.math(angle),
        Text(f" = {degrees} + " if turns else " = "),
        phrases.math(DEVIATION),
    ]
    for wave in sorted(waves, key=str):
        slope = sp.diff(wave, angle).subs(angle, at)
        linear = wave.subs(angle, at) + slope * DEVIATION
        told += [Text(", "), phrases.math(wave), Text(" ≈ "), Math(linear)]
    return line(*told)


def _quarter_of(found: OscillationTrace, value: Valuation) -> tuple[sp.Expr, sp.Symbol, int] | None:
    """The one law, the one angle in its sines and cosines, and at which quarter of a turn it is."""
    if len(found.motion) != 1:
        return None
    ((_, law),) = found.motion
    angles = {f.args[0] for f in law.atoms(sp.sin, sp.cos) if f.args[0].is_Symbol}
    if len(angles) != 1:
        return None
    (angle,) = angles
    place = value.known(sp.Symbol(f"{angle.name}__{found.state}", real=True))
    if place is None:
        return None
    quarters = place * 180 / PI / QUARTER
    turns = int(quarters.to_integral_value())
    return None if abs(quarters - turns) > NEAR else (law, angle, turns)
