"""Reactions in words: a normal force and the sliding friction that follows it are one force, the total reaction."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.system import System
from planar_cli.report.blocks import Line, Math, line


def force_named(system: System, symbol: sp.Symbol) -> Line:
    """A reaction by its letter; where sliding friction has the same letter, the total reaction at its place."""
    name = next((n for n, s in system.symbols.items() if s == symbol), "")
    push = next((p for p in system.pushes if p.name == name), None)
    if push is not None and push.place and any(law.of == name for law in system.laws):
        return line(f"the total reaction at {push.place}")
    return (Math(symbol),)


def perpendicular(system: System, words: str) -> Line:
    """`across N_A` as a direction in words; other words as they are."""
    symbol = system.symbols.get(words.removeprefix("across ")) if words.startswith("across ") else None
    return line(words) if symbol is None else line("perpendicular to ", *force_named(system, symbol))
