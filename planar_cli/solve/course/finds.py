"""What is asked of a motion: quantities at states, formulas that hold throughout, truths and modes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from planar_cli.equation.conditions import gap
from planar_cli.equation.evaluate import refuse
from planar_cli.equation.exact import Settled, Valuation
from planar_cli.equation.plain import longer, rounded_inside, simplified, with_short_roots
from planar_cli.equation.system import mode_of
from planar_cli.errors import Undecided
from planar_cli.problem.check_dimensions import about
from planar_cli.problem.dimensions import Kind, dimension_of
from planar_cli.problem.expression import Name, Quantity, Relation
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import Find
from planar_cli.problem.scope import Scope
from planar_cli.solve.asked import is_energy
from planar_cli.solve.course.derivation import Route
from planar_cli.solve.course.motion_equations import MotionEquations
from planar_cli.solve.course.oscillation import stability
from planar_cli.solve.course.paths import CurveReader
from planar_cli.solve.course.regime_sequence import RegimeSequence
from planar_cli.solve.course.starts import started
from planar_cli.solve.course.stated_motion import StatedMotion
from planar_cli.solve.course.throughout import Throughout
from planar_cli.solve.course.timeline import Reader, Stop
from planar_cli.solve.course.trace import SpanIntegral
from planar_cli.solve.course.unsettled import settled_by
from planar_cli.solve.passages import Passage
from planar_cli.solve.roads import is_curve
from planar_cli.solve.solution import Found
from planar_cli.solve.truth import holds
from planar_cli.units import IMPULSE, Unit, parse_unit

CLOSED_OPS, LONGEST = 90, 600
TRUTHS = ("reached", "stable")


@dataclass(slots=True)
class Asked:
    """One find as expressions with stand-ins (a relation: left and right), read by `reader`; `at`: its state, if it has
    no `@` of its own.
    """

    find: Find
    reader: Reader
    parts: tuple[sp.Expr, ...]
    at: Stop | None


@dataclass(slots=True)
class FindReader:
    """Reads all finds before the regimes are worked out, and answers them afterwards."""

    motion: RegimeSequence
    units: dict[str, str]
    asked: list[Asked] = field(default_factory=list)
    throughout: Throughout | None = None
    passing: dict[str, Route] = field(default_factory=dict)
    curves: list[Passage] = field(default_factory=list)

    def read(self) -> None:
        course = self.motion
        only = "" in course.stops
        last = course.states[-1].name if course.states else next(iter(course.stops))
        for find in course.problem.find:
            reader = course.readers[last]
            at = course.stops[""] if only else None
            self.asked.append(Asked(find, reader, self._parts(find, reader), at))

    def _parts(self, find: Find, reader: Reader) -> tuple[sp.Expr, ...]:
        what = find.found.what
        if isinstance(what, Relation):
            if mode_of(what) is not None:
                return ()
            apart = gap(reader.any(what.left), reader.any(what.right))
            parts = tuple(p.value for p in ((apart.x, apart.y) if isinstance(apart, Vec) else (apart,)))
        elif (isinstance(what, Quantity) and what.word == "mode") or is_curve(what):
            return ()
        else:
            found = reader.any(what)
            parts = tuple(p.value for p in (found.x, found.y)) if isinstance(found, Vec) else (found.value,)
        if any(p is None for p in parts):
            raise refuse(find.mark, "PL552", f"{find.name}: the accelerations do not tell this rate")
        reader.exprs += parts
        return parts

    # --- answers -----------------------------------------------------------------------------------------------------

    def answer(
        self, course: MotionEquations, asked: Asked, route: Route, value: Valuation, spans: Iterable[SpanIntegral]
    ) -> Found:
        """One find. `value`: numbers of everything; `spans`: quantities over spans, worked out."""
        find, what = asked.find, asked.find.found.what
        pure = parse_unit("1")
        mode = self._mode(what, asked)
        if mode is not None:
            return Found(find.name, mode[0], pure, None, None, mode[1], find)
        if isinstance(what, Quantity) and what.word in TRUTHS:
            word = "true" if _is_true(course, what, value) else "false"
            return Found(find.name, "truth", pure, None, None, word, find)
        if is_curve(what):
            known = {} if self.throughout is None else self.throughout.start
            starts = started(course, asked.reader.regime, lambda s: known.get(s, s), value)
            found, passage = CurveReader(asked.reader.regime, starts).answer(find)
            self.curves.append(passage)
            return found
        parts = [self.settled(asked, p) for p in asked.parts]
        if isinstance(what, Quantity) and what.word == "frequency" and self.unit_of(find).angle:
            parts = [2 * sp.pi * p for p in parts]
        passing = None if self.throughout is None else self.throughout.route(parts)
        if passing is not None:
            self.passing[find.name] = passing
            parts = [self.put_in(p, passing) for p in parts]
        closed = tuple(self.closed(p, route, course.symbolic) for p in parts)
        by = settled_by(course, find, closed, value, spans)
        told = tuple(parts) if by is value else closed
        if isinstance(what, Relation):
            truth = holds(find, what.operator, told, closed, by, course.scene.everywhere())
            return Found(find.name, "truth", pure, None, None, "true" if truth else "false", find)
        letters = course.parameters() | self._varying()
        symbolic = any(letters & c.free_symbols for c in closed)
        values = None if symbolic else tuple(self._number(p, c, by) for p, c in zip(told, closed, strict=True))
        short = all(not longer(c, CLOSED_OPS) and not rounded_inside(c) and not c.atoms(sp.Dummy) for c in closed)
        kind = "vector" if len(parts) == 2 else "number"
        energy = is_energy(what)
        return Found(
            find.name,
            kind,
            self.unit_of(find),
            values,
            closed if symbolic or short else None,
            "",
            find,
            energy,
            tuple(parts),
        )

    def _varying(self) -> set[sp.Symbol]:
        return {s for r in self.motion.distinct_regimes() for s in r.letters}

    def settled(self, asked: Asked, part: sp.Expr) -> sp.Expr:
        """A part of a find in letters of states, or of the general position where it holds throughout."""
        if asked.at is not None:
            return asked.reader.at(asked.at, part)
        return asked.reader.closed(part)

    @staticmethod
    def _number(expr: sp.Expr, closed: sp.Expr, value: Valuation) -> Settled:
        """Undecided: a denominator vanishes there, so that no number is one."""
        if any(p.exp.could_extract_minus_sign() and value.is_zero(p.base) for p in expr.atoms(sp.Pow)):
            raise Undecided("what is asked becomes 0/0 in the letters of this motion: it is not told")
        return value.settled(expr, closed)

    @staticmethod
    def put_in(expr: sp.Expr, route: Route) -> sp.Expr:
        """An expression with the formulas of a route put in, all the way down."""
        for _ in range(60):
            inside = {s: route.formulas[s] for s in expr.free_symbols if s in route.formulas}
            if not inside or longer(expr, 3000):
                break
            expr = expr.xreplace(inside)
        return expr

    def closed(self, expr: sp.Expr, route: Route, symbolic: bool) -> sp.Expr:
        """The formula of a find down to the names of the file. `symbolic`: letters of the file stay in it."""
        expr = self.put_in(expr, route)
        most = LONGEST if symbolic else CLOSED_OPS
        return expr if expr.is_number or expr.is_Symbol or longer(expr, most) else with_short_roots(simplified(expr))

    def unit_of(self, find: Find) -> Unit:
        if find.found.unit is not None:
            return parse_unit(find.found.unit)
        if find.name in self.units:
            return parse_unit(self.units[find.name])
        setup = self.motion.readers[next(iter(self.motion.stops))].regime.general.instant.setup
        what = find.found.what
        assert not isinstance(what, Relation)
        scope = Scope(self.motion.problem, ())

        def lookup(thing: Name | Quantity) -> Kind | None:
            if isinstance(thing, Quantity) and thing.word == "impulse" and about(thing, scope) is None:
                return Kind(IMPULSE)
            return setup.lookup(thing)

        return setup.unit_for(dimension_of(what, lookup))

    def _mode(self, what: Any, asked: Asked) -> tuple[str, str] | None:
        """A mode that is asked, or compared."""
        if isinstance(what, Relation) and (stated := mode_of(what)) is not None:
            side = what.left if isinstance(what.left, Quantity) else what.right
            name = self._mode_name(stated[0], getattr(side, "at", None), asked)
            return "truth", "true" if name == stated[1] else "false"
        if isinstance(what, Quantity) and what.word == "mode":
            return "word", self._mode_name(what.things[0], what.at, asked)
        return None

    def _mode_name(self, joint: str, at: Any, asked: Asked) -> str:
        reader = self.motion.tellers[at] if isinstance(at, str) else asked.reader
        system = reader.regime.general.trial.system
        ours = next(our for our, name in system.aliases.items() if name == joint and system.modes[our].name)
        return system.modes[ours].name


def _is_true(course: StatedMotion, q: Quantity, value: Valuation) -> bool:
    """reached(s): is the state part of the motion? stable(s): does a small deviation stay small?"""
    if q.word == "reached":
        return q.things[0] in course.stops
    return stability(course.swings[q.things[0]], value).stable
