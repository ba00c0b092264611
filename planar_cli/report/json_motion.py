"""The steps of a motion over time as plain mappings, for the JSON document."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

from planar_cli.report.words import rounded, si_text
from planar_cli.solve.course.derivation import Result
from planar_cli.solve.course.equations import Equation
from planar_cli.solve.course.unfolded import Unfolded

STEP_DIGITS = 12


def motion_steps(case: str, found: Unfolded) -> list[dict[str, Any]]:
    """Every relation between states that the solution uses, and every letter that it gives."""
    if found.route is None:
        return []
    steps: list[dict[str, Any]] = []
    for leg in found.route.legs:
        steps += [{"case": case, "stage": "motion", **_relation(e)} for e in leg.derivation.equations]
        steps += [{"case": case, "stage": "motion", **_result(r, found)} for r in leg.results]
    return steps


def _relation(e: Equation) -> dict[str, Any]:
    return {
        "kind": "relation",
        "law": e.kind,
        "state": e.stop,
        "since": e.since,
        "left": str(rounded(e.residual, STEP_DIGITS)),
        "right": "0",
        "words": e.words,
    }


def _result(r: Result, found: Unfolded) -> dict[str, Any]:
    ledger = found.course.ledger
    unit = ledger.units.get(r.unknown)
    numeric = not found.course.symbolic and isinstance(r.value, Decimal) and r.value.is_finite()
    return {
        "kind": "solved",
        "symbol": r.unknown.name,
        "formula": None if r.formula is None else str(rounded(r.formula, STEP_DIGITS)),
        "value": r.value if numeric else None,
        "unit": si_text(unit) if unit is not None else "1",
        "roots": [x.value for x in r.roots] if numeric else [],
    }
