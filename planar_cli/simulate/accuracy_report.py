"""A study of accuracy as a table in letters, Markdown, CSV, or data for JSON."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Sequence
from typing import Any

from planar_cli.simulate.accuracy import Advice, Row, Study
from planar_cli.simulate.diagram import diagram

HEADS = ("integrator", "tolerance or step", "error", "estimated", "energy", "drift", "evaluations", "time")
CSV_HEADS = (
    "integrator",
    "tolerance",
    "step [s]",
    "error",
    "estimated error",
    "energy error",
    "constraint drift",
    "steps",
    "evaluations",
    "time [s]",
    "note",
)


def as_text(title: str, study: Study) -> str:
    """For a terminal: the table, the diagram, and what follows from them."""
    rows = [_cells(row) for row in study.rows]
    widths = [max(len(r[i]) for r in (HEADS, *rows)) for i in range(len(HEADS))]
    lines = [title, "", *_head(study), ""]
    for row, cells in zip((None, *study.rows), (HEADS, *rows), strict=True):
        line = "  ".join(
            c.ljust(w) if i < 2 else c.rjust(w) for i, (c, w) in enumerate(zip(cells, widths, strict=True))
        )
        lines.append("  " + line.rstrip() + (f"   {row.note}" if row is not None and row.note else ""))
    lines += ["", *diagram(study), "", *_conclusions(study), ""]
    return "\n".join(lines)


def as_markdown(title: str, study: Study) -> str:
    """The same as a table of Markdown."""
    lines = [f"## {title}", "", *(f"{line}  " for line in _head(study)), ""]
    lines += ["| " + " | ".join(HEADS) + " |", "|" + " --- |" * 2 + " ---: |" * (len(HEADS) - 2)]
    for row in study.rows:
        cells = _cells(row)
        lines.append("| " + " | ".join((*cells[:2], row.note or cells[2], *cells[3:])) + " |")
    return "\n".join([*lines, "", *(f"- {line.strip()}" for line in _conclusions(study)), ""])


def as_csv(studies: Sequence[tuple[str, Study]]) -> str:
    """All rows of all studies; the first column says of which one."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(("problem", *CSV_HEADS))
    for title, study in studies:
        for r in study.rows:
            numbers = (r.tolerance, r.step, r.error, r.estimated, _finite(r.energy), _finite(r.drift))
            told = ["" if v is None else repr(v) for v in numbers]
            writer.writerow((title, r.integrator, *told, r.steps, r.evaluations, f"{r.seconds:.6g}", r.note))
    return out.getvalue()


def as_data(title: str, study: Study) -> dict[str, Any]:
    """For JSON."""
    grown = study.growth
    return {
        "problem": title,
        "reference": {"words": study.reference.words, "uncertainty": _finite(study.reference.uncertainty)},
        "rows": [
            {
                "integrator": r.integrator,
                "tolerance": r.tolerance,
                "step": r.step,
                "error": r.error,
                "estimated_error": r.estimated,
                "energy_error": _finite(r.energy),
                "constraint_drift": _finite(r.drift),
                "steps": r.steps,
                "evaluations": r.evaluations,
                "seconds": r.seconds,
                "note": r.note,
            }
            for r in study.rows
        ],
        "recommended": [_advised(a) for a in study.advice],
        "growth": {"factor": grown.factor, "horizon": grown.horizon, "extrapolated": grown.extrapolated},
    }


def _advised(advice: Advice) -> dict[str, Any]:
    row = advice.row
    setting = None if row is None else {"integrator": row.integrator, "tolerance": row.tolerance, "step": row.step}
    return {"digits": advice.digits, "setting": setting, "seconds": None if row is None else row.seconds}


def _head(study: Study) -> Iterator[str]:
    ran = study.ran
    happened = f", with {len(ran.met)} events on the way" if ran.met else ""
    yield f"From t = {ran.t0:.6g} s to t = {ran.t1:.6g} s{happened}."
    yield f"Reference: {study.reference.words}."
    yield "Errors are parts of the scene's scales, the largest of all numbers that are compared."


def _conclusions(study: Study) -> Iterator[str]:
    for advice in study.advice:
        row = advice.row
        if row is None:
            yield f"{advice.digits} digits: none of these settings reaches them"
        else:
            yield f"{advice.digits} digits: {row.integrator} with {row.setting}, {_time(row.seconds)}"
    grown = study.growth
    yield f"A unit in the last place at the start is {grown.factor:.1e} units at the end."
    if grown.horizon is None:
        yield "Digits keep their meaning throughout."
    else:
        how = "If differences go on growing like that, digits" if grown.extrapolated else "Digits"
        yield f"{how} mean nothing beyond t = {grown.horizon:.3g} s."


def _cells(row: Row) -> tuple[str, ...]:
    setting = f"{row.tolerance:.0e}" if row.tolerance is not None else f"{row.step:.2e} s"
    return (
        row.integrator,
        setting,
        _number(row.error),
        _number(row.estimated),
        _number(row.energy),
        _number(row.drift),
        str(row.evaluations),
        _time(row.seconds),
    )


def _number(value: float | None) -> str:
    return "-" if value is None or not math.isfinite(value) else f"{value:.1e}"


def _time(seconds: float) -> str:
    return f"{1e3 * seconds:.3g} ms" if seconds < 1.0 else f"{seconds:.3g} s"


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
