"""What is largest or smallest over a constant that is sought: as a formula of it, before its derivative is taken."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.report.between import BetweenTelling
from planar_cli.report.blocks import Block, Equation, line
from planar_cli.solve.between.trace import AimTrace, MotionTrace, RouteStep


def aim_blocks(
    aim: AimTrace, leg: RouteStep, found: MotionTrace, between: BetweenTelling, number: int
) -> Iterator[Block]:
    """The balance that tells it, in the letters that are not known yet, and it as a formula. `leg`: the step whose
    condition this is; `number`: that of the balance.
    """
    steps = [step for step in found.route.steps if any(r.source == aim.law for r in step.relations)]
    unknowns = {x for step in (leg, *steps) for x in step.unknowns} | aim.quantity.free_symbols
    between.plain, between.unknowns = found.route.plain, tuple(unknowns)
    yield from between.blocks(aim.law, number)
    formula = aim.formula.xreplace(dict(found.route.plain))
    yield Equation((between.phrases.math(aim.quantity), between.phrases.math(formula)), None, line(f"({number}):"))
