"""Write the answers of problem files, or their worked solutions, or both, as one document.

FILES are problem files or folders (every .yaml and .yml file below). The answers are those of the solution; one that
the file states otherwise is marked. With --both all answers come first, then all solutions; with -o FILE.md figures of
solutions are files in the folder FILE-figures. The exit status is that of `planar solve`.

One FILE may be a homework set (`planar explain homework`): its variants are drawn, and with -o FOLDER a sheet for each
variant or student, a key for each variant and the key of all are written there; else the key is printed. The same seed
gives the same files.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import click

from planar_cli import cli
from planar_cli.by_click import type_of
from planar_cli.commands._handed_out import PAGES, PDF, in_form, printed_as
from planar_cli.commands._limit import limits
from planar_cli.commands._output import write, write_bytes
from planar_cli.commands._pictures import pictures_of, write_with_pictures
from planar_cli.errors import PlanarError
from planar_cli.options import SECONDS

if TYPE_CHECKING:
    from planar_cli.report.document.blocks import Document

MARKDOWN = "markdown"
FORMS = (*PAGES, "json", "csv")


@click.command(help=__doc__)
@click.argument("files", nargs=-1, required=True)
@click.option("--worked", is_flag=True, help="The worked solutions, not the answers alone.")
@click.option("--both", is_flag=True, help="The answers of all files, then their worked solutions.")
@click.option(
    "--audience",
    type=click.Choice(["exam", "student", "lesson"]),
    default="student",
    help="How solutions are worked: as short as a key, worked out, or with words on each step.",
)
@click.option("--variants", type=click.IntRange(1, 10_000), help="Of a set: so many variants.")
@click.option("--seed", type=click.IntRange(0, 10**9), help="Of a set: what the variants are drawn by.")
@click.option("--format", "form", type=click.Choice(FORMS), help="How to write; json and csv of a set.")
@click.option(
    "--export", "exports", multiple=True, metavar="NAME", help="Of a set: moodle, prairielearn, qti, text2qti."
)
@click.option("-o", "--output", metavar="FILE", help="Write to FILE (of a set: a folder) instead of standard output.")
@click.option("--figures", type=click.IntRange(1, 40), default=4, show_default=True, help="Significant figures.")
@click.option("--timeout", type=type_of(SECONDS), default=60, show_default=True, help="Seconds a problem; 0: none.")
def command(
    files: tuple[str, ...],
    worked: bool,
    both: bool,
    audience: str,
    output: str | None,
    figures: int,
    timeout: float,
    form: str | None,
    **of_set: Any,
) -> int:
    """One section for each file, in their order; or the sheets and the key of a set."""
    if len(files) == 1 and _is_set(files[0]):
        from planar_cli.commands._key_of_set import key_of_set

        return key_of_set(files[0], worked, both, output, timeout, (figures, audience), form=form, **of_set)
    style = form or MARKDOWN
    if style not in PAGES or any(v not in (None, ()) for v in of_set.values()):
        raise click.UsageError("--variants, --seed, --export, --format json and csv are for one homework set")
    if style == PDF and output in (None, "-"):
        raise click.UsageError("a PDF is written to a file: add `-o FILE`")
    from planar_cli.problem.nodes.files import problem_files
    from planar_cli.registry import member
    from planar_cli.report.document.blocks import Title

    below = 1 if both else 0
    called = style == MARKDOWN and output not in (None, "-")
    pages: Any = member("formats", printed_as(style))(*((below, called) if called else (below,)))
    pictures: dict[str, str] = {}
    answers: list[str] = []
    solutions: list[str] = []
    titles: list[str] = []
    worst = cli.SOLVED
    for path in problem_files(files):
        try:
            with limits(timeout):
                short, long, status = _sections(path, figures, audience if worked or both else "")
                titles.append(short.title)
                answers.append(pages.part((Title(short.title), *short.blocks)))
                solutions += [pages.part((Title(long.title), *long.blocks))] if long is not None else []
                pictures |= pictures_of(long.blocks) if called and long is not None else {}
        except PlanarError as error:
            status = cli.tell(error)
        except Exception as error:
            status = cli.tell_fault(error)
        worst = max(worst, status)
    parts = solutions if worked else answers
    if both:
        parts = [pages.part([Title("Answers", -1)]), *answers, pages.part([Title("Solutions", -1)]), *solutions]
    if parts:
        _write(pages.whole("Answers and solutions" if both else titles[0], parts), style, output, pictures)
    return worst


def _write(text: str, style: str, output: str | None, pictures: dict[str, str]) -> None:
    if style == PDF:
        write_bytes(in_form(text, style), output or "")
    elif style == MARKDOWN and output not in (None, "-"):
        write_with_pictures(text, pictures, output or "")
    else:
        write(text, output, exact=True)


def _is_set(path: str) -> bool:
    """Does a file list problems, as a homework set does?"""
    from planar_cli.problem.nodes.nodes import Mapping, read_file

    if path == "-" or os.path.isdir(path):
        return False
    node = read_file(path)[1]
    return isinstance(node, Mapping) and node.get("problems") is not None and node.get("find") is None


def _sections(path: str, figures: int, audience: str) -> tuple[Document, Document | None, int]:
    """The answers of one file, its worked solution for an audience (none: ""), and its exit status."""
    from planar_cli.figures.illustrated import illustrated
    from planar_cli.homework.checking.checking import read, solve_and_compare
    from planar_cli.report.page.key import key_document, with_disagreements
    from planar_cli.report.page.narrate import Voice, narrate

    solution, verdicts = solve_and_compare(read(path))
    status = cli.SOLVED if all(v.agrees for v in verdicts) else cli.DISAGREES
    short = key_document(solution, verdicts, figures)
    if not audience:
        return short, None, status
    worked = with_disagreements(narrate(solution, Voice(figures, audience)), verdicts)
    return short, illustrated(worked, solution), status
