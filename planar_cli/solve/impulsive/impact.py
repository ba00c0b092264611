"""A blow in a motion: the equations between a state and the one just after it.

    momentum before + impulses = momentum after, for every body and group, along every direction, about every point

The plan of equations is that of an instant; its letters are those of the two states, and one for each impulse.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge, Motion
from planar_cli.equation.kinematics.struck import StruckScene
from planar_cli.equation.system.setup import Course as Position
from planar_cli.equation.system.system import System
from planar_cli.equation.values.cancelled_angles import without_cancelled_angles
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.jets import constant
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.facts import FAR
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.solve.impulsive.instant import Struck, struck_instant
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.stages import Stage, StageMaker, acceleration_unknowns
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.principled import families_across, position_of
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.mode_sequence import Span
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.speed_transfer import transferred_speed
from planar_cli.solve.regimes.timeline import Stop

MOVES = Decimal("1e-9")
ABOUT_PUSHES = ("impulse", "work", "heat", "mean")


def arriving(regime: Regime) -> dict[str, tuple[Vec, sp.Expr]]:
    """Velocity of the mass centre and angular velocity of every body, as the regime's own unknowns."""
    motion, scene = regime.general.quantities.motion, regime.general.instant.scene
    return {b: (motion.velocity(scene.center(b), b), motion.velocities[b].angular) for b in scene.bodies}


@record
class Stroke:
    """A blow in numbers."""

    after: dict[sp.Symbol, float]
    """The symbols of the general position just after it."""
    own: dict[sp.Symbol, float]
    """Its impulses."""
    objection: str
    """What speaks against its modes."""
    misfit: str = ""
    """What speaks against the modes after it."""
    far: frozenset[str] = frozenset()
    """Impacts whose bodies are apart."""


@dataclass(frozen=True, slots=True, eq=False)
class Blow:
    """One blow."""

    since: Stop
    """The state just before it."""
    stop: Stop
    """The state just after it."""
    before: Regime
    """The regime that tells the velocities before."""
    after: Regime
    """The regime that tells the velocities after."""
    struck: Struck
    drawn: Mapping[sp.Symbol, sp.Expr]
    """Coordinates put where they were drawn, if nothing has moved yet."""
    choice: tuple[int, ...]
    """The modes of its joints."""
    trial: Trial
    """These modes for draws of all letters."""
    edges: Mapping[sp.Symbol, Edge]
    """What the speeds of all regimes are, by their symbols."""
    otherwise: bool
    """Does something else than an impact of the whole motion make it a blow?"""
    stage: Stage | None = None
    """The plan of its equations; None: its modes cannot be."""
    letters: tuple[sp.Symbol, ...] = ()
    """Unknowns of its own, impulses above all."""
    equations: tuple[Equation, ...] = ()
    """The velocities after it, and the impulses."""

    @property
    def system(self) -> System:
        return self.trial.system

    @property
    def scene(self) -> StruckScene:
        found = self.struck.scene
        assert isinstance(found, StruckScene)
        return found

    @property
    def undetermined(self) -> tuple[sp.Symbol, ...]:
        """Impulses that are asked and not unique."""
        return () if self.stage is None else self.stage.undetermined

    # --- equations ---------------------------------------------------------------------------------------------------

    def planned(self, asked: Iterable[str]) -> Blow:
        """With the equations of the velocities after the blow, and of the impulses of joints that are `asked`."""
        if not self.trial.outcomes:
            return self
        unknowns = set(acceleration_unknowns(self.system))
        transfer = list(self._transferred())
        targets = {s for _, e in transfer for s in e.free_symbols & unknowns}
        targets |= set(self.stop.letters.values()) & unknowns | self._asked(asked) & unknowns
        if self.scene.ledger.symbolic:
            targets |= {s for e in self.limits() for s in e.free_symbols & unknowns}
        base = self.trial.outcomes[0].value
        value = base.without(unknowns)
        maker = StageMaker(self.system, value, True, constructed=self.scene.displacement is None, whole=True)
        maker.families = families_across(self.scene.problem.method, position_of(self.system, value))
        found = replace(self, stage=maker.accelerations(targets))
        equations = tuple(found._written(transfer))
        inside = {s for e in equations for s in e.residual.free_symbols}
        own = {*unknowns, *self.scene.open_names.values()} & inside
        letters = tuple(sorted(own - set(self.stop.letters.values()), key=lambda s: s.name))
        return replace(found, equations=equations, letters=letters)

    def _written(self, transfer: Iterable[tuple[sp.Symbol, sp.Expr]]) -> Iterator[Equation]:
        assert self.stage is not None
        yield from self._same_place()
        yield from self._planned(self.stage)
        yield from self._zero(self.stage)
        for u, expr in transfer:
            words = "the velocities after the blow"
            yield Equation(self.stop.letters[u] - self.here(expr), "blow", words, self.stop.name)

    def here(self, expr: sp.Expr, told: bool = False) -> sp.Expr:
        """An expression of the blow in letters of its states and its own; named lines are put in. `told`: masses and
        moments of inertia keep their letters.
        """
        explicit = {} if self.stage is None else {x.symbol: x.expression for x in self.stage.lines}
        definitions = dict(self.scene.ledger.definitions)
        for s in self.scene.constants() if told else ():
            del definitions[s]
        for _ in range(40):
            inside = {s: explicit[s] for s in expr.free_symbols if s in explicit}
            inside |= {s: definitions[s] for s in expr.free_symbols if s in definitions}
            if not inside:
                break
            expr = expr.xreplace(inside)
        return without_cancelled_angles(self.stop.at(expr), self.scene.valuations[0])

    def _same_place(self) -> Iterator[Equation]:
        """Nothing moves in a blow."""
        regime = self.after
        for letter in (regime.time, *(c.symbol for c in regime.coordinates)):
            residual = self.stop.letters[letter] - self.since.letters[letter]
            words = "a blow takes no time" if letter == regime.time else "nothing moves during a blow"
            yield Equation(residual, "link", words, self.stop.name, self.since.name)

    def _planned(self, stage: Stage) -> Iterator[Equation]:
        for block in stage.blocks:
            for w in block.equations:
                yield Equation(
                    self.here(w.residual), "blow", w.words, self.stop.name, self.since.name, source=(self, w)
                )

    def _zero(self, stage: Stage) -> Iterator[Equation]:
        for s in stage.zero:
            yield Equation(self.here(s), "blow", "nothing acts that way", self.stop.name, self.since.name)

    def _transferred(self) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
        """Free speeds after the blow that are no unknowns of it, in its own unknowns."""
        own = set(acceleration_unknowns(self.system))
        for u in self.after.free:
            if self.stop.letters[u] in own or u not in self.edges:
                continue
            expr = transferred_speed(u, self.edges[u], self._motion, self.scene, after=True)
            if expr is not None:
                yield u, expr

    def _asked(self, joints: Iterable[str]) -> set[sp.Symbol]:
        """The impulses of these joints."""
        names = set(joints)
        every = "all" in names or names & set(self.scene.bodies)
        aliases = self.system.aliases
        return {
            self.system.symbols[p.name] for p in self.system.pushes if every or aliases.get(p.joint, p.joint) in names
        }

    def limits(self) -> tuple[sp.Expr, ...]:
        """What is not negative in its modes where friction limits an impulse: μ J_N - |J_F|, or how fast it slides."""
        found: list[sp.Expr] = []
        for mode in self.system.modes.values():
            for test in mode.tests if mode.name in ("stick", "slip") else ():
                if len(test.pushes) > 1 and all(n in self.system.symbols for n, _ in test.pushes):
                    found.append(sp.Add(*(c * self.system.symbols[n] for n, c in test.pushes), test.constant))
                elif test.row is not None and mode.name == "slip":
                    found.append(test.sense * self._motion.row_acceleration(test.row))
        return tuple(found)

    def numbers(self, value: Valuation) -> Valuation:
        """Numbers of the scene in the blow; `value` knows the letters of the state before it, and all names."""
        places = {s: value(own) for s, own in self.since.letters.items() if own in value.values}
        draws = self.scene.valuations[0]
        return draws.extended({**value.values, **places})

    # --- numbers -----------------------------------------------------------------------------------------------------

    def arrived(self, state: Mapping[sp.Symbol, Any], value: Valuation) -> Valuation:
        """Numbers of the scene just before the blow. `state`: by the letters of the general position. `value`: numbers
        of everything that does not vary.
        """
        number = {s: Decimal(repr(float(v))) for s, v in state.items()}
        return self.numbers(value.extended({self.since.letters[s]: v for s, v in number.items()}))

    def placed(self, state: Mapping[sp.Symbol, Any], values: Mapping[sp.Symbol, Any]) -> dict[sp.Symbol, Any]:
        """The letters just before the blow, with where the coordinates after it then are. `values`: by letters of
        states.
        """
        places = {c.symbol: self.since.letters[c.symbol] for c in self.after.coordinates}
        return {**state, **{s: values[own] for s, own in places.items() if own in values}}

    def strike(self, state: Mapping[sp.Symbol, Any], here: Valuation, near: float, value: Valuation) -> Stroke:
        """What comes of the letters just before the blow. `here`: the numbers with which things have `arrived`. `near`:
        a smaller gap is none, in m. `value`: knows those constants that are sought and have been found.
        """
        far = self._far(here, Decimal(repr(near)))
        if not self.fits(self.choice, far):
            return Stroke({}, {}, "what is apart is not struck", far=far)
        trial = self._tried(here, value)
        self._demand_meeting(here, Decimal(repr(near)), far, trial)
        if not trial.outcomes:
            return Stroke({}, {}, trial.objection, far=far)
        outcome = trial.outcomes[0]
        unknowns = unknowns_of(trial.system, outcome)
        found = here.extended(unknowns)
        after = {s: state[s] for s in (self.after.time, *(c.symbol for c in self.after.coordinates)) if s in state}
        after |= {u: float(found(own)) for u in self.after.free if (own := self.stop.letters[u]) in unknowns}
        after |= {u: float(found(expr)) for u, expr in self._transferred()}
        own = {s: float(unknowns[s]) for s in self.letters if s in unknowns and self._unique(s, outcome)}
        return Stroke(after, own, trial.objection, self._moves(after, found), far)

    def _tried(self, here: Valuation, value: Valuation) -> Trial:
        """Its modes in numbers, with those constants that are sought and that `value` knows."""
        known = {s: value(s) for s in self.scene.ledger.sought if s in value.values}
        return self.struck.try_choice(self.choice, (here,), known or None)

    def in_solution(self, value: Valuation) -> Stroke:
        """The blow with the numbers of a solution; nothing speaks against its modes where that leaves some open."""
        before = (e for b in self.scene.before.values() for e in (b.linear.x, b.linear.y, b.angular))
        needed = {*self.scene.ledger.sought, *(s for e in before for s in sp.sympify(e).free_symbols)}
        if any(value.known(s) is None for s in needed):
            return Stroke({}, {}, "")
        trial = self._tried(self.numbers(value), value)
        if not trial.outcomes:
            return Stroke({}, {}, trial.objection)
        unknowns = unknowns_of(trial.system, trial.outcomes[0])
        told = {s: value.known(self.stop.letters[s]) for s in self.after.letters}
        after = {s: float(v) for s, v in told.items() if v is not None}
        return Stroke(after, {}, trial.objection, self._moves(after, self.numbers(value).extended(unknowns)))

    def _demand_meeting(self, here: Valuation, near: Decimal, far: frozenset[str], trial: Trial) -> None:
        """NoSolution: the corner that strikes is another than was taken, or there are two, and they do not move alike.
        FileProblem: the file says another point or normal.
        """
        for joint in self.struck.joints:
            if joint.strikes and joint.name not in far:
                if (wrong := self.scene.doubtful(joint, here, near)) and self._rests_on_corner(joint, here, trial):
                    hint = (
                        "draw the points in the state of the impact, slightly turned so that one corner comes first; "
                        "an edge that strikes between them is a particle that is welded to the ground"
                    )
                    raise NoSolution([Diagnostic(joint.mark, "PL528", wrong, hint)])
                self.scene.demand_as_said(joint, here, near)

    def _rests_on_corner(self, joint: Any, here: Valuation, trial: Trial) -> bool:
        """Does the corner matter with which the partners of an impact meet? Not where they do not turn against each
        other, before the blow or by it, and part: all that touches has one velocity then, and one impulse tells all.
        """
        if not trial.outcomes or self.scene.is_zero(joint.restitutes(self.scene)):
            return True
        bodies = [b for b in map(self.scene.carrier, joint.between) if b != GROUND]
        found = here.extended(unknowns_of(trial.system, trial.outcomes[0]))
        before = [found(self.scene.before[b].angular) for b in bodies]
        after = [found(self._motion.accelerations[b].angular) for b in bodies]
        against = [w[0] - sum(w[1:]) for w in (before, after)]
        return max(map(abs, against)) > MOVES * max(map(abs, (*before, *after)))

    def _far(self, here: Valuation, near: Decimal) -> frozenset[str]:
        """Impacts of the whole motion that do not strike here: their bodies are apart. Where all are, and nothing else
        makes this a blow, the file only draws them so.
        """
        free = [j for j in self.struck.joints if j.strikes and j.during is None]
        gaps = {j.name: self.scene.distance(j, here) for j in free}
        far = frozenset(name for name, gap in gaps.items() if gap is not None and gap > near)
        return far if len(far) < len(free) or self.otherwise else frozenset()

    def fits(self, choice: tuple[int, ...], far: frozenset[str]) -> bool:
        """Do these modes leave out what is apart, and nothing else?"""
        chosen = ((j.name, found[i].name) for (j, found), i in zip(self.struck.modes, choice, strict=True))
        return all((mode == FAR) == (name in far) for name, mode in chosen)

    def _moves(self, after: Mapping[sp.Symbol, float], found: Valuation) -> str:
        """Does something move after the blow that the regime after it takes for held?"""
        if any(s not in after for s in self.after.letters):
            return ""
        known = found.extended({s: Decimal(repr(after[s])) for s in self.after.letters})
        motion, scene = self._motion, self.scene
        for body, (v, spin) in arriving(self.after).items():
            w = motion.acceleration(scene.center(body), body)
            here = (w.x, w.y, motion.accelerations[body].angular)
            pairs = list(zip((v.x, v.y, spin), here, strict=True))
            speeds = [abs(found(e)) for e in here]
            if any(abs(known(self.after.closed(a)) - found(b)) > MOVES * max(speeds) for a, b in pairs):
                return "it moves"
        return ""

    @property
    def _motion(self) -> Motion:
        assert self.system.motion is not None
        return self.system.motion

    def _unique(self, symbol: sp.Symbol, outcome: Any) -> bool:
        """Is an impulse determined at all?"""
        name = next((n for n, s in self.system.symbols.items() if s == symbol), None)
        columns = outcome.assembly.columns
        return name is None or name not in columns or bool(outcome.solved.unique(columns[name]))


def asked_of_blows(problem: Any) -> list[str]:
    """Whose impulses the file asks for: names of joints, bodies or `all`."""
    nodes = (node for formula in formulas(problem) for node in walk(formula.tree))
    quantities = (node for node in nodes if isinstance(node, Quantity) and node.word in ABOUT_PUSHES)
    return [q.things[0] for q in quantities if q.things]


def make_blow(course: RegimeSequence, i: int, span: Span, choice: tuple[int, ...] | None, placed: bool) -> Blow:
    """The blow between states i and i + 1, its modes tried in draws. `placed`: what `motion` says fixes the places of
    the first state.
    """
    since, stop = (course.stops[course.states[k].name] for k in (i, i + 1))
    before, after = course.readers[since.name].regime, course.readers[stop.name].regime
    drawn = {} if placed else _as_drawn(course, i, before)
    named = {u: since.letters[u] for u in before.free}

    def here(expr: sp.Expr) -> sp.Expr:
        return before.closed(expr).xreplace({**named, **drawn})

    told = {b: (Vec(here(v.x), here(v.y)), here(spin)) for b, (v, spin) in arriving(before).items()}
    inside = set().union(*(e.free_symbols for v, w in told.values() for e in (v.x, v.y, w)))
    ledger = course.ledger
    letters = {s: ledger.units[s].text for s in named.values() if s in inside}
    known = {title: stop.letters[u] for u, title in _titles(course).items() if u in stop.letters}
    position = Position(None, {}) if drawn else before.general.position
    mark = f"__{stop.name}" if sum(s.blow is not None for s in course.modes.stretches) > 1 else ""
    laws = tuple(s for s in course.modes.stretches[i].span.always if s in span.always)
    quantities = before.general.quantities.evaluator
    scene = (span.problem, span.always, laws, course.workshop.earlier, position)
    struck = struck_instant(
        *scene, told, lambda s: constant(here(quantities.value(s))), letters, known, stop.letters, mark
    )
    choice = choice if choice is not None else next(struck.choices())
    trial = struck.try_choice(choice, struck.scene.valuations[:1])
    otherwise = _struck_otherwise(course.modes.stretches[i].span, span)
    found = Blow(since, stop, before, after, struck, drawn, choice, trial, course.edges(), otherwise)
    return found.planned(asked_of_blows(course.problem))


def _titles(course: RegimeSequence) -> dict[sp.Symbol, str]:
    """What the velocity unknowns of all regimes are."""
    titles: dict[sp.Symbol, str] = {}
    for regime in course.distinct_regimes():
        system = regime.general.trial.system
        titles |= {u: system.titles[u] for u in system.tree.velocity_unknowns()}
    return titles


def _struck_otherwise(before: Span, blow: Span) -> bool:
    """Is it a blow by an impulse, an impact that the file puts there, or a joint that takes hold?"""
    held = before.problem.joints
    taken = any(j.during is not None if j.strikes else j not in held for j in blow.problem.joints)
    return taken or any(x.strikes for x in blow.problem.loads)


def _as_drawn(course: RegimeSequence, i: int, before: Regime) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates as drawn, if nothing but blows happens before state i."""
    if not all(course.is_impulsive(k) for k in range(i)):
        return {}
    return {c.symbol: c.drawn for c in before.coordinates if c.drawn is not None}
