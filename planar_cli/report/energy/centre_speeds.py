"""Where the speed of a mass centre comes from that is no product: its place, and the rates of that.

x_G = -3/2 l cos θ,  y_G = 1/2 l sin θ
differentiated:   ẋ_G = 3/2 l θ̇ sin θ,  ẏ_G = 1/2 l θ̇ cos θ
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer
from planar_cli.principles.base import Moving
from planar_cli.report.document.blocks import Block, Equation, Line, Math, line
from planar_cli.report.words.words import Phrases

STATE = "__"
LONGEST = 12
"""A coordinate of more operations is not told."""


def centre_lines(
    made: Moving, name: str, rate: sp.Symbol, put: Callable[[sp.Expr], sp.Expr], phrases: Phrases
) -> Iterator[Block]:
    """The coordinates of a mass centre and their rates; nothing where they are long, or do not follow one angle or way
    alone. `name`: of its letters behind x and y, {} for the mark of a rate; `rate`: in which its speed is told.
    """
    places, speeds = [put(e) for e in made.place], [put(e) for e in (made.vx, made.vy)]
    if len(places) < 2 or any(longer(e, LONGEST) for e in (*places, *speeds)):
        return
    running = sorted((s for e in places for s in e.free_symbols), key=str)
    followed = [q for q in dict.fromkeys(running) if _follow(places, speeds, q, rate)]
    if not followed:
        return
    # At any place: what is at one place alone does not change.
    general = {s: sp.Symbol(s.name.partition(STATE)[0], real=True) for s in (*running, rate) if STATE in s.name}
    places, speeds = ([e.xreplace(general) for e in parts] for parts in (places, speeds))
    yield Equation(_pair(name.format(""), places, phrases))
    yield Equation(_pair(name.format("_dot"), speeds, phrases), None, line("differentiated:"))


def _follow(places: list[sp.Expr], speeds: list[sp.Expr], q: sp.Symbol, rate: sp.Symbol) -> bool:
    """Are the speeds the rates of the places, as q changes at the rate?"""
    return all(identically_zero(sp.diff(p, q) * rate - v) for p, v in zip(places, speeds, strict=True))


def _pair(name: str, parts: list[sp.Expr], phrases: Phrases) -> tuple[Math, Line]:
    """x = one,  y = other, as the sides of one line."""
    x, y = (Math(sp.Symbol(phrases.ledger.apart(f"{axis}_{name}"), real=True)) for axis in ("x", "y"))
    return x, line(phrases.math(parts[0]), ",  ", y, " = ", phrases.math(parts[1]))
