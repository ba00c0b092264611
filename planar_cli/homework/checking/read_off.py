"""Comparison of stated answers with what was read off a motion: numbers and words only."""

from __future__ import annotations

import math
from decimal import Decimal

from planar_cli.base_units import in_base
from planar_cli.homework.checking.verdict import FLOOR, TOLERANCE, Verdict
from planar_cli.problem.language.expression import Side, Word
from planar_cli.problem.scene.scene import Answer, Problem
from planar_cli.simulate.run import Simulation
from planar_cli.solve.solution import Found


def verdict_on(problem: Problem, answer: Answer, found: Found, motion: Simulation) -> Verdict:
    """One stated answer beside the one read off."""
    stated = answer.value
    if isinstance(stated, bool | Word | str):
        said = str(stated).lower() if isinstance(stated, bool) else stated.word if isinstance(stated, Word) else stated
        agrees = said == found.word
        other = found.word or "a number"
        message = "" if agrees else f"{answer.name}: the file states {said}, the solution gives {other}"
        return Verdict(answer.name, said, found.word, agrees, None, message)
    sides = motion.run.measures.model.scene.sides

    def number(side: Side | None) -> float | None:
        return None if side is None else sides.value(side).value

    wanted = [sides.value(s).value for s in (stated if isinstance(stated, tuple) else (stated,))]
    solved = [float(v) for v in found.values or ()]
    texts = _shown(wanted, found, problem.us), _shown(solved, found, problem.us)
    if len(wanted) != len(solved):
        message = f"{answer.name}: the file states {texts[0]}, the solution gives {texts[1] or found.word}"
        return Verdict(answer.name, *texts, False, None, message)
    off, size = math.hypot(*(a - b for a, b in zip(wanted, solved, strict=True))), math.hypot(*wanted)
    own, common = number(answer.tolerance), number(problem.tolerance)
    tolerance = own if own is not None else common if common is not None else float(TOLERANCE)
    scale = next((a.scale for a in motion.answers if a.name == answer.name), 0.0)
    agrees = off <= tolerance * size + float(FLOOR) * tolerance * scale
    error = Decimal(off / size) if size else None
    message = "" if agrees else f"{answer.name}: the file states {texts[0]}, the solution gives {texts[1]}"
    return Verdict(answer.name, *texts, agrees, error, message)


def _shown(values: list[float], found: Found, us: bool) -> str:
    numbers = [f"{v / in_base(found.unit, us):.6g}" for v in values]
    text = numbers[0] if len(numbers) == 1 else f"[{', '.join(numbers)}]"
    return text if found.unit.text == "1" else f"{text} {found.unit.text}"
