"""A question of PrairieLearn, written by planar: the table at the end has its variants.

`generate` picks one by the seed. Numbers are graded by the elements of the page; `grade` adds that a direction may be
told after a whole turn, and what a typical mistake gives.
"""

from __future__ import annotations

import importlib
from typing import Any

VARIANTS: list[dict[str, Any]] = []


def generate(data: dict[str, Any]) -> None:
    """Put in the numbers of one variant."""
    index = int(data["variant_seed"]) % len(VARIANTS)
    data["params"]["index"] = index
    data["params"].update(VARIANTS[index]["params"])
    data["correct_answers"].update(VARIANTS[index]["answers"])


def grade(data: dict[str, Any]) -> None:
    """Look at what the elements called wrong."""
    again = False
    for name, known in VARIANTS[data["params"]["index"]]["inputs"].items():
        result = data["partial_scores"].get(name)
        if not result or result.get("score"):
            continue
        value = number(data["submitted_answers"].get(name), known["unit"])
        if value is None:
            continue
        if any(abs(value - right) <= tolerance for right, tolerance in known["turned"]):
            result["score"], again = 1.0, True
            result.pop("feedback", None)
        for wrong, tolerance, feedback in known["mistakes"]:
            if abs(value - wrong) <= tolerance:
                result["feedback"] = feedback
    if again:
        parts = list(data["partial_scores"].values())
        weights = [part.get("weight", 1) for part in parts]
        scores = [part.get("score") or 0.0 for part in parts]
        data["score"] = sum(w * s for w, s in zip(weights, scores, strict=True)) / sum(weights)


def number(typed: Any, unit: str) -> float | None:
    """What was typed, in the unit of the key; None where that is no number."""
    if isinstance(typed, dict):
        typed = typed.get("_value")
    try:
        if unit and isinstance(typed, str):
            registry = importlib.import_module("prairielearn").get_unit_registry()
            return float(registry.Quantity(typed).to(unit).magnitude)
        return float(typed)
    except Exception:
        # Feedback is an extra: whatever cannot be read as a number has none.
        return None
