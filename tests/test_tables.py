"""Loads given by tables of instants and values, and resistances that turn round with the velocity."""

from __future__ import annotations

from math import atan, atanh, log, sqrt
from pathlib import Path

import pytest
import sympy as sp

from planar_cli.errors import FileProblem
from planar_cli.homework.checking.checking import read
from planar_cli.report.notation.notation import latex, plain
from planar_cli.solve.run import solve_problem

CART = """
title: Cart
plane: vertical
points: {{A: [0, 0]}}
bodies: {{cart: {{particle: A, mass: 2 kg}}}}
joints:
  - guide: {{point: A, along: 0 deg}}
loads:
  - {load}
{more}
"""
TABLE = "force: {body: cart, magnitude: {table: [[1 s, 4 N], [3 s, 8 N]]}, angle: 0 deg}"


def solved(tmp_path: Path, text: str) -> dict[str, list[float]]:
    path = tmp_path / "problem.yaml"
    path.write_text(text, encoding="utf-8")
    solution = solve_problem(read(str(path)))
    return {f.name: [float(v) for v in f.values or ()] for part in solution.parts for f in part.found}


def test_straight_lines_and_constant_ends(tmp_path: Path) -> None:
    """a = 2 up to 1 s, then 2 + (t - 1), then 4 from 3 s on."""
    more = (
        "states: {0: [t = 0, at rest], 1: [t = 1 s], 2: [t = 2 s], 3: [t = 3 s], 4: [t = 4 s]}\n"
        "find: {v1: v(A).x @ 1, v2: v(A).x @ 2, v3: v(A).x @ 3, v4: v(A).x @ 4, a2: a(A).x @ 2, x3: x(A) @ 3}"
    )
    found = solved(tmp_path, CART.format(load=TABLE, more=more))
    assert found["v1"] == pytest.approx([2])
    assert found["v2"] == pytest.approx([4.5])
    assert found["v3"] == pytest.approx([8])
    assert found["v4"] == pytest.approx([12])
    assert found["a2"] == pytest.approx([3])
    assert found["x3"] == pytest.approx([1 + 4 + 4 + 8 / 6])


@pytest.mark.parametrize(("time", "a"), [("0.2 s", 2), ("2 s", 3), ("7 s", 4)])
def test_value_at_an_instant(tmp_path: Path, time: str, a: float) -> None:
    more = f"instant: [t = {time}, at rest]\nfind: {{a: a(A).x}}"
    assert solved(tmp_path, CART.format(load=TABLE, more=more))["a"] == pytest.approx([a])


def test_the_time_must_be_known(tmp_path: Path) -> None:
    with pytest.raises(FileProblem, match="a time that is known"):
        solved(tmp_path, CART.format(load=TABLE, more="instant: [at rest]\nfind: {a: a(A).x}"))


def test_instants_follow_each_other(tmp_path: Path) -> None:
    load = TABLE.replace("[3 s, 8 N]", "[0.5 s, 8 N]")
    with pytest.raises(FileProblem, match="follow each other"):
        solved(tmp_path, CART.format(load=load, more="instant: [t = 1 s, at rest]\nfind: {a: a(A).x}"))


def test_pieces_in_print() -> None:
    t = sp.Symbol("t", real=True)
    pieces = sp.Piecewise((25 * t, t < 2), (50, True))
    assert plain(pieces) == "25 t for t < 2; 50 for t > 2"
    assert plain(sp.Piecewise((t, t < 2), (4 - t, t < 4), (0, True))) == "t for t < 2; 4 - t for 2 < t < 4; 0 for t > 4"
    assert plain(3 - pieces / 2) == "3 - (25 t for t < 2; 50 for t > 2)/2"
    assert latex(pieces) == r"\begin{cases} 25 t & t \lt 2 \\ 50 & \text{else} \end{cases}"


@pytest.mark.parametrize("way", [1, -1])
def test_drag_is_against_the_velocity_both_ways(tmp_path: Path, way: int) -> None:
    """A constant force of 6 N against a start at 5 m/s: drag 0.5 kg/m v² helps it first and hinders it afterwards."""
    text = CART.format(
        load="force: {body: cart, magnitude: -6 N, angle: 0 deg}\n"
        "  - drag: {body: cart, magnitude: (0.5 kg/m)*v(cart).mag^2}",
        more="states: {1: [t = 0, v(A).x = 5 m/s], 2: [v(A).x = 0], 3: [x(A) = 0]}\n"
        "find: {x: x(A) @ 2, t2: t @ 2, v: v(A).x @ 3, t3: t @ 3}",
    )
    if way < 0:
        text = text.replace("-6 N", "6 N").replace("v(A).x = 5 m/s", "v(A).x = -5 m/s")
    found = solved(tmp_path, text)
    k, g = 0.25, 3.0
    back = 5 / sqrt(1 + k * 25 / g)
    first = atan(5 * sqrt(k / g)) / sqrt(k * g)
    assert found["x"] == pytest.approx([way * log(1 + k * 25 / g) / (2 * k)])
    assert found["t2"] == pytest.approx([first])
    assert found["v"] == pytest.approx([-way * back])
    assert found["t3"] == pytest.approx([first + atanh(back * sqrt(k / g)) / sqrt(k * g)])
