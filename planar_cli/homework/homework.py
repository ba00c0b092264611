"""A whole homework made ready: every problem of a set solved, its variants drawn, its papers as plain data."""

from __future__ import annotations

import hashlib
import json
import pickle
from collections.abc import Callable, Sequence
from dataclasses import replace

from planar_cli.errors import Diagnostic, FileProblem, PlanarError, Undecided, UndecidedFiles
from planar_cli.homework.grading.carried_errors import carriable
from planar_cli.homework.grading.dependence import behind_each, together_each
from planar_cli.homework.grading.followed_mistakes import left_out, with_followed
from planar_cli.homework.grading.passing import passing
from planar_cli.homework.grading.what_mistakes_give import with_mistakes
from planar_cli.homework.sets.paper import Expected, Paper, Task
from planar_cli.homework.sets.printed_names import printed
from planar_cli.homework.sets.ready import Homework, Prepared
from planar_cli.homework.sets.set_file import HomeworkSet, SetProblem
from planar_cli.homework.variants.given_letters import gravity_told, with_given
from planar_cli.homework.variants.numbered import numbered, with_wrong_values
from planar_cli.homework.variants.pages_of_variants import Press, with_pages
from planar_cli.homework.variants.told_letters import Formulas, Told
from planar_cli.homework.variants.variant_draws import Draw
from planar_cli.homework.variants.variants import Variants, columns, variants_of
from planar_cli.homework.variants.worked_problem import (
    WorkedProblem,
    base_expected,
    base_numbers,
    read_and_solve,
)
from planar_cli.problem.nodes.nodes import Mapping as MappingNode
from planar_cli.problem.nodes.nodes import Scalar
from planar_cli.problem.nodes.placeholders import PLACEHOLDER, put_in, told
from planar_cli.problem.sections.variations import with_first_values
from planar_cli.records import record

FEW = 0.5
"""A lower rate of fit combinations is worth a warning."""


def prepared(problem: SetProblem, variants: int, seed: int, formulas: Formulas | None = None) -> Prepared:
    """One problem of a set with so many variants. `formulas`: tells answers in letters, which else stand as a file
    writes them. PlanarError: it has no solution.
    """
    solved = read_and_solve(problem.path, problem.name)
    _check_finds(problem, solved)
    drawn = variants_of(solved, variants, seed, formulas)
    _demand_fit(problem, drawn)
    base = base_expected(solved)
    rows = _with_mistakes(solved, base, drawn)
    draws = [Draw(()), *(v.draw for v in drawn.taken)]
    # Where there are fewer variants than were asked for, they are given out again from the first.
    spread = [0, *(k % len(drawn.taken) + 1 if drawn.taken else 0 for k in range(variants))]
    if (same := numbered(solved)) is not None:
        rows = with_wrong_values(solved, same, rows, [dict(d.values) for d in draws])
    rows = with_followed(solved, rows, [dict(d.values) for d in draws])
    told = Told(solved, base, formulas)
    asked = [
        _with_points(problem, _in_words(problem, with_given(solved, told.of(e, dict(d.values)), dict(d.values))))
        for d, e in zip(draws, rows, strict=True)
    ]
    whole = solved if same is None else same.problem
    behind, together = behind_each(whole), together_each(whole)
    made = [
        replace(_task(problem, solved, d, e), behind=behind, together=together)
        for d, e in zip(draws, asked, strict=True)
    ]
    values = {k: base_numbers(solved.problem, dict(draws[place].values)) for k, place in enumerate(spread)}
    written = {k: dict(draws[place].values) for k, place in enumerate(spread)}
    solved_alone = (None, *(v.alone for v in drawn.taken))
    alone = {k: own for k, place in enumerate(spread) if (own := solved_alone[place]) is not None}
    return Prepared(
        problem.name,
        tuple(made[place] for place in spread),
        pickle.dumps(carriable(solved, values, alone, written) if same is None else carriable(same.problem, values)),
        (*_warnings(problem, drawn, variants), *(f"{problem.name}: {said}" for said in left_out(solved, len(draws)))),
        drawn.tried,
        len(drawn.taken),
        tuple(sorted(drawn.rejected.items())),
        tuple(draws[place].values for place in spread),
    )


def _with_mistakes(solved: WorkedProblem, base: tuple[Expected, ...], drawn: Variants) -> list[tuple[Expected, ...]]:
    """The finds of the file, and of each variant, with what mistakes give; of variants that were solved alone by their
    own equations.
    """
    rows = with_mistakes(solved, [base], columns(solved, [Draw(())]))
    if any(v.alone is None for v in drawn.taken):
        return rows + with_mistakes(
            solved, [v.expected for v in drawn.taken], columns(solved, [v.draw for v in drawn.taken])
        )
    return rows + [row for v in drawn.taken if v.alone is not None for row in with_mistakes(v.alone, [v.expected], {})]


def _demand_fit(problem: SetProblem, drawn: Variants) -> None:
    """PlanarError where the file has values for variants and no combination is fit."""
    if drawn.tried and not drawn.taken:
        text = f"no variant of {problem.name} is fit, so that all students would get the same numbers"
        why = ", ".join(f"{count} because {reason}" for reason, count in drawn.rejected.most_common())
        hint = f"of {drawn.tried} combinations none: {why}; write other values under `variants`"
        raise FileProblem([Diagnostic(problem.mark, "PL804", text, hint)])


def _warnings(problem: SetProblem, drawn: Variants, wanted: int) -> list[str]:
    found = []
    if drawn.note:
        found.append(f"{problem.name}: variants are {drawn.note}")
    if wanted and not drawn.tried:
        found.append(f"{problem.name}: the file has no `variants`; all students get the same numbers")
    elif wanted > len(drawn.taken) and drawn.tried == drawn.combinations:
        there = f"there are only {drawn.combinations} combinations of values"
        fit = "" if drawn.tried == len(drawn.taken) else f", of which {len(drawn.taken)} are fit"
        found.append(f"{problem.name}: {there}{fit}, for {wanted} variants; they are given out again")
    elif wanted > len(drawn.taken):
        found.append(f"{problem.name}: only {len(drawn.taken)} of {wanted} variants are fit; they are given out again")
    if drawn.repeated:
        alike = f"{drawn.repeated} of {len(drawn.taken)} variants have the answers of another one"
        found.append(f"{problem.name}: {alike}, as there are no others that are fit")
    if drawn.tried and drawn.rate < FEW:
        reasons = ", ".join(f"{count} because {why}" for why, count in drawn.rejected.most_common(3))
        found.append(f"{problem.name}: only {100 * drawn.rate:.0f} % of the combinations are fit ({reasons})")
    unfit: dict[str, list[str]] = {}
    for (name, value), counted in drawn.never:
        because = f"{'' if len(counted) == 1 else 'mostly '}because {counted.most_common(1)[0][0]}"
        unfit.setdefault(because, []).append(f"{printed(name)} = {told(value)}")
    found += [f"{problem.name}: no combination with {', '.join(v)} is fit, {because}" for because, v in unfit.items()]
    return found


def _check_finds(problem: SetProblem, solved: WorkedProblem) -> None:
    names = [f.name for _, f in solved.finds]
    wrong = [n for n in (*problem.points, *problem.ask) if n not in names]
    if wrong:
        text = f"{problem.path} has no find '{wrong[0]}'"
        raise FileProblem([Diagnostic(problem.mark, "PL802", text, f"there are {', '.join(names)}")])


def _in_words(problem: SetProblem, expected: Sequence[Expected]) -> tuple[Expected, ...]:
    """What is asked, in the words of the set where it has some."""
    return tuple(replace(e, asked=problem.ask.get(e.find, e.asked)) for e in expected)


def _with_points(problem: SetProblem, expected: Sequence[Expected]) -> tuple[Expected, ...]:
    if problem.points:
        return tuple(replace(e, points=problem.points.get(e.find, 0.0)) for e in expected)
    each = 1.0 if problem.whole is None else problem.whole / max(len(expected), 1)
    return tuple(replace(e, points=each) for e in expected)


# --- what is handed out ----------------------------------------------------------------------------------------------


def _task(problem: SetProblem, solved: WorkedProblem, draw: Draw, expected: tuple[Expected, ...]) -> Task:
    values = {**_written_values(solved), **dict(draw.values)}
    text = put_in(solved.problem.text, values)
    said, varied = set(PLACEHOLDER.findall(solved.problem.text)), {name for name, _ in draw.values}
    lines = {name: f"{printed(name)} = {told(value)}" for name, value in values.items()}
    return Task(
        problem.name,
        solved.problem.title or problem.name,
        text,
        (*(line for name, line in lines.items() if name not in said), *gravity_told(solved)),
        expected,
        drawn=tuple(line for name, line in lines.items() if name in varied),
        lead="Also given" if said else "Given",
    )


def _written_values(solved: WorkedProblem) -> dict[str, str]:
    """The given names with their values as the file writes them."""
    node = with_first_values(solved.node)
    given = node.get("given") if isinstance(node, MappingNode) else None
    pairs = given.pairs if isinstance(given, MappingNode) else ()
    return {key.text: value.text for key, value in pairs if isinstance(value, Scalar)}


# --- the whole set ---------------------------------------------------------------------------------------------------


def assembled(homework: HomeworkSet, problems: Sequence[Prepared]) -> Homework:
    """The papers of all variants from the problems of a set."""
    papers = {k: Paper(k, tuple(p.tasks[k] for p in problems)) for k in range(homework.variants + 1)}
    right = [
        [[e.find, e.kind, e.values, e.unit, e.text, e.points] for t in paper.tasks for e in t.expected]
        for paper in papers.values()
    ]
    rules = repr(homework.rules)
    digest = hashlib.sha256(json.dumps([right, rules]).encode()).hexdigest()[:16]
    return Homework(
        homework.title,
        homework.text,
        papers,
        {p.name: p.carrying for p in problems},
        digest,
        tuple(w for p in problems for w in (*p.warnings, *passing(p.tasks[1:] or p.tasks, homework.rules))),
        homework.rules,
        _students(homework),
    )


def _students(homework: HomeworkSet) -> tuple[tuple[str, int], ...]:
    """The students that the set lists, with their variants."""
    pairs = ((name, homework.variant_of(name)) for name in homework.students)
    return tuple((name, variant) for name, variant in pairs if variant is not None)


def made_ready(
    homework: HomeworkSet,
    jobs: int,
    timeout: float,
    press: Press | None,
    counter: Callable[[int, str], Callable[[int], None]],
    formulas: Formulas | None = None,
) -> Homework:
    """A set made ready on several workers, which import `press` and `formulas` by their names; `counter`: of a total,
    hears how many are done. FileProblem: a problem of it is no good; UndecidedFiles: one is not decided within the
    limits; Fault: planar failed over one.
    """
    from planar_cli.homework.tasks.supervisor import Supervisor, demand_no_fault

    items = [(p, homework.variants, homework.seed, formulas) for p in homework.problems]
    ended = Supervisor(_attempt, jobs, timeout, counter(len(items), "problems solved")).run(items)
    found: list[Prepared] = []
    wrong: list[Diagnostic] = []
    undecided = False
    demand_no_fault(zip((p.path for p in homework.problems), ended, strict=True))
    for problem, end in zip(homework.problems, ended, strict=True):
        if isinstance(end.result, Prepared):
            found.append(end.result)
            continue
        failed = end.result if isinstance(end.result, Failed) else Failed((), str(end.result), True)
        text, hint = failed.text, ""
        if end.verdict == "timeout":
            variants = f" and its {homework.variants} variants" if homework.variants else ""
            text, hint = f"the problem{variants}: {text}", "`--timeout 0` sets no limit"
        undecided |= failed.undecided
        wrong += failed.diagnostics or [Diagnostic(problem.mark, "PL803", f"{problem.path}: {text}", hint)]
    if wrong:
        raise UndecidedFiles(wrong) if undecided else FileProblem(wrong)
    if press is not None:
        found = with_pages(homework, found, press, (jobs, timeout), lambda total: counter(total, "pages made"))
    return assembled(homework, found)


@record
class Failed:
    """Why a problem could not be made ready; `undecided`: within the limits nothing was found."""

    diagnostics: tuple[Diagnostic, ...]
    text: str
    undecided: bool = False


def _attempt(item: tuple[SetProblem, int, int, Formulas | None]) -> Prepared | Failed:
    try:
        return prepared(*item)
    except PlanarError as error:
        return Failed(getattr(error, "diagnostics", ()), str(error), isinstance(error, Undecided))
