"""What `planar simulate` prints: a table, what happened on the way, and the answers with their estimated errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any

from planar_cli.errors import Diagnostic, FileProblem, Mark, NoSolution
from planar_cli.motion.trajectory.trajectory import Transition
from planar_cli.problem.nodes.reading import did_you_mean
from planar_cli.problem.nodes.show import spreadsheet_cell
from planar_cli.problem.scene.scene import Answer, Find, Problem
from planar_cli.records import record
from planar_cli.simulate.answers import Answered
from planar_cli.simulate.columns import USUAL, in_width, wrapped
from planar_cli.simulate.dated_by_spans import with_spans_dated
from planar_cli.simulate.effects import Entry, known_effects, ledger, without
from planar_cli.simulate.request import Request, columns, number_of, stops
from planar_cli.simulate.run import Run, Settings, Simulation, begin, simulate, units_of
from planar_cli.simulate.singular import SingularPosition, singular_positions
from planar_cli.simulate.stopped import CONTRADICTIONS, NotFollowed, refusal
from planar_cli.simulate.table import Table, table_of
from planar_cli.units import pretty_unit

FOLLOWED, CONTRADICTED, NOT_FOLLOWED = "followed", "contradicted", "not followed"
"""How a motion ended: as it should; where the scene has none or several ways to go on; where it could not be followed,
or a state or an answer was not reached."""
WORST = (FOLLOWED, CONTRADICTED, NOT_FOLLOWED)
"""The better one first."""
ROUNDING = 1e-13
Progress = Callable[[float, float], None] | None


@record
class Motion:
    """One motion that was followed, of the file or of a case of it."""

    case: str
    run: Run
    other: Run | None
    """The same without some effects."""
    asked: tuple[Find, ...]
    """The quantities that were asked for as columns; (): as the table chooses them."""
    singular: tuple[SingularPosition, ...] = ()
    """Through which it comes."""

    @property
    def notes(self) -> list[str]:
        """What else must be said."""
        return [*self.run.trajectory.notes, *(place.words for place in self.singular)]


def _alone(motion: Motion) -> Sequence[str]:
    """A table without a plot below it."""
    return ()


@record
class Watch:
    """Who is told what while motions are followed."""

    progress: Progress = None
    """Told how far a motion has been followed, and to where it goes [s]."""
    plot: Callable[[Motion], Sequence[str]] = _alone
    """Gives the lines below the table of a motion."""
    motions: list[Motion] = field(default_factory=list)
    """The motions, as they are followed."""
    width: int = USUAL
    """Columns of a table in letters."""


def told(problem: Problem, request: Request, watch: Watch) -> tuple[str, Any]:
    """How it ended, and a text, or data for `json` and `npz`."""
    parts = list(_parts(problem, request))
    if request.effects:
        return FOLLOWED, _joined([_effects(p) for _, p in parts], request)
    status, told_parts = FOLLOWED, []
    earlier: dict[str, float] = {}
    refused: list[FileProblem | NoSolution | NotFollowed] = []
    for case, part in parts:
        try:
            found, more, piece = _part(case, part, problem.answers, request, watch, earlier)
        except (FileProblem, NoSolution, NotFollowed) as error:
            # One case that can not be followed does not keep the others from being told.
            refused.append(error)
            if len(refused) == len(parts):
                raise refused[0] from None
            status = NOT_FOLLOWED
            told_parts.append(_refusal(case, error, request))
            continue
        earlier |= {f"{case}.{a.name}": a.values[0] for a in found.answers if len(a.values) == 1}
        status = max(status, more, key=WORST.index)
        told_parts.append(piece)
    if request.output in ("json", "npz"):
        whole = {"problem": problem.title or problem.file, "motions": told_parts}
        return status, whole
    if request.output == "csv":
        return status, "\n".join(told_parts)
    return status, "\n".join([*wrapped([problem.title or problem.file], watch.width), "", *told_parts])


def _refusal(case: str, error: FileProblem | NoSolution | NotFollowed, request: Request) -> Any:
    """What keeps a part from being followed."""
    why = [f"{d.mark.file}:{d.mark.line}: {d.code} {d.message}" for d in error.diagnostics] or [str(error)]
    if request.output in ("json", "npz"):
        return {"case": case, "refused": why}
    if request.output == "csv":
        return ""
    return "\n".join([*([f"CASE  {case.replace('_', ' ')}", ""] if case else []), *why, ""])


def _joined(pieces: list[Any], request: Request) -> Any:
    return {"effects": pieces} if request.output == "json" else "\n".join(_lines_of(pieces))


def _parts(problem: Problem, request: Request) -> Iterator[tuple[str, Problem]]:
    """The file as it stands, and its cases; only one of them where it is named."""
    names = [c.name for c in problem.cases]
    if request.case is not None and request.case not in names:
        hint = did_you_mean(request.case, names, "there are ")
        raise FileProblem([Diagnostic(Mark(problem.file, 1, 1), "PL711", f"there is no case {request.case}", hint)])
    whole = bool(problem.find or problem.states or not problem.cases)
    if request.case is None and whole:
        yield "", problem
    for case in problem.cases:
        if request.case in (None, case.name):
            yield case.name, case.problem


def _part(
    case: str,
    problem: Problem,
    stated: Sequence[Answer],
    request: Request,
    watch: Watch,
    earlier: Mapping[str, float],
) -> tuple[Simulation, str, Any]:
    """The file or a case of it: its motion, how it ended, and a text or data. `earlier`: finds of cases before it."""
    numbers = {**earlier, **{name: number_of(value, problem.us) for name, value in request.values}}
    problem = with_spans_dated(problem, numbers)
    asked = columns(problem, request)
    settings = Settings(
        request.until,
        request.tolerance,
        request.integrator,
        request.step,
        numbers,
        stops=stops(problem, request),
        progress=watch.progress,
    )
    found = simulate(problem, settings, units_of(stated))
    as_data = request.output in ("json", "npz")
    if not as_data and (refused := refusal(problem, found.run.trajectory)) is not None:
        raise refused
    table = table_of(found.run, asked, request.times, request.rows)
    other = _without(problem, request, settings, stated)
    singular = singular_positions(found.run)
    motion = Motion(case, found.run, other.run if other is not None else None, asked, singular)
    watch.motions.append(motion)
    if as_data:
        return found, _status(found), _data(motion, found, table, other)
    if request.output == "csv":
        return found, _status(found), "\n".join([*_csv(table), ""])
    lines = [f"CASE  {case.replace('_', ' ')}", ""] if case else []
    lines += [*wrapped(_head(found.run), watch.width), "", *_aligned(table, watch.width), *watch.plot(motion)]
    told = [*_happened(motion), *_answers(found, other), *_checks(found)]
    return found, _status(found), "\n".join([*lines, *wrapped(told, watch.width), ""])


def _without(problem: Problem, request: Request, settings: Settings, stated: Sequence[Answer]) -> Simulation | None:
    """The same scene without some effects."""
    if not request.without:
        return None
    known = known_effects(problem)
    for word in request.without:
        if word not in known:
            hint = did_you_mean(word, known, "there are ")
            text = f"this scene has no effect '{word}' that could be left out"
            raise FileProblem([Diagnostic(Mark(problem.file, 1, 1), "PL711", text, hint)])
    return simulate(without(problem, request.without), settings, units_of(stated))


def _status(found: Simulation) -> str:
    outcome = found.run.trajectory.outcome
    if outcome.refused:
        return CONTRADICTED if outcome.code in CONTRADICTIONS else NOT_FOLLOWED
    return NOT_FOLLOWED if any(a.why for a in found.answers) else FOLLOWED


# --- text -------------------------------------------------------------------------------------------------------------


def _head(run: Run) -> Iterator[str]:
    trajectory = run.trajectory
    work = trajectory.work
    yield (
        f"followed from t = {trajectory.t0:.6g} s to t = {trajectory.t1:.6g} s in {_many(work.steps, 'step')}, "
        f"{_many(work.evaluations, 'evaluation')} of {_many(_operations(run), 'operation')}"
    )
    yield trajectory.outcome.words


def _operations(run: Run) -> int:
    regimes = {id(s.regime): s.regime for s in run.trajectory.segments}
    return max((getattr(r, "operations", 0) for r in regimes.values()), default=0)


def _many(count: int, word: str) -> str:
    return f"{count} {word}" if count == 1 else f"{count} {word}s"


def _aligned(table: Table, width: int) -> list[str]:
    heads = [f"{n} [{pretty_unit(u)}]" if u != "1" else n for n, u in zip(table.names, table.units, strict=True)]
    rows = [[_cell(v, size) for v, size in zip(row, table.sizes, strict=True)] for row in table.rows]
    return in_width(heads, rows, 1, width)


def _cell(value: float, size: float) -> str:
    """Six figures; rounding beside the other numbers of a column is zero."""
    return "0" if abs(value) <= ROUNDING * size else f"{value:.6g}"


def _csv(table: Table) -> Iterator[str]:
    yield ",".join(_quoted(f"{n} [{u}]" if u != "1" else n) for n, u in zip(table.names, table.units, strict=True))
    for row in table.rows:
        yield ",".join(repr(v) for v in row)


def _quoted(text: str) -> str:
    """A cell of words."""
    safe = spreadsheet_cell(text).replace('"', '""')
    return f'"{safe}"' if any(c in safe for c in ',;"') else safe


def _happened(motion: Motion) -> Iterator[str]:
    trajectory, notes = motion.run.trajectory, motion.notes
    entries = [(e.t, f"state {e.name}") for e in trajectory.events]
    entries += [(x.t, transition_words(x)) for x in trajectory.transitions]
    if not entries and not trajectory.missed and not notes:
        return
    yield ""
    yield "What happens"
    for t, words in sorted(entries, key=lambda e: e[0]):
        yield f"  t = {t:.9g} s   {words}"
    for name in trajectory.missed:
        yield f"  the state {name} is not reached"
    for note in notes:
        yield f"  {note}"


def transition_words(x: Transition) -> str:
    """A transition in one line."""
    lost = f", {x.lost:.4g} J lost" if x.lost > 0 else ""
    law = f" ({x.law})" if x.law else ""
    return f"{x.begins or x.words}{lost}{law}"


def _answers(found: Simulation, other: Simulation | None) -> Iterator[str]:
    if not found.answers:
        return
    yield ""
    yield "Answer"
    width = max(len(a.name) for a in found.answers)
    beside = {a.name: a for a in other.answers} if other is not None else {}
    for answer in found.answers:
        line = f"  {answer.name.rjust(width)} = {answer_words(answer)}"
        if answer.name in beside:
            line += f"   without: {answer_words(beside[answer.name])}"
        yield line


def answer_words(answer: Answered) -> str:
    """A value with the digits that are certain, and its estimated error."""
    if answer.why:
        return f"no answer: {answer.why}"
    if answer.word:
        return answer.word
    unit = pretty_unit(answer.unit.text)
    error = None if answer.error is None else answer.error / answer.one
    size = max([*map(abs, answer.shown), answer.scale / answer.one])
    numbers = [_certain(v, error, size) for v in answer.shown]
    text = numbers[0] if len(numbers) == 1 else f"[{', '.join(numbers)}]"
    estimated = f"   (error about {error:.1e})" if error else ""
    return f"{text} {unit}".rstrip() + estimated


def _certain(value: float, error: float | None, size: float) -> str:
    """A number to its certain digits, twelve at most."""
    if not size or not math.isfinite(value):
        return f"{value:g}"
    digits = 12 if not error else min(12, max(1, math.floor(math.log10(size / error)) + 1))
    shift = math.floor(math.log10(abs(value) / size)) if value else 0
    return f"{value:.{max(1, digits + shift)}g}" if value and digits + shift > 0 else "0"


def _checks(found: Simulation) -> Iterator[str]:
    balances = [s.balance for s in found.run.trajectory.segments if s.balance is not None]
    if not balances:
        return
    yield ""
    yield f"Check  energy adds up to {max(b.off for b in balances):.1e} of its size over every part of the motion"


# --- data -------------------------------------------------------------------------------------------------------------


def _data(motion: Motion, found: Simulation, table: Table, other: Simulation | None) -> dict[str, Any]:
    run = found.run
    trajectory = run.trajectory
    return {
        "case": motion.case,
        "outcome": trajectory.outcome.kind,
        "code": trajectory.outcome.code or None,
        "words": trajectory.outcome.words,
        "answers": {a.name: _answer_data(a) for a in found.answers},
        "without": None if other is None else {a.name: _answer_data(a) for a in other.answers},
        "columns": [{"name": n, "unit": u} for n, u in zip(table.names, table.units, strict=True)],
        "rows": [list(row) for row in table.rows],
        "states": {e.name: e.t for e in trajectory.events},
        "missed": list(trajectory.missed),
        "transitions": [
            {"t": x.t, "kind": x.kind, "words": transition_words(x), "joints": list(x.joints)}
            for x in trajectory.transitions
        ],
        "notes": motion.notes,
        "work": {
            "steps": trajectory.work.steps,
            "rejected": trajectory.work.rejected,
            "evaluations": trajectory.work.evaluations,
            "operations": _operations(run),
        },
        "energy": max((s.balance.off for s in trajectory.segments if s.balance is not None), default=None),
    }


def _answer_data(answer: Answered) -> dict[str, Any]:
    value: Any = list(answer.shown) if len(answer.shown) > 1 else next(iter(answer.shown), None)
    if answer.word:
        value = {"true": True, "false": False}.get(answer.word, answer.word)
    error = None if answer.error is None else answer.error / answer.one
    return {"value": value, "unit": answer.unit.text, "error": error, "why": answer.why or None}


# --- effects ----------------------------------------------------------------------------------------------------------


def _effects(problem: Problem) -> dict[str, Any]:
    entries, absent = ledger(problem)
    return {"present": [_entry(e) for e in entries], "absent": list(absent), **_cost(problem)}


def _entry(entry: Entry) -> dict[str, Any]:
    return {"effect": entry.words, "line": entry.line, "name": entry.name}


def _cost(problem: Problem) -> dict[str, Any]:
    """What one evaluation of the equations of motion costs as the motion begins."""
    run = begin(problem)
    model = run.model
    operations, guards = 0, []
    for segment in run.trajectory.segments[:1]:
        operations = getattr(segment.regime, "operations", 0)
        guards = [g.words for g in segment.regime.guards]
    return {
        "states": 2 * model.layout.count,
        "operations": operations,
        "guards": guards,
        "modes": {name: [m.name for m in modes] for name, modes in model.choices.items()},
    }


def _lines_of(pieces: Sequence[dict[str, Any]]) -> Iterator[str]:
    for piece in pieces:
        yield "In this scene"
        for entry in piece["present"]:
            yield f"  {entry['effect']:<28} {entry['name']:<16} line {entry['line']}"
        yield f"Not in this scene: {', '.join(piece['absent'])}"
        guards = piece["guards"]
        yield f"{piece['states']} numbers of state, {piece['operations']} operations an evaluation"
        yield f"Watched: {'; '.join(guards)}" if guards else "Nothing has to be watched"
        yield ""
