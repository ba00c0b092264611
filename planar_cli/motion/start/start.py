"""The state from which a motion begins: places and velocities from the first state (or the instant) of the file.

Places are those of the drawing, changed as little as the joints and the relations of the state demand. Velocities are
sought in layers, each within what those before leave open: what joints that always hold, drives and the relations
demand; contacts that stay closed and ropes that stay taut; contacts that do not slip; and rest, where the file says so.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence

from planar_cli.errors import NOWHERE, Diagnostic, FileProblem, Mark, NoSolution
from planar_cli.motion.regime.model import Model
from planar_cli.motion.scene.drives import PLACES, VELOCITIES, of_forces
from planar_cli.motion.scene.places import points_of
from planar_cli.motion.start.directions import demand_directions
from planar_cli.motion.start.hanging import rates_across_ropes
from planar_cli.motion.start.other_side import open_terms, to_the_other_side
from planar_cli.motion.start.resting import resting
from planar_cli.motion.start.two_starts import demand_one_start
from planar_cli.motion.terms.constraints import Constraint, coefficients
from planar_cli.motion.terms.dense import null_space
from planar_cli.motion.terms.terms import Term
from planar_cli.motion.terms.zeros import AGREES, Equation, Zeros
from planar_cli.problem.language.expression import AtRest, Equilibrium, Relation, Statement
from planar_cli.problem.scene.facts import Mode
from planar_cli.records import record

Choose = Callable[[tuple[Mode, ...]], int]
Levels = tuple[int | None, ...]
ALL_LEVELS: Levels = (None, PLACES, VELOCITIES)


@record
class Start:
    """Where a motion begins."""

    time: float
    """s."""
    state: tuple[float, ...]
    """Coordinates, then rates."""
    assumed: tuple[str, ...] = ()
    """What the file does not say, in words."""


def start_of(model: Model, statements: Sequence[Statement] | None = None) -> Start:
    """The start of a model; `statements`: others than those of the first state or the instant."""
    return _Search(model, given_of(model) if statements is None else statements).start()


def fixed(model: Model, number: Term) -> bool:
    """Do the places that the file states at the start tell a number of places that the joints leave open?"""
    return _Search(model, given_of(model)).fixed(number)


def given_of(model: Model) -> tuple[Statement, ...]:
    """What the file says of the start."""
    problem = model.scene.problem
    if problem.instant is not None:
        return tuple(problem.instant)
    return tuple(problem.states[0].relations) if problem.states else ()


class _Search:
    """Looking for places, then for velocities."""

    def __init__(self, model: Model, statements: Sequence[Statement]) -> None:
        self.model, self.layout = model, model.layout
        self.statements = statements
        self.said = model.asked.said(statements)
        self.zeros = Zeros(model.layout, model.scale, *model.reference)
        self.half = model.layout.count

    def start(self) -> Start:
        """Places, then velocities, then the inequalities."""
        self.model.begin()
        self._places()
        self.model.note(self.zeros.time, self.zeros.state)
        assumed = self._velocities()
        self._fulfilled()
        demand_directions(self.model, self.zeros)
        return Start(self.zeros.time, tuple(self.zeros.state), assumed)

    # --- places ------------------------------------------------------------------------------------------------------

    def fixed(self, number: Term) -> bool:
        """Do relations of places tell a number that the joints leave open, near the drawing?"""
        joints = [self._of_place(c) for c in self._everything() if c.place is not None]
        every, left = (
            null_space(self.zeros.matrix(equations, range(self.half)), self.half)
            for equations in (joints, [*joints, *self._relations(PLACES)])
        )
        return self._varies(number, every) and not self._varies(number, left)

    def _places(self) -> None:
        """Newton's method from the drawing, each step the shortest."""
        joints = [self._of_place(c) for c in self._everything() if c.place is not None]
        relations = self._relations(PLACES)
        equations = [*joints, *relations]
        self._newton(equations, range(self.half))
        to_the_other_side(self.zeros, self.model, equations, lambda: self._true((None, PLACES)))
        self._demand_drawn(joints, relations)
        scene = self.model.scene
        if not scene.reference.open:
            return
        free = null_space(self.zeros.matrix(equations, range(self.half)), self.half)
        for name in sorted(scene.reference.open):
            if name in self.layout.frames:
                place = scene.places[name]
                told = not (self._varies(place.x, free) or self._varies(place.y, free))
                text, hint = f"where {name} is at the start is not told", "give its place in the first state"
            else:
                told = not self._varies(scene.coordinates[name][0], free)
                text, hint = f"{name} at the start is not told", f"give it in the first state: `{name} = …`"
            if not told:
                raise self._unknown(text, hint)

    def _demand_drawn(self, joints: Sequence[Equation], relations: Sequence[Equation]) -> None:
        """NoSolution where a relation holds only when what is drawn is moved: it chooses among the places of what is
        written with coordinates or not drawn at all. A drawing that its own joints do not fit leaves the choice, and
        so does that of an equilibrium.
        """
        zeros, numbers = self.zeros, range(self.half)
        _, drawn = self.model.reference
        off, unfit = zeros.unmet(relations, drawn), zeros.unmet(joints, drawn)
        elsewhere = any(s.before for s in self.model.scene.problem.states)
        if elsewhere or not off or unfit or not self._moves_points(drawn):
            return
        found = zeros.state
        free = open_terms(self.model)
        told = [
            Equation(term - self.model.graph.number(value), 1.0, "", NOWHERE)
            for term, value in zip(free, zeros.numbers(tuple(free)), strict=True)
        ]
        zeros.state = list(drawn)
        reached = zeros.solved([*joints, *told], numbers)
        wrong = zeros.unmet(relations, zeros.state)
        zeros.state = found
        if reached and wrong:
            text = f"`{wrong[0].text}` does not hold in the drawn position"
            hint = "draw the points at the first state, or write one with a coordinate"
            raise NoSolution([Diagnostic(wrong[0].mark, "PL609", text, hint)])

    def _moves_points(self, drawn: Sequence[float]) -> bool:
        """Do points of the file stand elsewhere than drawn? How a disk is turned that has none but its centre is not
        drawn.
        """
        scene, scale = self.model.scene, self.model.scales.length
        spots = [scene.point(name) for name in points_of(scene.problem)]
        terms = [self.model.graph.of(part) for spot in spots for part in (spot.x, spot.y)]
        there, here = (self.zeros.at(terms, state) for state in (drawn, self.zeros.state))
        return any(abs(a - b) > AGREES * scale for a, b in zip(there, here, strict=True))

    def _varies(self, term: Term, free: Iterable[Sequence[float]]) -> bool:
        """Does a place change in some motion that is still free?"""
        row = self.zeros.matrix([Equation(term, 1.0, "", NOWHERE)], range(self.half))[0]
        parts = [[a * b for a, b in zip(row, vector, strict=True)] for vector in free]
        return any(abs(sum(p)) > AGREES * max(map(abs, p)) for p in parts)

    def _everything(self) -> list[Constraint]:
        """The constraints of all joints in their natural modes, and of drives."""
        model = self.model
        return [*(c for j in model.joints for c in model.held(j, 0).constraints), *model.drives]

    def _of_place(self, constraint: Constraint) -> Equation:
        assert constraint.place is not None
        turns = all(self.layout.slots[i].kind == "theta" for i in constraint.row)
        return Equation(constraint.place, 1.0 if turns else self.model.scales.length, constraint.title, NOWHERE)

    def _relations(self, level: int) -> list[Equation]:
        """The relations of this level, on the scale of what is in them."""
        found = []
        for relation in self.said:
            found += [
                Equation(residual, self._size(residual, level) or 1.0, relation.text, relation.mark)
                for residual in relation.residuals
                if self.model.asked.level(residual) == level
            ]
        return found

    def _size(self, term: Term, level: int) -> float:
        """How much a term changes when usual places or velocities change by their scales."""
        first = level * self.half
        variables = self.layout.state[first : first + self.half]
        slopes = coefficients(term, {v: first + i for i, v in enumerate(variables)}, self.layout)
        usual = [*self.zeros.state[: self.half], *self.zeros.sizes[self.half :]]
        values = self.zeros.at(list(slopes.values()), usual)
        return max(
            (abs(v) * self.zeros.sizes[i] for i, v in zip(slopes, values, strict=True) if math.isfinite(v)), default=0.0
        )

    # --- velocities --------------------------------------------------------------------------------------------------

    def _velocities(self) -> tuple[str, ...]:
        """Layer by layer."""
        numbers = range(self.half, 2 * self.half)
        firm = [self._of_velocity(c) for c in self._bilateral()]
        firm += self._relations(VELOCITIES)
        firm += [e for s in self.statements if isinstance(s, AtRest) and s.body is not None for e in self._resting(s)]
        self._newton(firm, numbers, guesses=True)
        for group in self._touching():
            self._add(firm, group, numbers)
        at_rest = any(isinstance(s, AtRest | Equilibrium) and s.body is None for s in self.statements)
        for group in self._sticking():
            # What is said to be at rest is not yet carried along by a running belt.
            if not (at_rest and self._run(group)):
                self._add(firm, group, numbers)
        if at_rest:
            for group in resting(self.layout, self.zeros) if any(self.zeros.state[self.half :]) else ():
                self._add(firm, group, numbers)
            return ()
        free = null_space(self.zeros.matrix(firm, numbers), self.half)
        moving = self._moved(free)
        if not moving:
            return ()
        if self._hanging(set(moving)):
            size = self.model.scales.length / self.model.scales.time
            aside = [Equation(rate, size, "without swaying", NOWHERE) for rate in rates_across_ropes(self.model)]
            self._add(firm, aside, numbers)
            return (f"it begins without swaying of {', '.join(sorted(moving))}, as the file does not tell how",)
        if moving.keys() <= self.model.scene.speeds.keys():
            self.zeros.state = self._known()
            self._newton(firm, numbers)
            return ()
        names = ", ".join(sorted(moving))
        known = ", ".join(f"`{part} = …`" for name in sorted(moving) for part in moving[name][:1])
        raise self._unknown(
            f"the velocity of {names} at the start is not told", f"write `at rest`, or what is known of it: {known}"
        )

    def _bilateral(self) -> list[Constraint]:
        """What always holds: of joints that may part or slide, nothing."""
        model = self.model
        found = [c for j in model.joints if j.name not in model.choices for c in model.held(j, 0).constraints]
        found += [c for j in model.joints if j.name in model.choices for c in self._least(j.name)]
        return [c for c in (*found, *model.drives) if c.rate is not None]

    def _least(self, name: str) -> tuple[Constraint, ...]:
        """Of a joint that has several modes and can not part, what all of them keep."""
        model = self.model
        joint = next(j for j in model.joints if j.name == name)
        if any(m.parted for m in model.modes[name]):
            return ()
        held = [model.held(joint, i).constraints for i in range(len(model.modes[name]))]
        return min(held, key=len)

    def _touching(self) -> list[list[Equation]]:
        """Contacts and ropes that may part stay closed."""
        return self._of_modes(lambda modes: next((i for i, m in enumerate(modes) if m.name in ("slip", "taut")), 0))

    def _sticking(self) -> list[list[Equation]]:
        """Natural modes."""
        return self._of_modes(lambda modes: 0)

    def _of_modes(self, choose: Choose) -> list[list[Equation]]:
        model = self.model
        found = []
        for joint in model.joints:
            modes = model.modes[joint.name]
            if len(modes) > 1:
                held = model.held(joint, choose(modes))
                found.append([self._of_velocity(c) for c in held.constraints if c.rate is not None])
        return found

    def _add(self, firm: list[Equation], group: list[Equation], numbers: range) -> None:
        """Take a joint's relations in where they agree with what is there already."""
        before = self.zeros.state[:]
        if self.zeros.solved([*firm, *group], numbers):
            firm += group
        else:
            self.zeros.state = before

    def _run(self, group: Sequence[Equation]) -> bool:
        """Do these relations demand a speed of what is at rest?"""
        before = self.zeros.state[:]
        self.zeros.state[self.half :] = [0.0] * self.half
        runs = any(abs(v) > AGREES * e.size for v, e in zip(self.zeros.values(group), group, strict=True))
        self.zeros.state = before
        return runs

    def _of_velocity(self, constraint: Constraint) -> Equation:
        assert constraint.rate is not None
        turns = all(self.layout.slots[i].kind == "theta" for i in constraint.row)
        size = (1.0 if turns else self.model.scales.length) / self.model.scales.time
        if not constraint.joint:
            # A law of the file may hold squares of speeds.
            size = self._size(constraint.rate, VELOCITIES) or size
        return Equation(constraint.rate, size, constraint.title, NOWHERE)

    def _resting(self, rest: AtRest) -> list[Equation]:
        """A body that is at rest by itself."""
        slots = [s for s in self.layout.slots if s.body == rest.body]
        return [
            Equation(s.rate, self.zeros.sizes[self.half + self.layout.slots.index(s)], rest.text, rest.mark)
            for s in slots
        ]

    def _moved(self, free: Iterable[Sequence[float]]) -> dict[str, list[str]]:
        """The bodies that move in some of these motions, with what moves of them."""
        found: dict[str, list[str]] = {}
        for vector in free:
            top = max(abs(v) / s for v, s in zip(vector, self.zeros.sizes[: self.half], strict=True))
            for slot, v, s in zip(self.layout.slots, vector, self.zeros.sizes, strict=False):
                if slot.body and abs(v) / s > AGREES * top:
                    part = f"omega({slot.body})" if slot.kind == "theta" else f"v({slot.body}).{slot.kind}"
                    if part not in found.setdefault(slot.body, []):
                        found[slot.body].append(part)
        return found

    def _hanging(self, bodies: set[str]) -> bool:
        """Do they all hang on ropes, and does the file tell something of velocities?"""
        model = self.model
        tied: set[str] = set()
        for joint in model.joints:
            if any(m.name == "taut" for m in model.modes[joint.name]):
                pushes = model.modes[joint.name][0].facts.pushes
                tied |= {a.body for p in pushes for a in p.actions}
        return bodies <= tied and bool(self._relations(VELOCITIES) or model.drives)

    # --- solving -----------------------------------------------------------------------------------------------------

    def _newton(self, equations: Sequence[Equation], numbers: range, guesses: bool = False) -> None:
        """Make all equations zero; NoSolution where they contradict each other, or an inequality that is given."""
        tries, problem = self._guesses(numbers) if guesses else [self.zeros.state], self.model.scene.problem
        for state in tries:
            self.zeros.state = list(state)
            if self.zeros.solved(equations, numbers) and (not guesses or self._true()):
                if guesses and not self.model.scene.speeds:
                    demand_one_start(self.zeros, self.layout, equations, numbers, tries, self._true, problem)
                return
        self.zeros.state = list(tries[0])
        if self.zeros.solved(equations, numbers):
            self._fulfilled()
        off = max(equations, key=lambda e: abs(self.zeros.values([e])[0]) / e.size)
        laws = [law.statement for law in problem.motion]
        known = [*(r.mark for r in laws if r.text == off.text), off.mark, *(e.mark for e in equations)]
        mark = next((m for m in (*known, *(r.mark for r in laws)) if m != NOWHERE), NOWHERE)
        text = f"no start fulfils everything that the file says: “{off.text}” remains off"
        raise NoSolution([Diagnostic(mark, "PL704", text, "one of the relations of the first state must go")])

    def _guesses(self, numbers: range) -> list[list[float]]:
        """Velocities from which a solution is sought: rest first, then those that are known from elsewhere, then either
        way of relations that are not linear.
        """
        found = [self.zeros.state, self._known()] if self.model.scene.speeds else [self.zeros.state]
        for sign in (1.0, -1.0):
            guess = list(self.zeros.state)
            for k, n in enumerate(numbers):
                guess[n] = sign * self.zeros.sizes[n] * (1.0 + 0.1 * math.cos(2.4 * k))
            found.append(guess)
        return found

    def _known(self) -> list[float]:
        """The velocities of bodies that are known from elsewhere."""
        state = list(self.zeros.state)
        for body, speeds in self.model.scene.speeds.items():
            frame = self.layout.frames.get(body)
            if frame is not None:
                for number, speed in zip((frame.x, frame.y, frame.theta), speeds, strict=True):
                    if number is not None:
                        state[self.half + number] = speed
        return state

    # --- what must hold besides --------------------------------------------------------------------------------------

    def _fulfilled(self) -> None:
        """The inequalities and senses of the first state."""
        for text, mark, holds in self._conditions():
            if not holds:
                raise NoSolution([Diagnostic(mark, "PL704", f"the start that was found contradicts “{text}”")])

    def _true(self, levels: Levels = ALL_LEVELS) -> bool:
        return all(holds for _, _, holds in self._conditions(levels))

    def _conditions(self, levels: Levels = ALL_LEVELS) -> list[tuple[str, Mark, bool]]:
        """Do they hold, but for the rounding of what they measure?"""
        found = [(s.text, s.mark, s.sense) for s in self.said if s.sense is not None and VELOCITIES in levels]
        asked = self.model.asked
        for s in self.statements:
            if isinstance(s, Relation) and s.operator != "=" and not of_forces(s):
                left, right = asked.quantities.sides.value(s.left), asked.quantities.sides.value(s.right)
                term = left - right if s.operator in (">", ">=") else right - left
                if asked.level(term) in levels:
                    found.append((s.text, s.mark, term))
        return [(text, mark, self._not_negative(term)) for text, mark, term in found]

    def _not_negative(self, term: Term) -> bool:
        """Is it zero or more, but for what a usual change of the state, in its last digits, makes of it?"""
        layout = self.layout
        row = coefficients(term, {v: i for i, v in enumerate(layout.state)}, layout)
        value, *slopes = self.zeros.numbers((term, *row.values()))
        usual = sum(abs(slope) * self.model.scale[i] for i, slope in zip(row, slopes, strict=True))
        return value >= -AGREES * usual

    def _unknown(self, text: str, hint: str) -> FileProblem:
        mark = next((s.mark for s in self.said), Mark(self.model.scene.problem.file, 1, 1))
        return FileProblem([Diagnostic(mark, "PL704", text, hint)])
