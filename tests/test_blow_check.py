"""Blows are checked by the work of their impulses, which is the change of kinetic energy."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}
ONE = r"\(u \+ u′\)/2 = (\S+) \((\S+) \+ (\S+)\)/2 = (\S+) J; T′ - T = (\S+) - (\S+) = (\S+) J"


def _page(stem: str) -> str:
    return " ".join(Terminal(300).render(narrate(worked(FILES[stem])[0])).split())


@pytest.mark.parametrize("stem", ["puck-hits-a-free-rod", "ball-strikes-the-end-of-a-pinned-rod", "ex-4-14"])
def test_one_impulse(stem: str) -> None:
    """Of ex-4-14 the impulse is found by the momentum of the ball alone: the page had no need of it."""
    found = re.search(ONE, _page(stem))
    assert found is not None
    size, before, after, work, last, first, change = (float(x) for x in found.groups())
    assert size * (before + after) / 2 == pytest.approx(work, rel=3e-3)
    assert last - first == pytest.approx(work, rel=3e-3)
    assert change == work


def test_several_impulses() -> None:
    found = re.search(
        r"Σ J \(u \+ u′\)/2 = (\S+) - (\S+) = (\S+) J; T′ - T = (\S+) - (\S+) =", _page("wheel-over-a-kerb")
    )
    assert found is not None
    one, other, work, last, first = (float(x) for x in found.groups())
    assert one - other == pytest.approx(work)
    assert last - first == pytest.approx(work, rel=3e-3)


def test_none_in_letters() -> None:
    assert "T′ - T" not in _page("hinged-bars-struck")
