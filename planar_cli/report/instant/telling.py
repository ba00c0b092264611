"""One instant told in three steps: kinematics, kinetics, solving."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

import sympy as sp

from planar_cli.greek import GREEK
from planar_cli.report.document.blocks import Block, Equation, Heading, Line, Name, Paragraph, line
from planar_cli.report.document.joined_lines import ACCELERATIONS, VELOCITIES
from planar_cli.report.equations.body_by_body import body_by_body
from planar_cli.report.equations.group_by_group import told_groups
from planar_cli.report.equations.numeric import level_of, vanishing
from planar_cli.report.equations.numeric_choice import numeric_telling
from planar_cli.report.equations.solved_already import is_given
from planar_cli.report.equations.solving import SolvingTelling
from planar_cli.report.equations.steps import EQUILIBRIUM, KINETICS, SOLVING
from planar_cli.report.friction.assumed import assumption_notes
from planar_cli.report.friction.limits_alike import with_limits_alike
from planar_cli.report.given.data import DataTelling
from planar_cli.report.given.derivatives_after import derivatives_after
from planar_cli.report.given.given_speeds import speed_told, turned
from planar_cli.report.given.sizes_given import as_sum, with_sum
from planar_cli.report.instant.asked import AskedTelling
from planar_cli.report.instant.reasons import Reasons
from planar_cli.report.instant.velocities_first import asked_told, of_velocities, without_repeats
from planar_cli.report.kinematics.geometry import constructed, in_numbers, places, with_coordinates
from planar_cli.report.kinematics.given_components import vector_before, with_given
from planar_cli.report.kinematics.grooves import groove_told
from planar_cli.report.kinematics.polar import polar_blocks
from planar_cli.report.kinematics.projected import as_product
from planar_cli.report.kinematics.relative_motion import is_told
from planar_cli.report.kinematics.rolled_points import touching
from planar_cli.report.kinematics.rolled_speeds import about_centre
from planar_cli.report.kinematics.rope_ends import end_told, named_end
from planar_cli.report.kinematics.rope_lengths import all_against, length_told, wound
from planar_cli.report.kinematics.sums_of_rates import sums_of_rates
from planar_cli.report.kinematics.translations import translations
from planar_cli.report.kinematics.vectors import VectorTelling
from planar_cli.report.kinetics.actions import free_direction, moment_words, onward, perpendicular
from planar_cli.report.kinetics.angles_alike import alike_told
from planar_cli.report.kinetics.at_rest import balance, said_at_rest
from planar_cli.report.kinetics.centre_components import centre_blocks, component_lines, read_off_arms
from planar_cli.report.kinetics.definitions import DefinitionTelling
from planar_cli.report.kinetics.one_body import diagrams
from planar_cli.report.kinetics.raw_moments import with_raw_moments
from planar_cli.report.kinetics.rope_rates import rope_told
from planar_cli.report.kinetics.sentences import sentences
from planar_cli.report.kinetics.two_force import two_force_members
from planar_cli.report.kinetics.zero_reactions import zero_reactions
from planar_cli.report.words.counted import clockwise_too, counted, one_way_round, sense_of
from planar_cli.report.words.spoken import begun, lead_of, spoken
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.limit_conditions import at_the_limit
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.used import used_blocks
from planar_cli.solve.instant.written import Explicit, Written
from planar_cli.solve.solution import Found, InstantSolution

OF_FORCES = ("limit", "extreme")
"""Relations of these sources rest on the equations of forces."""
ROLLS = "rolls without slipping"
LONG_FORMULA = 16
"""A named intermediate with a longer formula is given by its value alone, except in a lesson."""


class Telling:
    """Tells one instant. Equations are numbered in the order in which they are printed.

    `wanted`: names of symbols whose derivation is told; None: all. `steps`, `numbers`: how many steps and numbered
    equations of the same motion stand before it; `constants`: speaks of what is the same all the time.
    """

    def __init__(
        self,
        instant: InstantSolution,
        phrases: Phrases,
        audience: str,
        wanted: frozenset[str] | None,
        steps: int = 0,
        numbers: int = 0,
        constants: Phrases | None = None,
    ) -> None:
        self.steps, self._before, self._wanted = steps, numbers, wanted or frozenset()
        self.instant, self.phrases, self.audience = instant, phrases, audience
        self.system, self.scene = instant.trial.system, instant.instant.scene
        self.stages = body_by_body(used_blocks(instant.stages, wanted))
        self.principle = instant.instant.principle
        self._numbers: dict[tuple[int, int], int] = {}
        self._premised, self._reasons = set[str](), Reasons(instant, phrases)
        self._constructed = {} if phrases.symbolic else constructed(self.scene, self.stages)
        nothing = {z for s in self.stages for z in vanishing(s)}
        told = {u for s in self.stages for b in s.blocks for u in b.unknowns if not is_given(b)}
        self.vectors = VectorTelling(instant.trial, phrases, nothing - told, instant.open_speeds)
        self.data = DataTelling(self.scene, instant.state, phrases)
        self.asked = AskedTelling(instant, phrases, self.vectors)
        self._alike = read_off_arms(next((s for s in self.stages if s.level == "acceleration"), None), self.vectors)
        self.numeric = numeric_telling(phrases, constants, self.stages)
        self.solving = SolvingTelling(instant, phrases, self.numeric, self.number, constants)
        long = LONG_FORMULA if audience != "lesson" and not phrases.symbolic else None
        self.definitions = DefinitionTelling(self.system, self.solving, self.vectors, self._constructed, long)

    def number(self, stage: Stage, own: int) -> int:
        """The printed number of an equation or line of a stage."""
        return self._numbers.setdefault((id(stage.algebra), own), self.count + 1)

    @property
    def count(self) -> int:
        """How many equations and lines have a number, with those before it."""
        return self._before + len(self._numbers)

    def blocks(self, found: Iterable[Found] = ()) -> list[Block]:
        """`found`: what is asked; velocities among it are told with the velocities, if accelerations follow."""
        self.first = of_velocities(found, self.vectors.late)
        blocks = assumption_notes(self.instant, self.phrases)
        self.vectors.named |= set().union(*self._constructed.values())
        velocity = [s for s in self.stages if s.level == "velocity"]
        last = next((s for s in self.stages if s.level == "acceleration"), None)
        kinetic = last is not None and any(w.law != "relation" for b in last.blocks for w in b.equations)
        placed = places(self.scene, self._constructed, self.phrases)
        kinematics = [
            *with_coordinates(placed, self.definitions.lines(self._used(), "m"), self.scene, self.phrases),
            *translations(self.instant.trial, self.vectors.zero, self.phrases),
            *self._kinematics(velocity, last, kinetic),
            *self._polar(last),
        ]
        if kinetic and last is not None:
            kinematics += sums_of_rates(self.instant, last, self.phrases)
        first = next((i for i, b in enumerate(kinematics) if b in (VELOCITIES, ACCELERATIONS)), 0)
        kinematics[first:first], self.vectors.opened = self.vectors.preface, True
        kinematics[:0] = in_numbers(self.scene, kinematics, self.phrases)
        legend = [*touching(self.system, kinetic), *(counted(self.system, self.phrases) if kinetic else ())]
        resting = said_at_rest(self.instant, last, self.system)
        blocks += [self._step("Kinematic analysis", resting)] if kinematics or resting else []
        blocks += [*(legend if kinematics else ()), *kinematics]
        if kinetic and last is not None:
            still = balance(self.system, last)
            blocks.append(self._step(EQUILIBRIUM if still else KINETICS, still or self.principle.diagram))
            rows = diagrams(self.instant, last, self.phrases, self.principle.inertia_as_force)
            bodies = list(dict.fromkeys(b for row in rows for b in row.body.split(", ")))
            blocks += [*(() if kinematics else legend), *two_force_members(self.system, rows), *rows]
            blocks += sentences(self.system, bodies, self.principle.inertia_as_force)
            blocks += self.definitions.lines(self._used(), "kg")
            written = [w for b in last.blocks for w in b.equations]
            blocks += self._equations([w for w in written if self._of_forces(w) and w.source != "extreme"], last)
            blocks += self._equations([w for w in written if w.law != "relation"], last)
            blocks += zero_reactions(self.instant, last, self.phrases, bodies)
            blocks += self._equations([w for w in written if w.source == "extreme"], last)
        if last is not None and self.solving.is_needed(last):
            blocks += [self._step(SOLVING, self.solving.count(last, self.count))] if kinetic or not kinematics else []
            blocks += self.solving.blocks(last)
        return blocks

    def _of_forces(self, w: Written) -> bool:
        """Does a relation rest on the equations of forces, or speak of forces itself?"""
        forces = set(self.system.symbols.values())
        return w.law == "relation" and (w.source in OF_FORCES or bool(w.residual.free_symbols & forces))

    def _polar(self, last: Stage | None) -> Iterator[Block]:
        """Particles in polar coordinates that equations or questions are about."""
        written = [w for b in last.blocks for w in b.equations] if last is not None else []
        moved = {body for w in written for body in w.bodies}
        yield from polar_blocks(self.system, moved, self.phrases, self.vectors.zero)

    def _step(self, title: str, aside: str | Line = "") -> Heading:
        """The heading of the next step."""
        self.steps += 1
        return Heading(f"STEP {self.steps}", title, aside)

    # --- step 1 ------------------------------------------------------------------------------------------------------

    def _used(self) -> set[sp.Symbol]:
        """Every symbol that stands in an equation or line that is told."""
        used = {s for s in self.scene.ledger.definitions if s.name in self._wanted}
        for stage in self.stages:
            for block in stage.blocks:
                for w in block.equations:
                    used |= set() if self.numeric.put_whole(w, stage) else w.residual.free_symbols
                    used |= self._turned(w, stage)
            for x in stage.lines:
                bare = self.numeric.put_named(x) or x.symbol in self._alike
                used |= set() if bare else x.expression.free_symbols
        return used

    def _turned(self, w: Written, stage: Stage) -> set[sp.Symbol]:
        """The moments of inertia that stand in the kinetic diagrams of an equation."""
        accelerations = self.vectors.motion.accelerations if w.bodies else {}
        turning = (b for b in w.bodies if accelerations[b].angular not in (0, *vanishing(stage)))
        return {s for b in turning for s in sp.sympify(self.scene.bodies[b].inertia).free_symbols}

    def _kinematics(self, stages: list[Stage], last: Stage | None, kinetic: bool) -> list[Block]:
        blocks: list[Block] = []
        for stage in stages:
            written = [w for b in stage.blocks for w in b.equations]
            if written:
                # What only stands under Given again, with nothing after it, wants no heading.
                blocks += [] if last is None and all(map(self.data.restates, written)) else [VELOCITIES]
                blocks += [*self._equations(written, stage), *self.solving.blocks(stage)]
        self.first = self.first if blocks and last is not None else ()
        blocks += [*self.definitions.of_asked(self.first), *asked_told(self.asked, self.first, blocks)]
        if last is None:
            return blocks
        relations = [w for b in last.blocks for w in b.equations if w.law == "relation"]
        relations = [w for w in relations if not (kinetic and self._of_forces(w))]
        relations = derivatives_after(sorted(relations, key=lambda w: w.source == "extreme"))
        ends = [found[0] for w in relations if (found := named_end(w, last, self.system)) is not None]
        # The centre of what rolls comes first: the accelerations of other points rest on it.
        first = [x for x in last.lines if x in ends or x.words.endswith(ROLLS)]
        rates = [*(self._explicit(x, last) for x in first), *self._equations(relations, last)]
        rates += centre_blocks(last, self.vectors) if kinetic else ()
        lines, numbers = [x for x in last.lines if x not in first], partial(self.number, last)
        rates += component_lines(lines, self._alike, rates, lambda x: self._explicit(x, last), numbers)
        return [*blocks, *([ACCELERATIONS] if rates and (blocks or (relations and stages)) else []), *rates]

    def _explicit(self, x: Explicit, stage: Stage) -> Equation:
        sides, note = self.numeric.named(x, stage)
        return Equation(sides, self.number(stage, x.number), self.numeric.title(x, stage), note)

    # --- equations ---------------------------------------------------------------------------------------------------

    def _equations(self, written: list[Written], stage: Stage) -> list[Block]:
        blocks: list[Block] = []
        is_row = None if self.phrases.symbolic else self.numeric.is_row
        for block in told_groups(written, stage, self._reasoned, self.number, is_row):
            # Sums over the same body stand below each other under its name.
            last = next((b for b in reversed(blocks) if not isinstance(b, Equation)), None)
            if not isinstance(block, Paragraph) or block != last:
                blocks.append(block)
        return with_limits_alike(blocks)

    def _reasoned(self, w: Written, stage: Stage) -> list[Block]:
        blocks = with_sum(w, self._equation(as_sum(w), stage), self._named)
        return self._reasons.once(w, stage, self.number, with_given(w, blocks, stage, self.vectors, self.number))

    def _equation(self, w: Written, stage: Stage) -> list[Block]:
        number = self.number(stage, w.number)
        if w.given and (words := self._at_limit(w)):
            sides = (self.phrases.math(w.left), self.phrases.math(w.right))
            return [Paragraph(self._named(words)), Equation(sides, number)]
        if w.given:
            return self.data.blocks(w, number, turned(w))
        if w.law == "relation":
            return self._relation(w, stage, number)
        if w.law == "single":
            sides, note = self.numeric.sides(w, stage, (w.left, w.right))
            return [*self._premises(w), Paragraph(line(f"{w.words}:")), Equation(sides, number, lead_of(w.lead), note)]
        turn = self.system.tree.turn(w.bodies) if w.law == "moment" else 1
        w, turn = one_way_round(clockwise_too(onward(w), turn), turn)
        whole = self.principle.sides(w.left, w.right)
        sides, note = self.numeric.sides(w, stage, whole)
        group = ", ".join(w.bodies)
        if w.law == "moment":
            head = Paragraph(moment_words(self.system, self.phrases, w, stage))
            lead = line(f"{sense_of(turn)} ", Name(f"ΣM_{w.lead}"), ":")
            sides = sides if self.numeric.put_whole(w, stage) else with_raw_moments(w, turn, sides, self.phrases)
        else:
            head = Paragraph(line(f"{group}:") if w.lead else line(f"{group}, ", *self._way(w, stage), ":"))
            lead = line(f"{self.phrases.along(w.along)} ", Name(f"ΣF_{w.lead}" if w.lead else "ΣF"), ":")
            sides = self._with_zero(w, stage, sides)
        if parts := self.numeric.opened(w, stage, whole):
            return [head, Equation(parts, number, lead, note), *self.numeric.collected(w, stage, sides, note)]
        return [head, Equation(sides, number, lead, note)]

    def _with_zero(self, w: Written, stage: Stage, sides: tuple[Any, ...]) -> tuple[Any, ...]:
        """0 = m a_x, so that a_x = 0: of a direction in which nothing acts this is all there is to solve."""
        found = next((x for b in stage.blocks for x in b.lines if x.equations == (w.number,)), None)
        if found is None or found.formula != 0 or 0 not in (w.left, w.right) or found.letters:
            self.solving.take_outright(w, found, stage)
            return sides
        letter = self.phrases.math(found.symbol)
        self.solving.nil.add((id(stage.algebra), w.number))
        return sides if letter in sides else (sides[0], line(sides[1], ", so that ", letter, " = 0"))

    def _way(self, w: Written, stage: Stage) -> Line:
        """The direction along which forces are summed."""
        found = free_direction(w, stage) or perpendicular(self.system, w.words)
        return self._named(w.words) if len(found) == 1 else found

    def _relation(self, w: Written, stage: Stage, number: int) -> list[Block]:
        """A relation of kinematics: why it holds, and its component; with the value where it is its own solution."""
        moving = frozenset(self.system.tree.velocity_unknowns())
        if speed := speed_told(w, stage, self.phrases, number, moving):
            self.solving.nil.add((id(stage.algebra), w.number))
            self.vectors.zero |= {speed[1].symbol} if speed[1].formula == 0 else set()
            return [speed[0]]
        moving |= frozenset(self.system.tree.acceleration_unknowns())
        if not self._at_limit(w) and (told := self.data.of_letter(w, moving, number)) is not None:
            return [told]
        whole = rope_told(w, stage, self.numeric, self.system, number, self.vectors.zero)
        whole = whole or about_centre(w, stage, self.stages, self.vectors, number)
        if whole := whole or groove_told(w, stage, self.vectors, number):
            self.solving.merged.add((id(stage.algebra), w.number))
            return whole
        length = length_told(w, self.system, self.phrases, stage.level != "velocity")
        length = length or (() if self._at_limit(w) else self.data.given(w, turned(w)))
        if (end := named_end(w, stage, self.system)) is not None:
            length = end_told(w, end, self.number(stage, end[0].number), self.phrases)
        level = level_of(w, stage, self.scene.ledger)
        words = alike_told(w, self.stages, self.system, self.phrases, self.number)
        words = words or self.vectors.before(w, level) or []
        words = words or [Paragraph(length or self._named(self._relation_words(w, stage)))]
        self.numeric.keep(w, stage, self.vectors.components)
        if self.vectors.components and w.place in self.scene.points:
            above = list(self.asked.absolute(w.place, "v" if self.vectors.components.as_told else level[0]))
            words = [*above, *without_repeats(words, above)]
        words = [*vector_before(w, self.vectors, level), *words]
        frame = self.vectors.frame_of(w) if level != "velocity" else None
        if frame is not None and is_told(frame, stage, self.vectors, self.solving.merged | self.solving.nil):
            words = [*self.asked.coriolis(*frame, bool(self.vectors.components)), *words]
        line_of = next((x for b in stage.blocks for x in b.lines if x.equations == (w.number,)), None)
        if line_of is not None and line_of.symbol in stage.zero:
            return [*words, self._nil(w, line_of, stage, number)]
        itself = line_of and not self.numeric.put_whole(w, stage) and self.solving.solves_itself(w, line_of, stage)
        if line_of is not None and (chain := self.solving.told_already(w, line_of, bool(itself))):
            self.solving.merged.add((id(stage.algebra), w.number))
            return [*words, Equation(chain, number)]
        if w.source in ("row", "closure") and w.right.is_Symbol and not w.left.as_coeff_Mul()[1].is_Symbol:
            w = replace(w, left=w.right, right=w.left)
        opposite = (-w.left).is_Symbol or all(e.could_extract_minus_sign() for e in (w.left, w.right))
        opposite |= w.source in ("row", "closure") and all_against(w)
        sides, note = self.numeric.sides(w, stage, (-w.left, -w.right) if opposite else (w.left, w.right))
        if result := self.numeric.result(line_of, sides):
            self.solving.merged.add((id(stage.algebra), w.number))
            sides, note = result, ()
        if product := as_product(
            self.numeric.components.get((id(stage.algebra), w.number)), sides, level, self.phrases
        ):
            sides, note = product, ()
        elif self.numeric.put_whole(w, stage):
            words = self.vectors.with_unit(words, w, level)
            sides = (sides[0], sides[-1]) if level == "acceleration" and self.vectors.swings(w) else sides
        return [*words, Equation(sides, number, (), note)]

    def _nil(self, w: Written, found: SolvedLine, stage: Stage, number: int) -> Block:
        """A relation that says at sight that something is zero; what follows does without it."""
        self.solving.merged.add((id(stage.algebra), w.number))
        self.vectors.zero |= {found.symbol}
        letter = self.phrases.math(found.symbol)
        plain = (letter, self.phrases.math(sp.S.Zero))
        sides, _ = self.numeric.sides(w, stage, (w.left, w.right))
        if sides == plain or self.solving.solves_itself(w, found, stage) or self.numeric.put_whole(w, stage):
            return Equation(plain, number)
        return Equation(sides, number, (), line("hence ", letter, " = 0"))

    def _premises(self, w: Written) -> list[Block]:
        """What stands in equations of a whole scene, each once."""
        blocks: list[Block] = []
        for p in w.premises:
            if p.name not in self._premised:
                self._premised.add(p.name)
                blocks.append(Equation((line(Name(p.name)), self.phrases.math(p.formula)), None, line(f"{p.words}:")))
        return blocks

    def _named(self, words: str) -> Line:
        """Words in which the names of symbols are set as mathematics."""
        names = {n for n in (*self.scene.ledger.symbols, *self.system.symbols) if "_" in n or n in GREEK}
        return spoken(words, names)

    def _at_limit(self, w: Written) -> str:
        """What the file says with an equation in which an assumption only just holds; empty: it says something else."""
        reactions = self.system.reactions
        values = {p.name: e for p, e in reactions.pushes} if reactions is not None and w.source == "given" else {}
        for test in (t for mode in self.system.modes.values() for t in mode.tests if not t.strict and not t.within):
            if test.pushes and all(name in values for name, _ in test.pushes):
                bound = sp.Add(*(factor * values[name] for name, factor in test.pushes), test.constant)
                if w.residual in (bound, -bound):
                    return f"At the limit: {at_the_limit(test.words)}:"
        smooth = next(
            (p.place for p in self.system.pushes if p.kind == "friction" and values.get(p.name) == w.left), ""
        )
        return f"Without friction at {smooth}:" if smooth and w.right == 0 else ""

    def _relation_words(self, w: Written, stage: Stage) -> str:
        if w.source == "given":
            often = ("", ", differentiated", ", differentiated twice")[w.times]
            return self._at_limit(w) or f"Given: {w.words or w.lead}{often}{turned(w)}"
        if w.source == "limit" and self.instant.instant.statements.extremes:
            extreme = self.instant.instant.statements.extremes[0].text
            name, _, most = extreme.partition(" is ")
            return f"At the {most} {name}{w.lead.removeprefix('at the limit')}:"
        if w.source in OF_FORCES:
            return f"{begun(w.lead)}:"
        if w.source == "closure":
            joint = next((j for j in self.system.tree.closures if j.joint == w.lead), None)
            if joint is not None:
                base = "the ground" if joint.base == "ground" else joint.base
                if any(push.kind == "tension" for push in self.system.modes[joint.joint].facts.pushes):
                    return f"{begun(self.scene.problem.called(joint.joint))} keeps its length:"
                if joint.path is not None:
                    return f"{joint.place} stays on its path on {base}, across which nothing moves:"
                return f"{joint.place} is a point of {joint.mover} and of {base}; {w.words}:"
        if told := wound(w, self.system, [x for b in stage.blocks for x in b.equations]):
            return told
        words = w.words.removeprefix(w.lead).removeprefix(", ")
        return f"{begun(w.lead)}{', ' + words if words and w.source != 'row' else ''}:"
