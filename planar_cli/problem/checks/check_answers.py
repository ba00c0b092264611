"""Checks of `answers`: each names a find, and says the kind of thing that is asked."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.errors import Diagnostic
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.check_formulas import formula_names
from planar_cli.problem.checks.check_vectors import is_vector
from planar_cli.problem.checks.formulas import Formula
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.dimensions import CURVE, MODE, TRUTH, Kind, check_found, check_side
from planar_cli.problem.language.expression import Quantity, Side, Word
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.problem.nodes.reading import did_you_mean
from planar_cli.problem.scene.scene import Answer, Find, Problem
from planar_cli.units import PURE


def check_answers(problem: Problem) -> Iterator[Diagnostic]:
    """All that is wrong with the answers of a whole file."""
    finds: dict[str, tuple[Find, Scope]] = {}
    for scope in (Scope(problem, ()), *(Scope(c.problem, problem.cases[:i]) for i, c in enumerate(problem.cases))):
        for find in scope.problem.find:
            if find.name in finds:
                line = finds[find.name][0].mark.line
                message = f"the find '{find.name}' is asked for a second time; the first is in line {line}"
                yield Diagnostic(
                    find.mark, "PL404", message, "finds of all cases stand side by side; give it another name"
                )
            finds[find.name] = (find, scope)
    for answer in problem.answers:
        if answer.name in finds and not finds[answer.name][0].found.text:
            continue  # what it asks cannot be read
        if answer.name in finds:
            yield from _answer(answer, *finds[answer.name])
        else:
            hint = did_you_mean(answer.name, finds, "finds are ") or "the file asks nothing"
            yield Diagnostic(answer.mark, "PL460", f"there is no find '{answer.name}' that this could answer", hint)


def _answer(answer: Answer, find: Find, scope: Scope) -> Iterator[Diagnostic]:
    kinds = Kinds(scope)
    kind = check_found(find.found, kinds.of, [])
    what = find.found.what
    vector = isinstance(what, Side) and is_vector(what, scope, [])
    modes = isinstance(what, Quantity) and what.word in OF_SWINGS
    if isinstance(answer.value, tuple) and len(answer.value) > 2 and not modes:
        text = f"a vector has two parts, here are {len(answer.value)}"
        yield Diagnostic(answer.mark, "PL341", text, "write `[3 m, 4 m]`")
        return
    message, hint = _misfit(answer, kind, vector, modes)
    if message:
        yield Diagnostic(answer.mark, "PL461", f"the find {answer.name} asks {message}", hint)
        return
    values = answer.value if isinstance(answer.value, tuple) else (answer.value,)
    report: list[Diagnostic] = []
    for value in values:
        if isinstance(value, Side):
            yield from formula_names(Formula(value, f"the answer {answer.name}", answer.mark, time=True), scope)
            if not isinstance(value, Word):
                check_side(value, kind.dimension, kinds.of, report, kind.angle)
    if isinstance(answer.tolerance, Side):
        check_side(answer.tolerance, PURE, kinds.of, report)
    what_answer = f"the answer {answer.name}"
    yield from (Diagnostic(d.mark, d.code, f"{what_answer}: {d.message}", d.hint) for d in report)


def _misfit(answer: Answer, kind: Kind, vector: bool, modes: bool) -> tuple[str, str]:
    """What the find asks for and what to write, where the answer is of another kind; else two empty texts.
    `vector`: it asks for one; `modes`: for what each of several modes of oscillation has.
    """
    value = answer.value
    if value == "":
        return "", ""
    if kind == TRUTH:
        return ("", "") if isinstance(value, bool) else ("whether something is so", "answer `true` or `false`")
    if kind == MODE:
        return (
            ("", "")
            if isinstance(value, Word)
            else ("for a mode", "answer `stick`, `slip`, `apart`, `tip`, `taut` or `slack`")
        )
    if kind == CURVE:
        return ("", "") if isinstance(value, str) else ("for a curve", "answer an equation in x and y: `y = x^2/(4 m)`")
    if vector:
        return (
            ("", "") if isinstance(value, tuple) else ("for a vector", "answer `[x, y]`, or ask one part: `.x`, `.mag`")
        )
    if isinstance(value, tuple) and not modes:
        return "for a number", "a pair answers a vector; leave the part out of the find, or answer one number"
    if isinstance(value, bool):
        return "for a number", "true and false answer a relation, such as `mode(C) = stick`"
    return "", ""
