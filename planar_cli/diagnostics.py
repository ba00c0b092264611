"""Printing diagnostics: on a terminal with excerpt and caret, as JSON, or as annotations of GitHub Actions."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Mapping

from planar_cli.errors import Diagnostic
from planar_cli.problem.nodes.nodes import text_of
from planar_cli.problem.nodes.show import show_diagnostic, visible
from planar_cli.streams import echo


def use_colour() -> bool:
    """Colour on a terminal, unless NO_COLOR asks for none; FORCE_COLOR asks for it everywhere."""
    if os.environ.get("NO_COLOR"):
        return False
    return bool(os.environ.get("FORCE_COLOR")) or sys.stderr.isatty()


def show_all(diagnostics: Iterable[Diagnostic], sources: Mapping[str, str] | None = None) -> None:
    """Print diagnostics to standard error; `sources` has the texts of files already read, standard input among them."""
    texts = dict(sources or {})
    for diagnostic in diagnostics:
        file = diagnostic.mark.file
        if file not in texts:
            texts[file] = text_of(file)
        shown = _coloured(show_diagnostic(diagnostic, texts[file]), diagnostic.code)
        echo(shown, err=True, colour=use_colour())


def _coloured(shown: str, code: str) -> str:
    if not use_colour():
        return shown
    import click

    head, line_end, rest = shown.partition("\n")
    return head.replace(code, click.style(code, fg="red", bold=True), 1) + line_end + rest


def as_data(diagnostic: Diagnostic) -> dict[str, object]:
    """One diagnostic for JSON."""
    mark = diagnostic.mark
    return {
        "file": mark.file,
        "line": mark.line,
        "column": mark.column,
        "code": diagnostic.code,
        "message": diagnostic.message,
        "hint": diagnostic.hint,
    }


def as_annotation(diagnostic: Diagnostic) -> str:
    """One diagnostic as a workflow command of GitHub Actions."""
    mark = diagnostic.mark
    words = diagnostic.message + (f" ({diagnostic.hint})" if diagnostic.hint else "")
    file = _escaped(visible(mark.file), ",:")
    place = f"file={file},line={mark.line},col={mark.column},title={diagnostic.code}"
    return f"::error {place}::{_escaped(visible(words))}"


def _escaped(text: str, more: str = "") -> str:
    for character in "%\r\n" + more:
        text = text.replace(character, f"%{ord(character):02X}")
    return text
