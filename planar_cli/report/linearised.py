"""Sines and cosines near an equilibrium, as they are linearised there: θ = 180° + δ, sin θ ≈ -δ."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import PI, Valuation
from planar_cli.report.blocks import Line, Math, Text, line
from planar_cli.report.words import Phrases
from planar_cli.solve.between.oscillation_trace import OscillationTrace

DEVIATION = sp.Symbol("delta", real=True)
QUARTER, NEAR = 90, Decimal("1e-20")
"""An equilibrium is upright or level; so near to it, degrees."""


def near_equilibrium(found: OscillationTrace, value: Valuation, phrases: Phrases) -> Line:
    """`θ = 180° + δ, sin θ ≈ -δ`; empty where no angle stands in a sine, or it is at no quarter of a turn."""
    if len(found.motion) != 1:
        return ()
    ((_, law),) = found.motion
    waves = [f for f in law.atoms(sp.sin, sp.cos) if f.args[0].is_Symbol]
    angles = {f.args[0] for f in waves}
    if len(angles) != 1:
        return ()
    (angle,) = angles
    place = value.known(sp.Symbol(f"{angle.name}__{found.state}", real=True))
    if place is None:
        return ()
    quarters = place * 180 / PI / QUARTER
    turns = int(quarters.to_integral_value())
    if abs(quarters - turns) > NEAR:
        return ()
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
