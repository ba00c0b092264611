"""A page in feet and pounds has no newton, joule or metre in any of its values."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT
from worked import name_of, worked

from planar_cli.problem.read_sections import ATOM, NEUTRAL_ATOMS, US_ATOMS
from planar_cli.report.blocks import Text, Value
from planar_cli.report.narrate import narrate

IN_FEET = re.compile(r"\d[* ]*(?:lbf|lb|ft)\b")
FILES = sorted(
    p
    for p in (ROOT / "problems").rglob("*.yaml")
    if p.parent.name != "hard" and IN_FEET.search(p.read_text(encoding="utf-8").partition("given:")[2])
)
IN_WORDS = re.compile(r"\d (?:N|J|kg|N·m|m/s|m/s²)(?![\w·/])")


def _parts(block: Any) -> Iterator[Any]:
    """All values and texts in a block, at any depth."""
    if isinstance(block, Value | Text):
        yield block
    elif isinstance(block, tuple):
        for part in block:
            yield from _parts(part)
    elif is_dataclass(block):
        for field in fields(block):
            yield from _parts(getattr(block, field.name))


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_no_other_system_of_units(path: Path) -> None:
    solution = worked(path)[0]
    assert solution.problem.us
    for part in _parts(narrate(solution).blocks):
        if isinstance(part, Value):
            assert set(ATOM.findall(part.unit)) <= US_ATOMS | NEUTRAL_ATOMS, part
        else:
            assert not IN_WORDS.search(part.text), part
