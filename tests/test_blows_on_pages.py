"""What a page says of a blow: momenta and impulses in letters."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def page(stem: str) -> str:
    """The page with single spaces."""
    return " ".join(Terminal(400).render(narrate(worked(FILES[stem])[0])).split())


@pytest.mark.parametrize(("stem", "row"), [
    ("ex-4-13", "= m AG ω_2 → at G, I ω_2 ↺"),
    ("wheel-over-a-kerb", "= m R ω_2 ↙ at G, I_G ω_2 ↺"),
    ("free-bar-struck-at-its-end", "I ω_2 ↺"),
    ("box-that-tips-over", "= m CG ω_2 ↙ at G, I_G ω_2 ↺"),
])  # fmt: skip
def test_momenta_after_a_blow_have_letters(stem: str, row: str) -> None:
    """m v_G and I ω, with AG where the distance of the mass centre is a number of the file."""
    printed = page(stem)
    assert row in printed
    assert not re.search(r"= [\d.]+ [vω]_\S+ [→↑↺]", printed)


@pytest.mark.parametrize(("stem", "row"), [
    ("rod-and-disk-pendulum", "= m OG α ↗ at G, m OG ω² ↖ at G, I α ↺"),
    ("five-bar-chain", "= m AB α_AB ↗ at G_BC, m BG_BC α_BC ↑ at G_BC"),
])  # fmt: skip
def test_distances_in_a_kinetic_diagram(stem: str, row: str) -> None:
    """A distance that is a number of the file is told by the points between which it lies."""
    assert row in page(stem)
