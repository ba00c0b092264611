"""States in their order, the letters of each state, and what the file states of them as equations between letters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field, replace
from typing import Any, TypeGuard

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.polar import vector_equations
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.system.conditions import gap, vector_or_jet
from planar_cli.equation.system.system import mode_of
from planar_cli.equation.values.evaluate import Evaluator
from planar_cli.equation.values.jets import Jet, constant
from planar_cli.equation.values.ledger import Kind, Ledger, Role
from planar_cli.errors import NOWHERE, Mark, refuse
from planar_cli.problem.checks.check_dimensions import about
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import (
    AtRest,
    Equilibrium,
    Extreme,
    Grouped,
    Part,
    Quantity,
    Relation,
    Side,
    Statement,
)
from planar_cli.problem.scene.ended import told_before
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.polar import VectorStatement, grouped
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import changing, record
from planar_cli.solve.regimes.after import changes_at_once
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.roads import SPANNED

KeptLetters = Mapping[int, Mapping[sp.Symbol, sp.Symbol]]
"""By the id of a regime: unknowns of its general position that stay in a formula, and their names in the motion."""
NONE_KEPT: KeptLetters = {}


@record
class Stop:
    """One state with its letters."""

    name: str
    relations: tuple[Statement, ...]
    letters: Mapping[sp.Symbol, sp.Symbol]
    """By the letter of the general position, the one of this state."""
    time: sp.Symbol
    """The letter of the general position that is the time."""
    speeds: frozenset[sp.Symbol] = frozenset()
    """The letters of the general position that are velocities."""
    mark: Mark = NOWHERE
    turning: bool = False
    """Put in by us, where something comes to rest or begins to act otherwise."""

    def at(self, expr: sp.Expr) -> sp.Expr:
        """A formula of the general position at this state."""
        return expr.xreplace(dict(self.letters))

    @property
    def t(self) -> sp.Symbol:
        return self.letters[self.time]


@record
class Demand:
    """What the file states of one state."""

    state: str
    text: str
    mark: Mark
    residual: sp.Expr
    """It vanishes, or is positive, or becomes infinite, or is largest or smallest."""
    kind: str = "equation"
    """equation, inequality, extreme or limit."""
    sign: int = 0
    """Of an inequality, 1: it is positive; 0: not negative."""
    extreme: int = 0
    """1 or -1 where it is to be largest or smallest."""
    trend: sp.Expr | None = None
    """It must be positive, where the residual alone would also let the opposite direction pass."""


@changing
class Reader:
    """Reads statements and finds of a problem in one regime."""

    problem: Problem
    regime: Regime
    stops: dict[str, Stop]
    """All states."""
    readers: dict[str, Reader]
    """Who reads at each state, by its name."""
    tellers: dict[str, Reader]
    """Who reads what may jump there."""
    told: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    """What stand-ins are, in letters of states."""
    pending: dict[sp.Symbol, tuple[Reader, str, sp.Expr]] = field(default_factory=dict)
    """Stand-ins for quantities at other states, with who reads them there."""
    spans: dict[sp.Symbol, Quantity] = field(default_factory=dict)
    """Stand-ins for quantities over spans or about states."""
    exprs: list[sp.Expr] = field(default_factory=list)
    """What the regime has to work out for them."""
    winding: dict[sp.Symbol, Quantity] = field(default_factory=dict)
    """Stand-ins for angles of places at other states whose turns are still to be counted along the motion."""

    # --- quantities of the general position --------------------------------------------------------------------------

    def quantities(self) -> Quantities:
        """Quantities that know other states."""
        base = self.regime.general.quantities

        def scalar(q: Quantity) -> Jet:
            if q.at is None and q.word not in SPANNED:
                return found.scalar(q)
            there = self.any(q)
            if isinstance(there, Vec) and isinstance(q.at, tuple):
                text = f"{q.word}(…) is a vector"
                raise refuse(q.mark, "PL550", text, "ask for a part: .x .y .mag .angle .along(30 deg)")
            if isinstance(there, Vec):
                return found.scalar(replace(q, at=None))
            return there

        def at_state(state: str) -> Any:
            return lambda side: constant(self._elsewhere(state, side))

        evaluator = Evaluator(base.scene.ledger, base.scene.evaluator.motions, scalar, at_state)
        found = Quantities(base.scene, base.motion, base.reactions, evaluator)
        return found

    def _elsewhere(self, state: str, side: Side) -> sp.Expr:
        """A stand-in for a number at another state."""
        found = self._there(state, side)
        if isinstance(found, Vec):
            raise refuse(side.mark, "PL550", "a vector stands where a number belongs", "ask for a part: .x .y .mag")
        return found.value

    def _there(self, state: str, side: Side) -> Jet | Vec:
        after = changes_at_once(side) and not told_before(side, self.problem, state)
        other = (self.tellers if after else self.readers)[state]
        value = other.any(side)
        if isinstance(value, Vec):
            return Vec(*(constant(self._stand_in(other, state, p.value)) for p in (value.x, value.y)))
        found = self._stand_in(other, state, value.value)
        if is_place_angle(side) and sp.sympify(value.value).has(sp.atan2):
            self.winding[found] = side
        return constant(found)

    def _stand_in(self, other: Reader, state: str, value: sp.Expr) -> sp.Symbol:
        symbol = sp.Dummy(f"at_{state}", real=True)
        self.pending[symbol] = (other, state, value)
        other.exprs.append(value)
        return symbol

    def number(self, side: Side) -> sp.Expr:
        """A side in the general position as one expression."""
        found = self.any(side)
        assert isinstance(found, Jet)
        return found.value

    def _span(self, q: Quantity) -> sp.Symbol:
        symbol = sp.Dummy(f"span_{q.word}", real=True)
        self.spans[symbol] = q
        return symbol

    def _over(self, q: Quantity) -> Jet | Vec:
        """Stand-ins for a quantity over a span: of a vector for both components, which `parts` then name."""
        whole = replace(q, parts=())
        vector = q.word == "impulse" and about(q, Scope(self.problem, ())) is None
        if q.word == "mean":
            assert q.argument is not None
            assert not isinstance(q.argument, Relation)
            vector = isinstance(self.any(q.argument), Vec)
        if not vector:
            return constant(self._span(whole))
        x, y = (self._span(replace(q, parts=(Part(k, None, q.mark),))) for k in ("x", "y"))
        found: Jet | Vec = Vec(constant(x), constant(y))
        for part in q.parts:
            if part.kind in ("t", "n", "r", "theta") or not isinstance(found, Vec):
                text = f".{part.kind} of {q.word}(…) over a span"
                raise refuse(part.mark, "PL551", text, "ask .x .y .mag or .along(…)")
            found = self.quantities().part(found, part, q)
        return found

    def any(self, side: Side) -> Jet | Vec:
        """A side as a jet or a vector of jets, in the unknowns of the general position."""
        if isinstance(side, Quantity):
            if isinstance(side.at, tuple):
                return self._over(side)
            if side.word in SPANNED:
                return constant(self._span(side))
            if side.at is not None:
                return self._there(side.at, replace(side, at=None))
        if isinstance(side, Grouped):
            return self._there(side.at, side.operand)
        quantities = self.quantities()
        found: Jet | Vec = vector_or_jet(side, quantities, quantities.evaluator)
        return found

    def at(self, stop: Stop, expr: sp.Expr, kept: KeptLetters = NONE_KEPT) -> sp.Expr:
        """A closed formula of the general position at a state, stand-ins put in. `kept`: unknowns that stay in it."""
        return self.settled(stop.at(self._closed(expr, kept)), kept)

    def closed(self, expr: sp.Expr, kept: KeptLetters = NONE_KEPT) -> sp.Expr:
        """A closed formula that holds throughout, stand-ins put in."""
        return self.settled(self._closed(expr, kept), kept)

    def _closed(self, expr: sp.Expr, kept: KeptLetters) -> sp.Expr:
        names = kept.get(id(self.regime), {})
        return self.regime.closed(expr, frozenset(names)).xreplace(dict(names))

    def settled(self, expr: sp.Expr, kept: KeptLetters = NONE_KEPT) -> sp.Expr:
        """Stand-ins for other states put in."""
        inside = {}
        for symbol in expr.free_symbols:
            if symbol in self.pending:
                other, state, value = self.pending[symbol]
                inside[symbol] = other.at(self.stops[state], value, kept)
        settled: sp.Expr = expr.xreplace(inside) if inside else expr
        while inside := {s: self.told[s] for s in settled.free_symbols if s in self.told}:
            settled = settled.xreplace(inside)
        return settled

    # --- statements --------------------------------------------------------------------------------------------------

    def raw(self, statements: Iterable[Statement]) -> list[tuple[Statement, tuple[Any, ...]]]:
        """Every statement with its expressions in the unknowns of the general position, not yet closed."""
        found: list[tuple[Statement, tuple[Any, ...]]] = []
        statements = list(statements)
        relations = [s for s in statements if isinstance(s, Relation) and mode_of(s) is None]
        found += [(s, e) for item in grouped(relations) for s, e in self._relation(item)]
        for s in statements:
            if isinstance(s, Extreme):
                found.append((s, (self._number(s.side),)))
            elif isinstance(s, AtRest | Equilibrium):
                found += [(s, ("=", e, None)) for e in self._rest(s)]
        for _, parts in found:
            self.exprs += [p for p in parts if isinstance(p, sp.Basic)]
        return found

    def _number(self, side: Side) -> sp.Expr:
        """A side as one expression; of a magnitude the square, which has its extremes in the same places."""
        if isinstance(side, Quantity) and side.parts and side.parts[-1].kind == "mag" and side.at is None:
            whole = self.any(replace(side, parts=side.parts[:-1]))
            if isinstance(whole, Vec):
                return whole.x.value**2 + whole.y.value**2
        found = self.any(side)
        assert isinstance(found, Jet)
        return found.value

    def relation(self, s: Relation) -> list[tuple[Any, ...]]:
        """One relation: operators, what vanishes or is compared with zero, and what must be positive besides."""
        return [parts for item in grouped([s]) for _, parts in self._relation(item)]

    def _relation(self, item: Relation | VectorStatement) -> list[tuple[Relation, tuple[Any, ...]]]:
        """A relation, or one or two about a vector, with what vanishes and what must be positive."""
        difference: Any
        trend: sp.Expr | None = None
        if isinstance(item, VectorStatement) and self._counted(item):
            if item.size is not None:
                return [told for r in item.relations for one in grouped([r]) for told in self._relation(one)]
            item = item.relations[0]
        if isinstance(item, VectorStatement):
            s, (difference, trend) = item.relations[0], vector_equations(item, self.any)
            s = replace(s, text=", ".join(r.text for r in item.relations))
        else:
            s = item
            left: Any = self.any(item.left)
            right: Any = self.any(item.right)
            if isinstance(left, Jet) and isinstance(right, Jet) and s.operator == "=":
                for one, other in ((left.value, right.value), (right.value, left.value)):
                    if other in (sp.oo, -sp.oo):
                        return [(s, ("limit", one if other == sp.oo else -one, None))]
            difference = gap(left, right)
        if isinstance(difference, Vec):
            return [(s, ("=", difference.x.value, trend)), (s, ("=", difference.y.value, trend))]
        return [(s, (s.operator, difference.value, trend))]

    def _counted(self, item: VectorStatement) -> bool:
        """Does a statement about the direction of a place tell its turns as well?"""
        if item.vector.word != "r" or item.angle is None:
            return False
        angle = self.any(replace(item.vector, parts=(*item.vector.parts, Part("angle", None, item.vector.mark))))
        return isinstance(angle, Jet) and not angle.value.has(sp.atan2)

    def _rest(self, s: AtRest | Equilibrium) -> list[sp.Expr]:
        """Velocities that vanish: those of a body, or all free ones; in equilibrium their rates as well."""
        regime = self.regime
        general = regime.general
        motion = general.quantities.motion
        found: list[sp.Expr] = []
        scene = general.instant.scene
        if s.body is None:
            found += list(general.free)
            # What a running surface takes along is not at rest.
            sticking = [m.sliding for m in general.trial.system.modes.values() if m.direction == 0]
            found += [row.rate for row in sticking if row is not None and not scene.is_zero(row.rate)]
            if isinstance(s, Equilibrium):
                driven = general.trial.system.driven() if self.problem.motion else set()
                found += [a for a in map(general.rate_of, general.free) if a not in driven]
            return found
        center = scene.center(s.body)
        v = motion.velocity(center, s.body)
        found += [e for e in (v.x, v.y) if e != 0]
        if scene.rigid(s.body) and motion.velocities[s.body].angular != 0:
            found.append(motion.velocities[s.body].angular)
        return found

    def _resting(self, stop: Stop, residual: sp.Expr) -> sp.Expr:
        """Where one free speed moves a body, that speed itself vanishes with the body's velocity."""
        speeds = {stop.letters[u] for u in self.regime.free}
        inside = residual.free_symbols & speeds
        if len(inside) != 1:
            return residual
        u = inside.pop()
        factor = simplified(residual / u)
        return residual if u in factor.free_symbols else u

    def demands(self, stop: Stop, raw: list[tuple[Statement, tuple[Any, ...]]]) -> list[Demand]:
        """The statements of one state as equations between letters, once everything is closed."""
        found = []
        for s, parts in raw:
            if isinstance(s, Extreme):
                value = self.closed(parts[0])
                found.append(Demand(stop.name, s.text, s.mark, value, "extreme", extreme=s.sense))
                continue
            operator, expr, trend = parts
            residual = simplified(self.at(stop, expr))
            direction = None if trend is None else self.at(stop, trend)
            if operator == "limit":
                found.append(Demand(stop.name, s.text, s.mark, residual, "limit"))
                continue
            if isinstance(s, AtRest | Equilibrium):
                residual = self._resting(stop, residual)
            if operator == "=":
                if residual != 0 and not any(d.residual == residual for d in found):
                    found.append(Demand(stop.name, s.text, s.mark, residual, trend=direction))
            else:
                sign = 1 if operator in "<>" else 0
                held = residual if operator.startswith(">") else -residual
                found.append(Demand(stop.name, s.text, s.mark, held, "inequality", sign))
        return found


def is_place_angle(side: Side) -> TypeGuard[Quantity]:
    """Is it r(…).angle, which counts turns?"""
    return isinstance(side, Quantity) and side.word == "r" and bool(side.parts) and side.parts[-1].kind == "angle"


def stop_of(
    name: str,
    relations: tuple[Statement, ...],
    mark: Mark,
    letters: Iterable[sp.Symbol],
    ledger: Ledger,
    made: dict[tuple[int, sp.Symbol, str], sp.Symbol],
) -> Stop:
    """A state with letters of its own, named after it: x_2, v_x_2, t_2. `made`: those of earlier tries."""
    own = {}
    for s in letters:
        key = (id(ledger), s, name)
        if key not in made:
            title = f"{s.name}__{name}" if name else s.name + "__1"
            made[key] = ledger.fresh(title, ledger.units[s].text, role=Role(Kind.STATE, s, name))
        own[s] = made[key]
    time = next(s for s in own if ledger.roles[s].kind is Kind.TIME)
    return Stop(name, relations, own, time, frozenset(s for s in own if ledger.is_speed(s)), mark)
