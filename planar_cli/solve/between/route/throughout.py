"""Formulas that hold throughout a motion: speeds by the place (first integral), or everything by the time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import NoValue
from planar_cli.records import changing
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.newton import refined
from planar_cli.solve.between.roots.events import FollowedSegment, scale_of
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.between.route.route import Router
from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.regimes.equations import Equation, law_equations, link_equations
from planar_cli.solve.regimes.timeline import Stop


@changing
class Throughout:
    """Speeds and places between the first state and the next, by the file's own coordinates or by t."""

    course: MotionEquations
    followed: Followed | None
    value: Valuation
    start: dict[sp.Symbol, sp.Expr]

    def route(self, parts: Sequence[sp.Expr]) -> Route | None:
        """The way to the varying letters of these formulas; None where they are to stay, or cannot be told."""
        if not self.course.regimes:
            return None
        regime = self.course.regimes[0]
        letters = set(regime.letters)
        own = self._own()
        inside = {s for p in parts for s in p.free_symbols if s in letters}
        targets = inside - own - {regime.time}
        alone = len(parts) == 1 and parts[0] in own
        if self.followed is None or (not targets and not alone):
            return None
        for fixed in ([own] if own and not alone else []) + [{regime.time}]:
            wanted = inside - fixed
            found = self._by(fixed, wanted)
            if found is not None and wanted <= set(found.formulas) and _rests_on(found, wanted) & letters <= fixed:
                return found
        return None

    def _own(self) -> set[sp.Symbol]:
        """The coordinates of the file."""
        names = {c.name for c in self.course.problem.coordinates}
        return {s for s in self.course.regimes[0].letters if s.name in names}

    def _by(self, fixed: set[sp.Symbol], wanted: set[sp.Symbol]) -> Route | None:
        """The letters wanted as functions of the fixed ones."""
        course, regime = self.course, self.course.regimes[0]
        now = Stop("", (), {s: s for s in regime.letters}, regime.time)
        equations: list[Equation] = [
            *law_equations(course.laws[0], course.first, now, regime, regime.general.value),
            *link_equations(course.laws[0], course.first, now, regime),
        ]
        if regime.time not in fixed:
            equations = [e for e in equations if regime.time not in e.residual.free_symbols]
        value = self._sample(fixed, equations)
        if value is None:
            return None
        begun = [self._begun(e) for e in equations]
        natural = self.course.natural(regime.letters)
        router = Router(begun, frozenset(set(regime.letters) - fixed), value, True, natural=natural)
        return router.route(sorted(wanted, key=lambda s: s.name))

    def _leg(self, followed: Followed) -> FollowedSegment:
        """The first stretch as it was followed; from the only state on, where there is no other."""
        if followed.segments:
            return followed.segments[0]
        if followed.onward is None:
            raise NoValue("the motion was not followed")
        return followed.onward

    def _within(self, segment: FollowedSegment) -> float:
        """How long after its beginning a stretch shows how it goes on [s]."""
        if segment.t0 < segment.t1 < math.inf:
            return 0.43 * (segment.t1 - segment.t0)
        departure = self.course.departure
        return 0.43 * scale_of(segment) if departure is None else departure.grown

    def _begun(self, equation: Equation) -> Equation:
        """With what is known of the first state put in."""
        residual, span = equation.residual.xreplace(self.start), equation.span
        if span is not None and span.left is not None and span.right is not None:
            span = replace(span, left=span.left.xreplace(self.start), right=span.right.xreplace(self.start))
        return replace(equation, residual=residual, span=span)

    def _sample(self, fixed: set[sp.Symbol], equations: Sequence[Equation]) -> Valuation | None:
        """Numbers of a moment in the middle of the first stretch, to all digits."""
        assert self.followed is not None
        try:
            segment = self._leg(self.followed)
            here = segment.at(segment.t0 + self._within(segment))
        except NoValue:
            return None
        exact = {s: Decimal(repr(here[s])) for s in fixed}
        known = self.value.extended(exact)
        rest = {s: here[s] for s in self.course.regimes[0].letters if s not in fixed}
        try:
            more = refined([e.residual for e in equations], list(rest), rest, known, self.course.natural(rest))
        except NoValue:
            return None
        return known.extended({**{s: Decimal(repr(v)) for s, v in rest.items()}, **more})


def _rests_on(route: Route, wanted: set[sp.Symbol]) -> set[sp.Symbol]:
    """Symbols of which the formulas of these consist in the end. What is found by trial, at one time, has none."""
    waiting, seen, found = set(wanted), set[sp.Symbol](), set[sp.Symbol]()
    while waiting:
        symbol = waiting.pop()
        seen.add(symbol)
        formula = route.formulas.get(symbol)
        if formula is None or formula == symbol:
            found.add(symbol)
        else:
            waiting |= sp.sympify(formula).free_symbols - seen
    return found
