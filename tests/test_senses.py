"""Answers in letters tell their sense where the signs of the letters do."""

from __future__ import annotations

import re

import pytest
from conftest import PROBLEMS
from worked import worked

from planar_cli.formats.terminal import Terminal
from planar_cli.report.page.narrate import narrate

FILES = {p.stem: p for p in PROBLEMS}


@pytest.mark.parametrize(
    ("stem", "answer"),
    [
        ("ex-4-04", "α = 12 g/(11 L) counterclockwise"),
        ("ex-4-06", "F_pivot = A_y = 4/7 m g upward"),
        ("ex-1-07", " = -l √(k/m), that is to the left"),
        ("ex-1-07", " = -k x/m\n"),
        ("ex-1-07", "x_stop = -l\n"),
    ],
)
def test_the_sense_of_an_answer_in_letters(stem: str, answer: str) -> None:
    page = Terminal(200).render(narrate(worked(FILES[stem])[0]))
    assert answer in page.partition("Answer")[2]


@pytest.mark.parametrize("stem", ["bob-on-a-thread-that-goes-slack", "exercise-4-34"])
def test_the_kinetic_energy_leaves_the_letter_of_what_is_asked(stem: str) -> None:
    """T is a tension there."""
    page = Terminal(200).render(narrate(worked(FILES[stem])[0]))
    assert re.search(r"E_k,1 (=|\+ U =) ", page)
    assert "+ U = T_" not in page


def test_one_letter_for_the_kinetic_energy() -> None:
    """A file that calls a tension T has another letter for the energy in all cases, and in its check."""
    yoyo = Terminal(200).render(narrate(worked(FILES["yo-yo"])[0]))
    assert "E_k,2 = 1/2 m v_G,2² + 1/2 I_G ω_2²" in yoyo.partition("CASE")[2]
    pendulum = Terminal(200).render(narrate(worked(FILES["pendulum-against-a-wall"])[0]))
    assert "E_k′ - E_k = 1.648 - 3.364" in pendulum
    pivot = Terminal(200).render(narrate(worked(FILES["pivot-of-the-shortest-period"])[0]))
    assert "energies near the equilibrium: E_k = 1/2 · 0.3333" in pivot
