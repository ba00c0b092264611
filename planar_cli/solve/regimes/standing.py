"""What begins at rest in a stable equilibrium stays there until something takes hold of it: a ball that hangs still."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, identically_zero, replaced, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.regimes.equations import DATA, Equation, Laws
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop

WORDS = "it stays at rest in equilibrium"


def standing_equations(
    laws: Laws, since: Stop, stop: Stop, regime: Regime, begun: Mapping[sp.Symbol, sp.Expr]
) -> Iterator[Equation]:
    """Coordinates that stay as they are from one state to another. `begun`: what is known of letters of the first."""
    value = regime.general.value
    starts = {c.start: begun.get(since.letters[c.symbol], c.start) for c in regime.coordinates}
    for law in laws.laws:
        q = law.coordinate.symbol
        place, speed = since.letters[q], None if law.speed is None else law.speed
        if law.order != 2 or speed is None or place not in begun or begun.get(since.letters[speed]) != 0:
            continue
        if law.f.has(sp.Abs, sp.sign) or not _holds(replaced(law.f, starts), q, law.v, begun[place], value):
            continue
        family = ("stands", q.name, stop.name)
        yield Equation(stop.letters[q] - place, "link", WORDS, stop.name, since.name, family=(*family, "q"), rank=1)
        yield Equation(stop.letters[speed], "link", WORDS, stop.name, since.name, family=(*family, "v"), rank=1)


def standing_at(equations: Iterable[Equation], begun: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The letters of the later state that these tell, as the equilibrium may last over several states."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for e in equations:
        end, *more = e.residual.free_symbols - begun.keys() or (None,)
        if end is not None and not more:
            found[end] = (end - e.residual).xreplace(dict(begun))
    return found


def _holds(f: sp.Expr, q: sp.Symbol, v: sp.Symbol, place: sp.Expr, value: Valuation) -> bool:
    """Is f(q, v) zero at rest in this place, at all times, and does it drive back what leaves it?"""
    if not identically_zero(f.xreplace({v: sp.S.Zero, q: place})):
        return False
    stiffness = value.known(derivative(f, q).xreplace({v: sp.S.Zero, q: place}))
    return stiffness is not None and stiffness < 0


def begun_at(equations: Iterable[Equation], first: Stop) -> dict[sp.Symbol, sp.Expr]:
    """What the data of the first state say of its letters, one after the other."""
    letters = set(first.letters.values())
    data = [e.residual for e in equations if e.kind in DATA and e.stop == first.name]
    found: dict[sp.Symbol, sp.Expr] = {}
    grows = True
    while grows:
        grows = False
        for residual in (r.xreplace(found) for r in data):
            inside = residual.free_symbols & letters
            (letter, *more) = inside or (None,)
            rate = sp.S.Zero if letter is None or more else derivative(residual, letter)
            if letter is not None and rate != 0 and letter not in rate.free_symbols:
                found[letter] = simplified(letter - residual / rate)
                grows = True
    return found
