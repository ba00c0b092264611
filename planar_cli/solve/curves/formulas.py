"""Finds that are formulas: in the time and the coordinates of a general position, where the file names no instant.

The place of what is asked is written in the coordinates, and differentiated with their rates: v = dr/dt, a = dv/dt.
Forces come from the equations of the general position.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import longer, rounded_inside, simplified
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.system.conditions import vector_or_jet
from planar_cli.equation.system.system import mode_of
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution, refuse
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Find, Problem
from planar_cli.records import changing
from planar_cli.solve.between.branches.agreement import balanced
from planar_cli.solve.between.branches.solved_motion import SolvedMotion
from planar_cli.solve.curves.by_coordinates import by_coordinates
from planar_cli.solve.curves.kinds_asked import letter_of, tells
from planar_cli.solve.curves.kinematics import Story, no_value
from planar_cli.solve.curves.paths import CurveReader, without_told_places
from planar_cli.solve.curves.unsigned import divided, unsigned
from planar_cli.solve.diagnosis.clash import BLAMED, clash
from planar_cli.solve.diagnosis.placed import told_throughout
from planar_cli.solve.diagnosis.unheld import unheld
from planar_cli.solve.instant.verify import differs
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.passages import Passage, Tale, beside, sides_of
from planar_cli.solve.regimes.differentiated import differentiated, rates_put_in
from planar_cli.solve.regimes.functions import Functions, directed, drawn_start
from planar_cli.solve.regimes.mode_sequence import Stretch, Workshop, spans_of
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.roads import asks_forces, is_curve
from planar_cli.solve.solution import BY_ENERGY, Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit

CLOSED_OPS = 90
AGREE = Decimal("1e-25")
LONG_ROW = 24
"""A place whose derivatives take more operations is better told with the numbers of the instant."""


def general_regime(problem: Problem, earlier: Mapping[str, Any], exprs_of: Any) -> Regime:
    """The general position in the first modes that hold, worked out. `exprs_of`: what is needed of it."""
    workshop = Workshop(earlier)
    span = spans_of(problem, ())[0]
    objection, blamed = "", None
    mark = problem.find[0].mark
    for choice in workshop.drawn(span).choices():
        regime = workshop.regime(Stretch(span, choice))
        trial = regime.general.trial
        if trial.objection or not trial.outcomes:
            objection = objection or trial.objection
            blamed = blamed or (regime.general.instant, trial)
            continue
        regime.work(exprs_of(regime))
        return regime
    if blamed is not None and blamed[1].objection in BLAMED:
        raise NoSolution([clash(*blamed, mark)])
    raise NoSolution(
        [Diagnostic(mark, "PL622", f"no assumption about the contacts holds in a general position: {objection}")]
    )


def solve_formulas(problem: Problem, case: str, units: Mapping[str, str], earlier: Mapping[str, Any]) -> PartSolution:
    """All finds of a problem as formulas and curves."""

    def exprs_of(regime: Regime) -> list[sp.Expr]:
        quantities = regime.general.quantities
        return [e for f in problem.find if asks_forces(f) for e in _values(f, quantities)]

    regime = general_regime(problem, earlier, exprs_of)
    reader = FormulaReader(problem, units, regime)
    found = told_throughout(problem, [reader.answer(f) for f in problem.find])
    solution = regime.general.solution
    assert solution is not None
    if reader.compared:
        solution.checks.setdefault("lines", []).append("velocities and accelerations along the joints agree")
    for words in balanced([regime]):
        _checked(solution, words, BY_ENERGY)
    whole = not reader.kinetic and not reader.by_joints
    return PartSolution(case, (solution,), found, None, Tale(beside(reader.passages(), whole), whole))


def _checked(solution: InstantSolution, words: str, told: str) -> None:
    """A check that a person can make too. `told`: how the page tells it."""
    solution.checks.setdefault("lines", []).append(words)
    solution.checks.setdefault("told", []).append(told)


def _values(find: Find, quantities: Quantities) -> tuple[sp.Expr, ...]:
    """A find as one or two expressions; a relation as left and right."""
    what = find.found.what
    if isinstance(what, Relation):
        if mode_of(what) is not None:
            return ()
        sides: list[Any] = [vector_or_jet(s, quantities, quantities.evaluator) for s in (what.left, what.right)]
    elif isinstance(what, Quantity) and what.word == "mode":
        return ()
    else:
        one = vector_or_jet(what, quantities, quantities.evaluator)
        sides = [one.x, one.y] if isinstance(one, Vec) else [one]
    values = tuple(s.value for s in sides)
    if any(v is None for v in values):
        raise refuse(find.mark, "PL552", f"{find.name}: the accelerations do not tell this rate")
    return values


@changing
class FormulaReader:
    """Answers finds in one regime. `value`: of a formula at the instant asked for; `curves`: how they were found."""

    problem: Problem
    units: Mapping[str, str]
    regime: Regime
    value: Callable[[sp.Expr], Decimal | None] | None = None
    curves: list[tuple[Quantity, Passage]] = field(default_factory=list)
    compared: int = 0
    _quantities: Quantities | None = None
    _functions: Functions | None = None

    @property
    def quantities(self) -> Quantities:
        if self._quantities is None:
            self._quantities = differentiated(self.regime)
        return self._quantities

    @property
    def functions(self) -> Functions:
        if self._functions is None:
            self._functions = Functions(self.regime, drawn_start(self.regime))
            if self._uses_time():
                self._functions.find()
        return self._functions

    @property
    def kinetic(self) -> bool:
        """Do forces tell the motion, or is one asked?"""
        return bool(self.regime.free and self._massive()) or any(asks_forces(f) for f in self.problem.find)

    @property
    def by_joints(self) -> bool:
        """Do joints, not `motion` alone, tell how fast coordinates change that stand in the finds?"""
        if all(is_curve(f.found.what) for f in self.problem.find):
            return False
        varying = {c.symbol for c in self.regime.coordinates}
        return any(r.free_symbols & varying for s, r in self.regime.rates.items() if s not in self.functions.found)

    def _massive(self) -> bool:
        return any(b.mass != 0 for b in self.regime.general.instant.scene.bodies.values())

    def _uses_time(self) -> bool:
        return any(isinstance(n, Name) and n.name == "t" for f in formulas(self.problem) for n in walk(f.tree))

    # --- answers -----------------------------------------------------------------------------------------------------

    def answer(self, find: Find) -> Found:
        """One find."""
        what = find.found.what
        if is_curve(what):
            assert isinstance(what, Quantity)
            self._check_points(find, what)
            found, passage = CurveReader(self.regime, drawn_start(self.regime)).answer(find)
            self.curves.append((what, passage))
            return found
        if isinstance(what, Relation) or (isinstance(what, Quantity) and what.word == "mode"):
            word = self._word(find, what)
            kind = "word" if isinstance(what, Quantity) else "truth"
            return Found(find.name, kind, parse_unit("1"), None, None, word, find)
        quantities = self.regime.general.quantities if asks_forces(find) else self.quantities
        raw = _values(find, quantities)
        if not asks_forces(find):
            self._check(find, raw)
        parts = tuple(self.closed(e, find) for e in raw)
        varying = set(self.regime.general.instant.scene.ledger.letters)
        values = None
        if not any(p.free_symbols & varying for p in parts):
            value = self.regime.general.instant.scene.valuations[0]
            if any(value.known(s) is None for p in parts for s in p.free_symbols):
                text = f"{find.name} rests on a motion that nothing in the file tells"
                hint = "hold it by a joint, or say in `motion` how it moves"
                raise NoSolution([Diagnostic(find.mark, "PL651", text, hint)])
            values = tuple(value.settled(p, p) for p in parts)
        elif not self._uses_time():
            self._check_closed(find, raw, parts)
        short = all(not longer(p, CLOSED_OPS) and not rounded_inside(p) for p in parts)
        kind = "vector" if len(parts) == 2 else "number"
        energy = any(q.word in ("KE", "PE") for q in quantities_in(what))
        shown = parts if values is None or short else None
        return Found(find.name, kind, self._unit(find), values, shown, "", find, energy, parts)

    def _check_closed(self, find: Find, raw: tuple[sp.Expr, ...], parts: tuple[sp.Expr, ...]) -> None:
        """The formulas as they are printed are the same numbers as those that were worked out."""
        rates, value = rates_put_in(self.regime), self.regime.general.instant.scene.valuations[0]
        for before, after in zip(raw, parts, strict=True):
            one, other = value.known(self.regime.closed(before.xreplace(rates))), value.known(after)
            if one is not None and other is not None and abs(one - other) > AGREE * max(abs(one), Decimal("1e-20")):
                text = f"{find.name}: the formula gives {other:.6g}, what it was worked out from {one:.6g}"
                raise differs(find.mark, text)

    def _check_points(self, find: Find, what: Quantity) -> None:
        """The points of a curve move as the joints let them, where these may say something else than the places."""
        for point in what.things:
            if point in self.regime.general.instant.scene.points:
                asked = replace(find.found, what=Quantity("v", (point,), None, (), None, what.mark))
                moves = replace(find, found=asked, name=point)
                self._check(moves, _values(moves, self.quantities))

    def _check(self, find: Find, raw: tuple[sp.Expr, ...]) -> None:
        """The derivatives of places are what the joints say of velocities and accelerations."""
        outcome = self.regime.general.trial.outcomes[0]
        rates = rates_put_in(self.regime)
        value = outcome.value.extended(unknowns_of(self.regime.general.trial.system, outcome))
        for ours, theirs in zip(raw, _values(find, self.regime.general.quantities), strict=True):
            one, other = value(self.regime.closed(ours.xreplace(rates))), value(theirs)
            if abs(one - other) > AGREE * max(abs(one), abs(other), Decimal("1e-20")):
                points = (p for q in quantities_in(find.found.what) for p in q.things)
                if (loose := unheld(self.regime.general.trial.system, points)) is not None:
                    raise NoSolution([loose])
                text = f"{find.name}: the derivative of the place is {one:.6g}, the joints give {other:.6g}"
                raise differs(find.mark, text)
        self.compared += len(raw)

    def closed(self, expr: sp.Expr, find: Find) -> sp.Expr:
        """A formula in t and the coordinates of the file; our own coordinates are put in as functions of time."""
        expr = self.clean(expr)
        scene = self.regime.general.instant.scene
        own = {c.symbol: c for c in self.regime.coordinates if c.symbol not in scene.ledger.coordinates}
        left = [c for s, c in own.items() if s in expr.free_symbols]
        if left and not self._uses_time():
            expr = expr.subs({c.symbol: c.drawn for c in left if c.drawn is not None})
        elif left:
            raise self._open(find, left[0].words)
        speeds = set(scene.evaluator.speeds)
        titles = self.regime.general.trial.system.titles
        if loose := sorted(expr.free_symbols & set(self.regime.free) - speeds, key=str):
            raise self._open(find, titles.get(loose[0], loose[0].name))
        return expr

    def clean(self, expr: sp.Expr) -> sp.Expr:
        """A formula of the regime with rates and functions of time put in, as it is printed."""
        expr = self.regime.closed(expr.xreplace(rates_put_in(self.regime)))
        expr = unsigned(simplified(self.functions.put_in(expr)), self.regime.general.instant.scene)
        expr = divided(simplified(expr))
        return self._together(directed(expr, self.regime.general.instant.scene.valuations[0]))

    def _together(self, expr: sp.Expr) -> sp.Expr:
        """r - r cos φ as r (1 - cos φ), beside r (φ - sin φ): what all terms have of the letters of the file."""
        ledger = self.regime.general.instant.scene.ledger
        whole = factor_terms(expr) if expr.is_Add else expr
        own = {*ledger.coordinates, self.regime.time}
        shared = {f for f in sp.Mul.make_args(whole) if f.is_Symbol} - own if whole is not expr else set()
        return whole if shared & set(ledger.letters) else expr

    @staticmethod
    def _open(find: Find, words: str) -> Exception:
        text = f"{find.name}: the file does not tell how this varies in time: {words}"
        return refuse(
            find.mark, "PL651", text, "give the start of the motion in `states`, or say in `motion` how it moves"
        )

    def _unit(self, find: Find) -> Any:
        if find.found.unit is not None:
            return parse_unit(find.found.unit)
        if find.name in self.units:
            return parse_unit(self.units[find.name])
        setup, what = self.regime.general.instant.setup, find.found.what
        assert isinstance(what, Side)
        return setup.unit_for(dimension_of(what, setup.lookup))

    def _word(self, find: Find, what: Any) -> str:
        """A mode, or whether a relation holds whatever t and the coordinates are."""
        system = self.regime.general.trial.system
        stated = mode_of(what) if isinstance(what, Relation) else (what.things[0], "")
        if stated is not None:
            ours = next(our for our, name in system.aliases.items() if name == stated[0] and system.modes[our].name)
            name = system.modes[ours].name
            return name if not isinstance(what, Relation) else "true" if name == stated[1] else "false"
        left, right = (self.closed(e, find) for e in _values(find, self.regime.general.quantities))
        truths = set()
        for value in self.regime.general.instant.scene.valuations:
            off = Decimal(0) if value.is_zero(left - right) else value(left - right)
            truths.add({"<": off < 0, ">": off > 0, "<=": off <= 0, ">=": off >= 0, "=": not off}[what.operator])
        return "true" if truths == {True} else "false"

    # --- telling -----------------------------------------------------------------------------------------------------

    def passages(self) -> tuple[Passage, ...]:
        """Places and their derivatives, then the curves."""
        finds = [f for f in self.problem.find if not is_curve(f.found.what) and not asks_forces(f)]
        told = () if self.kinetic or not finds else self._places(finds)
        return (*told, *(without_told_places(q, curve, told) for q, curve in self.curves))

    def by_coordinates(self, value: Valuation) -> tuple[tuple[Passage, ...], frozenset[str]]:
        """The same with the coordinates that are given over time as letters, and their names; empty: there are none."""
        driven = by_coordinates(self.regime, value, lambda f: not longer(f, LONG_ROW) and self.value is not None)
        if driven is None or self.curves:
            return (), frozenset()
        finds = [f for f in self.problem.find if not is_curve(f.found.what)]
        story = Story(self.regime, self.quantities, self.functions, driven.clean, False, driven.known, driven)
        return story.passages(finds), frozenset(q.name for q in driven.driven)

    def _places(self, finds: list[Find]) -> tuple[Passage, ...]:
        value = self.value or no_value
        story = Story(self.regime, self.quantities, self.functions, self.clean, not self.by_joints, value)
        return story.passages(finds)


def at_given_time(problem: Problem, solved: SolvedMotion, passages: tuple[Passage, ...]) -> Tale | None:
    """One instant of a motion that `motion` gives as short places over time: differentiated, then the time put in.
    `passages`: what is told of curves. None: it is no such motion.
    """
    regimes = solved.course.distinct_regimes()
    statements = problem.states[0].relations if problem.states else problem.instant or ()
    stated = [s for s in statements if isinstance(s, Relation)]
    several = problem.states and (problem.states[1:] or not _is_date(stated) or len(statements) > 1)
    dated = solved.value.known(list(solved.course.stops.values())[-1].t) is not None
    if several or not dated or len(regimes) != 1 or any(asks_forces(f) for f in problem.find):
        return None
    reader = FormulaReader(problem, {}, regimes[0], _values_in(solved, regimes[0]))
    if set(Functions(regimes[0], {}).find()) != set(regimes[0].rates) or reader.kinetic:
        return None
    when = " and ".join(s.text for s in stated)
    told, names = reader.passages(), frozenset[str]()
    if _is_long(told):
        told, names = reader.by_coordinates(_at_instant(solved, regimes[0]))
    if not told or _is_long(told):
        return None
    finds = [f for f in problem.find if not is_curve(f.found.what)]
    letters = {f.name: letter for f in finds if (letter := letter_of(f)) is not None}
    valued = _is_date(stated) and all(row.value is not None for p in told for row in p.rows)
    if valued and finds and all(tells(f, names, finds) for f in finds):
        return Tale((Passage(f"Values are those at {when}.", ()), *told, *passages), True, True, letters)
    return None if names else Tale((*told, Passage(f"All this is taken at {when}.", ()), *passages))


def _is_long(told: tuple[Passage, ...]) -> bool:
    return any(longer(side, LONG_ROW) for p in told for row in p.rows for side in sides_of(row))


def _at_instant(solved: SolvedMotion, regime: Regime) -> Valuation:
    """Numbers at the instant that is asked for."""
    stop = list(solved.course.stops.values())[-1]
    return solved.value.extended({regime.time: solved.value(stop.t)})


def _is_date(stated: Sequence[Relation]) -> bool:
    """Is the time of an instant all that is stated of it?"""
    return [(s.operator, getattr(s.left, "name", "")) for s in stated] == [("=", "t")]


def _values_in(solved: SolvedMotion, regime: Regime) -> Callable[[sp.Expr], Decimal | None]:
    """Numbers of formulas in the time at the instant that is asked for; none where they hold letters without one."""
    value = _at_instant(solved, regime)
    open_letters = solved.course.parameters()

    def number(expr: sp.Expr) -> Decimal | None:
        return None if expr.free_symbols & open_letters else value.known(expr)

    return number
