"""Place, velocity and acceleration of what slides along a curve of a body that turns about a fixed point, in axes ξ, η
that turn with that body.

    v_ξ = ξ̇ - ω η                           v_η = η̇ + ω ξ
    a_ξ = ξ̈ - 2 ω η̇ - ω² ξ - α η            a_η = η̈ + 2 ω ξ̇ - ω² η + α ξ
    v_x = v_ξ cos θ - v_η sin θ             v_y = v_ξ sin θ + v_η cos θ

(An Introduction to Planar Dynamics, 2.5.)
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Name, Paragraph, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace, Request
from planar_cli.units import ACCELERATION, LENGTH, VELOCITY, Dimension

LEVELS = {"r": 0, "v": 1, "a": 2}
DIMENSIONS = (LENGTH, VELOCITY, ACCELERATION)
XI, ETA, V_XI, V_ETA, A_XI, A_ETA = sp.symbols("xi eta v_xi v_eta a_xi a_eta", real=True)
RATES = sp.symbols("xi_dot eta_dot xi_ddot eta_ddot", real=True)


@record
class Turned:
    """What slides along a curve η = f(ξ) of a body, in general: `place` is ξ, `curve` f(ξ) and `angle` the angle by
    which the body has turned, all letters of the general position; `rate` is ξ̇, `spin` ω.
    """

    point: str
    frame: str
    place: sp.Symbol
    curve: sp.Expr
    angle: sp.Symbol
    rate: sp.Expr
    spin: sp.Expr


class TurningAxes:
    """Lines of the finds of a motion that are told in turning axes; both rates that they need are constant."""

    def __init__(self, found: MotionTrace, phrases: Phrases) -> None:
        self.found, self.phrases = found, phrases
        self._turned = {r.find.name: (r, t) for r in found.requests if (t := _turned(found, r)) is not None}
        self._told: set[tuple[str, str, int]] = set()

    @property
    def names(self) -> frozenset[str]:
        """The finds that are told so."""
        return frozenset(self._turned)

    def blocks(self, find: str) -> Iterator[Block]:
        """The lines of one of them, after those of the components in the turning axes that it needs; none of others."""
        if find not in self._turned:
            return
        asked, turned = self._turned[find]
        what = asked.find.found.what
        assert isinstance(what, Quantity)
        state, level = str(what.at), LEVELS[what.word]
        letters = {g: own for own, g in self.found.general.items() if self.found.ledger.roles[own].at == state}
        theta, sizes = letters[turned.angle], self._sizes(turned, letters)
        for n in range(level + 1):
            if (turned.point, state, n) not in self._told:
                self._told.add((turned.point, state, n))
                yield from self._opened(turned, letters, sizes, n, state)
        one, other = ((XI, ETA), (V_XI, V_ETA), (A_XI, A_ETA))[level]
        name, dimension = asked.find.name, DIMENSIONS[level]
        if len(what.things) > 1:
            one, other = RATES[:2]
        if what.parts:
            yield self._line((line(Name(name)),), sp.sqrt(one**2 + other**2), sizes, asked)
            return
        cosine, sine = sp.cos(theta), sp.sin(theta)
        for axis, formula in (("x", one * cosine - other * sine), ("y", one * sine + other * cosine)):
            yield self._line((line(Name(name), f", {axis}"),), formula, sizes, dimension)

    def _sizes(self, turned: Turned, letters: dict[sp.Symbol, sp.Symbol]) -> dict[sp.Symbol, Decimal]:
        """The numbers [SI] of all components at a state."""
        value, place = self.found.value, turned.place
        slope, bend = sp.diff(turned.curve, place), sp.diff(turned.curve, place, 2)
        general = {XI: place, ETA: turned.curve, RATES[0]: turned.rate, RATES[1]: slope * turned.rate}
        general[RATES[3]] = bend * turned.rate**2
        sizes = {s: value(sp.sympify(e).xreplace(letters)) for s, e in general.items()}
        spin = value(turned.spin)
        sizes[V_XI] = sizes[RATES[0]] - spin * sizes[ETA]
        sizes[V_ETA] = sizes[RATES[1]] + spin * sizes[XI]
        sizes[A_XI] = -2 * spin * sizes[RATES[1]] - spin**2 * sizes[XI]
        sizes[A_ETA] = sizes[RATES[3]] + 2 * spin * sizes[RATES[0]] - spin**2 * sizes[ETA]
        return {**sizes, letters[turned.angle]: value(letters[turned.angle])}

    def _opened(
        self,
        turned: Turned,
        letters: dict[sp.Symbol, sp.Symbol],
        sizes: dict[sp.Symbol, Decimal],
        level: int,
        state: str,
    ) -> Iterator[Block]:
        """The components of one level in the turning axes."""
        spin, math = turned.spin, self.phrases.math
        curve, slope = turned.curve.xreplace(letters), sp.diff(turned.curve, turned.place).xreplace(letters)
        bend, speed = sp.diff(turned.curve, turned.place, 2).xreplace(letters), RATES[0]
        if level == 0:
            lead = at(state).removesuffix(":")
            yield Paragraph(
                line(f"{lead}, in axes ", Name("xi"), ", ", Name("eta"), f" that turn with {turned.frame}:")
            )
            value = self._value(sizes[ETA], LENGTH)
            yield Equation((math(ETA), *self._own(turned, turned.curve), *self._numbers(curve, {}), value))
        elif level == 1:
            yield Paragraph(velocity_words(math(spin)))
            yield Equation((math(speed), math(turned.rate), self._value(sizes[speed], VELOCITY)))
            words = line("(d", Name("eta"), "/d", Name("xi"), ") ", Name("xi_dot"))
            own = sp.diff(turned.curve, turned.place).xreplace({turned.place: XI}) * speed
            yield self._rate(RATES[1], (words, *self._clean(own)), slope * speed, sizes, 1)
            yield self._line((math(V_XI),), speed - spin * ETA, sizes, VELOCITY)
            yield self._line((math(V_ETA),), RATES[1] + spin * XI, sizes, VELOCITY)
        else:
            yield Paragraph(acceleration_words(math(spin), bend != 0))
            if bend != 0:
                words = line("(d²", Name("eta"), "/d", Name("xi"), "²) ", math(speed**2))
                own = sp.diff(turned.curve, turned.place, 2).xreplace({turned.place: XI}) * speed**2
                told = (words, *self._clean(own))
                yield self._rate(RATES[3], told, bend * speed**2, sizes, 2)
            curved = RATES[3] if bend != 0 else sp.S.Zero
            yield self._line((line(Name("a_xi")),), -2 * spin * RATES[1] - spin**2 * XI, sizes, ACCELERATION)
            yield self._line((line(Name("a_eta")),), curved + 2 * spin * speed - spin**2 * ETA, sizes, ACCELERATION)

    def _own(self, turned: Turned, formula: sp.Expr) -> list[Any]:
        """A formula of the curve in ξ, where its numbers hide no unit."""
        clean = is_clean(self.phrases.ledger, formula, dimension=LENGTH)
        return [self.phrases.math(formula.xreplace({turned.place: XI}))] if clean else []

    def _clean(self, formula: sp.Expr) -> list[Any]:
        """A rate of the curve in ξ and ξ̇, where its own numbers, which would hide units, are whole."""
        numbers = formula.atoms(sp.Rational) - {sp.S.One, sp.S.NegativeOne}
        return [self.phrases.math(formula)] if formula.free_symbols - {XI, RATES[0]} and len(numbers) < 2 else []

    def _rate(
        self, rate: sp.Symbol, told: tuple[Any, ...], formula: sp.Expr, sizes: dict[sp.Symbol, Decimal], n: int
    ) -> Equation:
        value = self._value(sizes[rate], DIMENSIONS[n])
        return Equation((self.phrases.math(rate), *told, *self._numbers(formula, sizes), value))

    def _numbers(self, formula: sp.Expr, sizes: dict[sp.Symbol, Decimal]) -> list[Any]:
        known = {s: sizes.get(s, self.found.value.known(s)) for s in formula.free_symbols}
        put = self.phrases.numbers(formula, {s: n for s, n in known.items() if n is not None})
        return [] if put is None else [put]

    def _line(
        self, name: tuple[Any, ...], formula: sp.Expr, sizes: dict[sp.Symbol, Decimal], of: Dimension | Request
    ) -> Equation:
        """name = formula = numbers = value."""
        whole = self.found.value.extended(sizes)(formula)
        if isinstance(of, Request):
            assert of.unit is not None
            values = self.phrases.in_units(whole, of.unit)
        else:
            values = [self._value(whole, of)]
        return Equation((*name, self.phrases.math(formula), *self._numbers(formula, sizes), *values))

    def _value(self, number: Decimal, dimension: Dimension) -> Any:
        return self.phrases.of_dimension(number, dimension)


def velocity_words(spin: Math) -> Line:
    """v = v_rel + ω × r in components."""
    xi, eta, xi_dot, eta_dot = (Name(n) for n in ("xi", "eta", "xi_dot", "eta_dot"))
    relative = line(Name("v_rel"), " = [", xi_dot, ", ", eta_dot, "], ")
    carried = line("ω × r = [-", spin, " ", eta, ", ", spin, " ", xi, "]")
    return line("Velocity, v = ", Name("v_rel"), " + ω × r, along ", xi, " and ", eta, ": ", *relative, *carried)


def acceleration_words(spin: Math, bent: bool) -> Line:
    """a = a_rel + 2 ω × v_rel - ω² r in components. `bent`: the curve is no straight line."""
    xi, eta, xi_dot, eta_dot = (Name(n) for n in ("xi", "eta", "xi_dot", "eta_dot"))
    relative = line(Name("a_rel"), " = [0, ", Name("eta_ddot") if bent else "0", "], ")
    coriolis = line("2 ω × ", Name("v_rel"), " = [-2 ", spin, " ", eta_dot, ", 2 ", spin, " ", xi_dot, "]")
    law = line("Acceleration, a = ", Name("a_rel"), " + 2 ω × ", Name("v_rel"), " - ω² r, along ", xi, " and ", eta)
    return line(*law, ": ", *relative, *coriolis)


def coordinates_turned(found: MotionTrace) -> dict[sp.Symbol, tuple[str, str]]:
    """The coordinates along an axis of a turning body, with the points whose they are and that body."""
    turned = (t for r in found.requests if (t := _turned(found, r)) is not None)
    return {t.place: (t.point, t.frame) for t in turned}


def in_turning_axes(found: MotionTrace) -> frozenset[str]:
    """The finds of a motion that are told in turning axes."""
    return frozenset(r.find.name for r in found.requests if _turned(found, r) is not None)


def _turned(found: MotionTrace, asked: Request) -> Turned | None:
    """None: it is no place, velocity or acceleration at a state of what slides along a curve of a body that turns at a
    constant rate, with a constant ξ̇.
    """
    what = asked.find.found.what
    if found.symbolic or len(found.regimes) != 1 or not isinstance(what, Quantity) or what.word not in LEVELS:
        return None
    parts = [p.kind for p in what.parts]
    if not isinstance(what.at, str) or parts not in ([], ["mag"]) or (what.word, parts) == ("r", ["mag"]):
        return None
    if len(what.things) > 1 and ((what.word, parts) != ("v", ["mag"]) or not _told_besides(found, what)):
        return None
    regime = found.regimes[0]
    system = regime.solution.trial.system
    body = what.things[0] if what.things[0] in system.scene.bodies else system.scene.owner(what.things[0])
    edges = {e.body: e for e in system.tree.edges}
    if (
        body not in edges
        or what.things[1:] not in ((), (edges[body].parent,))
        or {"xi", "eta"} & set(system.scene.ledger.symbols)
    ):
        return None
    return _on_curve(found, regime, edges[body], edges)


def _told_besides(found: MotionTrace, what: Quantity) -> bool:
    """Is the velocity or acceleration of the same thing asked too, whose lines tell ξ̇ and η̇?"""
    others = (r.find.found.what for r in found.requests)
    same = (q for q in others if isinstance(q, Quantity) and (q.things, q.at) == (what.things[:1], what.at))
    return any(q.word in ("v", "a") for q in same)


def _on_curve(found: MotionTrace, regime: RegimeTrace, edge: Edge, edges: dict[str, Edge]) -> Turned | None:
    system, frame = regime.solution.trial.system, edges.get(edge.parent)
    joining = edge.joining
    if frame is None or joining is None or joining.path is None or joining.path.curvature == 0 or not edge.particle:
        return None
    hinge = frame.joining
    if hinge is None or hinge.base != GROUND or hinge.path is not None or hinge.rolling is not None:
        return None
    if (hinge.point.x, hinge.point.y) != (0, 0) or system.motion is None:
        return None
    x, y = sp.sympify(joining.point.x), sp.sympify(joining.point.y)
    angles = {a.args[0] for a in (x.atoms(sp.sin, sp.cos) | y.atoms(sp.sin, sp.cos))}
    theta = angles.pop() if len(angles) == 1 else sp.S.Zero
    if not theta.is_Symbol:
        return None
    cosine, sine = sp.cos(theta), sp.sin(theta)
    along, across = simplified(x * cosine + y * sine), simplified(y * cosine - x * sine)
    laws = {law.coordinate.symbol: law for *_, several in found.stretches for law in several}
    if not along.is_Symbol or not {along, theta} <= set(laws) or across.has(theta):
        return None
    rate, spin = laws[along], laws[theta]
    steady = all(law.order == 1 and not law.f.free_symbols & found.varying for law in (rate, spin))
    return Turned(joining.place, edge.parent, along, across, theta, rate.f, spin.f) if steady else None
