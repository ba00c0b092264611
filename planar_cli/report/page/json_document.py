"""A solution as plain mappings and lists, for programs: what `--format json` prints.

The keys are a promise to other programs; `schema_version` counts up when one changes its meaning.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import PRINTABLE, longer
from planar_cli.equation.values.ledger import display
from planar_cli.homework.checking.verdict import Verdict
from planar_cli.report.checks.checks import unconfirmed
from planar_cli.report.notation.page_units import in_base_units
from planar_cli.report.notation.rounding import rounded
from planar_cli.report.page.effects import effects
from planar_cli.report.page.narrate import phrases_in
from planar_cli.report.words.counted import clockwise_letter
from planar_cli.report.words.words import answer_text, told_unit
from planar_cli.solve.instant.algebra import Line
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Explicit, Written
from planar_cli.solve.principled import principle_of, usual
from planar_cli.solve.solution import Found, InstantSolution
from planar_cli.solve.solved_problem import PartSolution, Solution

MACHINE_DIGITS = 15
STEP_DIGITS = 12
"""Numbers put in for long formulas are given to so many figures."""


def solution_data(solution: Solution, verdicts: Sequence[Verdict], figures: int, method: str | None) -> dict[str, Any]:
    """The whole solution. `verdicts`: of the answers that the file states."""
    instants = [(part.case, instant) for part in solution.parts for instant in part.instants]
    return {
        "schema_version": 1,
        "problem": solution.problem.title or solution.problem.file,
        "outcome": "solved",
        "answers": answers_data(solution, figures),
        "unconfirmed": sum(bool(unconfirmed(f, part)) for part in solution.parts for f in part.found),
        "plan": _plan(solution, method),
        "steps": [
            *(step for case, instant in instants for step in _steps(case, instant)),
            *(step for part in solution.parts for step in _passages(part)),
            *(step for part in solution.parts for step in _motion(part)),
        ],
        "checks": [
            *(str(text) for _, instant in instants for text in instant.checks.get("lines", ())),
            *(text for part in solution.parts if part.motion for text in part.motion.checks),
            *(text for part in solution.parts for text in part.not_compared),
            *(part.confirmed.words for part in solution.parts if part.confirmed.words),
        ],
        "stated": [_verdict(v) for v in verdicts],
        "effects": _effects(instant for _, instant in instants),
        "rejected": [entry for case, instant in instants for entry in _rejected(case, instant)],
        "seconds": dict(solution.seconds),
    }


def answers_data(solution: Solution, figures: int) -> dict[str, Any]:
    """All answers by their names."""
    return {f.name: _answer(f, part, figures, solution.problem.us) for part in solution.parts for f in part.found}


def _motion(part: PartSolution) -> list[dict[str, Any]]:
    """The steps of a motion over time; imported where there is one."""
    if part.motion is None:
        return []
    from planar_cli.report.page.json_motion import motion_steps

    return motion_steps(part.case, part.motion)


def failure_data(problem: str, outcome: str, message: str, diagnostics: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """A problem without a solution: `outcome` is "no solution", "undecided" or "bad file"."""
    return {
        "schema_version": 1,
        "problem": problem,
        "outcome": outcome,
        "answers": {},
        "message": message,
        "diagnostics": list(diagnostics),
    }


# --- answers ---------------------------------------------------------------------------------------------------------


def _answer(found: Found, part: PartSolution, figures: int, us: bool) -> dict[str, Any]:
    # Formulas are in base units whatever is asked.
    formula = found.values is None and bool(found.expressions)
    unit = told_unit(in_base_units(found.unit, us) if formula else found.unit, found.energy)
    digits = part.instants[-1].checks.get("digits") if part.instants else _digits(found, part)
    return {
        "value": _value(found, us),
        "unit": unit,
        "expression": _expression(found),
        "text": answer_text(found, phrases_in(part, figures)),
        "digits": digits,
        "confirmed": not (why := unconfirmed(found, part)),
        **({"unconfirmed": why} if why else {}),
    }


def _digits(found: Found, part: PartSolution) -> int | None:
    """The digits of what was read off a motion that are certain."""
    answers = part.followed.answers if part.followed is not None else ()
    answer = next((a for a in answers if a.name == found.name and a.values and a.error is not None), None)
    if answer is None or answer.error is None:
        return None
    size = max((*map(abs, answer.values), answer.scale))
    return MACHINE_DIGITS if not answer.error else min(MACHINE_DIGITS, max(0, int(math.log10(size / answer.error))))


def _value(found: Found, us: bool) -> Any:
    if found.kind == "truth":
        return found.word == "true"
    if found.kind == "word":
        return found.word
    if found.values is None:
        return None
    numbers = [display(v, found.unit, us) if v.is_finite() else None for v in found.values]
    return numbers if found.kind in ("vector", "list") else numbers[0]


def _expression(found: Found) -> Any:
    if not found.expressions or any(longer(e, PRINTABLE) for e in found.expressions):
        return None
    texts = [text_of(e) for e in found.expressions]
    return texts if found.kind in ("vector", "list") else texts[0]


def text_of(expr: Any) -> str:
    """SymPy syntax in the file's names; a curve as `left = right`."""
    if isinstance(expr, tuple):
        return " = ".join(str(side) for side in expr)
    return f"{expr.lhs} = {expr.rhs}" if isinstance(expr, sp.Eq) else str(expr)


def _verdict(verdict: Verdict) -> dict[str, Any]:
    return {
        "find": verdict.find,
        "stated": verdict.stated,
        "solved": verdict.solved,
        "agrees": verdict.agrees,
        "relative_error": verdict.error,
        "message": verdict.message,
    }


# --- plan and steps --------------------------------------------------------------------------------------------------


def _plan(solution: Solution, method: str | None) -> dict[str, Any]:
    """Numbers of equations to be solved; lines that only name something are not counted."""
    blocks = [b for part in solution.parts for i in part.instants for s in i.stages for b in s.blocks]
    named = method or solution.problem.method
    chosen = usual() if named is None else principle_of(named)
    return {
        "method": chosen.title or chosen.kind,
        "equations": sum(len(b.equations) for b in blocks),
        "largest_block": max((len(b.unknowns) for b in blocks), default=0),
        "tear": max((len(b.letters) for b in blocks), default=0),
    }


def _steps(case: str, instant: InstantSolution) -> list[dict[str, Any]]:
    """Every equation, explicit line and solved line, in the order in which they are worked out."""
    place = {"case": case, "state": instant.state}
    steps: list[dict[str, Any]] = []
    for stage in instant.stages:
        steps += [{**place, "stage": stage.level, **step} for step in _of_stage(stage, instant)]
    return steps


def _passages(part: PartSolution) -> list[dict[str, Any]]:
    """The lines about places over time and about curves."""
    passages = part.tale.passages if part.tale is not None else ()
    return [
        {
            "case": part.case,
            "kind": "passage",
            "heading": p.heading.replace("`", ""),
            "lines": [{"words": r.words, "line": text_of(r.line)} for r in p.rows],
        }
        for p in passages
    ]


def _of_stage(stage: Stage, instant: InstantSolution) -> list[dict[str, Any]]:
    lines = [_explicit(x) for x in stage.lines]
    equations = [_equation(w) for b in stage.blocks for w in b.equations]
    solved = [_solved(x, instant) for b in stage.blocks for x in b.lines]
    return sorted([*lines, *equations], key=lambda s: int(s["number"])) + solved


def _equation(written: Written) -> dict[str, Any]:
    return {
        "kind": "equation",
        "number": written.number,
        "law": written.law,
        "bodies": list(written.bodies),
        "lead": str(written.lead),
        "left": str(rounded(written.left, STEP_DIGITS)),
        "right": str(rounded(written.right, STEP_DIGITS)),
        "words": written.words,
    }


def _explicit(named: Explicit) -> dict[str, Any]:
    return {
        "kind": "line",
        "number": named.number,
        "symbol": named.symbol.name,
        "expression": str(rounded(named.expression, STEP_DIGITS)),
        "words": named.words,
    }


def _solved(solved: Line, instant: InstantSolution) -> dict[str, Any]:
    ledger = instant.instant.scene.ledger
    unit = ledger.units.get(solved.symbol)
    numeric = isinstance(solved.value, Decimal) and not ledger.symbolic
    return {
        "kind": "solved",
        "symbol": solved.symbol.name,
        "formula": str(rounded(solved.formula, STEP_DIGITS)),
        "value": solved.value if numeric else None,
        "unit": in_base_units(unit, ledger.us).text if unit is not None else "1",
        "equations": list(solved.equations),
        **({"counts": "clockwise"} if clockwise_letter(-solved.symbol, instant) is not None else {}),
    }


# --- scene -----------------------------------------------------------------------------------------------------------


def _effects(instants: Any) -> dict[str, list[str]]:
    """What acts at any of the instants, and what acts at none."""
    present: dict[str, None] = {}
    absent: dict[str, None] = {}
    for instant in instants:
        here, not_here = effects(instant)
        present.update(dict.fromkeys(here))
        absent.update(dict.fromkeys(not_here))
    return {"present": list(present), "absent": [a for a in absent if a not in present]}


def _rejected(case: str, instant: InstantSolution) -> list[dict[str, Any]]:
    """Assumptions that failed, each with the reason."""
    place = {"case": case, "state": instant.state}
    return [{**place, "assumed": _assumed(trial), "because": trial.objection} for trial in instant.rejected]


def _assumed(trial: Trial) -> list[str]:
    return [m.words for m in trial.system.modes.values() if m.words]
