"""Checks of a finished instant: its own equations at sixty digits, the independent multibody road, the tests of its
modes.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.system.conditions import Condition
from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import ZERO, Unvalued, Valuation
from planar_cli.errors import NOWHERE, Diagnostic, Mark, NoSolution, Undecided
from planar_cli.records import record
from planar_cli.solve.diagnosis.left_open import LEAVE_OUT
from planar_cli.solve.instant.instant import Trial
from planar_cli.solve.instant.study import Outcome
from planar_cli.solve.instant.worked import Worked, unknowns_of
from planar_cli.solve.multibody.agreement import Agreement
from planar_cli.solve.multibody.motion import second_road

AGREE = Decimal("1e-20")
TINY_SHARE = Decimal("1e-12")
MOST_TOLD = 3
"""So many of the values that differ are told."""
TWO_WAYS = (
    "the file may be read in two ways: does a point belong to two bodies that no joint holds together there? If not, "
    "please report it with the file"
)


class Disagreement(Undecided):
    """Two roads to the same answer differ: the solution is not to be trusted, and is not shown as solved."""

    def __init__(self, message: str, diagnostics: tuple[Diagnostic, ...] = ()) -> None:
        self.diagnostics = diagnostics
        super().__init__(message)


@record
class Checks:
    """`equations`: how many were put in; `residual`: the largest remainder relative to its terms; `agreement`: of the
    second road; None where the scene has no body, so that there is nothing to compare.
    """

    equations: int
    residual: Decimal
    agreement: Agreement | None

    def report(self) -> dict[str, object]:
        """For the document and the JSON: the phrases, and the digits to which the two roads agree."""
        if self.agreement is None:
            return {"lines": [], "digits": None}
        noun = "equation" if self.equations == 1 else "equations"
        lines = [
            f"residuals 0 in {self.equations} {noun}",
            f"multibody solution agrees to {self.agreement.digits} digits",
        ]
        return {"lines": lines, "digits": self.agreement.digits}


def verify(trial: Trial, solved: dict[sp.Symbol, Decimal]) -> Checks:
    """All equations of the instant at the solution, and the scene assembled anew. Disagreement: they do not fit."""
    system, outcome = trial.system, trial.outcomes[0]
    numbers = outcome.value.extended({**unknowns_of(system, outcome), **solved})
    count, residual, left = residuals(system, numbers, outcome)
    agreement = second_road(system, Worked.of_solution(system, outcome, solved))
    if residual > AGREE:
        denied = next((c for c in system.velocity_conditions() if c.kind == "given" and _off(c, numbers)), None)
        if denied is not None and denied.mark != NOWHERE:
            text = f"`{denied.text}` contradicts what the rest says of the velocities"
            hint = "leave one of them out, or declare its value under `unknowns`"
            raise NoSolution([Diagnostic(denied.mark, "PL607", text, hint)])
        raise _left_over(system, left, residual)
    if agreement.changed is not None:
        joint, words = agreement.changed
        raise NoSolution([Diagnostic(joint.mark, "PL539", f"{joint.name}: {words}", LEAVE_OUT)])
    if not agreement.holds:
        raise _differs(system, agreement)
    return Checks(count, residual, agreement if system.scene.bodies else None)


def differs(mark: Mark, text: str) -> Disagreement:
    """The refusal of what two roads tell differently."""
    return Disagreement(f"{mark.file}:{mark.line}: {text}", (Diagnostic(mark, "PL722", text, TWO_WAYS),))


def _differs(system: System, agreement: Agreement) -> Disagreement:
    """The same of an instant, with the first of the values that differ."""
    problem = system.scene.problem
    mark = problem.find[0].mark if problem.find else Mark(problem.file, 1, 1)
    more = len(agreement.disagreements) - MOST_TOLD
    told = "; ".join(agreement.disagreements[:MOST_TOLD]) + (f"; and {more} more" if more > 0 else "")
    return differs(mark, f"the scene as a multibody system has another solution: {told}")


def _off(condition: Condition, numbers: Valuation) -> bool:
    """Is a relation of the file not fulfilled?"""
    found = [(numbers.known(e), e) for e in condition.rows()]
    return any(v is not None and abs(v) > AGREE * numbers.size(e) for v, e in found)


def _left_over(system: System, left: Condition | str, share: Decimal) -> Disagreement:
    """The refusal of numbers that do not fulfil a relation of the file or of a joint, or the equations of a body."""
    problem = system.scene.problem
    if isinstance(left, str):
        what = f"the equations of motion of {left}"
        mark = next((b.mark for b in problem.bodies if b.name == left), NOWHERE)
    else:
        stated = left.mark != NOWHERE
        what, mark = f"`{left.text}`" if stated else f"the relation of a joint, {left.text}", left.mark
    mark = mark if mark != NOWHERE or not problem.find else problem.find[0].mark
    text = f"the numbers that were found do not fulfil {what}: {float(share):.2g} of the size of its terms is left over"
    diagnostic = Diagnostic(mark, "PL721", text, "please report it with the file")
    return Disagreement(f"{mark.file}:{mark.line}: {text}", (diagnostic,))


def residuals(system: System, numbers: Valuation, outcome: Outcome) -> tuple[int, Decimal, Condition | str]:
    """How many equations the instant has, and the largest remainder relative to the size of its terms, with the
    condition or the body whose it is.
    """
    conditions = (*system.acceleration_conditions(), *system.velocity_conditions())
    exprs: list[tuple[sp.Expr, Condition | str]] = [(e, c) for c in conditions for e in c.rows()]
    if any(b.mass != 0 for b in system.scene.bodies.values()) or system.wrenches:
        for body in system.scene.bodies:
            exprs += [(e, body) for e in body_residuals(system, body)[: 3 if system.scene.rigid(body) else 2]]
    found: list[tuple[Decimal, Decimal, Condition | str]] = []
    for expr, whose in exprs:
        try:
            found.append((abs(numbers(expr)), numbers.size(expr), whose))
        except Unvalued:
            continue
    # An equation all of whose terms have cancelled is measured against the others.
    floor = max((size for _, size, _ in found), default=ZERO) * TINY_SHARE
    shares = [(value / max(size, floor), whose) for value, size, whose in found if value]
    return len(found), *max(shares, key=lambda pair: pair[0], default=(ZERO, ""))
