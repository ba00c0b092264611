"""What came of comparing one stated answer with the solution, and what counts as agreement."""

from __future__ import annotations

from decimal import Decimal

from planar_cli.records import record

TOLERANCE = Decimal("0.01")
"""Relative, where the file says no other."""
FLOOR = Decimal("0.001")
"""Share of tolerance times scale that is allowed on top: at one per cent, 1e-5 of the scale for a true zero."""


@record
class Verdict:
    """One stated answer beside the solved one."""

    find: str
    stated: str
    solved: str
    agrees: bool
    error: Decimal | None = None
    """Relative; None where that means nothing."""
    message: str = ""
    """What differs, in a sentence."""
