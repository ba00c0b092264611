"""Springs whose stretch is their length less the natural one, s_1 = CB_1 - l_0, where both have letters."""

from __future__ import annotations

import re

import sympy as sp

from planar_cli.problem.scene.acting import acting_loads
from planar_cli.solve.between.trace.trace import MotionTrace

POINT = re.compile(r"[A-Z]\d?")


def spring_lengths(found: MotionTrace) -> dict[str, tuple[str, sp.Symbol]]:
    """By the words of what does work: its length by its ends, and the letter of its natural length."""
    made: dict[str, tuple[str, sp.Symbol]] = {}
    for load in acting_loads(found.problem):
        length, ends = getattr(load, "natural_length", None), getattr(load, "between", ())
        # One that only pulls may be slack in a state: then its length is less than the natural one.
        if length is not None and getattr(load, "acts", None) is None and ends and all(map(POINT.fullmatch, ends)):
            natural = found.regimes[0].solution.instant.scene.value(length)
            if natural.is_Symbol:
                made[load.phrase(load.short_name).removeprefix("the ")] = ("".join(ends), natural)
    return made
