"""A start that is told but for a sign: velocities of two sizes fulfil all that the file says of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from planar_cli.base_units import in_base
from planar_cli.errors import NOWHERE, Diagnostic, NoSolution
from planar_cli.motion.terms.dense import null_space
from planar_cli.motion.terms.layout import Layout, Slot
from planar_cli.motion.terms.zeros import AGREES, Equation, Zeros
from planar_cli.problem.scene.scene import Problem
from planar_cli.units import RATE, VELOCITY, default_unit

DISTINCT = AGREES**0.5
"""A start that is found twice, as where a square is zero, is known to this part of the usual sizes only."""


def demand_one_start(
    zeros: Zeros,
    layout: Layout,
    equations: Sequence[Equation],
    numbers: range,
    guesses: Sequence[Sequence[float]],
    holds: Callable[[], bool],
    problem: Problem,
) -> None:
    """NoSolution: from other guesses another start is found that fulfils everything, where nothing is left open.

    `zeros` has the start that was found, and keeps it; `holds`: do the inequalities hold at what it has?
    """
    if null_space(zeros.matrix(equations, numbers), len(numbers)):
        return
    first = list(zeros.state)
    for guess in guesses:
        zeros.state = list(guess)
        if zeros.solved(equations, numbers) and holds():
            other = [n for n in numbers if abs(zeros.state[n] - first[n]) > DISTINCT * zeros.sizes[n]]
            if other:
                n = other[0]
                marks = [e.mark for e in equations] + [law.statement.mark for law in problem.motion]
                text, hint = _both(layout.slots[n - numbers.start], first[n], zeros.state[n], problem.us)
                mark = next((m for m in marks if m != NOWHERE), NOWHERE)
                raise NoSolution([Diagnostic(mark, "PL618", text, hint)])
    zeros.state = first


def _both(slot: Slot, one: float, other: float, us: bool) -> tuple[str, str]:
    """Which velocity has which two values, and what to write."""
    turns = slot.kind == "theta"
    name = f"omega({slot.body})" if turns else f"v({slot.body}).{slot.kind}"
    unit = default_unit(RATE if turns else VELOCITY, turns, us)
    told = " and for ".join(f"{v / in_base(unit, us):.4g} {unit.text}" for v in (one, other))
    return f"what is said of the start holds for {name} = {told}", f"say which is meant, such as `{name} > 0`"
