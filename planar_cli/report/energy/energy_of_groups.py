"""The kinetic energy of bodies that turn together about a fixed point while some slide along others, through it: that
of turning by their common moment of inertia, and that of sliding.

T_2 = 1/2 I_O,2 ω_2² + 1/2 m (v_A,rod,2² + v_B,rod,2²)
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import longer
from planar_cli.principles.base import Moving
from planar_cli.report.document.blocks import Block, Equation, Math, Name, line
from planar_cli.report.energy.energies import EnergyTelling
from planar_cli.report.energy.turning_groups import CLOSE, HALF, Turning
from planar_cli.report.notation.spread import spread
from planar_cli.report.words.words import Phrases

MOST_LETTERS = 44
SLIDES = Equation((line("v²"), line("(d ω)² + v_rel²")), None, (), line("of what slides"))
"""What slides through the point about which all turns has both velocities at right angles."""


def by_turning_and_sliding(
    blocks: Iterable[Block],
    names: tuple[str, str],
    parts: tuple[sp.Expr, Collection[sp.Symbol], Sequence[tuple[Moving, sp.Expr]]],
    group: Turning | None,
    phrases: Phrases,
) -> Iterator[Block]:
    """The lines of a balance of energies. `names`: of the kinetic energies at the beginning and at the end; `parts`:
    the last, the unknowns, and the bodies in letters of the end, each with the letter of its mass; `group`: what turns
    together at the end.
    """
    energy, unknowns, moving = parts
    whole = None if group is None else _whole(energy, unknowns, moving, group, phrases)
    first, last = (line(Name(n)) for n in names)
    held: list[Block] = []
    since = False
    for block in blocks:
        side = block.sides[0] if isinstance(block, Equation) else ()
        if whole is None or not since:
            yield block
        elif side == last and isinstance(block, Equation):
            yield SLIDES
            yield replace(block, sides=(side, Math(whole), block.sides[-1]))
            held, since = [], False
        else:
            held.append(block)
        since |= side == first
    yield from held


def balance_in_letters(telling: EnergyTelling, most: int) -> tuple[Math, ...]:
    """A balance by the letters in which its parts were told; empty: a part has none, or it gets long. `most`: how many
    operations a side has at most.
    """
    parts = telling.letters
    if None in parts.values():
        return ()
    right = [e for words, e in parts.items() if words.startswith("T of ") and e != 0]
    left = [e for words, e in parts.items() if not words.startswith("T of ") and e != 0]
    whole = [sp.Add(*(e for e in side if e is not None)) for side in (left, right)]
    if not left or any(longer(side, most) for side in whole) or sum(map(operations, whole)) > MOST_LETTERS:
        return ()
    return tuple(Math(spread(side)) for side in whole)


def _whole(
    energy: sp.Expr,
    unknowns: Collection[sp.Symbol],
    moving: Sequence[tuple[Moving, sp.Expr]],
    group: Turning,
    phrases: Phrases,
) -> sp.Expr | None:
    """The energy in letters; None: it has other parts, or a mass that slides has no letter."""
    speeds = sorted(energy.free_symbols & set(unknowns), key=lambda s: s.name)
    if not speeds or group.spin.free_symbols & set(speeds) or not energy.is_polynomial(*speeds):
        return None
    terms = sp.Poly(energy, *speeds).as_dict()
    turning = terms.pop((0,) * len(speeds), sp.S.Zero)
    squares = {tuple(2 * int(x == y) for y in speeds): x for x in speeds}
    told = phrases.value.extended(dict([group.inertia])).known(HALF * group.inertia[0] * group.spin**2)
    known = phrases.value.known(turning)
    if terms.keys() - squares.keys() or told is None or known is None or abs(told - known) > CLOSE * abs(known):
        return None
    by_mass: dict[sp.Expr, list[sp.Symbol]] = {}
    for powers, coefficient in sorted(terms.items(), reverse=True):
        speed = squares[powers]
        masses = [mass for m, mass in moving if speed in (m.vx**2 + m.vy**2).free_symbols]
        # Bodies of one mass are told by the first of them.
        alike = [next(one for one in masses if _same(one, mass, phrases)) for mass in masses]
        slides = sp.Add(*alike)
        if not all(mass.is_Symbol for mass in masses) or not _same(slides, 2 * coefficient, phrases):
            return None
        by_mass.setdefault(next((m for m in by_mass if _same(m, slides, phrases)), slides), []).append(speed)
    sliding = (HALF * mass * sp.Add(*(s**2 for s in own)) for mass, own in by_mass.items())
    return sp.Add(HALF * group.inertia[0] * group.spin**2, *sliding, evaluate=False)


def _same(mass: sp.Expr, other: sp.Expr, phrases: Phrases) -> bool:
    one, two = phrases.value.known(sp.sympify(mass)), phrases.value.known(sp.sympify(other))
    return one is not None and two is not None and one != 0 and abs(one - two) <= CLOSE * abs(one)
