"""How a homework is graded: tolerances, and what a slip in unit, sign or precision costs."""

from __future__ import annotations

from planar_cli.records import record


@record
class Rules:
    """Of a whole set. Credits are parts of the points of a find, 0 to 1."""

    tolerance: float | None = None
    """Relative; None: that of the problem file, else one per cent."""
    mode: str = "relative"
    """relative, or sigfig: within 0.51 of the last of so many `figures`."""
    figures: int = 3
    """Significant figures that are asked for."""
    unit: float = 0.0
    """Credit for the right number with a wrong unit."""
    no_unit: float | None = None
    """Credit for the right number without any unit; None: it is ungradable, and told so."""
    sign: float = 0.0
    """Credit for the right number with the wrong sign or sense."""
    precision: float = 1.0
    """Credit for a right number with fewer figures than are asked for."""
    carried: float = 1.0
    """Credit for what follows rightly from another wrong value of the student's own."""
    comma: bool = False
    """Is 12,5 twelve and a half?"""
