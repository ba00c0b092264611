"""A solution as a document: effects, the three steps, answers, checks and what is worth discussing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.problem.language.expression import Quantity
from planar_cli.records import record
from planar_cli.report.answers.answer_letters import answer_block
from planar_cli.report.answers.asked_in_general import with_asked
from planar_cli.report.answers.by_formula_above import by_formula_above, stood_above, without_foretold
from planar_cli.report.answers.closed import with_closed_forms
from planar_cli.report.answers.directions import with_tangents
from planar_cli.report.answers.discussion import discussion_lines
from planar_cli.report.answers.named_in_answer import named_in_answer
from planar_cli.report.answers.plain_answers import with_plain_answers
from planar_cli.report.answers.size_and_angle import with_size_and_angle
from planar_cli.report.answers.special_case import special_case
from planar_cli.report.checks.checked_once import checked_once
from planar_cli.report.checks.checks import check_blocks, program_blocks, road_blocks
from planar_cli.report.checks.choice_of_checks import OF_MOTIONS, OF_PARTS, chosen_check
from planar_cli.report.document.blocks import Block, Check, Document, Equation, Heading, Note
from planar_cli.report.document.said import said_once, says_nothing
from planar_cli.report.document.stated_text import stated_text
from planar_cli.report.energy.alike import with_equals_together
from planar_cli.report.equations.steps import SOLVING, without_ritual
from planar_cli.report.friction.decisions import with_decisions
from planar_cli.report.friction.slips_at_start import with_slips_told
from planar_cli.report.given.presumed import presumed_notes
from planar_cli.report.given.restated import is_restated
from planar_cli.report.instant.one_find import for_one_find
from planar_cli.report.instant.telling import Telling
from planar_cli.report.instant.velocities_first import asked_told
from planar_cli.report.instant.wanted import needed_of
from planar_cli.report.kinetics.free_flight import in_free_flight
from planar_cli.report.kinetics.inertias import with_inertias
from planar_cli.report.laws.laws import without_given
from planar_cli.report.laws.laws_solved import with_laws_solved
from planar_cli.report.laws.passages import tale_blocks
from planar_cli.report.momentum.blow_limits import ends_of_blows, limits_of_motion
from planar_cli.report.momentum.impulse_names import with_short_impulses
from planar_cli.report.motion.at_one_state import where_asked, where_told
from planar_cli.report.motion.meanings import with_meanings
from planar_cli.report.notation.sizes import with_signs
from planar_cli.report.oscillation.near_rest import with_numbers
from planar_cli.report.page.axes_of_frames import with_axes_of_frames
from planar_cli.report.page.beside_headings import beside_headings
from planar_cli.report.page.by_its_line import by_its_line
from planar_cli.report.page.carried_out import carried_out
from planar_cli.report.page.components_beside import with_components_beside
from planar_cli.report.page.data_numbers import without_numbered_data, without_restated_data
from planar_cli.report.page.effects import effect_notes
from planar_cli.report.page.exam import key_blocks
from planar_cli.report.page.idle_lines import without_idle_lines
from planar_cli.report.page.in_one_line import in_one_line, of_motion
from planar_cli.report.page.numbers_alone import numbers_alone
from planar_cli.report.page.opening import changed_notes, not_used, opening_notes
from planar_cli.report.page.slots_beside import slots_beside
from planar_cli.report.page.turning_rates import with_turning_rates
from planar_cli.report.page.uses import uses_of
from planar_cli.report.recast.equations_as_told import equations_as_told
from planar_cli.report.repeats.as_in_part import as_in_part
from planar_cli.report.repeats.likewise import told_likewise
from planar_cli.report.repeats.repeats import told_once
from planar_cli.report.repeats.roots_of_cases import with_roots_of_cases
from planar_cli.report.repeats.told_before import ToldBefore, defined_once
from planar_cli.report.words.apart import with_letters_apart
from planar_cli.report.words.bars import with_bars
from planar_cli.report.words.component_letters import with_component_letters
from planar_cli.report.words.frames_apart import with_frames_apart
from planar_cli.report.words.loads_by_letter import with_loads_by_letter
from planar_cli.report.words.one_name import with_one_name, without_primes
from planar_cli.report.words.only_body import with_only_body
from planar_cli.report.words.polar_names import with_polar_names
from planar_cli.report.words.slopes import slopes_of
from planar_cli.report.words.sought_at_state import with_sought_names
from planar_cli.report.words.stated_angles import with_stated_angles
from planar_cli.report.words.stretches import only_after, stretches
from planar_cli.report.words.weights_by_letter import with_weights_by_letter
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.asked import asks_mode
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution, Solution

if TYPE_CHECKING:
    from planar_cli.report.motion.motion import MotionTelling


@record
class Voice:
    """How a page speaks. `figures`: significant figures; `audience`: student (the worked solution), exam (as short as
    a key) or lesson (with the text, every line, and what each step is for); `effects`: which effects the scene has, and
    lacks; `verbose`: what the program compared, with digits.
    """

    figures: int = 4
    audience: str = "student"
    effects: bool = False
    verbose: bool = False


STUDENT = Voice()


def narrate(solution: Solution, voice: Voice = STUDENT, why: str | None = None) -> Document:
    """The worked solution of a file.

    `why`: the name of one find; only what its answer used is told. KeyError: there is no such find.
    """
    blocks, problem = list[Block](), solution.problem
    texts = stated_text(problem) if voice.audience == "lesson" else []
    if why is not None and not any(f.name == why for part in solution.parts for f in part.found):
        raise KeyError(why)
    solution = for_one_find(solution, why)
    told: set[tuple[str, ...]] = set()
    lessons, meanings = set[str](), set[str]()
    first = next((phrases_of(i, voice.figures) for part in solution.parts for i in part.instants), None)
    for part in solution.parts:
        # Of a case in which nothing is asked there is nothing to tell.
        if part.case and not part.found:
            continue
        own = with_equals_together(with_bars(list(with_tangents(part_blocks(part, voice, why, told))), part.found))
        if part.motion is not None and why is None:
            own = list(with_meanings(own, part.motion, meanings))
            own = with_turning_rates(own, (c.name for c in problem.coordinates))
        if part.case:
            case = next(c.problem for c in problem.cases if c.name == part.case)
            mine = next((phrases_of(i, voice.figures) for i in part.instants), None)
            # Of what the formula above is set to zero for, the heading says all that is new.
            headed = why is None and (shorter := by_formula_above(part, solution, mine, own, blocks)) is not own
            if headed:
                blocks = without_foretold(blocks, part, solution)
                own = [b for b in shorter if not stood_above(b, blocks)]
            blocks.append(Heading("CASE", part.case.replace("_", " ")))
            if why is None and not (headed and all(g in problem.given for g in case.given)):
                blocks += changed_notes(problem, case, own, (first, mine), voice.figures)
        own = with_roots_of_cases(list(defined_once(own)), part, solution.parts)
        own = without_idle_lines(carried_out(in_one_line(own)), meanings, problem)
        own = with_weights_by_letter(by_its_line(without_primes(list(without_ritual(own)))))
        if voice.audience == "exam":
            blocks += key_blocks(own, blocks, problem)
        elif voice.audience == "lesson":
            from planar_cli.report.page.lessons import with_lessons

            blocks += with_lessons(told_once(as_in_part(own, blocks, problem, part), blocks), uses_of([part]), lessons)
        else:
            blocks += told_once(as_in_part(numbers_alone(own), blocks, problem, part), blocks)
    blocks[:0] = not_used(problem, blocks, voice.figures) if why is None else ()
    scene = next((i.instant.scene for part in solution.parts for i in part.instants), None)
    drawn = () if first is None or scene is None else tuple(slots_beside(scene, first))
    opening = opening_notes(problem, blocks, uses_of(solution.parts, why), first, voice.figures, drawn)
    opening = (n for n in opening if (voice.audience != "exam" and why is None) or n.kind == "Principle")
    named = with_short_impulses(with_one_name(with_polar_names(with_only_body((*opening, *blocks), problem))))
    named = beside_headings(with_stated_angles(with_loads_by_letter(named, problem), problem))
    page = told_likewise(with_letters_apart(without_restated_data(named), problem), problem)
    page = checked_once(with_components_beside(page))
    return Document(problem.title or problem.file, (*texts, *(said_once(b) for b in page if not says_nothing(b))))


def part_blocks(part: PartSolution, voice: Voice, why: str | None, told: set[tuple[str, ...]]) -> list[Block]:
    """One part: its instants, its answers, its checks. `told`: effects that were listed before."""
    part, positive = with_signs(with_plain_answers(equations_as_told(part)))
    figures = voice.figures
    telling = None
    if part.motion is not None:
        from planar_cli.report.motion.motion_in_parts import motion_telling

        telling = motion_telling(part.motion, figures, why)
    notes = presumed_notes(part, phrases_of(part.instants[0], figures), positive) if part.instants else []
    before = ToldBefore(by_number=voice.audience != "exam")
    blocks, steps, count, place = _of_instants(part, telling, voice, why, (told, notes, before))
    phrases = settled = phrases_in(part, figures)
    blocks += _read_off(part, figures)
    if part.motion is not None:
        from planar_cli.report.motion.motion_in_parts import placed
        from planar_cli.report.words.motion_phrases import motion_phrases, settled_phrases

        phrases = motion_phrases(part.motion, figures)
    blocks += (whole := _tale(part, phrases, steps + 1, whole=True))
    if part.motion is not None:
        assert telling is not None
        moving = list(_motion_blocks(part, telling, voice, why, steps + bool(whole), count))
        settled = settled_phrases(part.motion, phrases)
        if part.instants:
            scene = part.instants[-1].instant.scene
            moving = without_given(with_inertias(moving, part.motion, scene, settled, blocks), [*before.data, *blocks])
            blocks, moving = with_laws_solved(blocks, moving, part.instants[-1].value, part.motion.varying)
        moving += ends_of_blows(part.motion, phrases) if why is None else ()
        moving = moving if part.tale is None or not part.tale.valued else []
        blocks = placed(moving, blocks, place, part.motion)
    blocks += _tale(part, phrases, 0, whole=False)
    blocks = with_closed_forms(blocks, part, phrases)
    blocks = with_size_and_angle(blocks, (f for f in part.found if why in (None, f.name)), phrases, part)
    for found in part.found:
        if why is None or found.name == why:
            blocks.append(answer_block(found, part, phrases, blocks))
    blocks = named_in_answer(with_frames_apart(with_component_letters(blocks, part.found), part.found))
    blocks = with_sought_names(with_numbers(with_axes_of_frames(blocks, part.motion)), part.motion)
    checks, by_hand = _student_checks(part, (phrases, settled), figures, why)
    blocks += [*checks, *road_blocks(part), *(program_blocks(part) if voice.verbose else ())]
    if why is None and not by_hand and (case := special_case(part, phrases)):
        blocks.append(Note("Discussion", case))
    # Where a mode is decided, or friction opposes sliding, other values may mean another mode.
    systems = [instant.trial.system for instant in part.instants]
    decided = any(s.skids() or any(mode.tests for mode in s.modes.values()) for s in systems)
    if not decided and part.motion is None and part.tale is None:
        blocks += [Note("Discussion", remark) for remark in discussion_lines(part.found, phrases)]
    return without_numbered_data(blocks, part.motion is not None)


def _of_instants(
    part: PartSolution,
    telling: MotionTelling | None,
    voice: Voice,
    why: str | None,
    said: tuple[set[tuple[str, ...]], Iterable[Note], ToldBefore],
) -> tuple[list[Block], int, int, int | None]:
    """All instants, each after what happens before its forces act; how many steps and numbered equations there are, and
    where balances end that led through all states before the forces (None: none did). `said`: effects that were listed
    before, what is presumed, and what earlier parts of the motion have told.
    """
    blocks: list[Block] = []
    steps, count, place = 0, 0, None
    for instant in part.instants:
        if instant.state:
            blocks.append(Heading("STATE", instant.state))
        if voice.effects:
            blocks += _effects(instant, said[0])
        if instant is part.instants[0]:
            blocks += said[1]
        if instant.quiet or (part.tale is not None and part.tale.whole):
            continue
        if telling is not None:
            from planar_cli.report.motion.motion_in_parts import (
                early_blocks,
                leads_through,
                same_all_the_time,
                with_assumed_first,
            )

            early, steps, count = early_blocks(telling, instant, (steps, count), [*said[2].data, *blocks])
            blocks += early
        numbers = (steps, count) if part.motion is not None else (0, 0)
        told, steps, count = _instant_blocks(part, instant, voice, why, said[2], numbers)
        if telling is not None and early and leads_through(telling, instant):
            blocks, told = with_assumed_first(blocks, early, told)
            place = len(blocks)
        blocks += [*told, *(same_all_the_time(telling.found, instant, told) if telling is not None else ())]
    return blocks, steps, count, place


def _student_checks(
    part: PartSolution, speaks: tuple[Phrases, Phrases], figures: int, why: str | None
) -> tuple[list[Block], bool]:
    """What the assumptions ask for, and one check of a person's own; whether there is such a one. `speaks`: of the
    part, and of its motion with letters that have values.
    """
    phrases, settled = speaks
    heard = [instant for instant in part.instants if not instant.quiet]
    decides = any(f.find is not None and asks_mode(f.find) for f in part.found)
    checks = [check_blocks(instant, phrases_of(instant, figures), part.motion is None, decides) for instant in heard]
    blocks: list[Block] = []
    for b in (*(b for one in checks for b in one.tests), *(b for one in checks for b in one.own)):
        blocks += [b] if b not in blocks else []
    by_motion = chosen_check(OF_MOTIONS, part.motion, settled) if part.motion is not None and why is None else ()
    limits = limits_of_motion(part.motion, heard, phrases, settled) if part.motion is not None and why is None else ()
    own = by_motion or any(one.own for one in checks)
    derived = () if why is not None or own else chosen_check(OF_PARTS, part, phrases)
    return [*blocks, *(Check(x) for x in (*limits, by_motion, derived) if x)], bool(own or derived)


def _tale(part: PartSolution, phrases: Phrases, step: int, whole: bool) -> list[Block]:
    """Places over time and curves under a heading, if they are told by themselves (`whole`) or beside a motion."""
    if part.tale is None or part.tale.whole != whole or not part.tale.passages:
        return []
    heading = Heading(f"STEP {step}", "Kinematic analysis") if whole else Heading("", "Positions and curves")
    return [heading, *tale_blocks(part.tale, phrases)]


def _instant_blocks(
    part: PartSolution,
    instant: InstantSolution,
    voice: Voice,
    why: str | None,
    before: ToldBefore,
    numbers: tuple[int, int],
) -> tuple[list[Block], int, int]:
    """One instant, or one general position of a motion, without what an earlier one has told; how many steps and
    numbered equations there are then. `numbers`: how many of them stand before it.
    """
    from planar_cli.report.motion.integrated import is_solved_in_steps
    from planar_cli.report.words.motion_phrases import constant_phrases

    phrases, constants = phrases_of(instant, voice.figures), None
    if part.motion is not None:
        ways = part.motion.regime(instant).ways
        phrases = replace(phrases, ways=ways, drawn=where_told(part.motion, instant))
        constants = constant_phrases(part.motion, instant, phrases)
    wanted = needed_of(part, instant, why)
    telling = Telling(instant, phrases, voice.audience, wanted, *numbers, constants)
    mine = [f for f in part.found if (why is None or f.name == why) and _at(f) in ("", instant.state)]
    blocks = telling.blocks(mine if part.motion is None else ())
    if part.motion is None:
        asks = any(f.find is not None and asks_mode(f.find) for f in part.found)
        blocks = with_decisions(blocks, instant, phrases, asks) if why is None else blocks
        mine = [f for f in mine if f not in telling.first]
        asked = asked_told(telling.asked, mine, blocks)
        return [*blocks, *telling.definitions.of_asked(mine), *asked], telling.steps, telling.count
    blocks = where_asked(blocks, part.motion, instant, telling, phrases)
    blocks = with_slips_told(blocks, part.motion, instant, voice.figures)
    if why is None:
        blocks = in_free_flight(with_asked(blocks, telling, part.motion), part, instant)
    acting = stretches(part, instant)
    if is_restated(blocks):
        before.data += blocks
        blocks = []
    if is_solved_in_steps(part.motion, part.motion.regime(instant)):
        blocks = _without_solution(blocks)
    blocks = before.reduced(blocks, acting, numbers[0])
    steps = numbers[0] + sum(isinstance(b, Heading) for b in blocks)
    if len(part.instants) > 1 and all(isinstance(b, Note) for b in blocks) and only_after(part, instant):
        blocks = []
    if len(part.instants) > 1 and blocks:
        blocks = of_motion(blocks, acting)
    printed = [*before.named, *(b.number for b in blocks if isinstance(b, Equation) and b.number is not None)]
    return blocks, steps, max(printed, default=numbers[1])


def _without_solution(blocks: list[Block]) -> list[Block]:
    """What stands before the step that solves the equations."""
    stop = next((i for i, b in enumerate(blocks) if isinstance(b, Heading) and b.text == SOLVING), len(blocks))
    return blocks[:stop]


def _motion_blocks(
    part: PartSolution, telling: MotionTelling, voice: Voice, why: str | None, steps: int, count: int
) -> Iterator[Block]:
    """The way from state to state, then what is asked of forces at single states."""
    from planar_cli.report.motion.motion_in_parts import way_blocks

    telling.next = count + 1
    at_states = part.tale is None or not part.tale.whole
    yield from way_blocks(telling, steps, (voice.figures, voice.audience) if at_states else None)


def _at(found: Found) -> str:
    """The state at which something is asked; empty of the only instant."""
    what = found.find.found.what if found.find is not None else None
    return what.at if isinstance(what, Quantity) and isinstance(what.at, str) else ""


def _effects(instant: InstantSolution, told: set[tuple[str, ...]]) -> Iterator[Block]:
    """What acts, unless it was told before."""
    key = tuple(map(str, notes := effect_notes(instant)))
    if key not in told:
        yield from notes
        told.add(key)


def _read_off(part: PartSolution, figures: int) -> Iterator[Block]:
    """How answers were read off a motion, where nothing else gives them."""
    if part.followed is not None:
        from planar_cli.report.motion.read_off import read_off_blocks

        yield from read_off_blocks(part.followed, figures)


def phrases_in(part: PartSolution, figures: int) -> Phrases:
    """The phrases in which the answers of a part are told."""
    if part.instants:
        return phrases_of(part.instants[-1], figures)
    from planar_cli.report.motion.read_off import phrases_without_letters

    return phrases_without_letters(figures, part.followed is not None and part.followed.run.problem.us)


def phrases_of(instant: InstantSolution, figures: int) -> Phrases:
    """The phrases in which an instant speaks."""
    scene = instant.instant.scene
    ledger, letters = scene.ledger, frozenset(scene.ledger.letters)
    spoken = bool(letters) and _speaks_of(instant, letters)
    return Phrases(ledger, instant.value, figures, spoken, letters, slopes=slopes_of(scene.problem))


def _speaks_of(instant: InstantSolution, letters: frozenset[sp.Symbol]) -> bool:
    """Does a general position, or does an equation or a line of an instant have these letters? A mass or a moment of
    inertia without a number that cancels leaves a page of numbers.
    """
    ledger = instant.instant.scene.ledger
    if letters & {*ledger.coordinates, ledger.symbols.get("t")}:
        return True
    written = [w.residual for s in instant.stages for b in s.blocks for w in b.equations]
    names = set().union(*(e.free_symbols for e in (*written, *(x.expression for s in instant.stages for x in s.lines))))
    while inside := {s for n in names for s in ledger.behind(n).free_symbols} - names:
        names |= inside
    return not instant.stages or bool(names & letters)
