"""Solve problem files and print the worked solutions.

FILES are problem files, or - for standard input. Answers that a file states are compared with the solution. The exit
status is 0 when every problem is solved and agrees, 1 when an answer disagrees or there is no solution, 2 for wrong
usage or a bad file, 3 when something was not decided in time or an answer is not confirmed, 4 for a fault of planar; of
several, the highest.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from planar_cli import cli
from planar_cli.commands._limit import limits
from planar_cli.commands._output import write, write_bytes
from planar_cli.errors import PlanarError
from planar_cli.near import nearest
from planar_cli.options import SECONDS, Choice, IntRange, WrongUsage, argument, option
from planar_cli.options import command as declared
from planar_cli.records import record
from planar_cli.registry import member, modules

if TYPE_CHECKING:
    from planar_cli.problem.scene.scene import Problem
    from planar_cli.report.document.blocks import Document

LARGEST_FIGURES = 40
PDF = "pdf"
"""The page of the format `html`, on paper."""
MARKDOWN = "markdown"
ILLUSTRATED = ("html", "latex", PDF)
"""Formats with figures; Markdown has them as files, where it is a file itself."""
OUTCOMES = {cli.DISAGREES: "no solution", cli.BAD: "bad file", cli.UNDECIDED: "undecided", cli.FAULT: "fault"}


@record
class Wanted:
    """The options of one run."""

    form: str
    output: str | None
    method: str | None
    compare: bool
    why: str | None
    figures: int
    audience: str
    effects: bool
    verbose: bool
    drawing: bool
    timeout: float

    @property
    def json(self) -> bool:
        return self.form == "json"

    @property
    def illustrated(self) -> bool:
        """Has the page figures?"""
        return self.form in ILLUSTRATED or (self.form == MARKDOWN and self.output not in (None, "-"))

    @property
    def handed_out(self) -> bool:
        """Is it a whole page for somebody who may not have the task? A lesson has it anyway, a key has none."""
        return self.form != "terminal" and self.audience == "student" and not self.why


@record
class Report:
    """What came of one file: its exit status, and a text for people, a page with figures or data for programs."""

    status: int
    text: str = ""
    data: Mapping[str, Any] | None = None
    page: Document | None = None


FIGURES = IntRange(1, LARGEST_FIGURES)


@declared(help=__doc__)
@argument("files")
@option("--format", "form", type=Choice([*modules("formats"), PDF]), default="terminal", help="How to print.")
@option("-o", "--output", metavar="FILE", help="Write to FILE instead of standard output.")
@option("--method", type=Choice(modules("principles")), help="The principle to use, not that of the file.")
@option("--compare", is_flag=True, help="List the methods that reach the answers, instead of a solution.")
@option("--why", metavar="NAME", help="Only what the answer NAME rests on.")
@option("--figures", type=FIGURES, default=4, show_default=True, help="Significant figures of numbers.")
@option("--digits", type=FIGURES, help=f"As --figures: so many certain digits, at most {LARGEST_FIGURES}.")
@option(
    "--audience",
    type=Choice(["exam", "student", "lesson"]),
    default="student",
    help="As short as a key, worked out, or with words on each step.",
)
@option("--effects", is_flag=True, help="Also which effects the scene has, and which it lacks.")
@option("--verbose", is_flag=True, help="Also what was compared, with digits, and the effects.")
@option("--drawing", is_flag=True, help="With the scene and the diagrams, drawn in letters.")
@option("--timeout", type=SECONDS, default=60, show_default=True, help="Seconds a problem; 0: none.")
def command(files: tuple[str, ...], digits: int | None, **options: Any) -> int:
    """Solve each file; one that fails does not keep the others from being solved."""
    wanted = Wanted(**options)
    if digits is not None:
        wanted = replace(wanted, figures=digits)
    if wanted.compare and (wanted.why or wanted.method):
        raise WrongUsage("--compare looks at all methods; leave --method and --why out")
    if wanted.drawing and wanted.form != "terminal":
        raise WrongUsage("--drawing is for the terminal; pages of the format html have their figures anyway")
    if wanted.form == PDF and wanted.output in (None, "-"):
        raise WrongUsage("a PDF is written to a file: add `-o FILE`")
    reports = [_report(path, wanted) for path in files]
    status = max(report.status for report in reports)
    pages = [report.page for report in reports if report.page is not None]
    if pages:
        _write_pages(pages, wanted)
        return status
    text = _joined(reports, wanted)
    if text:
        write(text, wanted.output, styled=not wanted.json, exact=wanted.form != "terminal")
    return status


def _write_pages(pages: Sequence[Document], wanted: Wanted) -> None:
    """Several pages with figures as one, on a screen or on paper."""
    from planar_cli.formats.base import in_one

    if wanted.form == MARKDOWN:
        from planar_cli.commands._pictures import pictures_of, write_with_pictures

        whole = in_one(pages)
        text = member("formats", MARKDOWN)(pictures=True).render(whole)
        write_with_pictures(text, pictures_of(whole.blocks), wanted.output or "")
        return
    text = member("formats", "html" if wanted.form == PDF else wanted.form)().render(in_one(pages))
    if wanted.form != PDF:
        write(text, wanted.output, exact=True)
        return
    from planar_cli.formats._svg import PRINT
    from planar_cli.typeset import pdf

    write_bytes(pdf(text, PRINT), wanted.output or "")


def _joined(reports: list[Report], wanted: Wanted) -> str:
    """All reports as one output; of several files, JSON has a list."""
    if not wanted.json:
        return "\n".join(report.text for report in reports if report.text)
    from planar_cli.formats.json import dumps

    data = [report.data for report in reports if report.data is not None]
    return dumps(data[0] if len(reports) == 1 and data else {"solutions": data})


def _printed(document: Document, wanted: Wanted) -> str:
    form: Any = member("formats", wanted.form)
    on_screen = wanted.output in (None, "-")
    made = form.on(sys.stdout) if on_screen else form()
    rendered: str = (replace(made, drawn=True) if wanted.drawing else made).render(document)
    return rendered


def _report(path: str, wanted: Wanted) -> Report:
    """Read and solve one file; what goes wrong is told on standard error."""
    from planar_cli.homework.checking.checking import read

    name = path
    try:
        with limits(wanted.timeout):
            problem = read(path)
            name = problem.title or path
            return _compared(problem, wanted) if wanted.compare else _solved(problem, wanted)
    except PlanarError as error:
        return _failed(name, wanted, cli.tell(error), str(error), error)
    except WrongUsage:
        raise
    except Exception as error:
        return _failed(name, wanted, cli.tell_fault(error), f"{type(error).__name__}: {error}")


def _failed(name: str, wanted: Wanted, status: int, message: str, error: PlanarError | None = None) -> Report:
    if not wanted.json:
        return Report(status)
    from planar_cli.diagnostics import as_data
    from planar_cli.report.page.json_document import failure_data

    diagnostics = [as_data(d) for d in getattr(error, "diagnostics", ())]
    return Report(status, data=failure_data(name, OUTCOMES[status], message, diagnostics))


def _solved(problem: Problem, wanted: Wanted) -> Report:
    from planar_cli.homework.checking.checking import solve_and_compare
    from planar_cli.report.page.key import with_disagreements
    from planar_cli.report.page.narrate import Voice, narrate

    _demand_find(problem, wanted.why)
    solution, verdicts = solve_and_compare(problem, wanted.method)
    status = cli.SOLVED if all(v.agrees for v in verdicts) else cli.DISAGREES
    if wanted.json:
        from planar_cli.report.page.json_document import solution_data

        return Report(status, data=solution_data(solution, verdicts, wanted.figures, wanted.method))
    voice = Voice(wanted.figures, wanted.audience, wanted.effects or wanted.verbose, wanted.verbose)
    document = with_disagreements(narrate(solution, voice, wanted.why), verdicts)
    if wanted.handed_out:
        from planar_cli.report.document.stated_text import with_task

        document = with_task(document, problem)
    if wanted.illustrated or wanted.drawing:
        from planar_cli.figures.illustrated import illustrated

        document = illustrated(document, solution)
    if wanted.illustrated:
        return Report(status, page=document)
    return Report(status, _printed(document, wanted))


def _demand_find(problem: Problem, name: str | None) -> None:
    """Raise for --why with a name that the file does not ask for."""
    asked = [f.name for p in (problem, *(case.problem for case in problem.cases)) for f in p.find]
    if name is not None and name not in asked:
        near = nearest(name, asked)
        hint = f"did you mean {near}?" if near else f"it asks for {', '.join(asked)}"
        raise WrongUsage(f"{problem.file} has no find '{name}'; {hint}")


def _compared(problem: Problem, wanted: Wanted) -> Report:
    """Every method that the scene offers, side by side."""
    from planar_cli.report.page.comparison import comparison_data, comparison_document
    from planar_cli.solve.compare import compare_methods

    rows = compare_methods(problem)
    if wanted.json:
        return Report(cli.SOLVED, data=comparison_data(problem, rows))
    document = comparison_document(problem, rows)
    if wanted.illustrated:
        return Report(cli.SOLVED, page=document)
    return Report(cli.SOLVED, _printed(document, wanted))
