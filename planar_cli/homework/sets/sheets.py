"""What is handed out: which sheets there are, and sheets and keys as data, in JSON and CSV.

How sheets and keys look as pages stands in `report/document/handed_out.py`.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Iterable, Mapping, Sequence

from planar_cli.homework.exports._text import Names, slug
from planar_cli.homework.sets.paper import Task
from planar_cli.homework.sets.ready import Homework
from planar_cli.problem.nodes.show import harmless, spreadsheet_cell
from planar_cli.records import record

SCHEMA = 1
MARKUP = str.maketrans({c: f"\\{c}" for c in "\\`*_{}[]<>#|~$"})
"""Characters that mean something in Markdown."""


def plain(text: str) -> str:
    """Words in which nothing is markup."""
    return " ".join(harmless(text, kept="").translate(MARKUP).split())


@record
class Handed:
    """One sheet: the name of its file without the ending, its variant, and its student ("" where none is named)."""

    name: str
    variant: int
    student: str = ""

    @property
    def key(self) -> str:
        """The name of the file with its answers."""
        return f"key{self.name.removeprefix('sheet')}"

    def title(self, homework: Homework) -> str:
        """What stands over it."""
        variant = f"variant {self.variant}" if self.variant else ""
        return ", ".join(filter(None, (homework.title, variant, self.student)))


def handed(homework: Homework, variants: Sequence[int]) -> tuple[Handed, ...]:
    """The sheets of some variants: one for each student who has it, else one for the variant."""
    width = len(str(max(variants, default=0)))
    names = Names()
    found = []
    for variant in variants:
        number = f"sheet-{variant:0{width}d}" if variant else "sheet"
        students = [name for name, own in homework.students if own == variant]
        found += [Handed(names.of(f"{number}-{slug(name)}"), variant, name) for name in students]
        found += [] if students else [Handed(number, variant)]
    return tuple(found)


def sheet_data(homework: Homework, one: Handed) -> dict[str, object]:
    """A sheet as data."""
    return {
        "schema": SCHEMA,
        "title": homework.title,
        "variant": one.variant,
        **({"student": one.student} if one.student else {}),
        "problems": [_task_data(t, with_answers=False) for t in homework.papers[one.variant].tasks],
    }


def key_data(homework: Homework, variants: Sequence[int]) -> dict[str, object]:
    """The key of some variants as data."""
    return {
        "schema": SCHEMA,
        "title": homework.title,
        "digest": homework.digest,
        "variants": [
            {"variant": k, "problems": [_task_data(t, with_answers=True) for t in homework.papers[k].tasks]}
            for k in variants
        ],
    }


def _task_data(task: Task, with_answers: bool) -> dict[str, object]:
    finds: list[Mapping[str, object]] = []
    for e in task.expected:
        asked = {"find": e.find, "asked": e.asked, "kind": e.kind, "unit": e.unit, "points": e.points}
        told = {"answer": e.text, "values": list(e.values), "tolerance": e.tolerance} if with_answers else {}
        formula = {"formula": e.formula} if with_answers and e.formula else {}
        finds.append({**asked, **told, **formula})
    given = list(dict.fromkeys((*task.drawn, *task.given)))
    return {"problem": task.problem, "title": task.title, "text": task.text, "given": given, "finds": finds}


def as_json(data: Mapping[str, object]) -> str:
    """Data as JSON, the same for the same data."""
    return json.dumps(data, ensure_ascii=False, indent=1) + "\n"


def sheet_csv(homework: Homework, one: Handed) -> str:
    """The finds of a sheet as a table to be filled in: it is read back as a submission of its student and variant."""
    own = {"student": one.student, "variant": one.variant}
    own = {name: value for name, value in own.items() if value}
    tasks = homework.papers[one.variant].tasks
    rows = [(*own.values(), t.problem, e.find, "", e.unit) for t in tasks for e in t.expected]
    return _csv((*own, "problem", "find", "answer", "unit"), rows)


def key_csv(homework: Homework, variants: Iterable[int]) -> str:
    """The key of some variants as a table."""
    rows = [
        # A spreadsheet takes a hyphen, but no minus sign, for the beginning of a formula.
        (
            k,
            t.problem,
            e.find,
            re.sub("^-", "\N{MINUS SIGN}", e.text),
            *(list(e.values) + [""] * (2 - len(e.values)))[:2],
            e.unit,
            e.points,
        )
        for k in variants
        for t in homework.papers[k].tasks
        for e in t.expected
    ]
    return _csv(("variant", "problem", "find", "answer", "value", "second_value", "unit", "points"), rows)


def _csv(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(head)
    for row in rows:
        writer.writerow([spreadsheet_cell(c) if isinstance(c, str) else c for c in row])
    return out.getvalue()
