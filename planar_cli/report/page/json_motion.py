"""The steps of a motion over time as plain mappings, for the JSON document."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

from planar_cli.report.notation.page_units import in_base_units
from planar_cli.report.notation.rounding import rounded
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result

STEP_DIGITS = 12


def motion_steps(case: str, found: MotionTrace) -> list[dict[str, Any]]:
    """Every relation between states that the solution uses, and every letter that it gives."""
    steps: list[dict[str, Any]] = []
    for step in found.route.steps:
        steps += [{"case": case, "stage": "motion", **_relation(e)} for e in step.relations]
        steps += [{"case": case, "stage": "motion", **_result(r, found)} for r in step.results]
    return steps


def _relation(e: Relation) -> dict[str, Any]:
    return {
        "kind": "relation",
        "law": e.kind,
        "state": e.stop,
        "since": e.since,
        "left": str(rounded(e.residual, STEP_DIGITS)),
        "right": "0",
        "words": e.words,
    }


def _result(r: Result, found: MotionTrace) -> dict[str, Any]:
    ledger = found.ledger
    unit = ledger.units.get(r.unknown)
    numeric = not found.symbolic and isinstance(r.value, Decimal) and r.value.is_finite()
    return {
        "kind": "solved",
        "symbol": r.unknown.name,
        "formula": None if r.formula is None else str(rounded(r.formula, STEP_DIGITS)),
        "value": r.value if numeric else None,
        "unit": in_base_units(unit, ledger.us).text if unit is not None else "1",
        "roots": [x.value for x in r.roots] if numeric else [],
    }
