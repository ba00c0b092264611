"""`--audience exam` prints a page as short as a key: the principle, the key equations, the results."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.blocks import Answer, Equation, Forces, Paragraph
from planar_cli.report.narrate import Voice, narrate

STEMS = ("double-pulley", "ex-2-09", "ex-4-10", "ladder-sliding", "puck-hits-a-free-rod", "ex-1-02")
LONG = 25
"""A page of fewer lines is hardly more than its results."""
FILES = [p for p in PROBLEMS if p.stem in STEMS]


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_short_with_all_results(path: Path) -> None:
    page = narrate(worked(path)[0])
    key = narrate(worked(path)[0], Voice(audience="exam"))
    assert not [b for b in key.blocks if isinstance(b, Forces | Paragraph)]
    assert [b for b in key.blocks if isinstance(b, Answer)] == [b for b in page.blocks if isinstance(b, Answer)]
    short, long = (len(Terminal().render(x).splitlines()) for x in (key, page))
    assert short < (0.75 * long if long > LONG else long)


@pytest.mark.parametrize("path", FILES, ids=name_of)
def test_the_numbered_equations_are_the_key(path: Path) -> None:
    """With the numbers of the page; a part without any has its results with formula and numbers."""
    page = [b for b in narrate(worked(path)[0]).blocks if isinstance(b, Equation)]
    key = [b for b in narrate(worked(path)[0], Voice(audience="exam")).blocks if isinstance(b, Equation)]
    assert key
    assert {(b.number, str(b.sides)) for b in key} <= {(b.number, str(b.sides)) for b in page}
    numbered = [b for b in page if b.number is not None and not any("given:" in str(p) for p in b.lead)]
    assert [b.number for b in key if b.number is not None] == [b.number for b in numbered]
