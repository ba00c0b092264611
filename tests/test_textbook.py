"""The worked examples of the textbook: what the JSON document says, number by number, as the book does."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from conftest import PROBLEMS
from worked import name_of, worked

from planar_cli.formats.json import dumps
from planar_cli.report.page.json_document import solution_data
from planar_cli.units import parse_unit

TEXTBOOK = [p for p in PROBLEMS if p.parent.name == "textbook"]
# To the figures that the book prints: (file, find, value in the unit).
BOOK: list[tuple[str, str, Any, str]] = [
    ("ex-4-05", "alpha", -6.185567, "rad/s^2"),
    ("ex-4-05", "friction", 39.175258, "N"),
    ("ex-4-05", "k_critical", 0.3674235, "m"),
]
FORMULAS = [
    ("ex-4-04", "alpha", "12*g/(11*L)"),
    ("ex-4-06", "alpha", "12*g/(7*L)"),
    ("ex-4-06", "F_pivot", "4*m*g/7"),
]


def answers_of(name: str) -> dict[str, Any]:
    solution, verdicts = worked(next(p for p in TEXTBOOK if p.stem == name))
    found: dict[str, Any] = json.loads(dumps(solution_data(solution, verdicts, 4, None)))["answers"]
    return found


@pytest.mark.parametrize(("name", "find", "value", "unit"), BOOK)
def test_numbers(name: str, find: str, value: float, unit: str) -> None:
    answer = answers_of(name)[find]
    wanted, given = parse_unit(unit), parse_unit(answer["unit"])
    factor = float(given.factor / wanted.factor) * math.pi ** (given.pi_power - wanted.pi_power)
    assert answer["value"] * factor == pytest.approx(value, rel=2e-6)


@pytest.mark.parametrize(("name", "find", "formula"), FORMULAS)
def test_formulas(name: str, find: str, formula: str) -> None:
    answer = answers_of(name)[find]
    assert answer["value"] is None
    names = {n: sp.Symbol(n, positive=True) for n in ("g", "m", "L", "r", "l")}
    assert sp.simplify(sp.sympify(answer["expression"], locals=names) - sp.sympify(formula, locals=names)) == 0


@pytest.mark.parametrize("path", TEXTBOOK, ids=name_of)
def test_names_its_source(path: Path) -> None:
    solution, _ = worked(path)
    assert "Planar Dynamics" in solution.problem.source
