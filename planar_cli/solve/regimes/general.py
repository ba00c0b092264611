"""A scene in a general position: which coordinates vary, which speeds are free, and all else in terms of them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import field
from decimal import Decimal
from functools import cache
from itertools import islice
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.displaced import Displacer
from planar_cli.equation.kinematics.motion import Tree
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.scene.displacement import Coordinate, CoordinateNames, Displacement
from planar_cli.equation.system.setup import Course, Setup
from planar_cli.equation.system.system import Statements
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.sample import anywhere
from planar_cli.errors import NoSolution, Undecided
from planar_cli.problem.scene.ordinary import Scales
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import changing
from planar_cli.solve.diagnosis.clash import OffBalance, off_balance
from planar_cli.solve.diagnosis.placed import held_by_too_little, placed_by_nothing
from planar_cli.solve.instant.finish import Finisher
from planar_cli.solve.instant.instant import Instant, Trial
from planar_cli.solve.instant.stages import Stage, acceleration_unknowns, needed
from planar_cli.solve.instant.study import Velocities, solve_velocities
from planar_cli.solve.instant.unreached import unreached
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.solve.principled import usual
from planar_cli.solve.regimes.constraints import Constraint, constraints_of, drawn_starts, project
from planar_cli.solve.regimes.drawing import beside, ranges
from planar_cli.solve.regimes.free_speeds import independent_speeds
from planar_cli.solve.regimes.places import held_places
from planar_cli.solve.regimes.separation import Parted, parted_joints, parted_modes
from planar_cli.solve.regimes.stated_places import stated_places
from planar_cli.solve.solution import InstantSolution

IN_LOOPS = 150
"""Where loops close, longer formulas are followed in numbers only, and left as they come."""
MOST_COMPARED = 16
"""With so many choices of modes it is looked whether the equations fit."""


@changing
class General:
    """One choice of modes in a general position."""

    instant: Instant
    choice: tuple[int, ...]
    coordinates: tuple[Coordinate, ...]
    """What varies."""
    free: tuple[sp.Symbol, ...]
    """The velocity unknowns that nothing else fixes; they are letters."""
    trial: Trial
    """The choice solved for draws of all letters."""
    quantities: Quantities
    position: Course
    """How the scene is displaced."""
    constraints: tuple[Constraint, ...]
    kept: tuple[Constraint, ...]
    """What joints that act only for some time keep as it was."""
    places: Callable[[], Sequence[Valuation]]
    """Where the states of the file are."""
    parted: tuple[Parted, ...] = ()
    """Joints that hold nothing here."""
    resting: tuple[sp.Symbol, ...] = ()
    """Free speeds that stay zero."""
    finisher: Finisher | None = None
    stages: list[Stage] = field(default_factory=list)
    solution: InstantSolution | None = None
    """How the accelerations are found, by the principle of the file, once they are."""
    unreached: tuple[sp.Symbol, ...] = ()
    """What that does not tell."""
    closed_forms: dict[sp.Expr, sp.Expr] = field(default_factory=dict)

    @property
    def displacement(self) -> Displacement:
        """Where every body is, by the coordinates."""
        assert self.position.displacement is not None
        return self.position.displacement

    @property
    def time(self) -> sp.Symbol:
        return self.instant.scene.ledger.symbols["t"]

    def rate_of(self, speed: sp.Symbol) -> sp.Expr:
        """The acceleration unknown that goes with a velocity unknown."""
        own = self.trial.system.rates().get(speed)
        if own is not None:
            return own
        return next(a for r, a in self.instant.scene.evaluator.motions.values() if r == speed and a is not None)

    def unique(self, expr: sp.Expr) -> bool:
        """Are all pushes in an expression determined?"""
        solved = self.trial.outcomes[0].solved if self.trial.outcomes else None
        columns = self.trial.outcomes[0].assembly.columns if self.trial.outcomes else {}
        names = [n for n, s in self.trial.system.symbols.items() if s in expr.free_symbols and n in columns]
        return solved is None or all(solved.unique(columns[n]) for n in names)

    def demand_unique(self, exprs: Iterable[sp.Expr]) -> None:
        """NoSolution: pushes in these expressions are not determined."""
        unknowns = set(acceleration_unknowns(self.trial.system))
        maker = Finisher(self.instant, self.trial, (), {})
        maker.demand_unique(needed(list(exprs), unknowns), self.instant.scene.problem.find)

    def _finisher(self) -> Finisher:
        finisher = Finisher(self.instant, self.trial, (), {})
        finisher.letters = frozenset(self.free)
        finisher.coordinates = self.coordinates
        finisher.places = self.places
        if self.constraints:
            finisher.most = IN_LOOPS
        return finisher

    def govern(self, exprs: Iterable[sp.Expr]) -> None:
        """Work out everything that these expressions need."""
        finisher = self._finisher()
        wanted, finds = list(exprs), self.instant.scene.problem.find
        try:
            self.solution, self.stages, _ = finisher.work(wanted, finds)
        except Disagreement:
            if _contradicts(self.trial) and not _fits_otherwise(self.instant, self.trial):
                # Some of the equations were solved, and the others do not hold then.
                raise held_by_too_little(self.instant, self.trial) from None
            raise
        self.unreached = tuple(unreached(self.stages, wanted))
        if self.unreached:
            # What the principle of the file does not tell must be known all the same; what it tells is told by it.
            finisher = self._finisher()
            finisher.principle = usual()
            _, self.stages, _ = finisher.work(wanted, finds)
        self.finisher = finisher

    def closed(self, expr: sp.Expr) -> sp.Expr:
        """An expression of the instant in coordinates, free speeds, t and the names of the file."""
        if expr not in self.closed_forms:
            assert self.finisher is not None
            self.closed_forms[expr] = self.finisher.closed(expr, self.stages)
        return self.closed_forms[expr]

    def closed_but_for(self, expr: sp.Expr, kept: frozenset[sp.Symbol]) -> sp.Expr:
        """The same with some unknowns as they are."""
        assert self.finisher is not None
        return self.finisher.closed(expr, self.stages, kept=kept)

    def in_letters(self, expr: sp.Expr) -> sp.Expr:
        """The same for its numbers only, not made plainer."""
        assert self.finisher is not None
        found = self.closed_forms.get(expr)
        return self.finisher.closed(expr, self.stages, False) if found is None else found

    @property
    def value(self) -> Valuation:
        if not self.trial.outcomes:
            raise Undecided("what `motion` prescribes leaves open which way something accelerates")
        return self.trial.outcomes[0].value


def drawn_instant(problem: Problem, always: tuple[Any, ...], earlier: Mapping[str, Any]) -> Instant:
    """The scene as drawn, its coordinates left as letters."""
    return Instant(Setup(problem, Statements.of(always, ()), earlier, True, Course(None, {})))


def make_general(
    problem: Problem,
    always: tuple[Any, ...],
    earlier: Mapping[str, Any],
    drawn: Instant,
    choice: tuple[int, ...],
    resting: frozenset[str],
    made: CoordinateNames,
    sides: Mapping[str, int],
) -> General:
    """The scene in a general position, for one choice of modes. `resting`: names of free speeds that stay zero; `made`:
    symbols of coordinates of the same problem by name, which are the same in every choice of modes; `sides`: on which
    sides places are from which distances are measured.
    """
    still: frozenset[str] = frozenset()

    def balances(speed: str) -> bool:
        """Do the loads on what has no mass balance everywhere once this coordinate stays as drawn?"""
        held = displaced(drawn, choice, still | {speed}, made)
        try:
            _general(problem, always, earlier, drawn, choice, held, resting | {speed}, made, sides)
        except NoSolution:
            return False
        return True

    while True:
        displacement = displaced(drawn, choice, still, made)
        try:
            found = _general(problem, always, earlier, drawn, choice, displacement, resting, made, sides)
        except OffBalance as lack:
            # What has no mass is where its loads balance: between a cord and a spring on the line of both.
            aside = next((s for s in _speeds_of(displacement, lack.bodies) if balances(s)), None)
            if aside is None:
                raise
            still, resting = still | {aside}, resting | {aside}
            continue
        velocities = found.trial.velocities
        if _idle(displacement, velocities) - still and loosened(drawn, choice) != choice:
            # What friction holds here may have come to another place before.
            system = found.instant.system(loosened(drawn, choice))
            velocities = (*velocities, solve_velocities(system, found.instant.scene.valuations[0], False))
        if _idle(displacement, velocities) - still and any(law.during is not None for law in problem.motion):
            # So may what a law of this span alone keeps still.
            lasting = tuple(law.statement for law in problem.motion if law.during is None)
            before = drawn_instant(problem, lasting, earlier)
            system = before.system(loosened(drawn, choice))
            velocities = (*velocities, solve_velocities(system, before.scene.valuations[0], False))
        idle = _idle(displacement, velocities)
        if not idle - still:
            return found
        still |= idle


def _speeds_of(displacement: Displacement, bodies: Collection[str]) -> list[str]:
    """The speeds of the coordinates that we made for these bodies and that are drawn."""
    return [c.speed.name for c in displacement.coordinates if c.body in bodies and c.drawn is not None and c.extra == 0]


def _idle(displacement: Displacement, velocities: Sequence[Velocities]) -> frozenset[str]:
    """Speeds of coordinates that are zero in all of these velocities."""
    return frozenset(
        c.speed.name
        for c in displacement.coordinates
        if c.drawn is not None and c.extra == 0 and all(not v.values.get(c.speed, Decimal(1)) for v in velocities)
    )


def _general(
    problem: Problem,
    always: tuple[Any, ...],
    earlier: Mapping[str, Any],
    drawn: Instant,
    choice: tuple[int, ...],
    displacement: Displacement,
    resting: frozenset[str],
    made: CoordinateNames,
    sides: Mapping[str, int],
) -> General:
    user, scales = _user_coordinates(drawn, made), drawn.scene.ledger.scales
    every = constraints_of(drawn, loosened(drawn, choice), displacement, (*user, *displacement.coordinates))
    constraints = tuple(c for c in every if c.kind != "kept")
    kept = tuple(c for c in every if c.kind == "kept")
    loose = parted_modes(drawn, choice)
    near, projector = beside(drawn, displacement), _projector(constraints, displacement, user, scales)
    course = Course(displacement, ranges(drawn, displacement), projector, loose, near)
    setup = Setup(problem, Statements.of(always, ()), earlier, True, course)
    setup.scene.sides = sides
    setup.scene.facings = {joint.name: side for joint, modes in drawn.modes if (side := modes[0].side)}
    instant = Instant(setup)
    system = instant.system(choice)
    varying = {s for c in (*user, *displacement.coordinates) for s in (c.symbol, c.start)}
    held = held_places(instant.setup, system.quantities_of(system.first, None), varying)
    if held:
        constraints = (*constraints, *held)
        user = _user_coordinates(instant, made)
        instant.scene.ledger.project = _projector(constraints, displacement, user, scales)
        instant.scene.forget_valuations()
    valuations = instant.scene.valuations
    found = solve_velocities(system, valuations[0], False)
    as_drawn = _numbers_as_drawn(displacement, valuations[0])
    there = solve_velocities(system, as_drawn, False, sways=True)
    coordinates = (*_user_coordinates(instant, made), *displacement.coordinates)

    @cache
    def places() -> tuple[Valuation, ...]:
        quantities = system.quantities_of(system.first, None)
        return tuple(stated_places(problem.states, quantities, coordinates, constraints, as_drawn))

    def stated() -> list[Velocities]:
        return [solve_velocities(system, place, False, sways=True) for place in places()]

    independent = independent_speeds(found, there, stated, system.tree.velocity_unknowns(), displacement)
    ordinary = instant.scene.ledger.natural
    given = {s: anywhere(i) * ordinary(s) for i, s in enumerate(independent)}
    given |= {s: Decimal(0) for s in independent if s.name in resting}
    rests = tuple(s for s in independent if s.name in resting)
    independent = tuple(s for s in independent if s.name not in resting)
    trial = instant.try_choice(choice, valuations, given=given)
    if _contradicts(trial) and instant.add_drivers():
        trial = instant.try_choice(choice, valuations, given=given)
    if _contradicts(trial) and (lack := placed_by_nothing(instant) or off_balance(instant, trial)) is not None:
        raise lack
    quantities = trial.system.quantities() if trial.outcomes else trial.system.quantities_of(trial.system.first, None)
    parted = parted_joints(drawn, choice, displacement, coordinates) if loose else ()
    place = (quantities, course, constraints, kept, places, parted, rests)
    return General(instant, choice, coordinates, independent, trial, *place)


def _numbers_as_drawn(displacement: Displacement, value: Valuation) -> Valuation:
    """All numbers, with the coordinates that are drawn where they are drawn."""
    starts = {c.symbol: c.drawn for c in displacement.coordinates if c.drawn is not None}
    return value.extended({s: n for s, drawn in starts.items() if (n := value.known(drawn)) is not None})


def _contradicts(trial: Trial) -> bool:
    return any(outcome.solved.conflict is not None for outcome in trial.outcomes)


def _fits_otherwise(instant: Instant, trial: Trial) -> bool:
    """Do the equations not contradict each other with other modes, or are there too many of these to tell?"""
    others = [c for c in islice(instant.choices(), MOST_COMPARED + 1) if c != trial.choice]
    speeds = dict(trial.velocities[0].values)
    tried = (instant.try_choice(c, instant.scene.valuations, given=speeds) for c in others)
    false = (_contradicts(again) or again.objection == "velocities" for again in tried)
    return len(others) >= MOST_COMPARED or not all(false)


def _projector(
    constraints: tuple[Constraint, ...], displacement: Displacement, user: tuple[Coordinate, ...], scales: Scales
) -> Callable[[Valuation], Mapping[sp.Symbol, Decimal]] | None:
    if not constraints:
        return None
    coordinates = (*user, *displacement.coordinates)
    inside = set().union(*(c.residual.free_symbols for c in constraints))
    unknowns = tuple(c.symbol for c in coordinates if c.symbol in inside)
    starts = [c for c in coordinates if c.start in inside]

    def place(value: Valuation) -> Mapping[sp.Symbol, Decimal]:
        drawn = drawn_starts(starts, scales)
        return {**drawn, **project(constraints, unknowns, value.extended(drawn))}

    return place


def loosened(drawn: Instant, choice: tuple[int, ...]) -> tuple[int, ...]:
    """The choice of modes by which places are described: what sticks here may have slid before."""
    found = []
    for (_, modes), i in zip(drawn.modes, choice, strict=True):
        slips = [j for j, mode in enumerate(modes) if mode.name == "slip"]
        found.append(slips[0] if modes[i].name == "stick" and slips else i)
    return tuple(found)


def loose_tree(drawn: Instant, choice: tuple[int, ...]) -> Tree:
    """The tree along which places are described: of the joints that hold all the time, and of those that hold from the
    first state on, as drawn.
    """
    modes = drawn.system(loosened(drawn, choice)).modes
    lasting = {joint.name for joint, _ in drawn.modes if drawn.scene.problem.holds_at_first(joint.during)}
    return drawn.builder.build(j for name, mode in modes.items() if name in lasting for j in mode.facts.joinings)


def displaced(drawn: Instant, choice: tuple[int, ...], still: frozenset[str], made: CoordinateNames) -> Displacement:
    """All bodies of the drawn scene along the tree of this choice of modes."""
    tree, scene = loose_tree(drawn, choice), drawn.scene
    coordinates = set(scene.ledger.coordinates)
    formula = frozenset(
        name
        for name, body in scene.bodies.items()
        if (body.center.x.free_symbols | body.center.y.free_symbols | body.theta.free_symbols) & coordinates
    )
    joints = {j.name: j for j in drawn.joints}

    def surface_of(joint: str) -> str:
        found = joints.get(joint)
        names = [getattr(found, "along", None), *getattr(found, "between", ())]
        names = [getattr(n, "name", n) for n in names]
        return next((n for n in names if isinstance(n, str) and n in scene.surfaces), "")

    return Displacer(scene, tree, surface_of, scene.ledger.symbols["t"], formula, still, made).run()


def _user_coordinates(instant: Instant, made: CoordinateNames) -> tuple[Coordinate, ...]:
    """The coordinates of the file that vary freely: not those that are given as functions of time."""
    ledger = instant.scene.ledger
    found = []
    for symbol in ledger.coordinates:
        rate = instant.scene.evaluator.motions[symbol][0]
        if symbol in ledger.letters and isinstance(rate, sp.Symbol):
            unit = "rad" if ledger.units[symbol].angle else ledger.units[symbol].text
            start = made.start(ledger, symbol, ledger.units[symbol].text)
            found.append(Coordinate(symbol, start, unit, None, rate, sp.S.One, symbol.name, "", unit))
    return tuple(found)
