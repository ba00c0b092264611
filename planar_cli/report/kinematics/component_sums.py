"""The components of v_A + ω × r and of a_A + α × r - ω² r with their numbers: [-1.307, -0.7546 + 0.6 (-11.32)]."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.kinematics.told import RATES, Told
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.units import LENGTH, Dimension

MOST_TERMS = 10
"""Two components with more terms together are read off the vectors."""

Power = tuple[Decimal, int]
"""A number inside a product, and how often it stands in it: the ω of ω². Numbers that are only equal stay apart."""

Term = tuple[int, tuple[Power, ...]]
"""A signed product of numbers."""

NOTHING = Decimal("1e-12")
"""A sum of which so little is left is zero: it is what the motion keeps."""


@record
class Turned:
    """What a point of a body has beside another: `base` its velocity or acceleration, `turn` ω or α, `arm` the vector
    to the point, `spin` the ω of - ω² r, zero of a velocity; all in the units of the page.
    """

    base: tuple[Decimal, Decimal]
    turn: Decimal
    arm: tuple[Decimal, Decimal]
    spin: Decimal

    def parts(self, axis: int) -> Iterator[Term]:
        """The terms along x (0) or y (1) that are not zero: sign and factors."""
        across, along = self.arm[1 - axis], self.arm[axis]
        if self.base[axis]:
            yield 1, ((self.base[axis], 1),)
        if self.turn and across:
            yield (-1 if axis == 0 else 1), ((across, 1), (self.turn, 1))
        if self.spin and along:
            yield -1, ((along, 1), (self.spin, 2))


def turned_with(told: Told, body: str, arm: Vec, level: str) -> Turned:
    """What the components of a point of a body, `arm` from the one at which it is joined, are made of."""
    velocity, certain = told.motion.velocities[body], told.phrases.certain
    own = velocity if level == "velocity" else told.motion.accelerations[body]
    spin = Decimal(0) if level == "velocity" else certain(velocity.angular)
    base, reach = in_page_units(own.linear, RATES[level], told), in_page_units(arm, LENGTH, told)
    return Turned(base, certain(own.angular), reach, spin)


def in_page_units(vector: Vec, dimension: Dimension, told: Told) -> tuple[Decimal, Decimal]:
    """The components of a known vector in the unit of the page."""
    phrases = told.phrases
    x, y = (phrases.of_dimension(phrases.certain(p), dimension).number for p in (vector.x, vector.y))
    return x, y


def components_told(turned: Turned, figures: int) -> Line:
    """Both components as sums; empty where each is one number, or they are too long."""
    return both_told([list(turned.parts(axis)) for axis in (0, 1)], figures)


def sliding_told(told: Told, edge: Edge, frame: str, arm: Vec, level: str) -> Line:
    """The same of what slides along a straight line of a body that turns: its rate along the line and, of an
    acceleration, 2 ω × v come to what the place on the line has, `arm` from where the `frame` is joined.
    """
    assert edge.joining is not None
    assert edge.joining.path is not None
    certain, tangent = told.phrases.certain, edge.joining.path.tangent
    carried, unit = turned_with(told, frame, arm, level), (certain(tangent.x), certain(tangent.y))
    speed, pace = (
        told.phrases.of_dimension(certain(s), RATES[n]).number if s is not None else Decimal(0)
        for s, n in ((edge.slide, "velocity"), (edge.slide_rate, "acceleration"))
    )
    along = speed if level == "velocity" else pace
    both: list[list[Term]] = []
    for axis in (0, 1):
        terms = [*carried.parts(axis), *along_unit(unit[axis], ((along, 1),))]
        if carried.spin and speed and unit[1 - axis]:
            factors = ((Decimal(2), 1), (carried.spin, 1), (speed, 1))
            terms += along_unit(unit[1 - axis], factors, -1 if axis == 0 else 1)
        both.append(terms)
    return both_told(both, told.phrases.figures)


def along_unit(component: Decimal, factors: tuple[Power, ...], sign: int = 1) -> Iterator[Term]:
    """What has a direction, by the component of its unit vector; nothing where either is zero."""
    if not component or not all(number for number, _ in factors):
        return
    if abs(component) == 1:
        yield sign * int(component), factors
    else:
        yield sign, ((component, 1), *factors)


def both_told(terms: Sequence[Sequence[Term]], figures: int) -> Line:
    """[x, y] of the `terms` along each axis; empty where each is one number, or they are too long."""
    if all(len(parts) == 0 or (len(parts) == 1 and len(parts[0][1]) == 1) for parts in terms):
        return ()
    if sum(map(len, terms)) > MOST_TERMS:
        return ()
    needed = [figures if not p or _is_nothing(p) else figures_of(numbers_of(p), worker(p), figures) for p in terms]
    sizes = [{abs(n) for n in numbers_of(parts)} for parts in terms]
    # A number of both components is spelled alike in both.
    both = dict.fromkeys(sizes[0] & sizes[1], max(needed))
    x, y = (sum_of_products(parts, figures, dict.fromkeys(sizes[i], needed[i]) | both) for i, parts in enumerate(terms))
    return line("[", x, ", ", y, "]")


def numbers_of(parts: Sequence[Term]) -> list[Decimal]:
    """The numbers of signed products, in their order."""
    return [n for _, factors in parts for n, _ in factors]


def worker(parts: Sequence[Term]) -> Callable[[Sequence[Decimal]], Decimal]:
    """What such products come to with other numbers."""

    def worked(values: Sequence[Decimal]) -> Decimal:
        left, total = list(values), Decimal(0)
        for sign, factors in parts:
            product = Decimal(sign)
            for _, power in factors:
                product *= left.pop(0) ** power
            total += product
        return total

    return worked


def _is_nothing(parts: Sequence[Term]) -> bool:
    numbers = numbers_of(parts)
    return abs(worker(parts)(numbers)) <= NOTHING * max(map(abs, numbers))


def sum_of_products(parts: Sequence[Term], figures: int, enough: Mapping[Decimal, int] | None = None) -> Math:
    """A sum of signed products of numbers, with as many figures as its result needs; `enough`: those of each number, by
    its size.
    """
    if not parts or _is_nothing(parts):
        return Math(sp.S.Zero)
    if enough is None:
        needed = figures_of(numbers_of(parts), worker(parts), figures)
        enough = {abs(n): needed for n in numbers_of(parts)}
    texts: dict[sp.Symbol, str] = {}
    terms: list[sp.Expr] = []
    for i, (sign, factors) in enumerate(parts):
        own: list[sp.Expr] = []
        for j, (number, power) in enumerate(factors):
            symbol = sp.Symbol(f"{NUMBER}{i}{j}", real=True)
            texts[symbol] = significant(number, enough[abs(number)])
            own.append(symbol**power)
        terms.append(sp.Mul(sign, *own, evaluate=False) if sign < 0 or len(own) > 1 else own[0])
    return Math(sp.Add(*terms, evaluate=False) if len(terms) > 1 else terms[0], texts)
