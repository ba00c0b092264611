"""What was assumed of contacts, ropes and friction, why the first assumption fails, and what is assumed instead."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from planar_cli.problem.language.expression import Number, Quantity, Relation
from planar_cli.problem.scene.facts import Mode
from planar_cli.report.document.blocks import Block, Line, Math, Note, line
from planar_cli.report.friction.decisions import needed, of_rejected
from planar_cli.report.friction.limits_alike import assumed_alike
from planar_cli.report.friction.presses import bounded_in
from planar_cli.report.friction.shared_friction import at_best
from planar_cli.report.words.mode_words import words_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.solution import InstantSolution


def assumption_notes(instant: InstantSolution, phrases: Phrases) -> list[Block]:
    """What the first assumption was, why it fails, and what is assumed instead. What the velocities tell is no
    assumption.
    """
    trial = instant.trial
    natural = next((t for t in instant.rejected if not any(t.choice)), None)
    words = _words(trial)
    if natural is not None and any(trial.choice) and _words(natural) != words:
        assumed = _words(natural)
        if natural.objection == "velocities":
            told, rest = [w for w in words if w not in assumed], [w for w in words if w in assumed]
            notes = [Note("Motion", line(f"{'; '.join(told)}, as the velocities tell"))] if told else []
            return [*notes, *([Note("Assume", line("; ".join(rest)))] if rest else [])]
        if list(assumed) == words:
            # Only the side on which a contact presses is another one.
            return [Note("Assume", line("; ".join(_placed(trial))))]
        return [
            Note("Assume", line("; ".join(assumed_alike(assumed)))),
            Note("Fails", _objection(_on_its_side(natural, instant), instant, phrases)),
            *_then(natural, instant, phrases),
            Note("Instead", line("; ".join(_placed(trial)))),
        ]
    return [Note("Assume", line("; ".join(_placed(trial))))] if words else []


def _then(natural: Trial, instant: InstantSolution, phrases: Phrases) -> Iterator[Block]:
    """Where two contacts slip though both were assumed to stick: why the second does not stick when the first slips."""
    final = instant.trial.system.modes
    changed = [n for n, mode in final.items() if natural.system.modes[n].name == "stick" and mode.name == "slip"]
    if len(changed) != 2 or phrases.symbolic or not natural.tests or natural.tests[0][1] is None:
        return
    for trial in instant.rejected:
        apart = [n for n, mode in trial.system.modes.items() if (mode.name, mode.direction) != _way(final[n])]
        test = trial.tests[0][0] if trial.tests else None
        if len(apart) != 1 or trial.system.modes[apart[0]].name != "stick" or test is None or test.joint != apart[0]:
            continue
        if not trial.outcomes or (found := needed(trial, test)) is None:
            continue
        yield Note("Assume", line("; ".join(assumed_alike(_words(trial)))))
        told = of_rejected(found, trial, instant, phrases)
        first = needed(natural, natural.tests[0][0])
        before = None if first is None else of_rejected(first, natural, instant, phrases).presses
        if told.presses is not None and before is not None:
            told = replace(told, presses=told.presses.without(before))
        yield Note("Fails", told.wants(" > ", phrases))
        return


def _way(mode: Mode) -> tuple[str, int]:
    return mode.name, mode.direction


def _words(trial: Trial) -> list[str]:
    return list(dict.fromkeys(words_of(m, trial.system) for m in _assumed(trial)))


def _assumed(trial: Trial) -> list[Mode]:
    """The modes that are assumed. That a rope is taut is none where the file says that its tension is zero: it is about
    to slacken.
    """
    system = trial.system
    slack = {q.things[0] for q in _zero(system.statements.relations) if q.word == "tension" and len(q.things) == 1}
    return [m for n, m in system.modes.items() if m.words and system.aliases.get(n, n) not in slack]


def _zero(relations: Iterable[tuple[Relation, bool]]) -> Iterator[Quantity]:
    """What the file says is zero."""
    for relation, _ in relations:
        left, right = relation.left, relation.right
        if relation.operator == "=" and isinstance(left, Quantity) and isinstance(right, Number) and right.value == 0:
            yield left


def _placed(trial: Trial) -> list[str]:
    """The words with the side on which a particle presses, where its place leaves that open: ball at P stays in
    contact, inside loop. Where it only just touches there is no such side.
    """
    words = [(m, words_of(m, trial.system)) for m in _assumed(trial)]
    told = dict.fromkeys(f"{w}, {m.where}" if m.where and _presses(trial, m) else w for m, w in words)
    return assumed_alike(told)


def _presses(trial: Trial, mode: Mode) -> bool:
    """Is the first force of a contact, its normal force, another than zero?"""
    value = trial.outcomes[0].push(mode.facts.pushes[0].name) if trial.outcomes else None
    return value is None or value != 0


def _on_its_side(natural: Trial, instant: InstantSolution) -> Trial:
    """The same assumption with the side of a guide that is pressed: that it was the other one is nothing against it."""
    alike = (t for t in instant.rejected if t.tests and _words(t) == _words(natural))
    return next((t for t in alike if bounded_in(t.system, t.tests[0][0]) is not None), natural)


def _objection(trial: Any, instant: InstantSolution, phrases: Phrases) -> Line:
    reasons = {"contradiction": "the equations have no solution then"}
    if not trial.tests:
        return line(reasons.get(trial.objection, trial.objection))
    test, value = trial.tests[0]
    if value is None:
        if compared := at_best(trial, instant, phrases):
            return compared
        words = list(dict.fromkeys(t.words for t, v in trial.tests if v is None and len(t.pushes) > 1)) or [test.words]
        return line("no reactions satisfy all of these: " + "; ".join(words))
    found = None if phrases.symbolic else needed(trial, test)
    if found is not None:
        return of_rejected(found, trial, instant, phrases).wants(" > ", phrases)
    return line(f"this would not hold: {test.words}", _by_how_much(trial, test, phrases))


def broken_by(trial: Any, phrases: Phrases) -> Line:
    """With which value the first test of a trial fails: N = -2.9 N < 0; nothing where that has no number."""
    test, value = trial.tests[0]
    told = () if value is None else _by_how_much(trial, test, phrases)
    compared = told[1:-1]
    return line(*compared, " < 0") if compared and len(test.pushes) == 1 and test.constant == 0 else line(*compared)


def _by_how_much(trial: Any, test: Any, phrases: Phrases) -> Line:
    """What the failed test compares: friction, or the couple of a normal force, with its limit; or the push that should
    press.
    """
    if phrases.symbolic or not test.pushes:
        return ()
    if len(test.pushes) == 2 and (found := needed(trial, test)) is not None:
        return line(" (", *found.told(" > ", phrases), ")")
    name = test.pushes[0][0]
    value = trial.outcomes[0].push(name)
    if value is None or name not in trial.system.symbols:
        return ()
    symbol = trial.system.symbols[name]
    return line(" (", Math(symbol), " = ", phrases.shown(symbol, value), ")")
