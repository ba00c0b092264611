"""The answers of a motion: quantities at states, formulas that hold throughout, truths and modes."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import (
    letters,
    longer,
    replaced,
    rounded_inside,
    simplified,
    with_short_roots,
    with_whole_roots,
)
from planar_cli.equation.system.system import mode_of
from planar_cli.equation.values.exact import Sample, Settled, Valuation
from planar_cli.errors import Undecided, refuse, undecided_at
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.language.outermost import is_energy
from planar_cli.problem.scene.scene import Find
from planar_cli.records import record
from planar_cli.solve.between.equations.asked_finds import TRUTHS, AskedFind
from planar_cli.solve.between.equations.given_times import endless_times, without_end
from planar_cli.solve.between.equations.modes_of_oscillation import has_formula, mode_sizes, of_modes
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.oscillation import Oscillation, stability
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.route.throughout import Throughout
from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.curves.paths import CurveReader
from planar_cli.solve.diagnosis.unsettled import settled_by
from planar_cli.solve.following.starts import started
from planar_cli.solve.instant.truth import holds, signed_alike
from planar_cli.solve.passages import Passage
from planar_cli.solve.roads import is_curve
from planar_cli.solve.solution import Found
from planar_cli.units import parse_unit

CLOSED_OPS, LONGEST = 90, 600


@record
class AnsweredFind:
    """The answer of one find."""

    found: Found
    """Its values and formulas."""
    passing: Route | None = None
    """Where it holds throughout the motion, the way to it."""
    passage: Passage | None = None
    """Of a curve, what is told of it."""


@record
class Answering:
    """Answers the finds of one motion."""

    course: MotionEquations
    """The motion, solved."""
    route: Route
    """The way to what is asked."""
    value: Valuation
    """Numbers of everything."""
    spans: tuple[SpanIntegral, ...]
    """Quantities over spans, worked out."""
    throughout: Throughout
    """What holds throughout the motion."""
    oscillations: tuple[Oscillation, ...] = ()
    """About equilibrium states that are asked about, their places put in."""

    def answer(self, asked: AskedFind) -> AnsweredFind:
        """One find."""
        value = self.value
        find, what = asked.find, asked.find.found.what
        pure = parse_unit("1")
        mode = self._mode(what, asked)
        if mode is not None:
            return AnsweredFind(Found(find.name, mode[0], pure, None, None, mode[1], find))
        if isinstance(what, Quantity) and what.word in TRUTHS:
            word = "true" if _is_true(self.course, what, value) else "false"
            return AnsweredFind(Found(find.name, "truth", pure, None, None, word, find))
        if of_modes(what, self.course.swings):
            return AnsweredFind(self._of_modes(asked))
        if is_curve(what):
            known = self.throughout.start
            starts = started(self.course, asked.reader.regime, lambda s: known.get(s, s), value)
            found, passage = CurveReader(asked.reader.regime, starts).answer(find)
            return AnsweredFind(found, passage=passage)
        endless = dict.fromkeys(endless_times(self.course), sp.oo)
        parts = [p.xreplace(endless) for p in asked.parts()]
        passing = self.throughout.route(parts)
        if passing is not None:
            parts = [put_in(p, passing) for p in parts]
        closed = tuple(closed_formula(p, self.route, self.course) for p in parts)
        if isinstance(what, Relation) and isinstance(value, Sample):
            closed = tuple(signed_alike(c, value.drawn) for c in closed)
        self._demand_state(asked, closed)
        self._demand_limits(find, closed, value)
        by = settled_by(self.course, find, closed, value, self.spans)
        told = tuple(parts) if by is value else closed
        if isinstance(what, Relation):
            truth = holds(find, what.operator, told, closed, by, self.course.scene.everywhere())
            said = "true" if truth else "false"
            return AnsweredFind(Found(find.name, "truth", pure, None, None, said, find), passing)
        letters = self.course.parameters() | self._varying()
        symbolic = any(letters & c.free_symbols for c in closed)
        values = None if symbolic else tuple(self._number(p, c, by) for p, c in zip(told, closed, strict=True))
        short = all(not longer(c, CLOSED_OPS) and not rounded_inside(c) and not c.atoms(sp.Dummy) for c in closed)
        kind = "vector" if len(parts) == 2 else "number"
        energy = is_energy(what)
        assert asked.unit is not None
        formulas = closed if symbolic or short else None
        found = Found(find.name, kind, asked.unit, values, formulas, "", find, energy, tuple(parts))
        return AnsweredFind(found, passing)

    def _of_modes(self, asked: AskedFind) -> Found:
        """The periods or frequencies of several modes."""
        find, unit = asked.find, asked.unit
        what = find.found.what
        assert isinstance(what, Quantity)
        assert unit is not None
        about = next(o for o in self.oscillations if o.stop.name == what.things[0])
        sizes = tuple(asked.factor * e for e in mode_sizes(about, what.word, self.value))
        symbolic = any(self.course.parameters() & e.free_symbols for e in sizes)
        values = None if symbolic else tuple(self.value.settled(e, e) for e in sizes)
        told = symbolic or (has_formula(about, self.value) and not any(longer(e, CLOSED_OPS) for e in sizes))
        return Found(find.name, "list", unit, values, sizes if told else None, "", find)

    def _demand_state(self, asked: AskedFind, closed: tuple[sp.Expr, ...]) -> None:
        """FileProblem: what is asked without a state varies, and nothing is told of it but its own name.

        Of a relation that is whether it holds, which has one answer only where nothing in it varies.
        """
        varying = self._varying()
        relation = isinstance(asked.find.found.what, Relation)
        named = [c for c in closed if c in varying or (relation and c.free_symbols & varying)]
        if asked.at is None and named and all(c in named or c == 0 for c in closed):
            states = ", ".join(f"`@ {s.name}`" for s in self.course.problem.states)
            text = f"{asked.find.name} varies in the course of the motion: it has no one value"
            raise refuse(asked.find.mark, "PL560", text, f"say at which state: {states}")

    def _demand_limits(self, find: Find, closed: tuple[sp.Expr, ...], value: Valuation) -> None:
        """Undecided: what is asked where the time is infinite approaches nothing that was found."""
        course = self.course
        for k, state in enumerate(course.states):
            if without_end(course, k):
                own = set(course.stops[state.name].letters.values()) - value.values.keys()
                if any(c.free_symbols & own for c in closed):
                    text = f"{find.name}: as the time grows without end, no value was found that it approaches"
                    raise undecided_at(find.mark, f"{text}; ask at a time that is given, or for an extreme")

    def _varying(self) -> set[sp.Symbol]:
        return {s for r in self.course.distinct_regimes() for s in r.letters}

    @staticmethod
    def _number(expr: sp.Expr, closed: sp.Expr, value: Valuation) -> Settled:
        """Undecided: a denominator vanishes there, so that no number is one."""
        # Not one inside an integral, over whose variable it varies.
        powers = (p for p in expr.atoms(sp.Pow) if p.free_symbols <= expr.free_symbols)
        if any(p.exp.could_extract_minus_sign() and value.is_zero(p.base) for p in powers):
            raise Undecided("what is asked becomes 0/0 in the letters of this motion: it is not told")
        return value.settled(expr, closed)

    def _mode(self, what: Any, asked: AskedFind) -> tuple[str, str] | None:
        """A mode that is asked, or compared."""
        if isinstance(what, Relation) and (stated := mode_of(what)) is not None:
            side = what.left if isinstance(what.left, Quantity) else what.right
            name = self._mode_name(stated[0], getattr(side, "at", None), asked)
            return "truth", "true" if name == stated[1] else "false"
        if isinstance(what, Quantity) and what.word == "mode":
            return "word", self._mode_name(what.things[0], what.at, asked)
        return None

    def _mode_name(self, joint: str, at: Any, asked: AskedFind) -> str:
        reader = self.course.tellers[at] if isinstance(at, str) else asked.reader
        system = reader.regime.general.trial.system
        ours = next(our for our, name in system.aliases.items() if name == joint and system.modes[our].name)
        return system.modes[ours].name


def _is_true(course: StatedMotion, q: Quantity, value: Valuation) -> bool:
    """reached(s): is the state part of the motion? stable(s): does a small deviation stay small?"""
    if q.word == "reached":
        return q.things[0] in course.stops
    return stability(course.swings[q.things[0]], value).stable


def put_in(expr: sp.Expr, route: Route) -> sp.Expr:
    """An expression with the formulas of a route put in, all the way down."""
    for _ in range(60):
        inside = {s: route.formulas[s] for s in letters(expr) if s in route.formulas}
        if not inside or longer(expr, 3000):
            break
        expr = replaced(expr, inside)
    return expr


def closed_formula(expr: sp.Expr, route: Route, course: MotionEquations) -> sp.Expr:
    """A formula down to the names of the file; letters of the file stay in it."""
    expr, symbolic = replaced(put_in(expr, route), dict(course.rates.formulas)), course.symbolic
    if symbolic and not longer(expr, LONGEST):
        expr = with_whole_roots(expr, course.scene.root)
    most = LONGEST if symbolic else CLOSED_OPS
    if expr.is_number or expr.is_Symbol or longer(expr, most):
        return expr
    if not symbolic and any(a.has(sp.tan) for a in expr.atoms(sp.atan)):
        # By a place on an ellipse, tan(φ/2) = √((1 + ε)/(1 - ε)) tan(E/2), which nothing makes plainer.
        return expr
    found = with_short_roots(simplified(expr))
    found = course.scene.without_bars(found) if symbolic else found
    # What only a factor of a higher degree shows to be the same above and below.
    plain = factored(found) if symbolic and not found.has(sp.Integral) else found
    return plain if operations(plain) + 1 < operations(found) else found
