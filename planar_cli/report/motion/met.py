"""Two bodies with the same acceleration that meet: their relative velocity points from one to the other, so that their
velocities have equal components across the line between them; the difference of those along it brings them together.

across BA: v_B sin(150° - β) = v_A sin(150° - 30°)
along BA:  D = (v_B cos(150° - β) - v_A cos(150° - 30°)) t_meet
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, identically_zero, longer, simplified
from planar_cli.equation.scene.line_names import line_name
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, Value, line
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.one_name import pieces_of_name
from planar_cli.report.words.origins import head
from planar_cli.report.words.swallowed import with_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteStep
from planar_cli.solve.law import RELATIVE
from planar_cli.units import TIME, VELOCITY

SHORT = 6
"""Operations of a distance in letters."""
CLOSE, PI = Decimal("1e-20"), Decimal(str(sp.N(sp.pi, 60)))
Pair = tuple[sp.Expr, sp.Expr]


@record
class Met:
    """A body with a velocity of known size along an open angle, one with a known velocity, and the line between them.
    Angles are counted from the x axis, in rad.
    """

    names: tuple[str, str]
    """Of the body whose angle is open, and of the other one."""
    angle: Result
    time: Result
    meeting: Relation
    sizes: Pair
    """Of both velocities, m/s."""
    known: sp.Expr
    """The angle of the second velocity."""
    way: sp.Expr
    """The angle of the line from the first body to the second."""
    distance: sp.Expr
    """Between the bodies at first, m."""

    @property
    def angle_value(self) -> sp.Expr:
        """The open angle as a fraction of π."""
        return sp.nsimplify(sp.Rational(str(round(self.angle.value / PI * 180))) / 180) * sp.pi

    @property
    def closing(self) -> sp.Expr:
        """How fast the bodies come nearer, m/s."""
        return self.nearer(self.angle_value)

    def nearer(self, angle: sp.Expr) -> sp.Expr:
        """The same for another angle of the first velocity."""
        one, two = self.sizes
        return simplified(one * sp.cos(self.way - angle) - two * sp.cos(self.way - self.known))

    @property
    def other(self) -> sp.Expr:
        """The other angle with the same component across the line."""
        return 2 * self.way - self.angle_value - sp.pi

    @property
    def excluded(self) -> Line:
        """Why it is not the other angle."""
        apart = "they would stay as far apart as at first" if self.nearer(self.other) == 0 else "they would move apart"
        return line(f"not {_degrees(self.other)}: {apart}")


def met_of(leg: RouteStep, found: MotionTrace) -> Met | None:
    """None: a step is of something else, or an angle of it is no whole number of degrees."""
    meeting = [e for e in leg.relations if e.kind == RELATIVE]
    angles = [r for r in leg.results if r.unknown not in found.general]
    times = [r for r in leg.results if r.unknown in found.general and found.general[r.unknown].name == "t"]
    if [len(x) for x in (leg.relations, leg.results, meeting, angles, times)] != [4, 4, 2, 1, 1]:
        return None
    (angle,), (time,) = angles, times
    own = {r.unknown: r.formula for r in leg.results if r not in (angle, time) and r.formula is not None}
    # r = r_0 + v t of one body relative to the other, twice with the sign that counts the open velocity positive.
    rates = [_at_once(e.residual, found).diff(time.unknown) for e in meeting]
    letters = [by_name(v.free_symbols & own.keys()) for v in rates]
    if any(len(x) != 1 for x in letters) or time.unknown in set().union(*(v.free_symbols for v in rates)):
        return None
    signs = [v.coeff(s) for v, (s,) in zip(rates, letters, strict=True)]
    if signs not in ([1, 1], [-1, -1]):
        return None
    apart = [-signs[0] * _closed(e.residual.xreplace({time.unknown: sp.S.Zero}), found) for e in meeting]
    other = [_closed(s - signs[0] * v, found) for v, (s,) in zip(rates, letters, strict=True)]
    others = [x for v, (s,) in zip(rates, letters, strict=True) for x in by_name(v.free_symbols - {s})]
    size = _size_along(angle.unknown, [own[s] for (s,) in letters])
    distance = simplified(sp.sqrt(simplified(apart[0] ** 2 + apart[1] ** 2)))
    way, known = _angle([simplified(x / distance) for x in apart]), _angle(other)
    if size is None or way is None or known is None or not others or longer(distance, SHORT):
        return None
    moving = [found.general[s].name for s in (letters[0][0], others[0]) if s in found.general]
    names = ["_".join(pieces_of_name(name)[1:-1]) for name in moving]
    speed = simplified(sp.sqrt(other[0] ** 2 + other[1] ** 2))
    whole = len(names) == 2 and size.is_number and speed.is_number and distance.free_symbols
    if not whole:
        return None
    met = Met((names[0], names[1]), angle, time, meeting[0], (size, speed), known, way, distance)
    # Both angles, and that the other one leads to no meeting.
    plain = abs(Decimal(str(sp.N(met.angle_value, 40))) - angle.value) < CLOSE
    return met if plain and met.closing.is_positive and met.nearer(met.other).is_nonpositive else None


def met_blocks(leg: RouteStep, found: MotionTrace, phrases: Phrases, number: int) -> list[Block]:
    """The lines of such a step; empty of another one. `number`: of its first equation."""
    met = met_of(leg, found)
    return [] if met is None else list(_told(met, found, phrases, number))


def data_of_meetings(found: MotionTrace) -> list[RouteStep]:
    """Steps that only give components of velocities and places which the lines of a meeting do without."""
    steps = found.route.steps
    legs = [leg for leg in steps if met_of(leg, found) is not None]
    used = {s for leg in steps if leg not in legs for s in leg.needs} | {
        s for r in found.requests for p in r.parts for s in p.free_symbols
    }
    needed = {s for leg in legs for s in leg.needs} - used
    return [leg for leg in steps if leg.is_datum and set(leg.unknowns) <= needed]


def _told(met: Met, found: MotionTrace, phrases: Phrases, number: int) -> Iterator[Block]:
    angle, time, between = met.angle.unknown, met.time.unknown, line_name(*met.names)
    one, two = (sp.Symbol(f"v_{name}", real=True) for name in met.names)
    turned = met.way - met.angle_value
    texts = {
        sp.Symbol(f"{NUMBER}{k}", real=True): _degrees(a)
        for k, a in enumerate((met.way, met.known, met.way - met.known, turned))
    }
    way, known, across, own = texts
    open_angle, given = (sp.Add(way, -x, evaluate=False) for x in (angle, known))
    yield Paragraph(line(*head(met.meeting, found.ledger.symbols)[:-1], f". They meet if it points along {between}:"))
    sides = (_product(one, sp.sin, open_angle), _product(two, sp.sin, given))
    lead, note = line(f"across {between}:"), line("equal components")
    yield Equation(tuple(Math(side, texts) for side in sides), number, lead, note)
    ratio = _product(two / one, sp.sin, across)
    sine = phrases.value(met.sizes[1] / met.sizes[0] * sp.sin(met.way - met.known))
    if met.sizes[0] == met.sizes[1]:
        both = f"{_degrees(turned)} or {_degrees(sp.pi - turned)}"
        yield Equation((Math(open_angle, texts), line(both)), None, (), line("as ", *_same(met, phrases)))
    else:
        shown = (Math(_call(sp.sin, open_angle), texts), Math(ratio, texts), Value(sine, "", phrases.figures))
        yield Equation(shown)
    difference = Math(sp.Add(way, -own, evaluate=False), texts)
    yield Equation((Math(angle), difference, phrases.shown(angle, met.angle.value)), None, (), met.excluded)
    sides = (_product(one, sp.cos, open_angle), _product(two, sp.cos, given))
    nearer = line("(", Math(sp.Add(sides[0], -sides[1], evaluate=False), texts), ") ", Math(time))
    yield Equation((phrases.math(met.distance), nearer), number + 1, line(f"along {between}:"))
    speed = sp.Add(_product(one, sp.cos, own), -_product(two, sp.cos, across), evaluate=False)
    elapsed = met.distance / met.closing
    closed = with_unit(elapsed, TIME, phrases.ledger, phrases.figures) or phrases.math(elapsed)
    quotient = line(Math(met.distance), "/(", Math(speed, texts), ")")
    value = (closed,) if phrases.symbolic else (phrases.shown(time, met.time.value),)
    yield Equation((Math(time), quotient, *value))


def _same(met: Met, phrases: Phrases) -> Line:
    """`v_B = v_A = 50 m/s`, of velocities of one size."""
    names = [piece for name in met.names for piece in (Name(f"v_{name}"), " = ")]
    return line(*names, phrases.of_dimension(phrases.certain(met.sizes[0]), VELOCITY))


def _call(function: type[sp.Function], argument: sp.Expr) -> sp.Expr:
    return function(argument, evaluate=False)


def _product(factor: sp.Expr, function: type[sp.Function], argument: sp.Expr) -> sp.Expr:
    called = _call(function, argument)
    return called if factor == 1 else sp.Mul(factor, called, evaluate=False)


def _degrees(angle: sp.Expr) -> str:
    """An angle as it is printed."""
    return f"{sp.Rational(angle * 180 / sp.pi)}°"


def _angle(direction: Sequence[sp.Expr]) -> sp.Expr | None:
    """The angle of a direction; None: it is no whole number of degrees."""
    x, y = direction
    if x.free_symbols or y.free_symbols:
        return None
    angle = sp.atan2(y, x)
    return angle if (angle * 180 / sp.pi).is_Integer else None


def _size_along(angle: sp.Symbol, parts: Sequence[sp.Expr]) -> sp.Expr | None:
    """The size of a velocity with this angle; None: the angle is not its own."""
    x, y = (sp.expand(e).coeff(f(angle)) for e, f in zip(parts, (sp.cos, sp.sin), strict=True))
    same = identically_zero(parts[0] - x * sp.cos(angle)) and identically_zero(parts[1] - y * sp.sin(angle))
    return x if same and x == y and x.is_positive else None


def _closed(expr: sp.Expr, found: MotionTrace) -> sp.Expr:
    """In the letters of the file."""
    for _ in range(len(found.route.steps) + 1):
        expr = _at_once(expr, found).xreplace(dict(found.route.formulas))
    return simplified(expr)


def _at_once(expr: sp.Expr, found: MotionTrace) -> sp.Expr:
    return sp.expand(expr.xreplace(dict(found.route.plain)))
