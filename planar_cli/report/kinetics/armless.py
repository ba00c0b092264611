"""Why an m a of a diagram is not in a sum of moments in letters: with the numbers of the file its line passes through
the point.

disk, rod, moments about C, through which the line of m_R R α_disk passes, as R - l/4 = 0.3 - 1.2/4 = 0:
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.report.document.blocks import Line, Text, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written

LONGEST = 12
"""An arm with more operations is not told in letters."""


def with_lines_through(head: Line, w: Written, phrases: Phrases) -> Line:
    """The heading of a sum of moments, with what has no arm there for the numbers of the file alone."""
    if not w.armless or not isinstance(head[-1], Text) or not head[-1].text.endswith(":"):
        return head
    why: list[Any] = []
    for force, arm in w.armless:
        why += [" and" if why else ", through which", " the line of ", phrases.math(_positive(force)), " passes"]
        size = _positive(arm)
        if not longer(size, LONGEST):
            numbers = phrases.numbers(size)
            put_in = () if numbers is None else (" = ", numbers)
            why += [", as ", phrases.math(size), *put_in, " = 0"]
    end = head[-1].text.removesuffix(":")
    return line(*head[:-1], *((end,) if end else ()), *why, ":")


def _positive(expr: sp.Expr) -> sp.Expr:
    return -expr if expr.could_extract_minus_sign() else expr
