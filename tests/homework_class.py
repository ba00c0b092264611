"""Submissions of known kind for a homework: each answer with the verdict that it must get.

.venv/bin/python tests/homework_class.py SET.yaml FOLDER [NUMBER]        writes them as files
"""

from __future__ import annotations

import json
import random
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from planar_cli.homework.sets.key_text import shown
from planar_cli.homework.sets.paper import Expected, Paper
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.tolerances import within
from planar_cli.units import parse_unit

HOSTILE = (
    "__import__('os').system('touch /tmp/x')",
    "9**9**9**9",
    "(" * 200 + "1" + ")" * 200,
    "1e999 N",
    "nan",
    '=HYPERLINK("http://x")',
    "<script>alert(1)</script>",
    "12 ± 1000 N",
    "\u202e12 N",
    "sin('x')",
)
KINDS = ("right", "other form", "mistake", "sign", "unit", "no unit", "random", "hostile", "blank")
OTHER_UNITS = {"N": "kN", "m/s": "km/h", "m/s^2": "cm/s^2", "rad/s": "rpm", "m": "cm", "s": "min", "lbf": "kip"}


@dataclass(frozen=True)
class Planted:
    """One answer with what must come of it: the verdict, and the mistake that must be among those that are found."""

    problem: str
    find: str
    text: str
    kind: str
    verdict: str
    mistake: str = ""


def planted(paper: Paper, kind: str, rng: random.Random) -> Iterator[Planted]:
    """All answers of one submission, of one kind where a find allows it."""
    for task in paper.tasks:
        for expected in task.expected:
            yield _answer(task.problem, expected, kind, rng)


def _answer(problem: str, expected: Expected, kind: str, rng: random.Random) -> Planted:
    made = {
        "other form": _other_form,
        "mistake": _mistake,
        "sign": _sign,
        "unit": _unit,
        "no unit": _no_unit,
        "random": _random,
        "hostile": lambda e, r: (r.choice(HOSTILE), "ungradable", ""),
        "blank": lambda e, r: ("", "missing", ""),
    }.get(kind, lambda e, r: None)(expected, rng)
    text, verdict, mistake = made or (_typed(expected, expected.values), "right", "")
    return Planted(problem, expected.find, text, kind if made else "right", verdict, mistake)


def _typed(expected: Expected, values: tuple[float, ...], unit: str | None = None) -> str:
    shown_unit = expected.unit if unit is None else unit
    unit_text = "" if shown_unit in ("", "1") else f" {shown_unit}"
    # Four figures also of what ends in zeros: else it fits too much.
    numbers = [f"{v:#.4g}".rstrip(".") for v in values]
    return f"[{', '.join(numbers)}]{unit_text}" if len(numbers) > 1 else f"{numbers[0]}{unit_text}"


def _other_form(expected: Expected, rng: random.Random) -> tuple[str, str, str] | None:
    if expected.kind == "vector":
        import math

        x, y = expected.values
        return f"{math.hypot(x, y):.5g} {expected.unit} at {math.degrees(math.atan2(y, x)):.5g} deg", "right", ""
    if expected.rotation and rng.random() < 0.5:
        word = "counterclockwise" if expected.values[0] > 0 else "cw"
        return f"{shown(abs(expected.values[0]))} {expected.unit} {word}", "right", ""
    if expected.axis and rng.random() < 0.5:
        positive, negative = ("right", "left") if expected.axis == "x" else ("up", "downward")
        word = positive if expected.values[0] > 0 else negative
        return f"{shown(abs(expected.values[0]))} {expected.unit} {word}", "right", ""
    other = OTHER_UNITS.get(expected.unit)
    if other is None:
        return f"{expected.values[0]:.4e} {expected.unit if expected.unit != '1' else ''}".strip(), "right", ""
    mine, theirs = parse_unit(expected.unit), parse_unit(other)
    factor = float(mine.factor / theirs.factor) * 3.141592653589793 ** (mine.pi_power - theirs.pi_power)
    return f"{shown(expected.values[0] * factor, 5)} {other}", "right", ""


def _mistake(expected: Expected, rng: random.Random) -> tuple[str, str, str] | None:
    fit = [m for m in expected.mistakes if not within(expected, tuple(-v for v in m.values), Rules())]
    if not fit:
        return None
    chosen = rng.choice(fit)
    return _typed(expected, chosen.values), "wrong", chosen.name


def _sign(expected: Expected, rng: random.Random) -> tuple[str, str, str] | None:
    if expected.kind != "number" or not expected.values[0]:
        return None
    return _typed(expected, (-expected.values[0],)), "wrong", ""


def _unit(expected: Expected, rng: random.Random) -> tuple[str, str, str] | None:
    wrong = "kg" if expected.unit != "kg" else "m"
    return _typed(expected, expected.values, wrong), "wrong", ""


def _no_unit(expected: Expected, rng: random.Random) -> tuple[str, str, str] | None:
    return (_typed(expected, expected.values, ""), "ungradable", "") if expected.unit != "1" else None


def _random(expected: Expected, rng: random.Random) -> tuple[str, str, str] | None:
    while True:
        values = tuple(v * 10 ** rng.uniform(-1, 1) for v in expected.values)
        if not within(expected, values, Rules()):
            return _typed(expected, values), "wrong", ""


def class_of(papers: Mapping[int, Paper], number: int, seed: int = 1) -> Iterator[tuple[str, int, list[Planted]]]:
    """So many students with their variants and answers, the kinds by turns."""
    rng = random.Random(seed)
    variants = [k for k in papers if k] or [0]
    for n in range(number):
        variant = variants[n % len(variants)]
        yield f"s{n:04d}", variant, list(planted(papers[variant], KINDS[n % len(KINDS)], rng))


def written(folder: Path, papers: Mapping[int, Paper], number: int) -> list[tuple[str, int, list[Planted]]]:
    """The same as files, YAML and JSON by turns."""
    folder.mkdir(parents=True, exist_ok=True)
    made = list(class_of(papers, number))
    for n, (student, variant, answers) in enumerate(made):
        nested: dict[str, dict[str, str]] = {}
        for a in answers:
            if a.text:
                nested.setdefault(a.problem, {})[a.find] = a.text
        data = {"student": student, "variant": variant, "answers": nested}
        # JSON is YAML too; what cannot be seen is written out by neither reader.
        (folder / f"{student}.{'json' if n % 2 else 'yaml'}").write_text(json.dumps(data, ensure_ascii=not n % 2))
    return made


if __name__ == "__main__":
    from planar_cli.homework.homework import made_ready
    from planar_cli.homework.sets.set_file import read_set

    ready = made_ready(read_set(sys.argv[1]), 2, 60, None, lambda total, what: lambda done: None)
    written(Path(sys.argv[2]), ready.papers, int(sys.argv[3]) if len(sys.argv) > 3 else 300)
