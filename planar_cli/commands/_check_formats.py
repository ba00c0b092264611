"""Checked problem files in forms that other programs read: JSON lines, CSV, JUnit, GitHub, Markdown."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any
from xml.sax.saxutils import escape, quoteattr

from planar_cli.diagnostics import as_data
from planar_cli.homework.checking.checking import AGREES, Checked
from planar_cli.problem.nodes.show import harmless, spreadsheet_cell

NO_ANSWERS = "no answers"


def told(checked: Checked) -> str:
    """The outcome in print: what was solved and states no answers agrees with nothing."""
    return NO_ANSWERS if checked.outcome == AGREES and not checked.verdicts else checked.outcome


def as_record(one: Checked) -> dict[str, Any]:
    """One file as data."""
    answers = [
        {"find": v.find, "stated": v.stated, "solved": v.solved, "agrees": v.agrees, "relative_error": v.error}
        for v in one.verdicts
    ]
    return {
        "file": one.path,
        "problem": one.title,
        "outcome": told(one),
        "answers": answers,
        "message": one.message,
        "diagnostics": [as_data(d) for d in one.diagnostics],
        "seconds": round(one.seconds, 3),
    }


def _jsonl(one: Checked) -> str:
    return f"{json.dumps(as_record(one), ensure_ascii=False, default=float)}\n"


def _csv(one: Checked) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    if not one.verdicts:
        writer.writerow((spreadsheet_cell(one.path), told(one), "", "", "", "", spreadsheet_cell(one.message)))
    for v in one.verdicts:
        cells = (one.path, told(one), v.find, v.stated, v.solved, "yes" if v.agrees else "no", v.message)
        writer.writerow([spreadsheet_cell(c) for c in cells])
    return out.getvalue()


def _messages(one: Checked) -> list[str]:
    """What is wrong with one file, in sentences."""
    if one.outcome == AGREES:
        return []
    return [v.message for v in one.verdicts if not v.agrees] or [one.message or one.outcome]


def _junit(checked: Sequence[Checked]) -> str:
    failures = sum(c.outcome in ("disagrees", "no solution") for c in checked)
    errors = sum(c.outcome in ("bad file", "undecided", "fault") for c in checked)
    seconds = sum(c.seconds for c in checked)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<testsuites><testsuite name="planar check" tests="{len(checked)}" failures="{failures}" errors="{errors}" '
        f'time="{seconds:.3f}">',
    ]
    for one in checked:
        name, group = quoteattr(_clean(one.path)), quoteattr(_clean(one.title or "planar"))
        lines.append(f'<testcase name={name} classname={group} time="{one.seconds:.3f}">')
        if messages := _messages(one):
            kind = "failure" if one.outcome in ("disagrees", "no solution") else "error"
            text = _clean("\n".join(messages), kept="\n")
            lines.append(f"<{kind} message={quoteattr(_clean(messages[0]))}>{escape(text)}</{kind}>")
        elif not one.verdicts:
            lines.append('<skipped message="the file states no answers"/>')
        lines.append("</testcase>")
    return "\n".join([*lines, "</testsuite></testsuites>", ""])


def _clean(text: str, kept: str = "") -> str:
    """Without characters that XML does not allow."""
    return harmless(text, kept=kept)


def _github(one: Checked) -> str:
    """`::error file=…,line=…::…`, one for each thing that is wrong."""
    lines = []
    for d in one.diagnostics:
        place = f"file={_property(d.mark.file)},line={d.mark.line},col={d.mark.column},title={d.code}"
        lines.append(f"::error {place}::{_data(d.message)}")
    for message in _messages(one) if not one.diagnostics else []:
        level = "warning" if one.outcome == "undecided" else "error"
        lines.append(f"::{level} file={_property(one.path)}::{_data(message)}")
    return "".join(f"{line}\n" for line in lines)


def _data(text: str) -> str:
    return harmless(text, kept="\n").replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")


def _markdown(checked: Sequence[Checked]) -> str:
    from planar_cli.homework.sets.sheets import plain

    lines = ["| File | Outcome | Answers |", "| --- | --- | --- |"]
    for one in checked:
        right = sum(v.agrees for v in one.verdicts)
        answers = f"{right} of {len(one.verdicts)}" if one.verdicts else "-"
        lines.append(f"| {plain(one.path)} | {plain(told(one))} | {answers} |")
    notes = [f"- {plain(one.path)}: {plain(m)}" for one in checked for m in _messages(one)]
    return "\n".join([*lines, "", *notes, ""] if notes else [*lines, ""])


STREAMED: Mapping[str, Callable[[Checked], str]] = {"jsonl": _jsonl, "csv": _csv, "github": _github}
"""Forms in which a file is told as soon as all before it are known."""
HEADS: Mapping[str, str] = {"csv": "file,outcome,find,stated,solved,agrees,message\n"}
"""What stands before the first file."""
WHOLE: Mapping[str, Callable[[Sequence[Checked]], str]] = {"junit": _junit, "markdown": _markdown}
"""Forms that tell all files at once."""
