"""A motion that was found without energies is checked by them, with numbers that fulfil the balance."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


def _checks(stem: str) -> list[str]:
    page = " ".join(Terminal(200).render(narrate(worked(FILES[stem])[0])).split())
    return re.findall(r"work and energy: ((?:T_|E_k,)\w+ \+ U = .*?) J = (?:T_|E_k,)\w+", page)


@pytest.mark.parametrize(
    "stem", ["ball-with-backspin", "body-rotor-with-varying-torque", "body-atwood-with-heavy-pulley"]
)
def test_both_sides_agree(stem: str) -> None:
    found = _checks(stem)
    assert found
    for text in found:
        _, left, right = text.split(" = ")
        terms = [float(t) for t in re.sub(r" ([+-]) ", r" \1", left).split()]
        assert sum(terms) == pytest.approx(float(right), abs=2e-3 * max(map(abs, terms)))


def test_none_where_energies_were_used() -> None:
    assert not _checks("ex-4-10")
