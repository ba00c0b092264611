"""The angular momentum of bodies that turn together about a fixed point while some move along others: by the moment of
inertia of them all, at both states.

    A and B each have the momentum m_A d ω across the line to O and m_A v_rel along it, which has no moment about O.
    2 m_A d_A,1² ω_1 + (I_rod + 2 I_A) ω_1 = 2 m_A d_A,2² ω_2 + (I_rod + 2 I_A) ω_2
    I_O,1 = I_rod + 2 I_A + 2 m_A d_A,1²,   I_O,1 ω_1 = I_O,2 ω_2      d: distances from O

What moves along a line through the point has no other part of it. (An Introduction to Planar Dynamics, 4.4.)
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.principles.base import Moving
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, line
from planar_cli.report.energy.energy_pieces import STATE
from planar_cli.report.kinematics.component_sums import Term, sum_of_products
from planar_cli.report.notation.ordering import term_key
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import BalanceTrace
from planar_cli.units import INERTIA, LENGTH, MASS

HALF = sp.Rational(1, 2)
CLOSE = Decimal("1e-12")


@record
class Share:
    """What one body has of the moment of inertia: its own and m d², as numbers in base units and in letters."""

    body: str
    own: tuple[sp.Expr, Decimal]
    mass: tuple[sp.Expr, Decimal]
    arm: tuple[sp.Symbol, Decimal]

    @property
    def whole(self) -> Decimal:
        return self.own[1] + self.mass[1] * self.arm[1] ** 2


@record
class Turning:
    """Bodies that turn together at one state: the line of their moment of inertia, that with its number, their rate,
    and what each has of it.
    """

    line: Equation
    inertia: tuple[sp.Symbol, Decimal]
    spin: sp.Expr
    shares: tuple[Share, ...]

    @property
    def momentum(self) -> Math:
        """I ω."""
        return Math(self.inertia[0] * self.spin)

    @property
    def moments(self) -> Math:
        """The same part by part: the moments of the momenta m d ω, then what turns: 2 m_A d_A² ω + (I_0 + 2 I_A) ω."""
        orbits, own = list[sp.Expr](), list[sp.Expr]()
        for count, one in _counted(self.shares):
            if one.mass[1] and one.arm[1]:
                orbits.append(count * one.mass[0] * one.arm[0] ** 2 * self.spin)
            if one.own[1]:
                own.append(count * one.own[0])
        return Math(sp.Add(*orbits, sp.Add(*own) * self.spin, evaluate=False))


def group_lines(group: tuple[Turning, Turning], number: int, lead: Line, about: str) -> Iterator[Block]:
    """The balance of angular momenta of a group about a point, part by part, then by its moments of inertia."""
    first, last = group
    pairs = zip(first.shares, last.shares, strict=True)
    sliding = tuple(s for s, later in pairs if s.mass[1] and abs(s.arm[1] - later.arm[1]) > CLOSE * s.arm[1])
    if not sliding or not all(s.mass[0].is_Symbol for s in sliding):
        yield from (t.line for t in group)
        yield Equation(tuple(t.momentum for t in group), number, lead)
        return
    for count, one in _counted(sliding):
        names = [s.body for s in sliding if _numbers_of(s) == _numbers_of(one)]
        has = f"{', '.join(names[:-1])} and {names[-1]} each have" if count > 1 else f"{one.body} has"
        mass, words = Math(one.mass[0]), f" v_rel along it, which has no moment about {about}."
        yield Paragraph(line(f"{has} the momentum ", mass, f" d ω across the line to {about} and ", mass, words))
    yield Equation(tuple(t.moments for t in group), number, lead)
    yield from (t.line for t in group)
    yield Equation(tuple(t.momentum for t in group), None, line("collected:"))


def _numbers_of(share: Share) -> tuple[Decimal, Decimal, Decimal]:
    return share.own[1], share.mass[1], share.arm[1]


def _counted(shares: Sequence[Share]) -> Iterator[tuple[int, Share]]:
    """Equal bodies once, with their number."""
    for numbers in dict.fromkeys(map(_numbers_of, shares)):
        alike = [s for s in shares if _numbers_of(s) == numbers]
        yield len(alike), alike[0]


def by_group(
    blocks: Iterable[Block], name: str, energy: sp.Expr, group: Turning | None, phrases: Phrases
) -> Iterator[Block]:
    """The lines of a balance of energies, with the kinetic energy of that name by the moment of inertia of a group that
    has no other: T_1 = 1/2 I_O,1 ω².
    """
    whole = None if group is None else HALF * group.inertia[0] * group.spin**2
    for block in blocks:
        own = isinstance(block, Equation) and block.sides[0] == line(Name(name)) and len(block.sides) > 2
        if group is None or whole is None or not own or not isinstance(block, Equation):
            yield block
            continue
        value = phrases.value.extended(dict([group.inertia]))
        told, known = value.known(whole), phrases.value.known(energy)
        put = phrases.numbers(whole, {**dict([group.inertia]), **_numbers(group.spin, phrases)})
        if told is None or known is None or put is None or abs(told - known) > CLOSE * abs(known):
            yield block
        else:
            yield replace(block, sides=(block.sides[0], Math(whole), put, block.sides[-1]))


def _numbers(expr: sp.Expr, phrases: Phrases) -> dict[sp.Symbol, Decimal]:
    known = {s: phrases.value.known(s) for s in expr.free_symbols}
    return {s: n for s, n in known.items() if n is not None}


def turning_group(
    b: BalanceTrace, phrases: Phrases, put: Callable[[sp.Expr], sp.Expr]
) -> tuple[Turning, Turning] | None:
    """The group at the beginning and at the end of a balance; None: one body turns alone, they turn apart, or something
    is not known. `put`: puts in the data of a route.
    """
    if b.parts is None or not b.law.about or len(b.parts.moving) < 2 or phrases.symbolic or b.gain != 0:
        return None
    spins = {m.omega for m in b.parts.moving if m.omega != 0}
    (spin,) = spins if len(spins) == 1 else (sp.S.Zero,)
    ending = f"{STATE}{b.stop}"
    if not isinstance(spin, sp.Symbol) or not spin.name.endswith(ending):
        return None
    back = {
        s: next((x for x in b.before.free_symbols if x.name == s.name.removesuffix(ending) + f"{STATE}{b.since}"), None)
        for m in b.parts.moving
        for e in (m.omega, *m.place)
        for s in sp.sympify(e).free_symbols
        if s.name.endswith(ending)
    }
    earlier = {s: x for s, x in back.items() if x is not None}
    if spin not in earlier:
        return None
    found: list[Turning] = []
    for state, amount, turned in ((b.since, b.before, earlier), (b.stop, b.after, {})):
        pairs = zip(b.parts.moving, b.law.moving, strict=True)
        shares = [_share(m, general, turned, f"{STATE}{state}", phrases, put) for m, general in pairs]
        known = [s for s in shares if s is not None]
        whole = phrases.value.known(put(simplified(amount / spin.xreplace(turned))))
        total = sum((s.whole for s in known), Decimal(0))
        if len(known) < len(shares) or whole is None or abs(total - whole) > CLOSE * abs(whole):
            return None
        name = sp.Symbol(f"I_{b.law.about}{STATE}{state}", positive=True)
        told = _line(name, known, phrases, "" if found else b.law.about)
        found.append(Turning(told, (name, whole), put(spin.xreplace(turned)), tuple(known)))
    return found[0], found[1]


def _share(
    m: Moving,
    general: Moving,
    turned: dict[sp.Symbol, sp.Symbol],
    ending: str,
    phrases: Phrases,
    put: Callable[[sp.Expr], sp.Expr],
) -> Share | None:
    x, y = (sp.sympify(p) for p in m.place)
    square = put(simplified(x**2 + y**2).xreplace(turned))
    numbers = [phrases.value.known(put(sp.sympify(e))) for e in (m.inertia, m.mass)]
    reach = phrases.value.known(square)
    if None in numbers or reach is None or reach < 0:
        return None
    own, mass = (n or Decimal(0) for n in numbers)
    fixed = (x, y) == (0, 0)
    letter = sp.Symbol(f"d_{m.center or m.body}{ending}", positive=True)
    return Share(
        m.center or m.body,
        (sp.sympify(general.inertia), own),
        (sp.S.Zero if fixed else sp.sympify(general.mass), Decimal(0) if fixed else mass),
        (letter, reach.sqrt()),
    )


def _line(name: sp.Symbol, shares: Sequence[Share], phrases: Phrases, about: str) -> Equation:
    """I_O,1 = letters = numbers = value; equal bodies once, with their number. `about`: the point, where it is told
    that d is the distance from there.
    """
    letters: list[sp.Expr] = []
    terms: list[Term] = []
    for count, one in _counted(shares):
        times = ((Decimal(count), 1),) if count > 1 else ()
        shown = phrases.of_dimension(one.own[1], INERTIA).number
        if one.own[1]:
            letters.append(count * one.own[0])
            terms.append((1, (*times, (shown, 1))))
        if one.mass[1] and one.arm[1]:
            letters.append(count * one.mass[0] * one.arm[0] ** 2)
            mass, arm = phrases.of_dimension(one.mass[1], MASS), phrases.of_dimension(one.arm[1], LENGTH)
            terms.append((1, (*times, (mass.number, 1), (arm.number, 2))))
    whole = phrases.of_dimension(sum((s.whole for s in shares), Decimal(0)), INERTIA)
    order = sorted(range(len(letters)), key=lambda i: term_key(letters[i]))
    letters, terms = [letters[i] for i in order], [terms[i] for i in order]
    sides = (line(Name(name.name)), Math(sp.Add(*letters)), sum_of_products(terms, phrases.figures), whole)
    return Equation(sides, None, note=line(f"d: distance from {about}") if about else ())
