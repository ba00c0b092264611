"""Diagrams of work against error in letters, for a terminal."""

from __future__ import annotations

import math

from planar_cli.plain_letters import letters
from planar_cli.simulate.accuracy import Row, Study
from planar_cli.simulate.columns import USUAL, wrapped

WIDTH, HEIGHT = 64, 18
"""Of the field of a diagram in letters."""
LETTERS = "abcdefghijklmnopqrstuvwxyz"
BESIDE, FEWEST = 12, 16
"""What the numbers beside it take, and the narrowest field."""
ESTIMATED = "·"
"""Where an estimated error stands for its row."""
LEAST = 1e-16
"""Smaller errors are drawn here."""


def curves_of(study: Study) -> dict[str, list[Row]]:
    """The rows with an error, by integrator."""
    curves: dict[str, list[Row]] = {}
    for row in study.rows:
        if row.error is not None and row.seconds > 0.0:
            curves.setdefault(row.integrator, []).append(row)
    return curves


def lowest_of(study: Study) -> float:
    """Smaller errors are drawn here: below what the reference can tell."""
    known = study.reference.uncertainty
    return max(known, LEAST) if math.isfinite(known) else LEAST


def diagram(study: Study, columns: int = USUAL) -> list[str]:
    """Time [s] to the right, error upward, both by powers of ten; a letter for every integrator."""
    curves = curves_of(study)
    if not curves:
        return []
    low, width = lowest_of(study), max(min(WIDTH, columns - BESIDE), FEWEST)
    times = [math.log10(r.seconds) for rows in curves.values() for r in rows]
    errors = [
        math.log10(max(e, low))
        for rows in curves.values()
        for r in rows
        for e in (r.error, r.estimated)
        if e is not None
    ]
    left, right = math.floor(min(times)), math.ceil(max(times) + 1e-9)
    bottom, top = math.floor(min(errors)), math.ceil(max(errors) + 1e-9)
    estimated = letters(ESTIMATED)
    field = [[" "] * (width + 1) for _ in range(HEIGHT + 1)]

    def put(row: Row, error: float, letter: str) -> None:
        x = round(width * (math.log10(row.seconds) - left) / (right - left))
        y = round(HEIGHT * (top - math.log10(max(error, low))) / (top - bottom))
        if letter != estimated or field[y][x] == " ":
            field[y][x] = letter

    named = list(zip(LETTERS, curves.items(), strict=False))
    for letter, (_, rows) in named:
        for row in rows:
            if row.error is not None:
                put(row, row.error, letter)
    for _, (_, rows) in named:
        for row in rows:
            if row.estimated is not None:
                put(row, row.estimated, estimated)
    lines = [*wrapped(["error (parts of the scales) over time [s]:"], columns)]
    marks = _marks(bottom, top, HEIGHT)
    for i, cells in enumerate(field):
        lines.append(f"{marks.get(HEIGHT - i, ''):>7} |{''.join(cells).rstrip()}")
    lines.append(" " * 8 + "+" + "-" * (width + 1))
    scale = [" "] * (width + 12)
    for x, text in _marks(left, right, width).items():
        scale[x : x + len(text)] = text
    lines.append(" " * 8 + "".join(scale).rstrip())
    named_so = [f"{letter} {kind}" for letter, (kind, _) in named]
    lines += wrapped(["  " + "   ".join([*named_so, f"{estimated} estimated error"])], columns)
    return lines


def _marks(low: int, high: int, length: int) -> dict[int, str]:
    """Where powers of ten stand along an axis: not more than one in every fourth place."""
    every = max(1, math.ceil(4 * (high - low) / length))
    return {round(length * (k - low) / (high - low)): f"1e{k}" for k in range(low, high + 1, every)}
