"""Mistakes in problem files: every file of tests/bad has a golden list of all that is wrong with it.

`PLANAR_UPDATE=1 pytest tests/test_bad.py` writes the lists anew; read the difference before you keep it.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from planar_cli.errors import Diagnostic
from planar_cli.problem.codes.codes import CODES
from planar_cli.problem.codes.codes_structure import CODES_STRUCTURE
from planar_cli.problem.structure import load

BAD = sorted((Path(__file__).parent / "bad").glob("*.yaml"))


def shown(diagnostics: list[Diagnostic]) -> str:
    """Place, code, message and hint, one below the other."""
    lines = []
    for d in diagnostics:
        lines.append(f"{d.mark.line}:{d.mark.column} {d.code} {d.message}")
        if d.hint:
            lines.append(f"    {d.hint}")
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("path", BAD, ids=lambda p: p.stem)
def test_messages(path: Path) -> None:
    problem, diagnostics, _ = load(str(path))
    assert problem is None
    assert diagnostics
    golden = path.with_suffix(".expected")
    if os.environ.get("PLANAR_UPDATE"):
        golden.write_text(shown(diagnostics), encoding="utf-8")
    assert shown(diagnostics) == golden.read_text(encoding="utf-8")


@pytest.mark.parametrize("path", BAD, ids=lambda p: p.stem)
def test_every_code_is_explained_and_every_place_is_in_the_file(path: Path) -> None:
    _, diagnostics, source = load(str(path))
    lines = source.splitlines()
    for d in diagnostics:
        assert d.code in {**CODES, **CODES_STRUCTURE}
        assert 1 <= d.mark.line <= len(lines)
        assert 1 <= d.mark.column <= len(lines[d.mark.line - 1]) + 1
