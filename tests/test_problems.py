"""Every file of problems/: it is solved, it agrees with the answers that it states, and it reads as it did.

`PLANAR_UPDATE=1 pytest tests/test_problems.py` writes the golden files anew: the equations (physics) and the printed
solution (wording) apart, so that a change of one shows up alone. Read the difference before you keep it.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import assert_golden, name_of, worked

from planar_cli.formats.json import dumps
from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.json_document import solution_data
from planar_cli.report.page.narrate import narrate
from planar_cli.solve.solved_problem import PartSolution, Solution


def equations_text(solution: Solution) -> str:
    """The numbered equations of every stage, as they are before anything is solved."""
    lines: list[str] = []
    for part in solution.parts:
        for instant in part.instants:
            words = (f"case {part.case}" if part.case else "", f"state {instant.state}" if instant.state else "")
            place = ", ".join(word for word in words if word)
            for stage in instant.stages:
                lines.append(f"{place or 'file'}: {stage.level}")
                rows = [(x.number, f"{x.symbol} := {x.expression}") for x in stage.lines]
                rows += [
                    (w.number, f"{w.law} {w.lead} [{', '.join(w.bodies)}]: {w.left} = {w.right}")
                    for block in stage.blocks
                    for w in block.equations
                ]
                lines += [f"  ({number}) {text}" for number, text in sorted(rows)]
        lines += between_text(part)
    return "\n".join(lines) + "\n"


def between_text(part: PartSolution) -> list[str]:
    """The equations between states on which the answers of a motion rest."""
    if part.motion is None:
        return []
    equations = [e for step in part.motion.route.steps if not step.is_datum for e in step.relations]
    return [f"  {e.kind} {e.since or ''}->{e.stop}: {e.words}: {e.residual} = 0" for e in equations]


@pytest.mark.parametrize("path", PROBLEMS, ids=name_of)
def test_agrees_with_its_answers(path: Path) -> None:
    solution, verdicts = worked(path)
    assert not [v.message for v in verdicts if not v.agrees]
    asked = [f.name for p in (solution.problem, *(c.problem for c in solution.problem.cases)) for f in p.find]
    assert [f.name for part in solution.parts for f in part.found] == asked


@pytest.mark.parametrize("path", PROBLEMS, ids=name_of)
def test_states_an_answer(path: Path) -> None:
    solution, _ = worked(path)
    assert solution.problem.answers


@pytest.mark.parametrize("path", PROBLEMS, ids=name_of)
def test_equations(path: Path) -> None:
    assert_golden(f"{name_of(path)}.equations.txt", equations_text(worked(path)[0]))


@pytest.mark.parametrize("path", PROBLEMS, ids=name_of)
def test_printed_solution(path: Path) -> None:
    solution, _ = worked(path)
    text = Terminal().render(narrate(solution))
    assert_golden(f"{name_of(path)}.solution.txt", text)


@pytest.mark.parametrize("path", PROBLEMS, ids=name_of)
def test_json_of_the_solution(path: Path) -> None:
    solution, verdicts = worked(path)
    data = json.loads(dumps(solution_data(solution, verdicts, 4, None)))
    assert data["outcome"] == "solved"
    for answer in data["answers"].values():
        assert answer["text"]
        assert answer["value"] is not None or answer["expression"] is not None
