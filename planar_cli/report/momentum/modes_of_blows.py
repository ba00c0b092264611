"""What ropes and rough contacts do in a blow, in a sentence above its diagrams."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.report.document.blocks import Paragraph, line
from planar_cli.solve.solution import InstantSolution

SLIDE = "slide throughout the blow"
"""Ends what is assumed of bodies that rub against each other until they part."""


def said_of_modes(solution: InstantSolution) -> Iterator[Paragraph]:
    """A rope that stays slack, and why friction is at its limit in the sense in which it is drawn."""
    for mode in solution.trial.system.modes.values():
        words = f"{mode.words[:1].upper()}{mode.words[1:]}"
        if mode.name == "slack":
            yield Paragraph(line(f"{words} in the blow: its ends do not move apart, and it exerts no impulse."))
        elif mode.words.endswith(SLIDE):
            yield Paragraph(line(f"{words}: friction acts against the sliding, and is at its limit."))
