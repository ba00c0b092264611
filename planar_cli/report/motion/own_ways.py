"""Steps of a route that have a way of their own to be told, and those whose data are told with another one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_cli.report.document.blocks import Block
from planar_cli.report.laws.comes_back import back_blocks
from planar_cli.report.momentum.keeps_velocity import kept_blocks
from planar_cli.report.motion.links_in_line import in_line_blocks
from planar_cli.report.motion.met import data_of_meetings, met_blocks
from planar_cli.report.oscillation.periods_given import held_by_periods
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Result, RouteStep


def told_by_itself(
    leg: RouteStep, found: MotionTrace, phrases: Phrases, number: int, chain: Callable[[Result, bool], tuple[Any, ...]]
) -> list[Block]:
    """The blocks of such a step; empty of another one. `number`: of its first equation; `chain`: the sides of a
    result.
    """
    told = in_line_blocks(leg, found, phrases, number, chain) or met_blocks(leg, found, phrases, number)
    return told or back_blocks(leg, found, number, chain) or kept_blocks(leg, found, number, chain)


def told_elsewhere(found: MotionTrace) -> list[RouteStep]:
    """Steps that have no line of their own in the route."""
    return [*(leg for legs in held_by_periods(found).values() for leg in legs), *data_of_meetings(found)]
