"""The place at a given time on an ellipse, or the time at a given direction, by Kepler's equation.

From the end of the orbit that is nearer to the centre, with the semi-major axis a, the eccentricity e and the
eccentric anomaly E:

    v²/2 - μ/r = -μ/(2 a)     r_1 = a (1 - e)     E - e sin E = t √(μ/a³)
    r = a (1 - e cos E)       tan(φ/2) = √((1 + e)/(1 - e)) tan(E/2)

After a whole number of revolutions it is at its start again. (Kepler's laws; An Introduction to Planar Dynamics, 3.3.)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import PI
from planar_cli.equation.values.ledger import Ledger
from planar_cli.records import record
from planar_cli.solve.law import ANOMALY
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.timeline import Stop

OWN = "anomaly of an ellipse"
AXIS = "energy v²/2 - {K}/r = -{K}/(2 {a}) with the semi-major axis {a} of the orbit and the attraction {K} m/r²"
ECCENTRICITY = "the orbit is nearest to the centre, r = {a} (1 - {e}) with the eccentricity {e}"
EQUATION = "Kepler's equation for the eccentric anomaly E"
DEFINED = ", by which r = {a} (1 - {e} cos E)"
DISTANCE = "r = {a} (1 - {e} cos E)"
DIRECTION = "tan({turned}/2) = √((1 + {e})/(1 - {e})) tan(E/2)"
BY_ANGLE = "the eccentric anomaly E, tan(E/2) = √((1 - {e})/(1 + {e})) tan({turned}/2)"
TURNED = ", where Δφ is the angle through which it has turned"
AGAIN = "{}, as T = 2 π √(a³/{K}), so that it is at the start again and φ has changed by {} π"
CLOSE = Decimal("1e-20")
"""A time is a whole number of periods, where it differs from it by no larger part."""


@record
class Ellipse:
    """An orbit that is passed from its nearest end on. `mu` [m³/s²]; r, φ and φ̇ at the start; `rate`: the value of
    √(μ/a³) [1/s]; `clockwise`: φ decreases; `from_axis`: φ begins at zero.
    """

    mu: sp.Expr
    start: tuple[sp.Symbol, sp.Symbol, sp.Symbol]
    rate: Decimal
    clockwise: bool
    from_axis: bool
    since: Stop


def attraction(mu: sp.Expr) -> str:
    """What a page calls μ: by the letter of the file, where it has one, else K."""
    return str(mu) if mu.is_Symbol else "K"


def at_time(
    ellipse: Ellipse, stop: Stop, place: tuple[sp.Symbol, sp.Symbol], t: Decimal, ledger: Ledger
) -> Iterator[Equation]:
    """The place at a time [s] that is known, counted from the start."""
    mean = t * ellipse.rate
    turns = round(mean / (2 * PI))
    if abs(mean - turns * 2 * PI) > CLOSE * abs(mean):
        yield from _equations(ellipse, stop, place, mean, ledger, dated=True)
        return
    r, phi, _ = ellipse.start
    words = AGAIN.format(
        "a whole period has passed" if turns == 1 else f"{turns} periods have passed",
        2 * turns,
        K=attraction(ellipse.mu),
    )
    for now, told in ((place[0], r), (place[1], phi + (-1 if ellipse.clockwise else 1) * 2 * sp.pi * turns)):
        yield Equation(
            now - told, ANOMALY, words, stop.name, ellipse.since.name, family=(ANOMALY, stop.name, now.name), rank=1
        )


def at_direction(
    ellipse: Ellipse, stop: Stop, place: tuple[sp.Symbol, sp.Symbol], turned: Decimal, ledger: Ledger
) -> Iterator[Equation]:
    """The time at which it has turned by an angle [rad] that is known."""
    yield from _equations(ellipse, stop, place, abs(turned), ledger)


def anomalies(equations: Iterable[Equation]) -> tuple[sp.Symbol, ...]:
    """The letters of such equations that are unknowns of their own: a, ε and E."""
    told = [e for e in equations if e.kind == ANOMALY and e.family[0] == OWN]
    return tuple(
        dict.fromkeys(s for e in told for s in sorted(e.residual.free_symbols, key=str) if s.name == e.family[-1])
    )


def _equations(
    ellipse: Ellipse,
    stop: Stop,
    place: tuple[sp.Symbol, sp.Symbol],
    passed_by: Decimal,
    ledger: Ledger,
    dated: bool = False,
) -> Iterator[Equation]:
    r, phi, turning = ellipse.start
    mu, v = ellipse.mu, r * turning
    a = ledger.once("a", "m", mu * r)
    epsilon = ledger.once("ε", "1", mu * r)
    big = ledger.once(f"E_{stop.name}", "rad", mu * r)
    # E, φ and √(μ/a³) t pass the multiples of π together.
    turns = round(passed_by / (2 * PI))
    if abs(abs(passed_by - turns * 2 * PI) - PI) < CLOSE * PI:
        # At the other end tan(E/2) has no value.
        return
    passed = stop.t - ellipse.since.t
    turned = (phi - place[1]) if ellipse.clockwise else (place[1] - phi)
    half, wide = 2 * sp.pi * turns, sp.sqrt((1 + epsilon) / (1 - epsilon))
    after, angle = ("", "φ") if ellipse.from_axis and not ellipse.clockwise else (TURNED, "Δφ")
    if dated:
        direction = turned - 2 * sp.atan(wide * sp.tan(big / 2)) - half, DIRECTION + after, place[1].name
    else:
        residual = big - 2 * sp.atan(sp.tan(turned / 2) * sp.sqrt((1 - epsilon) / (1 + epsilon))) - half
        direction = residual, BY_ANGLE + after, big.name
    start = Equation(sp.S.Zero, ANOMALY, "", ellipse.since.name, rank=1)
    later = replace(start, stop=stop.name, since=ellipse.since.name)
    found = (
        (start, 1 / a - (2 / r - v**2 / mu), AXIS, a.name),
        (start, r - a * (1 - epsilon), ECCENTRICITY, epsilon.name),
        (
            later,
            big - epsilon * sp.sin(big) - sp.sqrt(mu / a**3) * passed,
            EQUATION + DEFINED if dated else EQUATION,
            big.name if dated else stop.t.name,
        ),
        *([(later, place[0] - a * (1 - epsilon * sp.cos(big)), DISTANCE, place[0].name)] if dated else []),
        (later, *direction),
    )
    for like, residual, words, name in found:
        told = words.format(a=a, e=epsilon, K=attraction(mu), turned=angle)
        yield replace(like, residual=residual, words=told, family=(OWN, like.stop, name))
