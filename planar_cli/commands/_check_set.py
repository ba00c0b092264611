"""`planar check --set`: a class graded against a homework set."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from planar_cli import cli
from planar_cli.commands._counter import counter
from planar_cli.commands._feedback import feedback, file_of
from planar_cli.commands._output import write_files
from planar_cli.options import WrongUsage
from planar_cli.problem.nodes.show import visible
from planar_cli.streams import echo

if TYPE_CHECKING:
    from planar_cli.homework.grading.class_report import ClassReport
    from planar_cli.homework.sets.paper import Result
    from planar_cli.homework.sets.ready import Homework
    from planar_cli.homework.sets.set_file import HomeworkSet
    from planar_cli.homework.submissions.batches import Ran
    from planar_cli.homework.tasks.results import Line

FORMS = ("terminal", "json", "jsonl", "csv", "markdown")
PAPERS, RESULTS = "papers", "results"
SHARED = 2
"""A variant of fewer submissions says nothing about itself."""
EACH = 200
"""Random wrong numbers for each find, where false matches are counted."""


def checked_set(
    path: str, files: tuple[str, ...], form: str, jobs: int, timeout: float, options: Mapping[str, Any]
) -> int:
    """Grade submissions and print what came of it."""
    from planar_cli.commands._told_formulas import told_formulas
    from planar_cli.homework.homework import made_ready
    from planar_cli.homework.sets.set_file import read_set

    if form not in FORMS:
        raise WrongUsage(f"--format {form} is for problem files; with --set it is one of {', '.join(FORMS)}")
    if options["exports"] and options["output"] is None:
        raise WrongUsage("--export needs a folder: `-o FOLDER`")
    homework_set = read_set(path)
    if options["tolerances"]:
        from planar_cli.commands._tolerances import tolerances_of_set

        return tolerances_of_set(homework_set, timeout)
    homework = made_ready(homework_set, jobs, timeout, None, counter, told_formulas)
    if options["matches"]:
        return _false_matches(homework_set, homework)
    if not files:
        raise WrongUsage("name submissions: files, or a folder of them")
    return _Class(homework_set, homework, form, options).graded(files, jobs)


def _false_matches(homework_set: HomeworkSet, homework: Homework) -> int:
    from planar_cli.homework.grading.false_matches import false_matches

    found = false_matches(homework.papers.values(), homework_set.rules, EACH, homework_set.seed)
    echo(
        f"{found.graded} random wrong numbers: {found.named} taken for one mistake ({100 * found.rate:.2f} %), "
        f"{found.ambiguous} for several"
    )
    return cli.SOLVED


class _Class:
    """The submissions of a class on their way through the workers."""

    def __init__(self, homework_set: HomeworkSet, homework: Homework, form: str, options: Mapping[str, Any]) -> None:
        from planar_cli.homework.exports._text import Names
        from planar_cli.homework.grading.class_report import ClassReport

        self.homework_set, self.homework, self.form, self.options = homework_set, homework, form, options
        self.report: ClassReport = ClassReport()
        self.kept: list[Result] = []
        self.names = Names()
        self.printed: set[tuple[str, str]] = set()
        """File and student of what was printed, where a results file may hold more."""
        self.is_whole = False
        self.titles = {t.problem: t.title for paper in homework.papers.values() for t in paper.tasks}

    def graded(self, files: tuple[str, ...], jobs: int) -> int:
        """Grade all, printing as they come, then what came of the class."""
        from planar_cli.homework.grading.grading_made import grading_of
        from planar_cli.homework.submissions.batches import grade_files, shard_of
        from planar_cli.homework.submissions.grader import Grading
        from planar_cli.homework.submissions.submissions import passed_over

        grading = Grading(grading_of(self.homework_set, self.homework), self.homework.digest)
        shard = shard_of(self.options["shard"])
        if self.form == "csv":
            echo(",".join(HEADER), exact=True)
        with _executor(self.options["cluster"]) as executor:
            ran = grade_files(files, grading, jobs, self.options["results"], shard, executor, self._take)
        if self.options["results"]:
            self._take_done_before(ran)
        if shard == (1, 1) and (told := passed_over(files)):
            echo(f"note: {told}", err=True)
        self.is_whole = shard == (1, 1) and not ran.interrupted
        self._close(ran)
        if ran.interrupted:
            left = f"{ran.left} file{'s'[: ran.left != 1]} not graded" if ran.left else "nothing was left"
            way = (
                "the same command goes on there" if self.options["results"] else "--results FILE goes on when run again"
            )
            echo(f"broken off: {left}; {way}", err=True)
            return 128 + ran.interrupted
        return cli.UNDECIDED if sum(ran.ended.values()) > ran.ended.get("ok", 0) else cli.SOLVED

    def _take_done_before(self, ran: Ran) -> None:
        """With a results file all that stands there is printed, and the report and exports are of all."""
        from planar_cli.homework.grading.class_report import ClassReport
        from planar_cli.homework.tasks.results import merge, result_of

        if ran.skipped:
            self.report, self.kept = ClassReport(), []
            for text in merge([self.options["results"]]):
                result = result_of(text)
                self._add(result)
                if (result.source, result.student) not in self.printed:
                    self._print(text, result)

    def _take(self, line: Line) -> None:
        from planar_cli.homework.tasks.results import result_of

        result = result_of(line.text)
        self._add(result)
        if self.options["results"]:
            self.printed.add((result.source, result.student))
        self._print(line.text, result)

    def _print(self, text: str, result: Result) -> None:
        """One submission, and its text to the student. `text`: its line of JSON."""
        if self.options["feedback"]:
            said = feedback(result, self.homework.title, self.titles)
            folder = self.options["feedback"]
            write_files({file_of(result.student, folder, self.names): said.encode()}, folder)
        if self.form == "jsonl":
            echo(text if not self.options["for_student"] else _for_student(text), exact=True)
        elif self.form == "csv":
            echo(rows_of(result, self.options["for_student"]), end="", exact=True)
        elif self.form == "terminal":
            for told in _lines(result, self.options["for_student"]):
                echo(told)

    def _add(self, result: Result) -> None:
        self.report.add(result)
        if self.options["exports"] or self.form == "json":
            self.kept.append(result)

    def _close(self, ran: Ran) -> None:
        """The report of the class, and the exports."""
        for sentence in ran.twice:
            echo(f"note: {sentence}", err=True)
        if self.form == "json":
            from planar_cli.homework.sets.sheets import as_json
            from planar_cli.homework.tasks.results import as_data

            kept = sorted(self.kept, key=lambda r: (r.student, r.source))
            data = [_without_key(as_data(r)) if self.options["for_student"] else as_data(r) for r in kept]
            echo(as_json({"title": self.homework.title, "results": data}), end="", exact=True)
        elif self.form == "markdown":
            echo(_report_markdown(self.homework.title, self.report), end="", exact=True)
        elif self.form == "terminal":
            _print_report(self.report)
        if absent := self._absent():
            echo(visible(f"nothing handed in by {', '.join(absent)}"), err=True)
        if ran.skipped:
            echo(f"{ran.skipped} submissions were graded before", err=True)
        for name in self.options["exports"]:
            self._export(name)

    def _absent(self) -> list[str]:
        """Who is in the list and handed in nothing; of a part of the submissions, or after Ctrl-C, nobody can tell."""
        names = sorted(name for name, _ in self.homework.students if name not in self.report.counted)
        return names if self.is_whole else []

    def _of_absent(self) -> list[Result]:
        """Their papers, with nothing answered."""
        from planar_cli.homework.grading.grading import grade
        from planar_cli.homework.sets.paper import Submission

        variants = dict(self.homework.students)
        blank = [Submission(name, variants[name], ()) for name in self._absent()]
        return [grade(one, self.homework.papers, self.homework_set.rules) for one in blank]

    def _export(self, name: str) -> None:
        from planar_cli.commands._exports import export_of

        export = export_of(name, RESULTS)
        kept = sorted([*self.kept, *self._of_absent()], key=lambda r: (r.student, r.source))
        made = export.export(kept, self.homework.title)
        write_files(made.files, os.path.join(self.options["output"], name))
        for sentence in made.left_out:
            echo(visible(f"{name}: {sentence}"), err=True)


# --- print -----------------------------------------------------------------------------------------------------------

HEADER = ("student", "variant", "problem", "find", "submitted", "verdict", "score", "max_score", "mistakes", "message")


def _for_student(text: str) -> str:
    """A line of JSON without what the key says."""
    import json

    data = json.loads(text)
    return json.dumps({**data, "result": _without_key(data["result"])}, ensure_ascii=True, separators=(",", ":"))


def _without_key(result: dict[str, Any]) -> dict[str, Any]:
    """A result as data, with nothing of the key, nor of several mistakes that give one number."""
    graded = [{name: value for name, value in one.items() if name != "expected"} for one in result["graded"]]
    for one in graded:
        if len(one.get("mistakes", ())) > 1:
            del one["mistakes"]
    return {**result, "graded": graded}


def rows_of(result: Result, for_student: bool) -> str:
    """The rows of one submission in a table; texts are no formulas of a spreadsheet."""
    import csv
    import io

    from planar_cli.problem.nodes.show import spreadsheet_cell

    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    for g in result.graded:
        told = f"{g.message}; {g.feedback}" if g.feedback else g.message
        cells = (result.student, result.variant, g.problem, g.find, g.submitted, g.told, g.score, g.max_score)
        mistakes = "" if for_student and len(g.mistakes) > 1 else " or ".join(g.mistakes)
        row = (*cells, mistakes, told)
        writer.writerow([spreadsheet_cell(c) if isinstance(c, str) else c for c in row])
    for sentence in result.wrong:
        writer.writerow((spreadsheet_cell(result.student), result.variant, *[""] * 7, spreadsheet_cell(sentence)))
    return out.getvalue()


def _lines(result: Result, for_student: bool) -> list[str]:
    """One submission in print: the score, and a line for all that is not right."""
    variant = f", variant {result.variant}" if result.variant else ""
    lines = [visible(f"{result.student}{variant}: {result.score:g} of {result.max_score:g}")]
    if result.graded and all(g.verdict == "missing" for g in result.graded):
        return [*lines, "  nothing was answered", *(visible(f"  {sentence}") for sentence in result.wrong)]
    # What keeps the whole from being graded is told once, below.
    of_all = {f"this cannot be graded: {sentence}" for sentence in result.wrong}
    for g in result.graded:
        if (g.verdict == "right" and not g.message) or g.message in of_all:
            continue
        told = "; ".join(m for m in (g.message, g.feedback) if m)
        if len(g.mistakes) > 1 and not for_student:
            told += f"; it may be {' or '.join(g.mistakes)}"
        key = "" if for_student or not g.expected else f" (key: {g.expected})"
        lines.append(visible(f"  {g.problem}.{g.find} {g.told}: `{g.submitted}`{key}: {told}"))
    whole = "this cannot be graded: " if any(g.message in of_all for g in result.graded) else ""
    return [*lines, *(visible(f"  {whole}{sentence}") for sentence in result.wrong)]


def _print_report(report: ClassReport) -> None:
    from planar_cli.homework.grading.class_report import by_variant, rows

    echo("")
    for row in rows(report):
        carried = f", {row.carried} follow from another" if row.carried else ""
        ungradable = f", {row.ungradable} ungradable" if row.ungradable else ""
        mistakes = f"; {row.mistakes}" if row.mistakes else ""
        name = f"{row.problem}.{row.find}"
        counted = f"{row.right} of {row.answers} right" if row.answers else "nobody answered"
        echo(visible(f"{name:<28} {counted}{ungradable}{carried}{mistakes}"))
    shared = by_variant(report, SHARED)
    if len(shared) > 1:
        echo("")
    for variant, counts in shared.items() if len(shared) > 1 else ():
        told = ", ".join(f"{problem}.{find} {right}/{answers}" for (problem, find), (right, answers) in counts.items())
        echo(visible(f"variant {variant}: {told} right"))
    for problem, find, why in report.suspicious():
        echo(visible(f"suspicious: {problem}.{find}: {why}"))
    plural = "" if report.submissions == 1 else "s"
    of = f" of {report.students} student{'s'[: report.students != 1]}" if report.students != report.submissions else ""
    refused = f", {report.refused} not graded" if report.refused else ""
    echo(
        f"{report.submissions} submission{plural}{of}{refused}; {report.mean:.3g} of {report.best:g} points on average"
    )


def _report_markdown(title: str, report: ClassReport) -> str:
    from planar_cli.homework.grading.class_report import by_variant, rows
    from planar_cli.homework.sets.sheets import plain

    lines = [
        f"# {plain(title)}: the class",
        "",
        "| Problem | Find | Answers | Right | Ungradable | Carried | Mistakes |",
    ]
    lines.append("| --- | --- | --- | --- | --- | --- | --- |")
    for r in rows(report):
        cells = (plain(r.problem), plain(r.find), r.answers, r.right, r.ungradable, r.carried, plain(r.mistakes))
        lines.append(f"| {' | '.join(map(str, cells))} |")
    variants = by_variant(report)
    if len(variants) > 1:
        names = [f"{plain(r.problem)}.{plain(r.find)}" for r in rows(report)]
        lines += [
            "",
            "Right answers by variant:",
            "",
            f"| Variant | {' | '.join(names)} |",
            "| --- |" + " --- |" * len(names),
        ]
        for variant, counts in variants.items():
            lines.append(f"| {variant} | {' | '.join(f'{right} of {answers}' for right, answers in counts.values())} |")
    lines += ["", *(f"- suspicious: {plain(f'{p}.{f}: {why}')}" for p, f, why in report.suspicious()), ""]
    return "\n".join(lines)


def _executor(address: str | None) -> Any:
    """A cluster to grade on, or nothing."""
    import contextlib

    if address is None:
        return contextlib.nullcontext(None)
    from planar_cli.homework.tasks.cluster import cluster

    return cluster(address)
