"""What was checked, in short phrases: the assumptions of contacts and another principle, which a person can follow, and
one line on the independent road. What only the program needs to say stands behind an option.
"""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal

from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.problem.scene.facts import Test
from planar_cli.records import record
from planar_cli.report.checks.choice_of_checks import OF_INSTANTS, chosen_check
from planar_cli.report.checks.letter_check import letter_check
from planar_cli.report.document.blocks import Check, Inline, Line, Math, Name, Relation, line
from planar_cli.report.friction.decisions import at_limit, decision_lines, limits_of, needed
from planar_cli.report.friction.presses import bounded_in, formula_of_press
from planar_cli.report.friction.slip_senses import slip_senses
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.distribution import possible
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.solution import AT_A_TOP, CAVEATS, Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import parse_unit

MOST_PRESSES = 4
TINY = Decimal("1e-30")


INDEPENDENT = "checked by an independent multibody solution"


@record
class Checks:
    """What was checked at one instant."""

    tests: tuple[Check, ...] = ()
    """What its assumptions ask for: N > 0, friction within its limit."""
    own: tuple[Check, ...] = ()
    """By another equation, as a person would."""


def check_blocks(instant: InstantSolution, phrases: Phrases, single: bool, decides: bool) -> Checks:
    """The checks of one instant that a person can follow, each a phrase. `single`: it is no part of a motion;
    `decides`: it is asked in which mode a joint is.
    """
    if not instant.checks.get("lines"):
        return Checks()
    bodies = instant.trial.system.scene.bodies.values()
    heavy = bool(instant.trial.outcomes) and not phrases.symbolic and any(b.mass != 0 for b in bodies)
    # What the page does not tell may rest on letters without a number.
    sure = not phrases.lettered
    # Of motions alone nothing on the page says what drives them, and with it how the contacts press.
    forces = any(w.law != "relation" for s in instant.stages for b in s.blocks for w in b.equations)
    presses, limits = (
        (_presses(instant, phrases), _friction(instant, phrases, decides)) if heavy and sure and forces else ([], [])
    )
    held = _possible(instant, phrases) if decides and heavy and sure else ()
    slips = slip_senses(instant, phrases) if single and heavy and sure and any(instant.trial.choice) else []
    told = [*presses, *slips, *limits, held, *(line(text) for text in instant.checks.get("told", ()))]
    own: list[Line] = []
    if single and sure and not limits:
        own.append(chosen_check(OF_INSTANTS, instant, phrases))
    own += [letter_check(instant, phrases)] if single and phrases.symbolic else []
    tests, others = (tuple(Check(phrase) for phrase in phrases_told if phrase) for phrases_told in (told, own))
    return Checks(tests, others)


def road_blocks(part: PartSolution) -> list[Check]:
    """What another way to the answers of a part gave, in one line for each."""
    if part.followed is not None:
        errors = any(a.error is not None and a.values for a in part.followed.answers)
        return [Check(line("a second run with finer steps gives the same"))] if errors else []
    caveats = part.motion.checks if part.motion is not None else ()
    # That the last state is just reached is said where the page first speaks of it.
    found = [Check(line(t)) for t in caveats if t.startswith(CAVEATS) and t != AT_A_TOP]
    read = [f.name for f in part.found if part.motion is not None and f.name in part.motion.read_off]
    if read:
        found.append(Check(line(*_listed(read), " read off the motion that is followed in numbers")))
    apart = [f.name for f in part.found if unconfirmed(f, part)]
    if not _has_equations(part):
        # A place or a moment of inertia rests on no equation of motion that another solution could check.
        return found
    if not apart:
        return [*found, Check(line(INDEPENDENT))]
    if len(apart) < len(part.found):
        names = _listed(apart)
        if _follow_from_motion(apart, part):
            follow = line(*names, " follow" if len(apart) > 1 else " follows")
            return [
                *found,
                Check(line("the equation of motion, from which ", *follow, f", and all else {INDEPENDENT}")),
            ]
        others = ("all else",) if apart == read else ("all but ", *names)
        return [*found, Check(line(*others, f" {INDEPENDENT}"))]
    if part.instants and part.instants[-1].checks.get("digits") is not None:
        found.append(Check(line(f"equations of motion {INDEPENDENT}")))
    return found


def _listed(names: list[str]) -> tuple[Inline | str, ...]:
    return tuple(piece for name in names for piece in (", ", Name(name)))[1:]


def _has_equations(part: PartSolution) -> bool:
    """Does anything move, or is anything balanced?"""
    return part.motion is not None or part.tale is not None or any(s.blocks for i in part.instants for s in i.stages)


def _follow_from_motion(names: list[str], part: PartSolution) -> bool:
    """Are these what an equation of motion, which was compared, tells of small oscillations?"""
    told = {f.name: f.find.found.what for f in part.found if f.find is not None}
    compared = bool(part.instants) and part.instants[-1].checks.get("digits") is not None
    words = [what.word if isinstance(what := told.get(name), Quantity) else "" for name in names]
    return compared and all(word in (*OF_SWINGS, "stable") for word in words)


def unconfirmed(found: Found, part: PartSolution) -> str:
    """Why nothing was compared with an answer; "" where a second road to it agrees."""
    if part.followed is not None:
        return "it is read off one motion, whose error was estimated by a second run"
    if part.motion is not None:
        return part.confirmed.apart.get(found.name, "")
    return "" if part.instants[-1].checks.get("digits") is not None else "no second road leads to it"


def program_blocks(part: PartSolution) -> list[Check]:
    """What the program compared, with digits."""
    heard = [instant for instant in part.instants if not instant.quiet]
    texts = [str(text) for instant in heard for text in instant.checks.get("lines", ())]
    if part.motion is not None:
        texts += [*part.motion.checks, *part.not_compared]
    if part.confirmed.words:
        texts.append(part.confirmed.words)
    found = [Check(line(text)) for text in dict.fromkeys(texts)]
    if part.followed is not None:
        from planar_cli.report.motion.read_off import read_off_checks

        found += read_off_checks(part.followed)
    return found


def _possible(instant: InstantSolution, phrases: Phrases) -> Line:
    """Where friction is not unique, one distribution of it with which nothing slips: all of its comparisons."""
    trial = instant.trial
    outcome = possible(trial.system, trial.outcomes[0])
    if outcome is None:
        return ()
    beside = replace(trial, outcomes=(outcome,))
    tests = {name: t for m in trial.system.modes.values() for t in m.tests if (name := bounded_in(trial.system, t))}
    compared = [told for t in tests.values() if (told := against_limit(beside, t, phrases))]
    listed = (piece for i, told in enumerate(compared) for piece in (", ", *told)[i == 0 :])
    return line("friction is not unique, but it can hold, as with ", *listed) if compared else ()


def _presses(instant: InstantSolution, phrases: Phrases) -> list[Line]:
    """N > 0 of each contact."""
    system, outcome = instant.trial.system, instant.trial.outcomes[0]
    values = {**unknowns_of(system, outcome), **instant.value.values}
    found: list[Line] = []
    for mode in system.modes.values():
        rolling = any(j.rolling is not None for j in mode.facts.joinings)
        for push in mode.facts.pushes:
            symbol = system.symbols.get(push.name)
            if symbol is None or symbol not in values or not (mode.tests or rolling):
                continue
            column = outcome.assembly.columns.get(push.name)
            if column is None or not outcome.solved.unique(column):
                continue
            if push.kind == "normal" and values[symbol] > 0:
                number = values[symbol]
                shown = phrases.of_dimension(number, parse_unit(push.unit).dimension)
                formula = formula_of_press(instant, push, symbol, number, phrases)
                told = line(Relation(Math(symbol), "=", shown))
                if formula:
                    told = line(Math(symbol), " = ", *formula, " = ", shown)
                found.append(line(*told, " > 0"))
    return found[:MOST_PRESSES]


def _friction(instant: InstantSolution, phrases: Phrases, decides: bool) -> list[Line]:
    """Friction against its limit where a contact sticks, and where on its face the normal force acts: what the solution
    does not decide, and what no equation puts at its limit.
    """
    told = {symbol for symbol, _ in decision_lines(instant, phrases, decides)} | at_limit(instant)
    found: list[Line] = []
    for _, test in limits_of(instant.trial):
        name = bounded_in(instant.trial.system, test)
        if name is not None and instant.trial.system.symbols[name] not in told:
            found.append(against_limit(instant.trial, test, phrases))
    return [compared for compared in found if compared]


def against_limit(trial: Trial, test: Test, phrases: Phrases) -> Line:
    """|F| = 29 N ≤ μ_s N = 76 N, or |M| > N b/2 with their values; nothing where they are not unique."""
    found = needed(trial, test)
    if found is None:
        return ()
    relation = "≤" if found.size <= found.limit * (1 + TINY) else ">"
    shown, most = found.shown(phrases)
    return line("|", Math(found.symbol), "| = ", shown, f" {relation} ", phrases.math(found.formula), " = ", most)
