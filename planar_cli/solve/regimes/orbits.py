"""What moves about a fixed point under an attraction μ/r² per mass moves along a conic section, and its time of
revolution is told by the semi-major axis of that.

    1/r = μ/h² + (1/r_1 - μ/h²) cos(φ - φ_1) - (ṙ_1/h) sin(φ - φ_1),  h = r² φ̇        T = 2 π √(a³/μ)

(An Introduction to Planar Dynamics, 3.3; Kepler's laws.)
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import letters, longer, simplified
from planar_cli.equation.values.exact import PI, Unvalued, Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.errors import NoValue
from planar_cli.records import record
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.kepler import Ellipse, at_direction, at_time, attraction
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop

KIND = "orbit"
CONIC = "the orbit is a conic section, 1/r = {K}/h² + C cos(φ - φ_0) with h = r² φ̇ and the attraction {K} m/r²"
HALF = "half a revolution, by Kepler's third law"
WHOLE = "one revolution, by Kepler's third law"
ROUND = Decimal("1e-12")
"""So small an eccentricity is that of a circle, which has no ends."""
LONGEST = 60
"""A longer formula is that of another force."""
Known = Mapping[sp.Symbol, sp.Expr]


@record
class Orbit:
    """The letters of the general position of what moves so, and μ [m³/s²]."""

    r: sp.Symbol
    phi: sp.Symbol
    outward: sp.Symbol
    """ṙ"""
    turning: sp.Symbol
    """φ̇"""
    mu: sp.Expr

    def at(self, stop: Stop) -> tuple[sp.Symbol, sp.Symbol, sp.Symbol, sp.Symbol]:
        """r, φ, ṙ, φ̇ of a state."""
        r, phi, outward, turning = (stop.letters[x] for x in (self.r, self.phi, self.outward, self.turning))
        return r, phi, outward, turning


def orbit_equations(
    since: Stop, between: Sequence[Stop], stop: Stop, regime: Regime, known: Known, data: Iterable[Equation]
) -> Iterator[Equation]:
    """The place on the orbit; the time between its two ends, or of a whole revolution. `between`: the states between
    the two; `known`: of letters of the first, by what is stated; `data`: what is stated of all states.
    """
    stated: dict[str, list[Equation]] = {}
    for e in data:
        stated.setdefault(e.stop, []).append(e)
    for orbit in _orbits(regime):
        shape = _shape(orbit, since, known, regime.general.value)
        if shape is None:
            continue
        passage = _Passage(orbit, since, stop, known, stated, regime.general.value, shape)
        family = (KIND, orbit.r.name, stop.name)
        told = passage.time(between)
        dated = []
        if told is not None:
            dated.append(Equation(told[0], KIND, told[1], stop.name, since.name, family=(*family, "t"), rank=1))
        elif passage.still and shape[0] > 0:
            dated += passage.by_anomaly(regime.general.instant.scene.ledger)
        if not any(letters(e.residual) & {stop.letters[orbit.r]} for e in dated):
            words = CONIC.format(K=attraction(orbit.mu))
            yield Equation(passage.place(), KIND, words, stop.name, since.name, family=family, rank=1)
        yield from dated


@record
class _Passage:
    """The motion along an orbit from one state to another. `shape`: e cos ν and e sin ν at the first, ν the angle from
    the nearer end.
    """

    orbit: Orbit
    since: Stop
    stop: Stop
    known: Known
    stated: Mapping[str, Sequence[Equation]]
    value: Valuation
    shape: tuple[Decimal, Decimal]

    @property
    def still(self) -> bool:
        """Does it start at an end of its orbit?"""
        return self.known.get(self.orbit.at(self.since)[2]) == 0

    def ends(self, stop: Stop) -> bool:
        """Is a state an end of the orbit?"""
        r, _, outward, _ = self.orbit.at(stop)
        return any(_is_end(e, stop, r, outward) for e in self.stated.get(stop.name, ()))

    def opposite(self, stop: Stop) -> bool:
        """Is it the end that is not the one from which the motion starts?"""
        outward = self.orbit.at(stop)[2]
        extremes = [e for e in self.stated[stop.name] if e.kind == "extreme" and outward in e.residual.free_symbols]
        return all(e.words.endswith("largest" if self.shape[0] > 0 else "smallest") for e in extremes)

    def place(self) -> sp.Expr:
        """Distance and direction; at an end the direction alone."""
        r, phi, outward, turning = self.orbit.at(self.since)
        r_2, phi_2, _, _ = self.orbit.at(self.stop)
        turned, flat = phi_2 - phi, self.orbit.mu / (r**4 * turning**2)
        leaving = sp.S.Zero if self.still else outward / (r**2 * turning)
        if not self.ends(self.stop):
            return 1 / r_2 - flat - (1 / r - flat) * sp.cos(turned) + leaving * sp.sin(turned)
        return sp.sin(turned) if self.still else (1 / r - flat) * sp.sin(turned) + leaving * sp.cos(turned)

    def time(self, between: Sequence[Stop]) -> tuple[sp.Expr, str] | None:
        """Half a revolution or whole ones, with the words; None: it is another part."""
        if self.shape[0] ** 2 + self.shape[1] ** 2 >= 1:
            return None
        r, _, outward, turning = self.orbit.at(self.since)
        passed, mu = self.stop.t - self.since.t, self.orbit.mu
        if self.still and self.ends(self.stop) and self.opposite(self.stop):
            if any(not 0 < abs(self.turned(s) or Decimal(0)) < PI for s in between):
                return None
            axis = (r + self.orbit.at(self.stop)[0]) / 2
            return passed - sp.pi * sp.sqrt(axis**3 / mu), HALF
        turned = self.turned(self.stop)
        back = self.still and not between and self.ends(self.stop)
        if not back and (turned is None or abs(abs(turned) / (2 * PI) - 1) > ROUND):
            return None
        axis = 1 / (2 / r - (r**2 * turning**2 + (sp.S.Zero if self.still else outward**2)) / mu)
        if far := [s for s in between if self.still and self.ends(s) and self.opposite(s)]:
            axis = (r + self.orbit.at(far[0])[0]) / 2
        return passed - 2 * sp.pi * sp.sqrt(axis**3 / mu), WHOLE

    def by_anomaly(self, ledger: Ledger) -> Iterator[Equation]:
        """By Kepler's equation, from the nearer end of an ellipse: where the time or the direction is known."""
        r, phi, _, turning = self.orbit.at(self.since)
        e, mu, v = self.shape[0], self.orbit.mu, r * turning
        cube = self._number((2 / r - v**2 / mu) ** 3 * mu)
        spin, passed, turned = self._number(turning), self._passed(), self.turned(self.stop)
        if e >= 1 or not cube or cube < 0 or not spin or self.ends(self.stop):
            return
        ellipse = Ellipse(mu, (r, phi, turning), cube.sqrt(), spin < 0, self._number(phi) == 0, self.since)
        place = self.orbit.at(self.stop)[:2]
        if passed is not None and passed > 0:
            yield from at_time(ellipse, self.stop, place, passed, ledger)
        elif turned is not None and turned * spin > 0:
            yield from at_direction(ellipse, self.stop, place, turned, ledger)

    def _passed(self) -> Decimal | None:
        """The time between the two states, where it is stated."""
        start = self._number(self.since.t)
        for e in self.stated.get(self.stop.name, ()):
            rate = sp.diff(e.residual, self.stop.t)
            rest = self._number(e.residual.xreplace({self.stop.t: sp.S.Zero})) if rate in (1, -1) else None
            if rest is not None and start is not None:
                return -rest * int(rate) - start
        return None

    def _number(self, expr: sp.Expr) -> Decimal | None:
        """The value of what is known of the first state."""
        return self.value.known(expr.xreplace(dict(self.known)))

    def turned(self, stop: Stop) -> Decimal | None:
        """The angle through which it has turned until a state, where that is stated."""
        phi, phi_2 = self.orbit.at(self.since)[1], self.orbit.at(stop)[1]
        start = self.value.known(self.known[phi]) if phi in self.known else None
        for e in self.stated.get(stop.name, ()):
            rate = sp.diff(e.residual, phi_2)
            rest = self.value.known(e.residual.xreplace({phi_2: sp.S.Zero})) if rate in (1, -1) else None
            if rest is not None and start is not None:
                return -rest * int(rate) - start
        return None


def _orbits(regime: Regime) -> Iterator[Orbit]:
    """Pairs of polar coordinates whose equations of motion are those."""
    speeds = {c.symbol: u for c in regime.coordinates for u in regime.free if regime.rates[c.symbol] == u}
    lengths, angles = ([c.symbol for c in regime.coordinates if c.unit == unit] for unit in ("m", "rad"))
    value = regime.general.value
    for r, phi in itertools.product(lengths, angles):
        if not {r, phi} <= speeds.keys() or not {speeds[r], speeds[phi]} <= regime.accelerations.keys():
            continue
        outward, turning = speeds[r], speeds[phi]
        sideways, falling = regime.accelerations[turning], regime.accelerations[outward]
        if not {outward, turning} <= letters(sideways) or longer(falling, LONGEST):
            continue
        try:
            if not value.is_zero(sideways + 2 * outward * turning / r):
                continue
            mu = simplified((r * turning**2 - falling) * r**2)
            if not letters(mu) & set(regime.letters) and (value.known(mu) or Decimal(0)) > 0:
                yield Orbit(r, phi, outward, turning, mu)
        except (NoValue, Unvalued):
            continue


def _shape(orbit: Orbit, since: Stop, known: Known, value: Valuation) -> tuple[Decimal, Decimal] | None:
    """e cos ν and e sin ν of the orbit, ν the angle from its nearest point to the first place; None: it is a circle, or
    not known.
    """
    r, _, outward, turning = orbit.at(since)
    momentum = r**2 * turning
    parts = (momentum**2 / (orbit.mu * r) - 1, momentum * outward / orbit.mu)
    x, y = (value.known(e.xreplace(dict(known))) if letters(e) & known.keys() else None for e in parts)
    if x is None or y is None:
        return None
    return (x, y) if x * x + y * y > ROUND else None


def _is_end(e: Equation, stop: Stop, r: sp.Symbol, outward: sp.Symbol) -> bool:
    """Does it say that the distance does not change there?"""
    inside = e.residual.free_symbols & set(stop.letters.values())
    return outward in inside <= {r, outward} and bool(e.residual.xreplace({outward: sp.S.Zero}) == 0)
