"""Finds the modes that happen: the motion is followed in numbers, and where an assumption ends others are tried.

A first state that is known is followed at once. Where constants or velocities are sought, the equations give all
branches first, and each is followed to see whether it happens so.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, replace
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Unvalued, Valuation
from planar_cli.errors import Diagnostic, NoSolution, NoValue, Undecided, undecided_at
from planar_cli.records import changing
from planar_cli.solve.between.branches.alternatives import one_of
from planar_cli.solve.between.branches.branch_order import candidates
from planar_cli.solve.between.branches.departed import without_departed
from planar_cli.solve.between.branches.matching import onward, same_motion
from planar_cli.solve.between.branches.reached import asked_about
from planar_cli.solve.between.branches.solved_motion import SolvedMotion, ended, sooner
from planar_cli.solve.between.equations.asked_finds import AskedFind, asked_finds, asked_letters
from planar_cli.solve.between.equations.masses import demand_mass
from planar_cli.solve.between.equations.methods import by_method
from planar_cli.solve.between.equations.motion_equations import MotionEquations, all_equations, first_equations
from planar_cli.solve.between.equations.needed_times import without_unneeded_times
from planar_cli.solve.between.equations.stated_motion import StatedMotion, stated_motion
from planar_cli.solve.between.roots.chain import Branch
from planar_cli.solve.between.roots.followed import Followed
from planar_cli.solve.diagnosis.directions_left_open import that_tell
from planar_cli.solve.diagnosis.held_in_blows import no_motion
from planar_cli.solve.diagnosis.lacking import lacking
from planar_cli.solve.diagnosis.missed import passed_before
from planar_cli.solve.diagnosis.motions import clash, demand_told, never, strikes_before
from planar_cli.solve.diagnosis.unbounded_times import Endless
from planar_cli.solve.following.by_ways import followed_by_ways
from planar_cli.solve.following.continuation import continued_branch
from planar_cli.solve.following.dated import told_by_what_follows
from planar_cli.solve.following.departure import departure_of, resting_until_struck
from planar_cli.solve.following.follower import Follower
from planar_cli.solve.following.foreseen import as_it_happens, foreseen
from planar_cli.solve.following.kept_at_rest import asks_about_touch, told_of_rest
from planar_cli.solve.following.known_prefix import Beginning, beginning
from planar_cli.solve.following.mode_choice import Far, ModeChoice, assumed, at_a_top
from planar_cli.solve.following.seen import Seen
from planar_cli.solve.following.solved_beside import solved_beside
from planar_cli.solve.following.starts import (
    Start,
    balanced,
    resting_though_sought,
    separated_start,
    trial_start,
    untold,
)
from planar_cli.solve.following.stillness import hanging, resting, unturned
from planar_cli.solve.following.straight_ways import along_straight_ways
from planar_cli.solve.following.traced import Traced
from planar_cli.solve.impulsive.checks import demand_restitutions
from planar_cli.solve.principled import principle_of
from planar_cli.solve.regimes.first_modes import first_modes
from planar_cli.solve.regimes.mode_sequence import ModeSequence
from planar_cli.solve.regimes.regime_sequence import regime_sequence
from planar_cli.solve.solution import AT_A_TOP

CHANGES = 40


@changing
class ModeSearch(ModeChoice):
    """The search of one problem."""

    units: dict[str, str] = field(default_factory=dict)
    """Of answers, by name."""
    trial: Mapping[str, float] = field(default_factory=dict)
    """Numbers of sought constants [SI] with which the motion passes all states, by name, where they are known from
    following it: they tell the modes, and the equations in these modes tell the constants.
    """
    stays: bool = False
    """Does it begin at rest in equilibrium?"""
    unstable: ModeSequence | None = None
    """The modes that begin in an unstable equilibrium; None: none was met."""
    departing: frozenset[str] = frozenset()
    """The free speeds by which that equilibrium can be left."""
    sense: int = 0
    """To which side it is left, 1 or -1; 0: not at all."""
    seen: Traced | None = None
    """The motion, where the file tells all of it."""
    loose: tuple[MotionEquations, tuple[AskedFind, ...]] | None = None
    """The equations, and what is asked, before what rests was held."""

    def run(self) -> SolvedMotion:
        """The modes that happen, and the motion in them."""
        self.seen = foreseen(self.problem, self.workshop)
        self.problem, self.workshop = along_straight_ways(self.problem, self.workshop, self.seen)
        modes = first_modes(self.problem, self.workshop)
        modes = modes if self.seen is None else as_it_happens(modes, self.seen, self.workshop)
        return self._sooner(self._searched(modes))

    def _searched(self, modes: ModeSequence) -> SolvedMotion:
        """The same, beginning with these modes."""
        looked: list[tuple[ModeSequence, int]] = []
        while (modes, self.sense) not in looked and len(looked) < CHANGES:
            looked.append((modes, self.sense))
            sequence = regime_sequence(self.problem, modes, self.workshop)
            other = self._unblocked(sequence) or self._agreeing(sequence)
            if other is not None:
                modes = other
                continue
            if hangs := hanging(sequence):
                modes = modes.with_resting(hangs)
                continue
            finds = asked_finds(sequence, self.units)
            course = first_equations(stated_motion(sequence))
            demand_mass(course, course.base())
            if not course.states:
                return SolvedMotion(course, finds, course.equilibria.branch, None, course.base())
            found = self._solve_departing(course, finds)
            if isinstance(found, SolvedMotion):
                if self.unstable is None or self.sense or not asks_about_touch(course):
                    why = told_of_rest(found, bool(self.sense), self.stays)
                    return replace(found, checks=(*found.checks, *why))
                found = self._departed(self.unstable, 1)
            modes = found
        for regime in sequence.regimes:
            regime.general.demand_unique(regime.undetermined)
        raise self._undecided(len(looked))

    def _solve_departing(self, course: MotionEquations, finds: tuple[AskedFind, ...]) -> SolvedMotion | ModeSequence:
        """The same, after a slight touch where a state is not reached from rest; `reached(s)` is about no touch."""
        try:
            return self._solve(course, finds)
        except NoSolution as error:
            if self.unstable is None or isinstance(error, Endless) or asked_about(self.problem):
                raise
            if self.sense < 0:
                raise self.lack or error from error
            self.lack = self.lack or error
            return self._departed(self.unstable, -1 if self.sense else 1)

    def _departed(self, modes: ModeSequence, sense: int) -> ModeSequence:
        """These modes, to be left to one side, with nothing tried yet."""
        self.sense, self.tried, self.tried_blows = sense, {}, {}
        return modes

    def _sooner(self, found: SolvedMotion) -> SolvedMotion:
        """The same, or the departure to the other side where that passes all states sooner."""
        if self.sense < 1 or self.unstable is None or len(found.course.states) == 1:
            return found
        self.by = ended(found)
        try:
            return sooner(found, self._searched(self._departed(self.unstable, -1)))
        except (NoSolution, Undecided):
            return found

    def _solve(self, course: MotionEquations, finds: tuple[AskedFind, ...]) -> SolvedMotion | ModeSequence:
        """The motion solved, or other modes to try."""
        course, start = separated_start(course)
        if start is Start.OPEN and self.trial:
            start = trial_start(course, self._known(course))
        if start is Start.CONTRADICTS:
            other = self._other(course.modes, 0, "what is stated of the first state contradicts it")
            if other is None:
                early = [e for e in course.equations if e.stop == course.first.name]
                raise self.lack or clash(course, early) or self._exhausted(course.modes, 0)
            return other
        if isinstance(start, dict) and untold(course):
            spins = unturned(course, start, asked_letters(finds))
            if spins:
                return course.modes.with_resting(spins | course.modes.stretches[0].resting)
            # A wrong assumption may be why a state says nothing: at rest nothing comes to rest.
            other = self._tried(course, start)
            if other is not None:
                return other
        if start is Start.OPEN or untold(course) or told_by_what_follows(self.problem):
            rests = course.modes.stretches[0].resting
            if resting_though_sought(course) - rests:
                return course.modes.with_resting(resting_though_sought(course) | rests)
            loose = next((i for i, r in enumerate(course.regimes) if r.undetermined), None)
            course = self._relate(course, finds)
            return self._sought(course, finds) if loose is None else self._determined(course, loose)
        assert isinstance(start, dict)
        if self.sense:
            departure = departure_of(course.regimes[0], course.base(), start, self.sense, self.departing)
            course = replace(course, departure=departure)
            start |= {departure.speed: departure.value} if departure is not None else {}
        kept = frozenset() if course.blows or self.sense else balanced(course, start)
        rests = frozenset() if course.blows else resting(course, start) | kept
        idle = resting_until_struck(course, start) if course.blows else rests
        if not self.sense and departure_of(course.regimes[0], course.base(), start, 1, idle) is not None:
            self.unstable, self.departing = course.modes, idle
        self.stays = self.stays or bool(kept)
        if any(rests - s.resting for s in course.modes.stretches):
            if self.loose is None and self._alone:
                self.loose = self._relate(course, finds), finds
            return course.modes.with_resting(rests | course.modes.stretches[0].resting)
        return self._followed(course, finds, start)

    def _known(self, course: StatedMotion) -> Valuation:
        """Numbers of what is known, and of sought constants on trial."""
        return course.base().extended({s: Decimal(repr(self.trial[s.name])) for s in course.sought() if self.trial})

    @staticmethod
    def _relate(course: MotionEquations, finds: tuple[AskedFind, ...]) -> MotionEquations:
        """With the equations from state to state."""
        course = all_equations(course)
        return replace(course, equations=without_unneeded_times(course, finds))

    def _tried(self, course: MotionEquations, start: dict[sp.Symbol, Decimal]) -> ModeSequence | None:
        """Other modes, if following these as far as they go shows a wrong assumption."""
        try:
            followed = Follower(course, course.base(), by=self.by).run({s: float(v) for s, v in start.items()})
        except (NoValue, Unvalued):
            return None
        return self._changed(course, followed)

    # --- a known start -----------------------------------------------------------------------------------------------

    def _followed(
        self, course: MotionEquations, finds: tuple[AskedFind, ...], start: dict[sp.Symbol, Decimal]
    ) -> SolvedMotion | ModeSequence:
        known = self._known(course)
        seen = self.seen if course.departure is None else None
        followed = Follower(course, known, seen=seen, by=self.by).run({s: float(v) for s, v in start.items()})
        changed = self._changed(course, followed)
        if changed is not None:
            return changed
        course = self._relate(course, finds)
        if followed.lost:
            branches = candidates(course)
            found = self._led(course, finds, branches) if branches else None
            if found is not None:
                return found
            text = f"the motion can not be followed: {followed.lost}"
            raise self.lack or followed.spent or undecided_at(course.states[0].mark, text)
        if followed.missed is not None:
            related = self._related(*(self.loose or (course, finds)), followed.missed)
            if related is not None:
                return related
            raise never(course, followed, known)
        followed.values |= {s: float(known(s)) for s in course.sought() if self.trial}
        return solved_beside(course, finds, followed)

    @property
    def _alone(self) -> str:
        """The law of the file's method that relates states even where no motion joins them; "" for none."""
        return "" if self.problem.method is None else principle_of(self.problem.method).alone

    def _related(self, course: MotionEquations, finds: tuple[AskedFind, ...], missed: str) -> SolvedMotion | None:
        """States related by one law alone, where the file asks for a method that does so and no motion leads there; the
        speed that goes the way from state to state comes first.
        """
        if not self._alone:
            return None
        course = replace(course, equations=by_method(course.equations, course.problem.method))
        branches = that_tell(course, asked_letters(finds) & course.chain().unknowns, candidates(course))
        if not branches:
            return None
        branch = max(branches, key=lambda b: onward(course, b))
        if not assumed(course, course.base().extended(branch.values)):
            return None
        told = f"let go by itself it does not reach state {missed}; {self._alone} relates the two states all the same"
        return SolvedMotion(course, finds, branch, None, course.base().extended(branch.values), checks=(told,))

    def _changed(self, course: StatedMotion, followed: Followed) -> ModeSequence | None:
        """The next modes to try, None when these hold."""
        modes = course.modes
        if followed.blow is not None:
            other = self._other_blow(course, followed.blow, followed.why, followed.far)
            if other is None:
                text = f"no assumption about the contacts holds in the blow: {self.why}"
                raise self.lack or NoSolution([Diagnostic(modes.states[followed.blow + 1].mark, "PL622", text)])
            return other
        if followed.struck is not None:
            raise strikes_before(course, *followed.struck)
        if followed.misfit is not None and followed.ways:
            return modes.going(followed.misfit, followed.ways)
        if followed.misfit is not None and followed.choice is not None:
            return modes.changed(followed.misfit, followed.choice)
        if followed.misfit is not None:
            return self._next(modes, followed.misfit, followed.why)
        if followed.dated is not None:
            return modes.dated(followed.dated)
        if followed.ends is not None:
            ends = followed.ends
            changed = modes.turned(ends.stretch, ends.expr, ends.words)
            return changed if ends.choice is None else changed.changed(ends.stretch + 1, ends.choice)
        return None

    # --- a start that is sought --------------------------------------------------------------------------------------

    def _sought(self, course: MotionEquations, finds: tuple[AskedFind, ...]) -> SolvedMotion | ModeSequence:
        """All branches of the equations; of those that happen so the first that passes no state before its time."""
        known = beginning(course)
        try:
            other = self._changed(course, known.followed)
        except NoSolution as error:
            raise self.lack or error from error
        return self._of_branches(course, finds, known) if other is None else other

    def _of_branches(
        self, course: MotionEquations, finds: tuple[AskedFind, ...], known: Beginning
    ) -> SolvedMotion | ModeSequence:
        seen = Seen(far=dict(known.followed.far))
        branches, guessed = known.after(course, candidates(course))
        if not branches and (rest := without_departed(course, asked_letters(finds))) is not None:
            branches, guessed = known.after(rest, candidates(rest))
            course = rest if branches else course
        for branch in branches:
            if branch.left or not set(course.first.letters.values()) <= set(branch.values) or untold(course):
                found = self._led(course, finds, branches)
                if found is not None:
                    return found
                continue
            top = self._look(course, SolvedMotion(course, finds, branch, None, course.base(), guessed), seen)
            if top is not None:
                return top
            if seen.fits and not course.sought():
                break
        if seen.fits or seen.again:
            return one_of(course, seen.fits, seen.again)
        found = None if seen.lost is None else self._led(course, finds, [seen.lost])
        if found is not None:
            return found
        return seen.changed if seen.changed is not None else self._none_fits(course, branches, seen.far)

    def _look(self, course: MotionEquations, found: SolvedMotion, seen: Seen) -> SolvedMotion | None:
        """Follow the motion of one branch; what comes of it goes to what was `seen`, but a motion to a top."""
        branch, value = found.branch, course.base().extended(found.branch.values)
        last = course.states[-1].name
        # A motion that comes to rest at a top is never there; it is followed to the state before it.
        top = len(course.states) > 1 and at_a_top(course, last, value)
        start = {s: branch.values[own] for s, own in course.first.letters.items()}
        begun = (*start.items(), *((s, v) for s, v in branch.values.items() if s in course.sought()))
        if begun in seen.otherwise:
            return None
        followed = self._along(course, value, start, len(course.states) - 2 if top else None)
        if followed is None:
            return None
        if followed.lost:
            seen.lost = seen.lost or branch
            return None
        seen.far |= followed.far
        other = self._changed(course, followed)
        if other is not None:
            seen.changed = seen.changed or other
            seen.otherwise.add(begun)
            return None
        if top and followed.missed is None:
            return replace(found, value=value, guessed=frozenset(), checks=(AT_A_TOP,))
        if followed.missed is None and same_motion(course, followed, branch):
            more = {s: Decimal(repr(v)) for s, v in followed.values.items() if s not in branch.values}
            first = not course.sought() or not passed_before(course, followed, value)
            fit = replace(found, followed=followed, value=value.extended(more), guessed=found.guessed | set(more))
            (seen.fits if first else seen.again).append(fit)
        return None

    def _none_fits(self, course: MotionEquations, branches: list[Branch], far: Far) -> ModeSequence:
        """Other modes where in these no motion passes through the states. NoSolution: all have been tried."""
        demand_restitutions(course.blows.values(), [course.base().extended(b.values) for b in branches])
        text = "no motion passes through these states"
        # What stands in the way in the first modes is told; to look for it takes longer than to try others.
        self.lack = self.lack or lacking(course, branches) or no_motion(course.problem, text)
        other = self._elsewhere(course, text, far) or (None if branches else self._other(course.modes, 0, text))
        if other is None:
            raise self.lack
        return other

    def _along(
        self, course: MotionEquations, value: Valuation, start: dict[sp.Symbol, Decimal], until: int | None
    ) -> Followed | None:
        """The motion of one branch, followed from its start, `until` so many stretches have passed; None: it cannot."""
        try:
            return Follower(course, value, until).run({s: float(v) for s, v in start.items()})
        except NoSolution as error:
            self.lack = self.lack or error
        except NoValue:
            pass
        return None

    def _led(
        self, course: MotionEquations, finds: tuple[AskedFind, ...], branches: list[Branch]
    ) -> SolvedMotion | ModeSequence | None:
        """Where no motion can be followed: the branch to which the drawn position leads, or other modes of blows that
        it refutes; None: after blows, another.
        """
        for regime in course.distinct_regimes():
            regime.general.demand_unique(regime.undetermined)
        led = continued_branch(course, branches)
        try:
            demand_told(course, finds, led.values)
        except NoSolution as error:
            if not course.blows:
                raise
            self.lack = self.lack or error
            return None
        value = course.base().extended(led.values)
        refuted = self._refuted(course, value)
        return refuted or SolvedMotion(course, finds, led, followed_by_ways(course, led, value), value)
