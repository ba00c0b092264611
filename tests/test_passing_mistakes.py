"""Mistakes that hardly change an answer are told to the lecturer, of the file and of each variant."""

from __future__ import annotations

from pathlib import Path

import pytest
from homework_made import SLOPE, set_of

from planar_cli.commands._tolerances import tolerances_of_set
from planar_cli.homework.homework import assembled, prepared
from planar_cli.homework.sets.set_file import HomeworkSet

SHALLOW = f"""{SLOPE.replace("beta: 30 deg, mu_k: 0.2", "beta: 10 deg, mu_k: 0.1")}
variants: {{beta: [10 deg, 60 deg, 12 deg]}}
"""


def made(folder: Path, more: str) -> HomeworkSet:
    return set_of(folder, more, slope=SHALLOW)


def warnings(homework_set: HomeworkSet) -> list[str]:
    (problem,) = homework_set.problems
    ready = prepared(problem, homework_set.variants, 1)
    return [w for w in assembled(homework_set, [ready]).warnings if "is not seen" in w]


def test_a_mistake_that_is_graded_right_is_told(tmp_path: Path) -> None:
    """N = m g for m g cos β: 1 - cos 10° = 1.5 % of the friction, and 2 % of a where tan β = 0.176."""
    said = "slope: normal-force-is-weight (the whole weight stands where its component along the normal belongs)"
    assert warnings(made(tmp_path, "")) == []
    assert warnings(made(tmp_path, "tolerance: 0.03")) == [f"{said} is not seen: it gives a right a"]


def test_variants_are_counted(tmp_path: Path) -> None:
    (told,) = warnings(made(tmp_path, "tolerance: 0.03\nvariants: {number: 3}"))
    assert told.endswith("it gives a right a in 2 of 3 variants")


def test_the_report_takes_the_variants_in(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tolerances_of_set(made(tmp_path, "tolerance: 0.03\nvariants: {number: 3}"), 60)
    told = capsys.readouterr().out
    assert "3 % would pass a wrong model with the values of the file and in variants " in told
    assert "nearest wrong model" in told
