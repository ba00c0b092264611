"""A study of accuracy as a table in letters, Markdown, CSV, or data for JSON."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Iterator, Sequence
from itertools import groupby, zip_longest
from typing import Any

from planar_cli.integrators.base import EPSILON
from planar_cli.motion.follow.estimate import Growth
from planar_cli.problem.nodes.show import harmless, spreadsheet_cell
from planar_cli.records import record
from planar_cli.simulate.accuracy import Advice, Row, Study
from planar_cli.simulate.columns import NARROW, USUAL, in_width, wrapped
from planar_cli.simulate.diagram import diagram
from planar_cli.simulate.solving import Solved

HEADS = ("integrator", "tolerance or step", "error", "estimated", "energy", "drift", "evaluations", "time")
SUMMARY = ("scene", "error", "estimated", "energy", "drift", "time", "6 digits in", "ended", "horizon")
SHORT, NOTE = "setting", 3
"""What the second column is called in a narrow table; what stands before a note."""
MIDDLE, SIX, LONGEST = 1e-9, 6, 48
"""The tolerance, the digits, and the longest text of a line."""
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


@record
class Told:
    """What was found out about one file."""

    title: str
    study: Study | None = None
    """None where its motion can not be followed."""
    solved: Solved | None = None
    """None where it was not solved: it asks nothing, or it is one of several."""
    failed: str = ""
    """Why there is no study."""


def as_text(told: Told, width: int = USUAL) -> str:
    """For a terminal: the table, the diagram, and what follows from them."""
    study = told.study
    if study is None:
        return "\n".join(wrapped([told.title, "", *_endings(told), ""], width))
    lines = [*wrapped([told.title, "", *_head(study), ""], width), *_table(study, width)]
    lines += ["", *diagram(study, width), ""] if lines[-1] else [*diagram(study, width), ""]
    lines += wrapped([*_conclusions(study), *_endings(told), ""], width)
    return "\n".join(lines)


def _table(study: Study, width: int) -> Iterator[str]:
    """All rows; in a narrow terminal those of one integrator after the other."""
    if width >= NARROW:
        table = in_width(HEADS, [_cells(row) for row in study.rows], 2, width, left=(0, 1))
        yield from _with_notes(table, [row.note for row in study.rows], width)
        return
    for kind, group in groupby(study.rows, key=lambda row: row.integrator):
        rows = list(group)
        yield kind
        table = in_width((SHORT, *HEADS[2:]), [_cells(row)[1:] for row in rows], 1, width, left=(0,))
        yield from _with_notes(table, [row.note for row in rows], width)
        yield ""


def _with_notes(table: Sequence[str], notes: Sequence[str], width: int) -> Iterator[str]:
    """Why a row has no error, behind it, or below where there is no room."""
    for line, note in zip_longest(table, ["", *notes], fillvalue=""):
        if note and len(line) + NOTE + len(note) > width:
            yield line
            yield from wrapped([" " * 2 * NOTE + note], width)
        else:
            yield line + (" " * NOTE + note if note else "")


def as_markdown(told: Told) -> str:
    """The same as a table of Markdown."""
    study = told.study
    title = f"## {_words(told.title)}"
    if study is None:
        return "\n".join([title, "", *(f"- {_words(line)}" for line in _endings(told)), ""])
    lines = [title, "", *(f"{line}  " for line in _head(study)), ""]
    lines += ["| " + " | ".join(HEADS) + " |", "|" + " --- |" * 2 + " ---: |" * (len(HEADS) - 2)]
    for row in study.rows:
        cells = _cells(row)
        lines.append("| " + " | ".join((*cells[:2], _words(row.note) or cells[2], *cells[3:])) + " |")
    return "\n".join([*lines, "", *(f"- {_words(line)}" for line in (*_conclusions(study), *_endings(told))), ""])


def _words(text: str) -> str:
    """Words without any meaning for Markdown or HTML, in one line."""
    return re.sub(r"([\\`*_{}\[\]<>#|~$&!])", r"\\\1", harmless(text, kept=""))


def as_summary(told: Sequence[Told], width: int = USUAL) -> str:
    """A line for every scene, at the tolerance nearest to MIDDLE, and why others could not be studied."""
    cells = [_line(one.title, one.study) for one in told if one.study is not None]
    lines = in_width(SUMMARY, cells, 1, width, left=(0, 7), indent=0)
    missing = [f"{one.title}: {one.failed}" for one in told if one.study is None]
    return "\n".join([*lines, *wrapped([*([""] if missing else []), *missing, ""], width)])


def _line(title: str, study: Study) -> tuple[str, ...]:
    by_tolerance = [(abs(math.log(r.tolerance / MIDDLE)), r) for r in study.rows if r.tolerance]
    row = min(by_tolerance, key=lambda found: found[0])[1] if by_tolerance else None
    six = next((a.row for a in study.advice if a.digits == SIX), None)
    horizon = "-" if study.growth is None or study.growth.horizon is None else f"{study.growth.horizon:.3g} s"
    ended = study.ran.refused or (row.note if row is not None else "") or _happened(study)
    figures = ("-",) * 5
    if row is not None:
        cells = _cells(row)
        figures = (cells[2], cells[3], cells[4], cells[5], cells[7])
    return (_cut(title), *figures, "-" if six is None else _time(six.seconds), _cut(ended), horizon)


def _happened(study: Study) -> str:
    """How many impacts, changes of mode and states there were; how the motion ended is told last, and not counted."""
    count = max(len(study.ran.met) - 1, 0)
    return f"{count} event{'' if count == 1 else 's'}"


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"


def as_csv(told: Sequence[Told]) -> str:
    """All rows of all studies; the first column says of which one."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(("problem", *CSV_HEADS))
    for one in told:
        for r in one.study.rows if one.study is not None else ():
            numbers = (r.tolerance, r.step, r.error, r.estimated, _finite(r.energy), _finite(r.drift))
            cells = ["" if v is None else repr(v) for v in numbers]
            last = (r.steps, r.evaluations, f"{r.seconds:.6g}", spreadsheet_cell(r.note))
            writer.writerow((spreadsheet_cell(one.title), r.integrator, *cells, *last))
    return out.getvalue()


def as_data(told: Told) -> dict[str, Any]:
    """For JSON."""
    data: dict[str, Any] = {"problem": told.title}
    if told.study is not None:
        data |= _study_data(told.study)
    if told.failed:
        data["failed"] = told.failed
    if told.solved is not None:
        data["solve"] = {"digits": told.solved.digits, "seconds": told.solved.seconds, "why": told.solved.why}
    return data


def _study_data(study: Study) -> dict[str, Any]:
    grown = study.growth
    return {
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
        "growth": None if grown is None else _growth_data(grown),
    }


def _advised(advice: Advice) -> dict[str, Any]:
    row = advice.row
    setting = None if row is None else {"integrator": row.integrator, "tolerance": row.tolerance, "step": row.step}
    return {"digits": advice.digits, "setting": setting, "seconds": None if row is None else row.seconds}


def _head(study: Study) -> Iterator[str]:
    ran = study.ran
    happened = f", with {_happened(study)} on the way" if len(ran.met) > 1 else ""
    yield f"From t = {ran.t0:.6g} s to t = {ran.t1:.6g} s{happened}."
    yield f"Reference: {study.reference.words}."
    yield "Errors are parts of the scene's scales, the largest of all numbers that are compared."


def _conclusions(study: Study) -> Iterator[str]:
    for advice in study.advice:
        row = advice.row
        if row is None:
            yield f"{advice.digits} digits: {_why_none(study, advice.digits)}"
        else:
            yield f"{advice.digits} digits: {row.integrator} with {row.setting}, {_time(row.seconds)}"
    grown = study.growth
    if grown is None:
        yield "How a unit in the last place at the start grows is not told: a motion that begins with it ends at once."
        return
    yield f"A unit in the last place at the start is {grown.factor:.1e} units at the end."
    if grown.horizon is None:
        yield f"Up to {_meaningful(grown)} digits mean something throughout."
    else:
        how = "If differences go on growing like that, digits" if grown.extrapolated else "Digits"
        yield f"{how} mean nothing beyond t = {grown.horizon:.3g} s."


def _growth_data(grown: Growth) -> dict[str, Any]:
    return {"factor": grown.factor, "horizon": grown.horizon, "extrapolated": grown.extrapolated}


def _meaningful(grown: Growth) -> int:
    """How many digits are left of a number in machine arithmetic."""
    return math.floor(-math.log10(EPSILON * max(grown.factor, 1.0)))


def _why_none(study: Study, digits: int) -> str:
    """Why no setting is recommended."""
    known = study.reference.uncertainty
    if not math.isfinite(known):
        return "none is recommended, as the reference is not checked"
    if known > 10.0**-digits:
        return f"none is recommended, as the reference is known to {known:.0e} only"
    return "none of these settings reaches them"


def _endings(told: Told) -> Iterator[str]:
    if told.failed:
        yield f"The motion can not be followed: {told.failed}"
    if told.solved is not None:
        yield told.solved.words


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
