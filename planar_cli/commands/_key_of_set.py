"""`planar key SET.yaml`: variants drawn, sheets and key written, questions exported."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import TYPE_CHECKING

from planar_cli import cli
from planar_cli.commands._counter import counter
from planar_cli.commands._earlier_sheets import MANIFEST, clear, demand_no_loss, manifest
from planar_cli.commands._handed_out import PAGES, PDF, SUFFIX, files, printed_as
from planar_cli.commands._output import write, write_files
from planar_cli.errors import PlanarError
from planar_cli.problem.nodes.show import visible
from planar_cli.streams import echo

if TYPE_CHECKING:
    from planar_cli.homework.sets.ready import Homework
    from planar_cli.homework.sets.set_file import HomeworkSet
    from planar_cli.homework.sets.sheets import Handed


def key_of_set(
    path: str,
    worked: bool,
    both: bool,
    output: str | None,
    timeout: float,
    voice: tuple[int, str],
    variants: int | None,
    seed: int | None,
    form: str | None,
    exports: tuple[str, ...],
) -> int:
    """Sheets, key and exports of a set. `voice`: figures and audience of worked solutions."""
    from planar_cli.commands._told_formulas import told_formulas
    from planar_cli.commands._worked_pages import Pressed
    from planar_cli.homework.homework import made_ready
    from planar_cli.homework.sets.set_file import read_set
    from planar_cli.homework.sets.sheets import handed

    if exports and output is None:
        raise PlanarError("--export needs a folder: `-o FOLDER`")
    style = form or "markdown"
    if style == PDF and output is None:
        raise PlanarError("a PDF is written to a file: `-o FOLDER`")
    suffix = SUFFIX[style]
    holds_worked = (worked or both) and style in PAGES
    if output is not None and not holds_worked:
        demand_no_loss(output, "add --both" if style in PAGES else "")
    of_file = homework_set = read_set(path)
    homework_set = replace(
        homework_set,
        variants=homework_set.variants if variants is None else variants,
        seed=homework_set.seed if seed is None else seed,
    )
    own = printed_as(style) if style in PAGES and (holds_worked or output is not None) else ""
    solves = holds_worked or bool(exports)
    below = 2 if homework_set.variants else 1
    press = Pressed(own, bool(exports), solves, below, output is not None, *voice) if own or exports else None
    homework = made_ready(homework_set, os.cpu_count() or 1, timeout, press, counter, told_formulas)
    for warning in (*homework.warnings, *_drawn_otherwise(of_file, homework_set)):
        echo(visible(f"warning: {warning}"), err=True)
    handed_out = [k for k in homework.papers if k] or [0]
    steps = worked or both, not worked or both
    if output is None:
        (key,) = _key(homework, handed_out, style, *steps).values()
        write(key.decode(), None, exact=True)
        return cli.SOLVED
    sheets = handed(homework, handed_out)
    data: dict[str, bytes] = {}
    for one in sheets:
        data |= _sheet(homework, one, style)
    data |= _key(homework, handed_out, style, *steps)
    for one in sheets if len(handed_out) > 1 else ():
        data |= _key(homework, [one.variant], style, *steps, one.key)
    clear(output, data)
    write_files({**data, MANIFEST: manifest(data, f"key.{suffix}" if holds_worked else "")}, output)
    for name in exports:
        _export(homework, name, homework_set.seed, output)
    return cli.SOLVED


def _drawn_otherwise(of_file: HomeworkSet, homework_set: HomeworkSet) -> list[str]:
    """What is to be said where the variants are not those by which submissions are graded."""
    number, seed = homework_set.variants, homework_set.seed
    if (number, seed) == (of_file.variants, of_file.seed):
        return []
    line = f"variants: {{number: {number}, seed: {seed}}}"
    return [f"`planar check --set` grades by the variants of the set file: write `{line}` there, or these are others"]


def _sheet(homework: Homework, one: Handed, form: str) -> dict[str, bytes]:
    from planar_cli.homework.sets import sheets
    from planar_cli.report.document.handed_out import sheet

    if form == "json":
        return {f"{one.name}.json": sheets.as_json(sheets.sheet_data(homework, one)).encode()}
    if form == "csv":
        return {f"{one.name}.csv": sheets.sheet_csv(homework, one).encode()}
    return files(sheet(homework, one), one.title(homework), form, one.name)


def _key(
    homework: Homework, variants: list[int], form: str, worked: bool, short: bool, name: str = "key"
) -> dict[str, bytes]:
    from planar_cli.homework.sets import sheets
    from planar_cli.report.document.handed_out import key

    if form == "json":
        return {f"{name}.json": sheets.as_json(sheets.key_data(homework, variants)).encode()}
    if form == "csv":
        return {f"{name}.csv": sheets.key_csv(homework, variants).encode()}
    return files(key(homework, variants, worked, short), f"{homework.title}: key", form, name)


def _export(homework: Homework, name: str, seed: int, output: str) -> None:
    from planar_cli.commands._exports import export_of

    export = export_of(name, "papers")
    papers = [p for k, p in homework.papers.items() if k] or [homework.papers[0]]
    made = export.export(papers, homework.title, seed)
    write_files(made.files, os.path.join(output, name))
    for sentence in made.left_out:
        echo(visible(f"{name}: {sentence}"), err=True)
